"""Slopes of cubic Hermite splines through points: local methods, one slope per point.

Each takes abscissas `x` (strictly increasing, three or more) and ordinates `y`, and gives the slopes with
which a cubic on every interval is once continuously differentiable.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

Slopes = Callable[[Sequence[float], Sequence[float]], list[float]]


def differences(x: Sequence[float], y: Sequence[float]) -> list[float]:
    """Divided differences: the slope of each chord."""
    return [(y[i + 1] - y[i]) / (x[i + 1] - x[i]) for i in range(len(x) - 1)]


def _extended(x: Sequence[float], y: Sequence[float]) -> list[float]:
    """The chords' slopes with two more on each side, continued linearly (Akima's end conditions)."""
    d = differences(x, y)
    left = [3 * d[0] - 2 * d[1], 2 * d[0] - d[1]]
    right = [2 * d[-1] - d[-2], 3 * d[-1] - 2 * d[-2]]
    return [*left, *d, *right]


def akima(x: Sequence[float], y: Sequence[float]) -> list[float]:
    """Weighted mean of the neighbouring chords, weights `|d4 - d3|` and `|d2 - d1|` (Akima, JACM 1970)."""
    d = _extended(x, y)
    slopes: list[float] = []
    for i in range(len(x)):
        after, before = abs(d[i + 3] - d[i + 2]), abs(d[i + 1] - d[i])
        slopes.append(_weighted(d[i + 1], d[i + 2], after, before, 0.5 * (d[i + 1] + d[i + 2])))
    return slopes


def modified_akima(x: Sequence[float], y: Sequence[float]) -> list[float]:
    """As `akima` with `|d4 + d3| / 2` and `|d2 + d1| / 2` added to the weights ("makima", Moler 2019)."""
    d = _extended(x, y)
    slopes: list[float] = []
    for i in range(len(x)):
        after = abs(d[i + 3] - d[i + 2]) + 0.5 * abs(d[i + 3] + d[i + 2])
        before = abs(d[i + 1] - d[i]) + 0.5 * abs(d[i + 1] + d[i])
        slopes.append(_weighted(d[i + 1], d[i + 2], after, before, 0.0))
    return slopes


def _weighted(left: float, right: float, after: float, before: float, otherwise: float) -> float:
    total = after + before
    return (after * left + before * right) / total if total > 0 else otherwise


def fritsch_butland(x: Sequence[float], y: Sequence[float]) -> list[float]:
    """Weighted harmonic mean of the chords, 0 at extrema; the ends take their chord (SIAM J. Sci. 1984)."""
    d = differences(x, y)
    slopes = [d[0]]
    for i in range(len(d) - 1):
        h, k = x[i + 1] - x[i], x[i + 2] - x[i + 1]
        flat = d[i] * d[i + 1] <= 0
        slopes.append(0.0 if flat else 3 * (h + k) / ((h + 2 * k) / d[i] + (k + 2 * h) / d[i + 1]))
    return [*slopes, d[-1]]


def steffen(x: Sequence[float], y: Sequence[float]) -> list[float]:
    """Slope of the parabola through three points, limited to twice the flatter chord (Steffen 1990)."""
    d = differences(x, y)
    slopes = [d[0]]
    for i in range(len(d) - 1):
        h, k = x[i + 1] - x[i], x[i + 2] - x[i + 1]
        if d[i] * d[i + 1] <= 0:
            slopes.append(0.0)
            continue
        parabola = (d[i] * k + d[i + 1] * h) / (h + k)
        limit = 2 * min(abs(d[i]), abs(d[i + 1]))
        slopes.append(max(-limit, min(limit, parabola)))
    return [*slopes, d[-1]]


def cubic(h: float, y0: float, y1: float, s0: float, s1: float) -> tuple[float, float, float, float]:
    """Coefficients, constant term first, of the cubic with values y and slopes s at 0 and h."""
    d = (y1 - y0) / h
    return y0, s0, (3 * d - 2 * s0 - s1) / h, (s0 + s1 - 2 * d) / (h * h)
