"""How a clutch's pressure follows its command.

All times count from the command passing 2 % of its change, all shares are of the change from the initial to
the final pressure, which are means over the first and last twentieth of the window.
"""

from __future__ import annotations

from dataclasses import dataclass

from acausal.study.metrics.traces import Trace, first_crossing

THRESHOLD = 0.02
_ENDS = 0.05
_ROUNDING = 1e-6


@dataclass(frozen=True)
class Engagement:
    """Figures of one pressure trace; None where a feature is absent. Pa and seconds."""

    initial: float
    final: float
    delay: float | None
    """From the command passing 2 % to the pressure passing 2 %."""
    rise: float | None
    """From the pressure passing 2 % to it reaching its final value; to 98 % where it creeps there: where the
    last 2 % take longer than all before."""
    corner_time: float | None
    """From the pressure passing 2 % to the piston reaching its stop, on its way up or, where the pressure
    falls, down."""
    corner_pressure: float | None
    """What the pressure has risen by until then."""
    overshoot: float | None
    """100 (p_peak - p_f) / (p_f - p_init) in per cent; 0 where the pressure never exceeds its final value."""


def engagement(
    command: Trace, pressure: Trace, piston: Trace | None = None, stop: float | None = None
) -> Engagement:
    """The figures of a rising or falling pressure; `piston` reaches its end stop at position `stop`."""
    initial, final = _ends(pressure)
    change = final - initial
    if abs(change) <= 1e-9 * max(abs(initial), abs(final), 1.0):
        return Engagement(initial, final, None, None, None, None, None)
    share = Trace(pressure.time, (pressure.values - initial) / change)
    asked_from, asked_to = _ends(command)
    commanded = None
    if asked_to != asked_from:
        wish = Trace(command.time, (command.values - asked_from) / (asked_to - asked_from))
        commanded = first_crossing(wish, THRESHOLD, rising=True)
    begun = first_crossing(share, THRESHOLD, rising=True)
    corner = None
    if piston is not None and stop is not None and begun is not None:
        corner = first_crossing(piston, stop, rising=change > 0, after=begun)
    return Engagement(
        initial,
        final,
        _after(commanded, begun),
        _after(begun, _arrived(share, begun)),
        _after(begun, corner),
        None if corner is None else pressure.at(corner) - initial,
        100 * max(0.0, float(share.values.max()) - 1),
    )


def _arrived(share: Trace, begun: float | None) -> float | None:
    """When the share reaches 1, or 98 % where it needs longer from there than to there."""
    if begun is None:
        return None
    close = first_crossing(share, 1 - THRESHOLD, rising=True, after=begun)
    there = first_crossing(share, 1 - _ROUNDING, rising=True, after=begun)
    creeps = close is not None and there is not None and there - close > close - begun
    return close if there is None or creeps else there


def _ends(trace: Trace) -> tuple[float, float]:
    start, end = float(trace.time[0]), float(trace.time[-1])
    width = _ENDS * (end - start)
    return trace.mean(start, start + width), trace.mean(end - width, end)


def _after(first: float | None, second: float | None) -> float | None:
    return None if first is None or second is None else second - first
