"""Whether a signal stays in a tube around another one.

The tube of a reference has the half width `0.002 * (largest - smallest value)`, with room for the rounding of
what is constant. Both are compared at the points of the reference. Near events, of either side, the tube also
reaches over everything that the other signal has within a short time: an event may come so much earlier or
later. Elsewhere time is exact. Jumps of the signal have to be jumps of the reference, too, unless this may
have them just after its end; the other way round, what a reference shows for less than that time, as the
passes of an event iteration, need not be there.
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
    """The worst place outside of the tube, None if there is none."""
    start = max(reference.time[0], found.time[0])
    end = min(reference.time[-1], found.time[-1])
    span = float(reference.time[-1] - reference.time[0])
    if end - start < (1 - 1e-6) * span:
        return Deviation(float(end), float(reference.values[-1]), float("nan"), float("inf"))
    width, shift = half_width(reference.values), SHIFT * min(1.0, span)
    events = np.unique(np.concatenate([reference.events, found.events]))
    expected = _off(reference, found, events, shift) / width
    expected[expected > 1.0] *= ~_is_short(reference, found, shift, width)[expected > 1.0]
    jumps = _before(_jumps(found, width), end - shift)
    own = _off(jumps, reference, events, shift) / width
    worst, at_jump = int(np.argmax(expected)), int(np.argmax(own)) if len(own) else -1
    if at_jump >= 0 and own[at_jump] > max(1.0, expected[worst]):
        time, value = float(jumps.time[at_jump]), float(jumps.values[at_jump])
        return Deviation(time, _value(reference, time), value, float(own[at_jump]))
    if expected[worst] > 1.0:
        time, value = float(reference.time[worst]), float(reference.values[worst])
        return Deviation(time, value, _value(found, time), float(expected[worst]))
    return None


def half_width(values: Vector) -> float:
    """Half the height of the tube around a signal."""
    span = float(values.max() - values.min())
    return SHARE * span + _ROUNDING * float(np.abs(values).max()) + _NOTHING


def _value(curve: Curve, time: float) -> float:
    return float(np.interp(time, curve.time, curve.values))


def _jumps(curve: Curve, width: float) -> Curve:
    """Both sides of the curve's jumps that are higher than `width`."""
    after = np.flatnonzero((np.diff(curve.time) <= 0) & ~(np.abs(np.diff(curve.values)) <= width))
    which = np.unique(np.concatenate([after, after + 1]))
    return Curve(curve.time[which], curve.values[which])


def _before(curve: Curve, time: float) -> Curve:
    """The part of a curve until `time`."""
    kept = curve.time <= time
    return Curve(curve.time[kept], curve.values[kept])


def _off(points: Curve, line: Curve, events: Vector, shift: float) -> Vector:
    """How far each of `points` is from what `line` has there, or near events about there."""
    low, high = _reach(line, points.time, np.where(_near(events, points.time, shift), shift, 0.0))
    off = np.maximum(low - points.values, points.values - high)
    return np.nan_to_num(np.maximum(off, 0.0), nan=np.inf)


def _is_short(reference: Curve, found: Curve, shift: float, width: float) -> NDArray[np.bool_]:
    """Where the reference is with the other signal again within the shift, on both sides."""
    around = np.full(len(reference.time), shift)
    low, high = _reach(found, reference.time, around)
    fine = np.ones(len(reference.time), dtype=np.bool_)
    for side in (-shift, shift):
        then = reference.time + side
        near = np.interp(then, reference.time, reference.values)
        fine &= ((near >= low - width) & (near <= high + width)) | (then < reference.time[0])
    return fine & _near(reference.events, reference.time, shift)


def _near(events: Vector, time: Vector, shift: float) -> NDArray[np.bool_]:
    """Which instants are close to an event."""
    if not len(events):
        return np.zeros(len(time), dtype=np.bool_)
    after = np.searchsorted(events, time)
    left, right = events[np.maximum(after - 1, 0)], events[np.minimum(after, len(events) - 1)]
    return (np.abs(time - left) <= shift) | (np.abs(time - right) <= shift)


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
