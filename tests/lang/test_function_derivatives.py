"""Derivatives that a function's author gives are taken where a model is differentiated."""

from __future__ import annotations

import pytest

import acausal
from acausal.errors import AcausalError

MOVE = """
package P
  function position
    input Real q[3]; input Real t; output Real y = q[1];
    annotation(derivative(noDerivative = q) = velocity);
  end position;
  function velocity
    input Real q[3]; input Real t; input Real dt; output Real y = q[2];
    annotation(derivative(noDerivative = q, order = 2) = acceleration);
  end velocity;
  function acceleration
    input Real q[3]; input Real t; input Real dt; input Real ddt; output Real y = q[3];
  end acceleration;
  model Test
    Real x = position({time, 5 * time, 7}, time);
    Real v = der(x);
    Real a = der(v);
  end Test;
end P;
"""

SQUARE = """
package P
  function square
    input Real u; output Real y;
  algorithm
    y := if u > 0 then u * u else 0;
    annotation({annotation});
  end square;
  function slope
    input Real u; input Real du; output Real y = {factor} * u * du;
    annotation(derivative(order = 2) = second);
  end slope;
  function second
    input Real u; input Real du; input Real ddu; output Real y = {factor} * (du * du + u * ddu);
  end second;
  model Test
    Real s(start = 1, fixed = true);
    Real y = square(s);
    Real v = der(y);
    Real a = der(v);
  equation
    der(s) = 1;
  end Test;
end P;
"""


def final(text: str) -> dict[str, float]:
    result = acausal.loads(text, "P.Test").compile().simulate(stop_time=1.0)
    return {name: float(result[name][-1]) for name in ("v", "a")}


def squared(annotation: str, factor: float = 2.0) -> dict[str, float]:
    return final(SQUARE.replace("{annotation}", annotation).replace("{factor}", str(factor)))


def test_the_given_derivatives_are_taken_twice() -> None:
    assert final(MOVE) == {"v": 5.0, "a": 7.0}


def test_orders_of_the_chain_rule() -> None:
    """The second derivative gets the second derivatives of the inputs: s'' = 0, s' = 1."""
    assert squared("derivative = slope") == pytest.approx({"v": 4.0, "a": 2.0})
    assert squared("derivative = slope", 3.0) == pytest.approx({"v": 6.0, "a": 3.0})


def test_zero_derivative_applies_to_what_is_constant_only() -> None:
    """`u` moves, so that the annotation does not apply, and the body jumps for all that is known."""
    assert squared("derivative(zeroDerivative = u) = slope, smoothOrder = 2") == pytest.approx(
        {"v": 4.0, "a": 2.0}
    )


def test_smooth_order_vouches_for_the_body() -> None:
    assert squared("smoothOrder = 2") == pytest.approx({"v": 4.0, "a": 2.0})


def test_a_derivative_with_other_inputs_is_not_used_but_said() -> None:
    text = SQUARE.replace("{annotation}", "derivative = square, smoothOrder = 2").replace("{factor}", "2")
    compiled = acausal.loads(text, "P.Test").compile()
    assert "function.derivative" in [d.code for d in compiled.compilation.warnings]


def test_without_annotation_a_jump_is_refused() -> None:
    text = (
        SQUARE.replace("annotation({annotation});", "").replace("{factor}", "2").replace("else 0", "else 1")
    )
    with pytest.raises(AcausalError) as problem:
        acausal.loads(text, "P.Test").compile()
    assert "reduction.not-differentiable" in problem.value.codes
