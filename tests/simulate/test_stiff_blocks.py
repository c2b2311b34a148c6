"""Blocks with exponentials: what a refused step found far ahead must not mislead Newton's method for good."""

from __future__ import annotations

import pytest

import acausal

CLIPPER = """
model Clipper "A diode that breaks through backwards, before a capacitor and a conductor"
  parameter Real R = 1000;
  parameter Real C = 1e-7;
  parameter Real w = 314;
  Real s = 10*sin(w*time);
  Real u;
  Real i;
  Real v(start = 0, fixed = true);
equation
  i = smooth(1, if u > 30*0.04 then 1e-6*(exp(30)*(1 + u/0.04 - 30) - 1) + u/1e8
    else if u + 5.1 < -30*0.03 then -1e-6 - 0.7*exp(30)*(1 - (u + 5.1)/0.03 - 30) + u/1e8
    else 1e-6*(exp(u/0.04) - 1) - 0.7*exp(-(u + 5.1)/0.03) + u/1e8);
  (s - u - v)/R = i;
  C*der(v) = i - v*1e-3;
end Clipper;
"""


@pytest.fixture(scope="module")
def clipper() -> acausal.CompiledModel:
    return acausal.loads(CLIPPER).compile()


@pytest.mark.parametrize(
    ("resistance", "capacity", "w"), [(1, 1e-9, 314), (10, 1e-3, 3000), (1000, 1e-9, 3000), (100, 1e-3, 314)]
)
def test_clipper_runs_through(
    clipper: acausal.CompiledModel, resistance: float, capacity: float, w: float
) -> None:
    given = {"R": resistance, "C": capacity, "w": w}
    result = clipper.simulate(stop_time=0.02, parameters=given)
    assert result.time[-1] == 0.02
    s, u, v, i = (result.values(name) for name in ("s", "u", "v", "i"))
    assert (s - u - v) / resistance == pytest.approx(i, abs=1e-6 * float(abs(i).max()))
