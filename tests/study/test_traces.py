"""Features of constructed signals."""

from __future__ import annotations

import numpy as np
import pytest

from acausal.study.metrics.traces import Trace, first_crossing, last_crossing, settled_since, slopes, smoothed


def trace(*points: tuple[float, float]) -> Trace:
    time, values = zip(*points, strict=True)
    return Trace(np.array(time, float), np.array(values, float))


ZIGZAG = trace((0, 0), (1, 2), (2, 0), (3, 4), (4, 1))


def test_crossings_are_interpolated() -> None:
    assert first_crossing(ZIGZAG, 1, rising=True) == pytest.approx(0.5)
    assert first_crossing(ZIGZAG, 1, rising=True, after=1) == pytest.approx(2.25)
    assert first_crossing(ZIGZAG, 1, rising=False) == pytest.approx(1.5)
    assert last_crossing(ZIGZAG, 1, rising=True) == pytest.approx(2.25)
    assert last_crossing(ZIGZAG, 2, rising=False, before=3) is None
    assert first_crossing(ZIGZAG, 5, rising=True) is None


def test_both_sides_of_an_event() -> None:
    jump = trace((0, 0), (1, 0), (1, 2), (2, 2))
    assert first_crossing(jump, 1, rising=True) == 1
    assert slopes(jump).tolist() == [0, 0]


def test_settled_since() -> None:
    assert settled_since(ZIGZAG, 2, 0.5) is None
    assert settled_since(trace((0, 0), (1, 4), (2, 2), (3, 2.1)), 2, 0.5) == pytest.approx(1.75)
    assert settled_since(trace((0, 2), (3, 2.1)), 2, 0.5) == 0


def test_part_and_mean() -> None:
    part = ZIGZAG.between(0.5, 1.5)
    assert part.values.tolist() == [1, 2, 1]
    assert ZIGZAG.mean(0.5, 1.5) == pytest.approx(1.5)


def test_smoothing_keeps_lines_and_removes_swings() -> None:
    time = np.linspace(0, 1, 1001)
    np.testing.assert_allclose(smoothed(Trace(time, 3 * time), 0.1).values, 3 * time, atol=1e-12)
    swinging = smoothed(Trace(time, np.sin(2 * np.pi * 50 * time)), 0.1)
    assert np.abs(swinging.values[100:-100]).max() < 1e-3


def test_a_trace_must_make_sense() -> None:
    with pytest.raises(ValueError, match="fall"):
        trace((1, 0), (0, 1))
    with pytest.raises(ValueError, match="as many"):
        Trace(np.zeros(2), np.zeros(3))
