"""Whether a signal stays in a tube around another one.

The tube of a reference has the half width `0.002 * (largest - smallest value)`, with room for the rounding of
what is constant. Near events, of either side, it also reaches over everything that the other signal has
within a short time: an event may come so much earlier or later. Elsewhere time is exact.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]

SHARE = 2e-3
"""Half width of the tube, of the reference's range."""
SHIFT = 2e-3
"""Seconds that an event may be off; a run shorter than a second has this share of its length."""
_ROUNDING = 1e-6
"""Of the largest value: what a constant may differ by."""
_NOTHING = 1e-9
"""What a signal that is zero may differ by."""


@dataclass(frozen=True, eq=False)
class Curve:
    """A signal over instants that do not fall; an instant that comes twice is an event."""

    time: Vector
    values: Vector

    @property
    def events(self) -> Vector:
        return self.time[1:][np.diff(self.time) <= 0]


@dataclass(frozen=True)
class Deviation:
    """Where a signal is farthest outside of its tube, in units of the tube's half width."""

    time: float
    expected: float
    found: float
    widths: float


def deviation(reference: Curve, found: Curve) -> Deviation | None:
    """The worst place outside of the tube, None if there is none.

    All points of `found` are looked at, and those of the reference that are not near an event: what a
    reference shows for less than the shift, as the passes of an event iteration, need not be there.
    """
    start = max(reference.time[0], found.time[0])
    end = min(reference.time[-1], found.time[-1])
    span = float(reference.time[-1] - reference.time[0])
    if end - start < (1 - 1e-6) * span:
        return Deviation(float(end), float(reference.values[-1]), float("nan"), float("inf"))
    tube = _Tube(half_width(reference.values), SHIFT * min(1.0, span), _events(reference, found))
    back = _clip(found, reference.time[0], reference.time[-1])
    worst = tube.farthest(back, reference, everywhere=True)
    other = tube.farthest(reference, found, everywhere=False)
    if other is not None and (worst is None or other.widths > worst.widths):
        worst = Deviation(other.time, other.found, other.expected, other.widths)
    return worst


def half_width(values: Vector) -> float:
    """Half the height of the tube around a signal."""
    span = float(values.max() - values.min())
    return SHARE * span + _ROUNDING * float(np.abs(values).max()) + _NOTHING


def _events(*curves: Curve) -> Vector:
    return np.unique(np.concatenate([curve.events for curve in curves]))


def _clip(curve: Curve, start: float, end: float) -> Curve:
    inside = (curve.time >= start) & (curve.time <= end)
    return Curve(curve.time[inside], curve.values[inside])


@dataclass(frozen=True, eq=False)
class _Tube:
    width: float
    shift: float
    events: Vector

    def farthest(self, points: Curve, line: Curve, *, everywhere: bool) -> Deviation | None:
        """The point that is farthest from `line`, of all or of those that are not near an event."""
        near = self._near(points.time)
        low, high = _reach(line, points.time, np.where(near, self.shift, 0.0))
        off = np.maximum(low - points.values, points.values - high) / self.width
        if not everywhere:
            off[near] = 0.0
        worst = int(np.argmax(np.nan_to_num(off, nan=np.inf)))
        if off[worst] <= 1.0:
            return None
        value = float(points.values[worst])
        nearest = float(np.clip(value, low[worst], high[worst]))
        return Deviation(float(points.time[worst]), nearest, value, float(off[worst]))

    def _near(self, time: Vector) -> NDArray[np.bool_]:
        """Which instants are close to an event."""
        if not len(self.events):
            return np.zeros(len(time), dtype=np.bool_)
        after = np.searchsorted(self.events, time)
        left = self.events[np.maximum(after - 1, 0)]
        right = self.events[np.minimum(after, len(self.events) - 1)]
        return (np.abs(time - left) <= self.shift) | (np.abs(time - right) <= self.shift)


def _reach(line: Curve, time: Vector, around: Vector) -> tuple[Vector, Vector]:
    """The smallest and the largest value of `line` in `time` plus and minus `around`, both sides of events.

    Between two points it has any value between theirs.
    """
    first = np.searchsorted(line.time, time - around, side="left")
    last = np.searchsorted(line.time, time + around, side="right")
    before = np.clip(np.searchsorted(line.time, time, side="right") - 1, 0, len(line.time) - 1)
    after = np.clip(np.searchsorted(line.time, time, side="left"), 0, len(line.time) - 1)
    ends = [np.interp(time + side * around, line.time, line.values) for side in (-1, 1)]
    ends += [line.values[before], line.values[after]]
    low, high = np.min(ends, axis=0), np.max(ends, axis=0)
    for i in np.flatnonzero(last > first):
        part = line.values[first[i] : last[i]]
        low[i], high[i] = min(low[i], part.min()), max(high[i], part.max())
    return low, high
