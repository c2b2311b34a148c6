"""Inputs of a model: constants, functions, tables, and what is said where a value is missing or senseless."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
import pytest

import acausal
from acausal.codegen.functions import Code
from acausal.errors import LookupProblem, SimulationProblem, UsageProblem
from acausal.runtime.build import compiler
from acausal.simulate.inputs import Inputs, InputValue, Table
from acausal.simulate.matrices import Vector
from acausal.simulate.result import Result
from acausal.simulate.simulate import simulate

LAG = """
model Lag
  input Real u(unit = "V");
  input Real gain(start = 2);
  parameter Real T = 1;
  Real x(start = 0, fixed = true);
  Real y;
equation
  T * der(x) = gain * u - x;
  y = u + x;
end Lag;
"""


def lag() -> Code:
    return acausal.loads(LAG).compile().code


def run(inputs: Mapping[str, InputValue], stop: float = 2.0) -> Result:
    return simulate(lag(), inputs=inputs, stop_time=stop, rtol=1e-9)


def test_constant_and_start_attribute() -> None:
    result = run({"u": 3.0})
    assert result.values("x") == pytest.approx(6.0 * (1 - np.exp(-result.time)), abs=1e-6)
    assert result.values("u").tolist() == [3.0] * len(result.time)
    assert result.values("y") == pytest.approx(result.values("x") + 3.0)
    assert run({"u": 3.0, "gain": 1.0}).final(["x"])["x"] == pytest.approx(3.0 * (1 - math.exp(-2)), abs=1e-6)


def test_function_of_time() -> None:
    result = run({"u": math.sin, "gain": 1.0})
    t = result.time
    assert result.values("x") == pytest.approx(0.5 * (np.sin(t) - np.cos(t) + np.exp(-t)), abs=1e-6)
    assert result.values("u") == pytest.approx(np.sin(t))


def test_table_is_linear_between_its_points_and_stops_at_kinks() -> None:
    """A triangle: x' = 2u - x with a ramp up to t = 1 and down to t = 2."""
    result = run({"u": ([0.0, 1.0, 2.0], [0.0, 1.0, 0.0])})
    t = result.time
    rising = 2 * (t - 1 + np.exp(-t))
    after = np.where(t > 1, t - 1, 0.0)
    exact = np.where(t > 1, rising - 4 * (after - 1 + np.exp(-after)), rising)
    assert np.max(np.abs(result.values("x") - exact)) < 1e-7
    assert result.values("u") == pytest.approx(1 - np.abs(t - 1))


