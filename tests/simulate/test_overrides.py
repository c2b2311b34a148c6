"""What a run may change without compiling again, and that nothing else is ignored silently."""

from __future__ import annotations

import pytest

import acausal
from acausal.codegen.functions import Code
from acausal.errors import LookupProblem, UsageProblem
from acausal.simulate.initialize import initialize
from acausal.simulate.simulate import simulate
from acausal.symbolic.causal import BlockKind


def code(text: str) -> Code:
    return acausal.loads(text).compile().code


TORN = """
model Torn "y starts inside a torn block: x and y are tied to each other and to y's start value"
  Real x, y(start = 2, fixed = true), z(start = 1);
equation
  der(x) = -z;
  y = x + z;
  z * z + z * x = 3;
end Torn;
"""


def test_start_value_in_a_torn_initial_block_can_be_changed() -> None:
    compiled = code(TORN)
    assert any(
        block.tearing and block.kind is BlockKind.NONLINEAR for block in compiled.system.initial.blocks
    )
    for start in (2.0, 5.0):
        result = simulate(compiled, stop_time=0.0, start={"y": start})
        final = result.final(["x", "y", "z"])
        assert final["y"] == pytest.approx(start, rel=1e-9)
        assert final["z"] * final["z"] + final["z"] * final["x"] == pytest.approx(3.0)


def test_start_value_that_became_a_check_is_checked_as_changed() -> None:
    compiled = code(
        """
        model Redundant
          Real x(start = 1, fixed = true), y(start = 2, fixed = true);
        equation
          der(x) = -x;
          y = 2 * x + 0 * time;
        end Redundant;
        """
    )
    initialize(compiled, 0.0)
    initialize(compiled, 0.0, start={"x": 3.0, "y": 6.0})
    with pytest.raises(acausal.AcausalError):
        initialize(compiled, 0.0, start={"x": 3.0})


def test_start_value_that_the_initial_equations_determine_is_not_open() -> None:
    compiled = code(
        """
        model Free
          parameter Real p(start = 1, fixed = false);
          Real x(start = p, fixed = true);
        equation
          der(x) = p - x * x;
        initial equation
          der(x) = -2;
        end Free;
        """
    )
    point = initialize(compiled, 0.0)
    p = point.evaluator.p[0]
    assert p - p * p == pytest.approx(-2.0)
    assert point.x == pytest.approx([p])
    with pytest.raises(UsageProblem, match=r"start value of `x` is `p`") as caught:
        initialize(compiled, 0.0, start={"x": 1.0})
    assert caught.value.codes == ("simulate.closed-start",)
    with pytest.raises(UsageProblem, match="initial equations"):
        initialize(compiled, 0.0, {"p": 1.0})


def test_parameter_computed_from_one_that_is_determined_follows_it() -> None:
    text = """
    model Chained
      parameter Real p(start = 1, fixed = false), twice = 2 * p;
      Real x(start = 1, fixed = true);
    equation
      der(x) = twice - x;
    initial equation
      der(x) = 0;
    end Chained;
    """
    point = initialize(code(text), 0.0)
    names = point.evaluator.code.system.parameters
    assert dict(zip(names, point.evaluator.p.tolist(), strict=True)) == {"p": 0.5, "twice": 1.0}


def test_start_of_an_alias_says_where_to_change_it() -> None:
    compiled = code(
        "model A Real x(start = 1, fixed = true), y; equation der(x) = -x; y = -x; end A;",
    )
    with pytest.raises(LookupProblem, match="`y` equals `-x`"):
        initialize(compiled, 0.0, start={"y": 1.0})


KINDS = """
package P
  type Mode = enumeration(closed, half, open);
  model Kinds
    parameter Integer n = 2;
    parameter Boolean on = false;
    parameter Mode mode = Mode.half;
    parameter Integer size = 3;
    final parameter Real fixed_one = 1;
    constant Real c = 4;
    parameter Real a = 2;
    Real v[size];
    Real x(start = 0, fixed = true);
    Real level;
  equation
    level = if mode == Mode.closed then 0 elseif mode == Mode.half then 0.5 else 1;
    for i in 1:size loop
      v[i] = i * time;
    end for;
    der(x) = n * (if on then 1 else -1) * a * fixed_one * c * level;
  end Kinds;
end P;
"""


def slope(**parameters: float | bool | str) -> float:
    compiled = acausal.loads(KINDS, "P.Kinds").compile().code
    return simulate(compiled, parameters=parameters, rtol=1e-9).final(["x"])["x"]


def test_every_type_of_parameter_can_be_changed() -> None:
    assert slope() == pytest.approx(-8.0)
    assert slope(n=3) == pytest.approx(-12.0)
    assert slope(on=True) == pytest.approx(8.0)
    assert slope(mode="open") == slope(mode="P.Mode.open") == slope(mode=3) == pytest.approx(-16.0)
    assert slope(mode="closed") == pytest.approx(0.0)


@pytest.mark.parametrize(
    ("name", "value", "code_", "words"),
    [
        ("size", 4, "simulate.fixed-parameter", r"structural.*(\n.*)*compile"),
        ("fixed_one", 2.0, "simulate.fixed-parameter", "final"),
        ("c", 2.0, "simulate.fixed-parameter", "constant"),
        ("n", 2.5, "simulate.parameter-type", "whole number"),
        ("n", True, "simulate.parameter-type", "a number"),
        ("on", 2.0, "simulate.parameter-type", "True or False"),
        ("mode", "ajar", "simulate.parameter-type", "closed, half, open"),
        ("mode", 4, "simulate.parameter-type", "closed, half, open"),
        ("a", "2", "simulate.parameter-type", "a number"),
    ],
)
def test_what_cannot_be_changed_is_refused_by_name(
    name: str, value: float | bool | str, code_: str, words: str
) -> None:
    with pytest.raises(UsageProblem, match=words) as caught:
        slope(**{name: value})
    assert caught.value.codes == (code_,)
    assert caught.value.diagnostics[0].names == (name,)


def test_names_that_are_no_parameters() -> None:
    with pytest.raises(LookupProblem, match="did you mean"):
        slope(fixed_on=1.0)
    with pytest.raises(LookupProblem, match="start="):
        slope(x=1.0)
