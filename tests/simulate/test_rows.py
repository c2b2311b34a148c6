"""Rows of a result, where there are so many that they come in portions."""

from __future__ import annotations

import numpy as np

import acausal

RAMP = """
model Ramp "steps are as long as from event to event"
  Real x(start = 0, fixed = true), y = 2*x;
  discrete Real z(start = 0, fixed = true);
equation
  der(x) = if time < 8 then 1 else 2;
  when time >= 9 then
    z = 1;
  end when;
end Ramp;
"""


def test_rows_come_in_order_across_events() -> None:
    run = acausal.loads(RAMP).compile().simulate(stop_time=10.0, interval=5e-5)
    assert len(run.time) > 200_000
    assert (np.diff(run.time) >= 0).all()
    assert np.abs(run.values("x") - np.where(run.time < 8, run.time, 2 * run.time - 8)).max() < 1e-9
