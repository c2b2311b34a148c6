"""Index reduction differentiates a call by the derivatives that its function is annotated with."""

from __future__ import annotations

import pytest

import acausal

TEXT = """package Motion
  function track "x^2 above 2, its tangent below"
    input Real x;
    output Real y;
  algorithm
    y := if x > 2 then x^2 else 4 * x - 4;
    annotation(derivative = speed);
  end track;
  function speed
    input Real x, dx;
    output Real dy;
  algorithm
    dy := {factor} * (if x > 2 then 2 * x else 4) * dx;
    annotation(derivative(order = 2) = acceleration);
  end speed;
  function acceleration
    input Real x, dx, ddx;
    output Real ddy;
  algorithm
    ddy := {factor} * (if x > 2 then 2 * dx^2 + 2 * x * ddx else 4 * ddx);
  end acceleration;
  model Mass "A mass whose position is prescribed through the function"
    parameter Real T(unit = "s") = 1;
    Real t, u, s, v, F;
  equation
    t = time / T;
    u = 1 + t + t^3;
    s = track(u);
    v = der(s);
    F = der(v);
  end Mass;
end Motion;"""


@pytest.mark.parametrize("factor", [1, 3])
def test_a_prescribed_motion_uses_them_twice(factor: int) -> None:
    """At t = 2: 11, 13 and 12 for u and its derivatives; a wrong factor shows that they are used."""
    compiled = acausal.loads(TEXT.format(factor=factor), "Motion.Mass").compile()
    assert (compiled.index, compiled.states) == (3, ())
    final = compiled.simulate(stop_time=2).final(["s", "v", "F"])
    assert final["s"] == pytest.approx(121)
    assert final["v"] == pytest.approx(factor * 22 * 13)
    assert final["F"] == pytest.approx(factor * (2 * 169 + 22 * 12))
