"""Values of parameters that no run can change stand in the equations; all others stay names."""

from __future__ import annotations

import pytest

import acausal
from acausal.errors import UsageProblem
from acausal.symbolic.expressions.expr import symbols

CIRCUIT = """model Circuit
  model Branch
    parameter Real R = 1;
    parameter Real L = 1;
    Real i(start = 1); input Real v;
  equation
    v = R * i + L * der(i);
  end Branch;
  Branch plain, resistor(final L = 0), coil(final R = 0);
equation
  plain.v = 1;
  resistor.v = 2;
  coil.v = 3;
end Circuit;"""


def used(compiled: acausal.CompiledModel) -> set[str]:
    return set(symbols([side for e in compiled.causal.equations for side in (e.left, e.right)]))


def test_a_final_zero_removes_its_term() -> None:
    compiled = acausal.loads(CIRCUIT).compile()
    assert compiled.states == ("plain.i", "coil.i")
    assert compiled.causal.evaluated == ("resistor.L", "coil.R")
    assert {"plain.R", "plain.L", "resistor.R", "coil.L"} <= used(compiled)
    assert not {"resistor.L", "coil.R"} & used(compiled)


def test_a_zero_that_may_be_changed_stays() -> None:
    compiled = acausal.loads(CIRCUIT.replace("final L = 0", "L = 0")).compile()
    assert compiled.states == ("plain.i", "resistor.i", "coil.i")
    assert compiled.simulate(parameters={"resistor.L": 2.0})["resistor.i"].values[-1] > 1


def test_final_parameters_are_not_changed_by_a_run() -> None:
    compiled = acausal.loads(CIRCUIT).compile()
    with pytest.raises(UsageProblem, match="is final"):
        compiled.simulate(parameters={"coil.R": 1.0})


EVALUATED = """model M
  parameter Real n = 2;
  parameter Real m = n + 1 annotation(Evaluate = true);
  parameter Real k = 4 annotation(Evaluate = false);
  final parameter Real open_ = k + 1;
  parameter Boolean on = false annotation(Evaluate = true);
  Real x(start = 1, fixed = true);
equation
  der(x) = if on then time else -m * n * k * open_ * x;
end M;"""


def test_evaluate_reaches_what_the_value_depends_on() -> None:
    compiled = acausal.loads(EVALUATED).compile()
    assert compiled.causal.evaluated == ("n", "m", "on")
    assert used(compiled) == {"x", "k", "open_"}
    with pytest.raises(UsageProblem, match="structural"):
        compiled.simulate(parameters={"n": 3.0})
    compiled.simulate(parameters={"k": 3.0})


def test_an_evaluated_parameter_is_changed_by_compiling_again() -> None:
    compiled = acausal.loads(EVALUATED).compile(on=True, n=3)
    assert compiled.simulate()["x"].values[-1] == pytest.approx(1.5, rel=1e-5)


def test_a_final_parameter_that_depends_on_a_tunable_one_is_not_evaluated() -> None:
    compiled = acausal.loads(EVALUATED).compile()
    fast = compiled.simulate(parameters={"k": 0.1}, stop_time=1)["x"].values[-1]
    assert fast == pytest.approx(2.718281828 ** (-3 * 2 * 0.1 * 1.1), rel=1e-4)


FREE = """model M
  parameter Real k(fixed = false, start = 1);
  parameter Real twice = 2 * k;
  parameter Real more = twice + 1;
  Real x(start = 3, fixed = true);
  Real y(start = more, fixed = true);
initial equation
  der(x) = -12;
equation
  der(x) = -twice * x;
  der(y) = -y;
end M;"""


def test_parameters_follow_one_that_the_start_determines() -> None:
    result = acausal.loads(FREE).compile().simulate()
    assert {name: result.parameters[name] for name in ("k", "twice", "more")} == {
        "k": 2,
        "twice": 4,
        "more": 5,
    }
    assert result["y"].values[0] == 5


def test_a_final_dependent_one_is_not_evaluated_either() -> None:
    compiled = acausal.loads(FREE.replace("parameter Real twice", "final parameter Real twice")).compile()
    assert compiled.causal.evaluated == ()
    assert compiled.simulate().parameters["twice"] == 4


def test_texts_are_compared_when_compiling() -> None:
    compiled = acausal.loads(
        """model Winding
          parameter String kind = "D", same = kind;
          parameter Real V = 3, V_phase = V / (if same == "D" then 1 else 2);
          Real u = if kind == "Y" then V else V_phase;
        end Winding;"""
    ).compile()
    assert not {"kind", "same"} & used(compiled)
    assert compiled.simulate(stop_time=1.0).final(["u"])["u"] == 3.0
    assert compiled.simulate(stop_time=1.0, parameters={"V": 5.0}).final(["u"])["u"] == 5.0
