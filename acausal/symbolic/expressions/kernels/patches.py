"""Piecewise polynomials of two arguments on a rectangular grid: tables of two inputs."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from acausal.symbolic.expressions.kernel import Kernel, digest
from acausal.symbolic.expressions.kernels.piecewise import whole_periods
from acausal.symbolic.expressions.node import Constant

Period = tuple[float, float]


@dataclass(frozen=True, eq=False)
class Patches(Kernel):
    """`sum_pq c_pq (u - u_i)^p (v - v_j)^q` on patch (i, j), i and j counting the breaks not above u and v.

    `coefficients` holds the patches row by row (j runs fastest), each with `powers` rows of p and columns of
    q. The periods are those of `Piecewise`.
    """

    name: str
    key: str
    breaks: tuple[tuple[float, ...], tuple[float, ...]]
    origins: tuple[tuple[float, ...], tuple[float, ...]]
    powers: tuple[int, int]
    coefficients: tuple[tuple[float, ...], ...]
    continuity: int = 0
    periods: tuple[Period | None, Period | None] = (None, None)
    result: str = "Real"
    arity: int = 2

    def evaluate(self, *args: Constant) -> Constant:
        cells: list[int] = []
        distances: list[float] = []
        for arg, breaks, origins, period in zip(args, self.breaks, self.origins, self.periods, strict=True):
            if not isinstance(arg, (int, float)):
                raise ValueError(f"{arg!r} is not a number")
            x = float(arg)
            if period is not None:
                x -= whole_periods(x, period) * period[1]
            cells.append(bisect_right(breaks, x))
            distances.append(x - origins[cells[-1]])
        patch = self.coefficients[cells[0] * len(self.origins[1]) + cells[1]]
        columns = self.powers[1]
        value = 0.0
        for p in range(self.powers[0] - 1, -1, -1):
            row = 0.0
            for c in reversed(patch[p * columns : (p + 1) * columns]):
                row = row * distances[1] + c
            value = value * distances[0] + row
        return value

    def partial(self, argument: int) -> Patches | None:
        return self._derivatives[argument]

    @cached_property
    def _derivatives(self) -> tuple[Patches | None, Patches | None]:
        return self._derivative(0), self._derivative(1)

    def _derivative(self, argument: int) -> Patches | None:
        rows, columns = self.powers
        if self.powers[argument] == 1:
            return None
        new_rows, new_columns = (rows - 1, columns) if argument == 0 else (rows, columns - 1)

        def slope(patch: tuple[float, ...], p: int, q: int) -> float:
            if argument == 0:
                return (p + 1) * patch[(p + 1) * columns + q]
            return (q + 1) * patch[p * columns + q + 1]

        coefficients = tuple(
            tuple(slope(patch, p, q) for p in range(new_rows) for q in range(new_columns))
            for patch in self.coefficients
        )
        if not any(c for patch in coefficients for c in patch):
            return None
        return Patches(
            f"der{argument + 1}({self.name})",
            digest("der", argument, self.key),
            self.breaks,
            self.origins,
            (new_rows, new_columns),
            coefficients,
            self.continuity - 1,
            self.periods,
        )


def patches(
    name: str,
    breaks: tuple[Sequence[float], Sequence[float]],
    origins: tuple[Sequence[float], Sequence[float]],
    powers: tuple[int, int],
    coefficients: Sequence[Sequence[float]],
    continuity: int,
    periods: tuple[Period | None, Period | None] = (None, None),
) -> Patches:
    """The kernel with these parts."""
    cuts = (tuple(map(float, breaks[0])), tuple(map(float, breaks[1])))
    places = (tuple(map(float, origins[0])), tuple(map(float, origins[1])))
    data = tuple(tuple(map(float, patch)) for patch in coefficients)
    key = digest("patches", name, cuts, places, powers, data, continuity, periods)
    return Patches(name, key, cuts, places, powers, data, continuity, periods)
