"""Features of one signal over time: where it crosses a level, where it has settled, how steep it is.

Signals are stored at rising instants, both sides of an event at the same one. Crossings are interpolated
linearly. A feature that is not there is None.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Trace:
    """A signal: instants in seconds, not falling, and as many values."""

    time: Vector
    values: Vector

    def __post_init__(self) -> None:
        if self.time.shape != self.values.shape or self.time.ndim != 1 or not len(self.time):
            raise ValueError("a trace needs as many values as instants, and at least one")
        if (np.diff(self.time) < 0).any():
            raise ValueError("the instants of a trace must not fall")

    def between(self, start: float, end: float) -> Trace:
        """The part from `start` to `end`, both included; its end points are interpolated."""
        inside = (self.time > start) & (self.time < end)
        time = np.concatenate([[start], self.time[inside], [end]])
        values = np.concatenate([[self.at(start)], self.values[inside], [self.at(end)]])
        return Trace(time, values)

    def at(self, time: float) -> float:
        """The value at an instant; the nearest end's outside."""
        return float(np.interp(time, self.time, self.values))

    @property
    def magnitude(self) -> Trace:
        return Trace(self.time, np.abs(self.values))

    def mean(self, start: float, end: float) -> float:
        """The mean over time from `start` to `end`."""
        part = self.between(start, end)
        if end <= start:
            return part.values[0]
        return float(np.trapezoid(part.values, part.time) / (end - start))


def first_crossing(trace: Trace, level: float, rising: bool, after: float = -np.inf) -> float | None:
    """The first instant after `after` at which the signal comes to `level` from below (or from above)."""
    y = trace.values - level if rising else level - trace.values
    for i in np.flatnonzero((y[:-1] < 0) & (y[1:] >= 0)):
        share = y[i] / (y[i] - y[i + 1])
        when = float(trace.time[i] + share * (trace.time[i + 1] - trace.time[i]))
        if when >= after:
            return when
    return None


def last_crossing(trace: Trace, level: float, rising: bool, before: float = np.inf) -> float | None:
    """The last instant before `before` at which the signal comes to `level` from below (or from above)."""
    y = trace.values - level if rising else level - trace.values
    for i in np.flatnonzero((y[:-1] < 0) & (y[1:] >= 0))[::-1]:
        share = y[i] / (y[i] - y[i + 1])
        when = float(trace.time[i] + share * (trace.time[i + 1] - trace.time[i]))
        if when <= before:
            return when
    return None


def settled_since(trace: Trace, final: float, band: float) -> float | None:
    """The instant from which on the signal is within `band` of `final`; None if it is not at the end."""
    outside = np.flatnonzero(np.abs(trace.values - final) > band)
    if not len(outside):
        return float(trace.time[0])
    last = int(outside[-1])
    if last + 1 == len(trace.values):
        return None
    edge = final + band if trace.values[last] > final else final - band
    share = (edge - trace.values[last]) / (trace.values[last + 1] - trace.values[last])
    return float(trace.time[last] + share * (trace.time[last + 1] - trace.time[last]))


def smoothed(trace: Trace, width: float) -> Trace:
    """The mean over a window of `width` seconds about each instant, narrower towards the ends."""
    time = trace.time
    integral = np.concatenate([[0.0], np.cumsum(np.diff(time) * (trace.values[1:] + trace.values[:-1]) / 2)])
    half = np.minimum(width / 2, np.minimum(time - time[0], time[-1] - time))
    left, right = time - half, time + half
    mean = np.array(trace.values)
    wide = right > left
    areas = _integral_at(trace, integral, right) - _integral_at(trace, integral, left)
    mean[wide] = areas[wide] / (right - left)[wide]
    return Trace(time, mean)


def _integral_at(trace: Trace, integral: Vector, when: Vector) -> Vector:
    """The integral of the piecewise linear signal from its start."""
    i = np.clip(np.searchsorted(trace.time, when, side="right") - 1, 0, len(trace.time) - 2)
    step = when - trace.time[i]
    values = np.interp(when, trace.time, trace.values)
    return integral[i] + step * (trace.values[i] + values) / 2


def slopes(trace: Trace) -> Vector:
    """The slope of every interval that is not an event (signal per second)."""
    steps = np.diff(trace.time)
    real = steps > 1e-9 * max(1.0, float(abs(trace.time[-1])))
    return np.diff(trace.values)[real] / steps[real]
