"""What a gear shift is like at the output shaft.

T_init and T_f are the means of the output torque before the shift and at its end. Extremes are those of the
stored signal; only the start of its decline is looked for in a smoothed one, so that an oscillating torque
does not hide it. Phases begin and end where the straight lines through what is 2 % and 4 % off would.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from acausal.study.metrics.traces import (
    Trace,
    first_crossing,
    last_crossing,
    settled_since,
    slopes,
    smoothed,
)

BAND = 0.02
"""What counts as settled, as begun and as over."""
_SMOOTHING = 0.03
_BEFORE = 0.1
_END = 0.1
_STANDSTILL = 1.0
_STRAIGHT = 0.05
"""Seconds over which a signal is continued as a straight line at most."""


@dataclass(frozen=True)
class Shift:
    """Figures of one shift; None where a feature is absent. N.m, seconds, N.m/s, per cent.

    `start` and `end` bound the window in which it was looked for.
    """

    start: float
    end: float
    initial_torque: float
    final_torque: float
    oncoming: str | None
    """The element whose slip ends."""
    offgoing: str | None
    """The element whose torque ends."""
    torque_hole: float
    """T_min - T_f, negative; 0 where the torque does not fall below both its initial and its final value."""
    recovery_overshoot: float | None
    """100 (T_os - T_f) / (T_f - T_min); None without hole, 0 where T stays below T_f after the hole."""
    settling_time: float | None
    """From the first T = T_f after the hole, else the start, to T within 2 % of |T_f|, or |T_init| / 10."""
    torque_phase: float | None
    """From the first decline of T to the offgoing element's torque being zero."""
    inertia_phase: float | None
    """From the start of the fall of the oncoming element's slip to zero slip."""
    peak_to_peak_derivative: float
    """Largest less smallest slope of the output torque."""


def shift(
    torque: Trace, slips: Mapping[str, Trace], torques: Mapping[str, Trace], start: float, end: float
) -> Shift:
    """The figures of the shift that begins at `start` and is over before `end`.

    `slips` and `torques` are those of all friction elements by name. Raises ValueError for an empty window.
    """
    if not end > start:
        raise ValueError("a shift needs a window of time")
    window = torque.between(start, end)
    initial = torque.mean(max(start - _BEFORE, float(torque.time[0])), start)
    final = torque.mean(end - _END * (end - start), end)
    size = max(abs(initial), abs(final))
    lowest = int(window.values.argmin())
    deepest = float(window.values[lowest])
    hole = deepest - final if deepest < min(initial, final) - BAND * size else 0.0
    after = window.between(float(window.time[lowest]), end) if hole else window
    begun = first_crossing(after, final, rising=True) if hole else start
    settled = settled_since(window, final, BAND * max(abs(final), 0.1 * size)) if size else start
    if settled is not None and settled > end - _END * (end - start):
        settled = None  # inside the band by chance, at the end of a swing
    oncoming, offgoing = _oncoming(torques, slips, start, end), _offgoing(torques, slips, start, end)
    return Shift(
        start,
        end,
        initial,
        final,
        oncoming,
        offgoing,
        hole,
        100 * max(0.0, float(after.values.max()) - final) / -hole if hole else None,
        None if begun is None or settled is None else max(0.0, settled - begun),
        None
        if offgoing is None
        else _torque_phase(window, torques[offgoing].between(start, end), initial, size),
        None if oncoming is None else _inertia_phase(slips[oncoming].between(start, end)),
        float(np.ptp(slopes(window))) if len(window.time) > 2 else 0.0,
    )


def _torque_phase(torque: Trace, offgoing: Trace, initial: float, size: float) -> float | None:
    calm = smoothed(torque, _SMOOTHING)
    level = initial - BAND * size
    about = first_crossing(calm, level, rising=False)
    # For good: where both elements hold for a while, the torque may pass zero and turn round
    carried = float(offgoing.magnitude.values.max())
    over = settled_since(offgoing, 0.0, BAND * carried)
    if about is None or over is None:
        return None
    sharp = first_crossing(torque, level, rising=False, after=about - _SMOOTHING / 2)
    seen, begun = (calm, about) if sharp is None or sharp > about + _SMOOTHING / 2 else (torque, sharp)
    before = torque.between(float(torque.time[0]), begun)
    swings = float(before.values.max()) > initial + BAND * size / 2
    below = first_crossing(seen, level - BAND * size, rising=False, after=begun)
    declined = max(_reached(None if swings else below, begun), float(torque.time[0]))
    ended = min(_reached(settled_since(offgoing, 0.0, 2 * BAND * carried), over), float(torque.time[-1]))
    return ended - declined if ended >= declined else None


def _inertia_phase(slip: Trace) -> float | None:
    size = slip.magnitude
    largest = float(size.values.max())
    over = first_crossing(size, BAND * largest, rising=False)
    if over is None:
        return None
    begun = last_crossing(size, (1 - BAND) * largest, rising=False, before=over)
    if begun is None:
        return None
    falling = first_crossing(size, (1 - 2 * BAND) * largest, rising=False, after=begun)
    fallen = last_crossing(size, 2 * BAND * largest, rising=False, before=over)
    first = max(_reached(falling, begun), float(slip.time[0]))
    return min(_reached(fallen, over), float(slip.time[-1])) - first


def _reached(twice: float | None, once: float) -> float:
    """Where the line through the instants at which a signal is two bands and one off is not off at all."""
    return once if twice is None else once + max(-_STRAIGHT, min(_STRAIGHT, once - twice))


def _oncoming(
    torques: Mapping[str, Trace], slips: Mapping[str, Trace], start: float, end: float
) -> str | None:
    """The element that slips at first and not at the end; of several the one that carries most on the way.

    What only comes to rest with the others, as an open brake may, carries nothing.
    """
    found: dict[str, tuple[float, float]] = {}
    for name, slip in slips.items():
        before, after = abs(slip.at(start)), abs(slip.mean(end - _END * (end - start), end))
        if before > _STANDSTILL and after < BAND * before:
            carried = torques[name].between(start, end).magnitude.values if name in torques else [0.0]
            found[name] = (float(max(carried)), before)
    return max(found, key=lambda name: found[name], default=None)


def _offgoing(
    torques: Mapping[str, Trace], slips: Mapping[str, Trace], start: float, end: float
) -> str | None:
    """The element that does not slip at first and does at the end; of several the one that carried most."""
    found: dict[str, float] = {}
    for name, slip in slips.items():
        before, after = abs(slip.at(start)), abs(slip.mean(end - _END * (end - start), end))
        if name in torques and after > _STANDSTILL and before < BAND * after:
            found[name] = abs(torques[name].at(start))
    return max(found, key=lambda name: found[name], default=None)
