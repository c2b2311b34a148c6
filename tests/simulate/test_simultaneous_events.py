"""What crosses at the very instant of another event is not lost, and is not undone by what it turns round."""

from __future__ import annotations

import numpy as np
import pytest

import acausal

SAMPLED = """
model Sampled "Turns round at x = 1, which it reaches at a sample now and then"
  Real x(start = 0, fixed = true);
  Boolean up(start = true, fixed = true);
  Integer n(start = 0, fixed = true), k(start = 0, fixed = true);
equation
  der(x) = if up then 1 else -2;
  when {x > 1, x < 0} then
    up = not pre(up);
    n = pre(n) + 1;
  end when;
  when sample(0.05, 0.13) then
    k = pre(k) + 1;
  end when;
end Sampled;
"""
TOGETHER = """
model Together "Two that turn round at the same instants, every second time"
  Real x(start = 0, fixed = true), y(start = 0, fixed = true);
  Boolean up(start = true, fixed = true), high(start = true, fixed = true);
  Integer n(start = 0, fixed = true), k(start = 0, fixed = true);
equation
  der(x) = if up then 1 else -1;
  der(y) = if high then 2 else -2;
  when {x > 1, x < 0} then
    up = not pre(up);
    n = pre(n) + 1;
  end when;
  when {y > 1, y < 0} then
    high = not pre(high);
    k = pre(k) + 1;
  end when;
end Together;
"""


@pytest.mark.parametrize("solver", ["auto", "cvode", "heun"])
def test_a_crossing_at_a_sample(solver: str) -> None:
    run = acausal.loads(SAMPLED).compile().simulate(stop_time=9.7, interval=0.05, solver=solver, step=0.01)
    n, k = run.values("n"), run.values("k")
    assert (n[-1], k[-1]) == (12.0, 75.0)
    assert set(np.diff(n)) <= {0.0, 1.0}
    for counter in (n, k):  # both at once
        assert np.abs(run.time[:-1][np.diff(counter) > 0] - 8.5).min() < 1e-9
    assert run.values("x").max() < 1.0 + 1e-6


@pytest.mark.parametrize("solver", ["auto", "cvode", "heun"])
def test_two_crossings_at_once(solver: str) -> None:
    run = acausal.loads(TOGETHER).compile().simulate(stop_time=20.25, interval=0.05, solver=solver, step=0.01)
    assert (run.values("n")[-1], run.values("k")[-1]) == (20.0, 40.0)
    assert max(np.abs(run.values(name) - 0.5).max() for name in "xy") < 0.5 + 1e-6
