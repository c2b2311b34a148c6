"""Crossings right after a restart: interpolation in a long step says little about what settles fast."""

from __future__ import annotations

import acausal

FOLLOWER = """
model Follower "Counts where u turns round, as seen by x, which follows it within microseconds"
  parameter Real w = 13;
  Real u = 2*sin(w*time)*(time - 0.5)*sin(3*time);
  Real x;
  Real y(start = 1, fixed = true);
  discrete Integer n(start = 0, fixed = true);
initial equation
  x = u;
equation
  der(y) = 20*cos(20*time) - y;
  der(x) = (u - x)/1e-6;
  when {u <= x, u >= x} then
    n = pre(n) + 1;
  end when;
end Follower;
"""


def test_fast_follower_gets_to_its_end() -> None:
    """Below the tolerance the sign of u - x is noise: looked at with long steps, it changed for ever."""
    compiled = acausal.loads(FOLLOWER).compile()
    for w in (5 + 55 * i / 39 for i in (5, 18, 28, 37)):
        result = compiled.simulate(stop_time=2.0, parameters={"w": w})
        assert result.time[-1] == 2.0
        assert result.values("n")[-1] >= 2.0 * w / 3.2
