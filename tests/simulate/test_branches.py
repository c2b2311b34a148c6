"""Blocks with several solutions keep to theirs until it ends, though no event says so."""

from __future__ import annotations

import math

import numpy as np
import pytest

import acausal

FLIP = """
model Flip "an amplifier with positive feedback: high, low, or unstable between both"
  Real x(start = 1, fixed = true), y(start = -15);
equation
  y = smooth(0, noEvent(if 15000*(y/2 - x) > 15 then 15 else if 15000*(y/2 - x) < -15 then -15
    else 15000*(y/2 - x)));
  der(x) = 22*(y - x);
end Flip;
"""


def test_a_refused_step_does_not_choose_the_branch() -> None:
    """x falls from 1 towards -15 and turns where the low branch ends, at x = -7.5 + 1e-3."""
    result = acausal.loads(FLIP).compile().simulate(stop_time=0.05, interval=1e-4, solver="rodas")
    jumps = np.flatnonzero(np.abs(np.diff(result.values("y"))) > 20)
    assert len(jumps) == 1
    assert result.time[jumps[0]] == pytest.approx(math.log(16 / (15 - 7.5 + 1e-3)) / 22, abs=2e-4)