@pytest.mark.parametrize("solver", ["rodas", "heun", "cvode"])
def test_tables_of_many_samples(solver: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two tables with kinks of their own; the run-time in C interpolates them itself."""
    asked: list[float] = []
    fill = Inputs.fill

    def counted(self: Inputs, time: float, u: Vector) -> None:
        asked.append(time)
        fill(self, time, u)

    monkeypatch.setattr(Inputs, "fill", counted)
    random = np.random.default_rng(1)
    tables = [(np.linspace(0, 2, n), random.normal(size=n)) for n in (31, 8)]
    inputs: dict[str, InputValue] = {"u": tables[0], "gain": tables[1]}
    result = simulate(lag(), inputs=inputs, stop_time=2.0, rtol=1e-9, solver=solver, step=1e-3)
    for name, (times, values) in zip(("u", "gain"), tables, strict=True):
        assert result.values(name) == pytest.approx(np.interp(result.time, times, values), abs=1e-12)
    fine = np.linspace(0, 2, 200_001)
    pull = np.interp(fine, *tables[0]) * np.interp(fine, *tables[1]) * np.exp(fine - 2.0)
    assert result.values("x")[-1] == pytest.approx(np.trapezoid(pull, fine), abs=1e-5)
    if solver != "cvode" and compiler() is not None:
        assert len(asked) < 20


def test_kinks_are_only_where_the_slope_changes() -> None:
    assert Table((0.0, 1.0, 2.0, 3.0), (0.0, 1.0, 2.0, 2.0)).kinks == [2.0]


def test_an_input_takes_part_in_events_and_loops() -> None:
    text = """
    model Threshold
      input Real u;
      Real x(start = 0, fixed = true), z(start = 1);
    equation
      der(x) = if u > 0.5 then 1 else 0;
      z * z * z + z = u + x;
    end Threshold;
    """
    code = acausal.loads(text).compile().code
    result = simulate(code, inputs={"u": lambda t: t}, stop_time=1.0, rtol=1e-9)
    assert result.final(["x"])["x"] == pytest.approx(0.5, abs=1e-7)
    z = result.values("z")
    assert z**3 + z == pytest.approx(result.values("u") + result.values("x"), rel=1e-9)


def test_boolean_input_is_a_constant() -> None:
    text = """
    model Switch
      input Boolean on;
      Real x(start = 0, fixed = true);
    equation
      der(x) = if on then 1 else -1;
    end Switch;
    """
    code = acausal.loads(text).compile().code
    assert simulate(code, inputs={"on": True}).final(["x"])["x"] == pytest.approx(1.0)
    assert simulate(code, inputs={"on": False}).final(["x"])["x"] == pytest.approx(-1.0)
    with pytest.raises(UsageProblem, match="only a constant"):
        simulate(code, inputs={"on": math.sin})


def test_missing_value_names_the_input_and_every_way_to_give_it() -> None:
    with pytest.raises(
        UsageProblem, match=r"input `u` has no value(.*\n)*.*inputs=.*-p u\.start=1"
    ) as caught:
        run({})
    assert caught.value.codes == ("simulate.input-missing",)
    assert caught.value.diagnostics[0].names == ("u",)
    assert caught.value.diagnostics[0].span is not None


def test_unknown_names() -> None:
    with pytest.raises(LookupProblem, match="did you mean gain"):
        run({"u": 1.0, "gains": 1.0})
    with pytest.raises(LookupProblem, match="`T` is a parameter"):
        run({"u": 1.0, "T": 1.0})
    with pytest.raises(LookupProblem, match="`u` is an input"):
        simulate(lag(), parameters={"u": 1.0})


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (math.nan, "nan is no value"),
        (([0.0, 1.0], [1.0]), "2 times and 1 values"),
        (([0.0, 0.0, 2.0], [1.0, 2.0, 3.0]), "must increase"),
        (([0.0, 1.0], [1.0, 2.0]), "covers 0 s to 1 s, the run 0 s to 2 s"),
        (([0.0, 2.0], [1.0, math.inf]), "not finite"),
    ],
)
def test_senseless_values_are_refused(value: InputValue, words: str) -> None:
    with pytest.raises(UsageProblem, match=words) as caught:
        run({"u": value})
    assert caught.value.codes == ("simulate.input-value",)


def test_function_that_fails_on_the_way_is_named() -> None:
    def failing(time: float) -> float:
        if time > 1.0:
            raise ZeroDivisionError("no more")
        return 1.0

    with pytest.raises(SimulationProblem, match=r"input `u` failed at time 1.*ZeroDivisionError: no more"):
        run({"u": failing})
    with pytest.raises(SimulationProblem, match=r"input `u` returned nan at time 0 s"):
        run({"u": lambda _: math.nan})


TYPED = """model M
  input Boolean on(start = false); input Integer n(start = 0);
  Real x = if on then 1 else n;
end M;"""


@pytest.mark.parametrize(
    ("given", "why"), [({"on": 2}, "neither true nor false"), ({"n": 1.5}, "no whole number")]
)
def test_constants_are_of_the_type_of_the_input(given: dict[str, float], why: str) -> None:
    compiled = acausal.loads(TYPED).compile()
    with pytest.raises(UsageProblem, match=why):
        compiled.simulate(inputs=given)
