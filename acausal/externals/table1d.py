"""Tables of one argument as piecewise polynomials (the tables of MSL's Blocks.Tables and Sources)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from itertools import pairwise

from acausal.externals.hermite import (
    Slopes,
    akima,
    cubic,
    fritsch_butland,
    modified_akima,
    steffen,
)
from acausal.symbolic.expressions.kernels.piecewise import Piecewise, piecewise

NEVER = 1.7976931348623157e308
"""The next time event where there is none."""
_NEARLY = 1e-10


class Smoothness(IntEnum):
    """MSL's `Blocks.Types.Smoothness`."""

    LINEAR = 1
    AKIMA = 2
    CONSTANT = 3
    FRITSCH_BUTLAND = 4
    STEFFEN = 5
    MODIFIED_AKIMA = 6


class Extrapolation(IntEnum):
    """MSL's `Blocks.Types.Extrapolation`."""

    HOLD = 1
    LAST_TWO_POINTS = 2
    PERIODIC = 3
    NONE = 4


class TimeEvents(IntEnum):
    """MSL's `Blocks.Types.TimeEvents`."""

    ALWAYS = 1
    AT_DISCONTINUITIES = 2
    NEVER = 3


_SLOPES: dict[Smoothness, Slopes] = {
    Smoothness.AKIMA: akima,
    Smoothness.FRITSCH_BUTLAND: fritsch_butland,
    Smoothness.STEFFEN: steffen,
    Smoothness.MODIFIED_AKIMA: modified_akima,
}
_PERIODIC = Extrapolation.PERIODIC
_Piece = tuple[float, list[float]]
"""Origin and coefficients."""


class BadTable(ValueError):
    """The data make no table; a text for the message."""


@dataclass(frozen=True)
class Curve:
    """One column over the abscissas, which may repeat where the value jumps."""

    x: tuple[float, ...]
    y: tuple[float, ...]
    smoothness: Smoothness
    extrapolation: Extrapolation

    @property
    def period(self) -> tuple[float, float] | None:
        """Start and length of the period of a periodic table."""
        if self.extrapolation is not Extrapolation.PERIODIC or len(self.x) == 1:
            return None
        return self.x[0], self.x[-1] - self.x[0]

    def kernel(self, name: str) -> Piecewise:
        """The curve as a kernel of (selector, abscissa)."""
        if len(self.x) == 1:
            return piecewise(name, [], [0.0], [[self.y[0]]], 1)
        spans = [i for i in range(len(self.x) - 1) if not nearly(self.x[i], self.x[i + 1])]
        inner = self._inner(spans)
        left, right = self._outside(spans, inner)
        breaks = [*[self.x[i] for i in spans], self.x[-1]]
        pieces = [left, *inner, right]
        return piecewise(
            name, breaks, [o for o, _ in pieces], [c for _, c in pieces], self._continuity(spans), self.period
        )

    def _inner(self, spans: Sequence[int]) -> list[_Piece]:
        x, y = self.x, self.y
        if self.smoothness is Smoothness.CONSTANT:
            return [(x[i], [y[i]]) for i in spans]
        if self.smoothness in _SLOPES and len(x) > 2:
            slopes = _SLOPES[self.smoothness](x, y)
            return [
                (x[i], [*cubic(x[i + 1] - x[i], y[i], y[i + 1], slopes[i], slopes[i + 1])]) for i in spans
            ]
        return [(x[i], [y[i], (y[i + 1] - y[i]) / (x[i + 1] - x[i])]) for i in spans]

    def _outside(self, spans: Sequence[int], inner: Sequence[_Piece]) -> tuple[_Piece, _Piece]:
        """What holds left and right of the table; in a periodic one, at its very end only."""
        x, y = list(self.x), list(self.y)
        if not spans or self.extrapolation is Extrapolation.HOLD or self.extrapolation is _PERIODIC:
            return (x[0], [y[0]]), (x[-1], [y[-1]])
        first, last = spans[0], spans[-1]
        left = right = 0.0
        if first == 0:
            left = (y[1] - y[0]) / (x[1] - x[0])
        if last == len(x) - 2:
            right = (y[-1] - y[-2]) / (x[-1] - x[-2])
        if self.smoothness in _SLOPES and len(x) > 2:
            left = inner[0][1][1]
            c, h = inner[-1][1], x[-1] - x[-2]
            right = sum(power * c[power] * h ** (power - 1) for power in (1, 2, 3))
        return (x[0], [y[0], left]), (x[-1], [y[-1], right])

    def _continuity(self, spans: Sequence[int]) -> int:
        if self.smoothness is Smoothness.CONSTANT or len(spans) < len(self.x) - 1:
            return -1
        if self.period is not None and self.y[0] != self.y[-1]:
            return -1
        smooth = self.smoothness in _SLOPES and len(self.x) > 2
        return 1 if smooth and self.extrapolation in _SMOOTH_OUTSIDE else 0


_SMOOTH_OUTSIDE = (Extrapolation.LAST_TWO_POINTS, Extrapolation.NONE)


def nearly(a: float, b: float) -> bool:
    """Whether two abscissas are the same up to rounding (1e-10 relative)."""
    return abs(a - b) < _NEARLY * max(abs(a), abs(b), _NEARLY)


def check_abscissas(x: Sequence[float], smoothness: Smoothness, *, may_repeat: bool) -> None:
    """Raise `BadTable` unless the abscissas increase."""
    strictly = not may_repeat or smoothness in _SLOPES
    for i, (a, b) in enumerate(pairwise(x), start=1):
        if a > b or (strictly and a == b):
            how = "strictly" if strictly else "monotonically"
            raise BadTable(f"its first column does not increase {how}: row {i} has {a}, row {i + 1} has {b}")


# --------------------------------------------------------------------------- time events


def next_event_kernel(
    name: str,
    x: Sequence[float],
    smoothness: Smoothness,
    extrapolation: Extrapolation,
    events: TimeEvents,
    start: float,
    shift: float,
) -> Piecewise:
    """The next time event as a function of (time, time); `NEVER` where there is none.

    Always the ends of the table; with `ALWAYS` every point, with `AT_DISCONTINUITIES` those that repeat.
    """
    inside: list[float] = []
    if smoothness not in _SLOPES and events is not TimeEvents.NEVER:
        for i in range(1, len(x) - 1):
            repeats = nearly(x[i - 1], x[i])
            wanted = repeats or events is TimeEvents.ALWAYS
            known = (x[0], x[-1], *inside[-1:])
            if wanted and not any(nearly(x[i], event) for event in known):
                inside.append(x[i])
    if len(x) == 1:
        return _steps(name, [start], None)
    if extrapolation is Extrapolation.PERIODIC:
        points = [*inside, x[-1]]
        return _steps(name, [point + shift for point in points], (x[0] + shift, x[-1] - x[0]))
    points = [point + shift for point in (x[0], *inside, x[-1]) if point + shift > start]
    return _steps(name, [start, *points] if start > -NEVER else points, None)


def _steps(name: str, events: Sequence[float], period: tuple[float, float] | None) -> Piecewise:
    """The first event above the argument."""
    values = [[event] for event in events]
    drift = 0.0
    if period is None:
        values.append([NEVER])
    else:
        values.append([events[0] + period[1]])
        drift = period[1]
    return piecewise(name, events, [0.0] * len(values), values, -1, period, drift)
