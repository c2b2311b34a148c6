"""The contact law: never pulling, linear at rest, and the same impact at every speed."""

from __future__ import annotations

import numpy as np
import pytest

import acausal

IMPACT = """
model Impact "A mass against a damped spring"
  parameter Real v_0 = 1 "Speed before";
  parameter Real d = 1000 "Damping";
  Real s(start = 0, fixed = true, nominal = v_0*1e-5);
  Real v(start = v_0, fixed = true, nominal = v_0);
  Real f;
equation
  v = der(s);
  0.025*der(v) = -f;
  f = Mechanics.Functions.elasticContact(s, v, 4e8, d);
end Impact;
"""


def test_an_impact_loses_the_same_share_at_every_speed() -> None:
    compiled = acausal.loads(IMPACT).compile()
    ratios: list[float] = []
    for speed in (1e-3, 1.0, 10.0):
        run = compiled.simulate(parameters={"v_0": speed}, stop_time=5e-5, solver="rodas", rtol=1e-8)
        assert run.values("f").min() >= 0.0
        ratios.append(-float(run.values("v")[-1]) / speed)
    assert ratios == pytest.approx([ratios[0]] * 3, rel=1e-5)
    assert 0.3 < ratios[0] < 0.8
    free = compiled.simulate(parameters={"d": 0.0}, stop_time=5e-5, rtol=1e-8)
    assert float(free.values("v")[-1]) == pytest.approx(-1.0, rel=1e-5)


def test_small_rates_are_damped_linearly() -> None:
    """The force of a steady approach, slow for its penetration, is that of spring and damper."""
    text = """
    model Approach
      Real f = Mechanics.Functions.elasticContact(1e-5 + 1e-4*time, 1e-4, 4e8, 1000);
      Real t = Mechanics.Functions.backlashTorque(-1e-3 - 1e-3*time, -1e-3, 1e-3, 1e4, 1);
    end Approach;
    """
    run = acausal.loads(text).compile().simulate(stop_time=1.0)
    assert run.values("f") == pytest.approx(4e8 * (1e-5 + 1e-4 * run.time) + 0.1, rel=1e-8)
    expected = -1e4 * (0.5e-3 + 1e-3 * run.time) - 1e-3
    assert np.abs(run.values("t") - expected).max() < 1e-10
