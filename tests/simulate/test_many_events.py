"""Thousands of events: none missed, none doubled; and the same bytes from one or two workers."""

from __future__ import annotations

import multiprocessing
from hashlib import sha256

import numpy as np
import pytest

import acausal

TURNING = """
model Turning "Counts the half turns of a shaft from the sign of a sine, up and down"
  Real phi(start = 0.5, fixed = true);
  Boolean up = sin(phi) > 0;
  discrete Integer n(start = 0, fixed = true);
  discrete Real last(start = 0, fixed = true);
equation
  der(phi) = 40;
  when {up, not up} then
    n = pre(n) + 1;
    last = time;
  end when;
end Turning;
"""
BALL = """
model Ball
  Real h(start = 1, fixed = true), v(start = 0, fixed = true);
equation
  der(h) = v;
  der(v) = -9.81;
  when h < 0 then
    reinit(v, -0.8*pre(v));
  end when;
end Ball;
"""


@pytest.mark.slow
def test_ten_thousand_events_are_found_once_each() -> None:
    turns = 10_000
    stop = ((turns + 0.5) * np.pi - 0.5) / 40
    result = acausal.loads(TURNING).compile().simulate(stop_time=stop, interval=0.02)
    n, last = result.values("n"), result.values("last")
    assert result.statistics.events == turns
    assert n[-1] == turns
    jumps = np.flatnonzero(np.diff(n))
    assert np.diff(n)[jumps].tolist() == [1.0] * turns
    exact = (np.arange(1, turns + 1) * np.pi - 0.5) / 40
    assert last[jumps + 1] == pytest.approx(exact, abs=1e-9)
    assert result.time[jumps] == pytest.approx(last[jumps + 1], abs=0.0)


def digest(stop: float) -> str:
    """Of the bytes of one run."""
    result = acausal.loads(BALL).compile().simulate(stop_time=stop)
    return sha256(result.time.tobytes() + result.data.tobytes()).hexdigest()


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="needs fork")
def test_workers_make_no_difference() -> None:
    stops = [0.9, 1.7]
    alone = [digest(stop) for stop in stops]
    for workers in (1, 2):
        with multiprocessing.get_context("fork").Pool(workers) as pool:
            assert pool.map(digest, stops) == alone
