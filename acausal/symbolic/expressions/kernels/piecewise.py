"""Piecewise polynomials of one argument: tables, and arrays indexed at run time."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import ceil, floor

from acausal.symbolic.expressions.kernel import Kernel, digest
from acausal.symbolic.expressions.node import Constant


@dataclass(frozen=True, eq=False)
class Piecewise(Kernel):
    """`p_k(x - origin_k)` with `k` the number of `breaks` that are not above the selector `s`.

    Arguments (s, x): usually the same; a table over time chooses its piece by another value than it is
    evaluated at (the left limit at an event). There is one piece more than there are breaks, coefficients
    run from the constant term up. With `period` (start, length) both arguments are shifted by whole periods,
    up to `start` from below and down to `start + length` from above, and `drift` is added for each.
    """

    name: str
    key: str
    breaks: tuple[float, ...]
    origins: tuple[float, ...]
    coefficients: tuple[tuple[float, ...], ...]
    continuity: int = 0
    period: tuple[float, float] | None = None
    drift: float = 0.0
    result: str = "Real"
    arity: int = 2

    def evaluate(self, *args: Constant) -> Constant:
        selector, x = (_number(arg) for arg in args)
        offset = 0.0
        if self.period is not None:
            turns = whole_periods(selector, self.period)
            shift = turns * self.period[1]
            selector, x, offset = selector - shift, x - shift, turns * self.drift
        piece = bisect_right(self.breaks, selector)
        distance = x - self.origins[piece]
        value = 0.0
        for coefficient in reversed(self.coefficients[piece]):
            value = value * distance + coefficient
        value += offset
        return round(value) if self.result == "Integer" else value

    def moves_with(self, argument: int) -> bool:
        return argument == 1

    def partial(self, argument: int) -> Piecewise | None:
        return None if argument == 0 else self._derivative

    @cached_property
    def _derivative(self) -> Piecewise | None:
        coefficients = tuple(
            tuple(power * c for power, c in enumerate(piece) if power) or (0.0,)
            for piece in self.coefficients
        )
        if not any(c for piece in coefficients for c in piece):
            return None
        return Piecewise(
            f"der({self.name})",
            digest("der", self.key),
            self.breaks,
            self.origins,
            coefficients,
            self.continuity - 1,
            self.period,
        )


def piecewise(
    name: str,
    breaks: Sequence[float],
    origins: Sequence[float],
    coefficients: Sequence[Sequence[float]],
    continuity: int,
    period: tuple[float, float] | None = None,
    drift: float = 0.0,
    result: str = "Real",
) -> Piecewise:
    """The kernel with these parts."""
    pieces = tuple(tuple(map(float, piece)) for piece in coefficients)
    parts = (tuple(map(float, breaks)), tuple(map(float, origins)), pieces)
    key = digest("piecewise", name, *parts, continuity, period, drift, result)
    return Piecewise(name, key, *parts, continuity, period, drift, result)


def whole_periods(x: float, period: tuple[float, float]) -> int:
    """How many periods `x` lies above the first one: 0 for `start <= x <= start + length`."""
    turns = (x - period[0]) / period[1]
    return floor(turns) if turns < 0 else max(0, ceil(turns) - 1)


def lookup(name: str, values: Sequence[float], result: str = "Real") -> Piecewise:
    """`values[i]` for an index from 1 known at run time only; beyond the ends the end's value."""
    breaks = [i + 0.5 for i in range(1, len(values))]
    return piecewise(name, breaks, [0.0] * len(values), [[v] for v in values], -1, result=result)


def _number(value: Constant) -> float:
    if isinstance(value, (int, float)):
        return float(value)
    raise ValueError(f"{value!r} is not a number")
