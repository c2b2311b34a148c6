"""Tables of two arguments as piecewise polynomials (MSL's Blocks.Tables.CombiTable2D)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acausal.externals.hermite import akima, cubic
from acausal.externals.table1d import BadTable, Extrapolation, Smoothness
from acausal.symbolic.expressions.kernels.patches import Patches, Period, patches

Array = NDArray[np.float64]
_ONE_SIDED = (Extrapolation.HOLD, Extrapolation.PERIODIC)


@dataclass(frozen=True)
class Surface:
    """Values `z[i, j]` at `u[i]`, `v[j]`."""

    u: tuple[float, ...]
    v: tuple[float, ...]
    z: tuple[tuple[float, ...], ...]
    smoothness: Smoothness
    extrapolation: Extrapolation

    def kernel(self, name: str) -> Patches:
        """The surface as a kernel of (u, v)."""
        z = np.array(self.z, dtype=float)
        if self.smoothness is Smoothness.CONSTANT:
            return self._steps(name, z)
        if self.smoothness is Smoothness.LINEAR or max(z.shape) <= 2:
            inner = _bilinear(self.u, self.v, z)
            continuity = 0
        elif self.smoothness is Smoothness.AKIMA:
            inner = _akima(self.u, self.v, z)
            continuity = 1 if self.extrapolation in (Extrapolation.LAST_TWO_POINTS, Extrapolation.NONE) else 0
        else:
            raise BadTable("tables of two arguments know linear, Akima and constant segments only")
        for axis, grid in ((0, self.u), (1, self.v)):
            inner = _with_outside(inner, axis, grid, self.extrapolation)
        if Extrapolation.PERIODIC is self.extrapolation and not _closes(z):
            continuity = -1
        breaks, origins = (_breaks(self.u), _breaks(self.v)), (_origins(self.u), _origins(self.v))
        return self._patches(name, inner, continuity, breaks, origins)

    def _steps(self, name: str, z: Array) -> Patches:
        """The value at the grid point below; outside, linear through the last two points if so wished.

        The last point itself belongs to the table: it has a piece of its own, up to the next number.
        """
        grids = (self.u, self.v)
        many = [len(grid) > 1 for grid in grids]
        below = [[0, *range(len(g)), len(g) - 1] if m else [0] for g, m in zip(grids, many, strict=True)]
        linear = _bilinear(self.u, self.v, z)
        coefficients = np.zeros((len(below[0]), len(below[1]), *linear.shape[2:]))
        coefficients[:, :, 0, 0] = z[np.ix_(*below)]
        if self.extrapolation not in _ONE_SIDED:
            for axis, grid in enumerate(grids):
                linear = _with_outside(linear, axis, grid, self.extrapolation)
            same = [[*range(len(g) + 1), len(g)] if m else [0] for g, m in zip(grids, many, strict=True)]
            outside = np.zeros(coefficients.shape[:2], dtype=bool)
            outside[[0, -1], :] |= many[0]
            outside[:, [0, -1]] |= many[1]
            coefficients[outside] = linear[np.ix_(*same)][outside]
        breaks = [
            [*g, float(np.nextafter(g[-1], np.inf))] if m else [] for g, m in zip(grids, many, strict=True)
        ]
        origins = [[g[0], *g, g[-1]] if m else [g[0]] for g, m in zip(grids, many, strict=True)]
        return self._patches(name, coefficients, -1, (breaks[0], breaks[1]), (origins[0], origins[1]))

    def _patches(
        self,
        name: str,
        coefficients: Array,
        continuity: int,
        breaks: tuple[Sequence[float], Sequence[float]],
        origins: tuple[Sequence[float], Sequence[float]],
    ) -> Patches:
        rows, columns, p, q = coefficients.shape
        flat = coefficients.reshape(rows * columns, p * q)
        periods = (self._period(self.u), self._period(self.v))
        return patches(name, breaks, origins, (p, q), flat.tolist(), continuity, periods)

    def _period(self, grid: Sequence[float]) -> Period | None:
        if self.extrapolation is not Extrapolation.PERIODIC or len(grid) == 1:
            return None
        return grid[0], grid[-1] - grid[0]


def _closes(z: Array) -> bool:
    return bool(np.all(z[0] == z[-1]) and np.all(z[:, 0] == z[:, -1]))


def _breaks(grid: Sequence[float]) -> Sequence[float]:
    return grid if len(grid) > 1 else []


def _origins(grid: Sequence[float]) -> Sequence[float]:
    """Of the pieces left of the grid, on its intervals, and right of it."""
    return [grid[0], *grid] if len(grid) > 1 else grid


def _bilinear(u: Sequence[float], v: Sequence[float], z: Array) -> Array:
    """Coefficients [i, j, p, q] on every cell."""
    cells = np.zeros((max(1, len(u) - 1), max(1, len(v) - 1), min(2, len(u)), min(2, len(v))))
    for i in range(cells.shape[0]):
        for j in range(cells.shape[1]):
            corner = z[i : i + 2, j : j + 2]
            h = u[i + 1] - u[i] if len(u) > 1 else 1.0
            k = v[j + 1] - v[j] if len(v) > 1 else 1.0
            cell = cells[i, j]
            cell[0, 0] = corner[0, 0]
            if len(u) > 1:
                cell[1, 0] = (corner[1, 0] - corner[0, 0]) / h
            if len(v) > 1:
                cell[0, 1] = (corner[0, 1] - corner[0, 0]) / k
            if len(u) > 1 and len(v) > 1:
                cell[1, 1] = (corner[1, 1] - corner[1, 0] - corner[0, 1] + corner[0, 0]) / (h * k)
    return cells


# ------------------------------------------------------------------------------ Akima


def _akima(u: Sequence[float], v: Sequence[float], z: Array) -> Array:
    """Bicubic coefficients [i, j, p, q] (H. Akima, Comm. ACM 17(1), 1974)."""
    if len(u) == 1 or len(v) == 1:
        return _akima_line(u, v, z)
    zu, zv, zuv = _partial_derivatives(np.array(u), np.array(v), z)
    cells = np.zeros((len(u) - 1, len(v) - 1, 4, 4))
    for i in range(len(u) - 1):
        for j in range(len(v) - 1):
            corner = (slice(i, i + 2), slice(j, j + 2))
            data = np.block([[z[corner], zv[corner]], [zu[corner], zuv[corner]]])
            cells[i, j] = _hermite(u[i + 1] - u[i]) @ data @ _hermite(v[j + 1] - v[j]).T
    return cells


def _hermite(h: float) -> Array:
    """From (value at 0, value at h, slope at 0, slope at h) to coefficients, constant term first."""
    columns = [cubic(h, *row) for row in np.eye(4)]
    return np.array(columns).T


def _akima_line(u: Sequence[float], v: Sequence[float], z: Array) -> Array:
    grid, values = (v, z[0]) if len(u) == 1 else (u, z[:, 0])
    slopes = akima(grid, [float(value) for value in values])
    pieces = [
        cubic(grid[i + 1] - grid[i], values[i], values[i + 1], slopes[i], slopes[i + 1])
        for i in range(len(grid) - 1)
    ]
    data = np.array(pieces)
    return data.reshape(1, -1, 1, 4) if len(u) == 1 else data.reshape(-1, 1, 4, 1)


def _partial_derivatives(u: Array, v: Array, z: Array) -> tuple[Array, Array, Array]:
    """dz/du, dz/dv and d2z/dudv at the grid points, from chords of the table extended by two lines."""
    x, y = _extended_grid(u), _extended_grid(v)
    wide = _extended_values(y, z.T).T
    full = _extended_values(x, wide)
    by_x = np.diff(full, axis=0) / np.diff(x)[:, None]
    by_y = np.diff(full, axis=1) / np.diff(y)[None, :]
    mixed = np.diff(by_y, axis=0) / np.diff(x)[:, None]
    before_x, after_x = _weights(by_x[:, 2:-2])
    before_y, after_y = (weight.T for weight in _weights(by_y[2:-2].T))
    zu = (after_x * by_x[1:-2, 2:-2] + before_x * by_x[2:-1, 2:-2]) / (after_x + before_x)
    zv = (after_y * by_y[2:-2, 1:-2] + before_y * by_y[2:-2, 2:-1]) / (after_y + before_y)
    m = mixed[1:-1, 1:-1]
    upper = after_y * m[:-1, :-1] + before_y * m[:-1, 1:]
    lower = after_y * m[1:, :-1] + before_y * m[1:, 1:]
    zuv = (after_x * upper + before_x * lower) / ((after_x + before_x) * (after_y + before_y))
    return zu, zv, zuv


def _weights(chords: Array) -> tuple[Array, Array]:
    """`|d2 - d1|` and `|d4 - d3|` at each point along the first axis; 1 and 1 where both vanish."""
    steps = np.abs(np.diff(chords, axis=0))
    before, after = steps[:-2], steps[2:]
    both = (before == 0) & (after == 0)
    return np.where(both, 1.0, before), np.where(both, 1.0, after)


def _extended_grid(grid: Array) -> Array:
    """Two more points on each side, at the distances of the last ones (Akima 1974)."""
    if len(grid) == 2:
        h = grid[1] - grid[0]
        return np.array([grid[0] - 2 * h, grid[0] - h, *grid, grid[1] + h, grid[1] + 2 * h])
    a, b = grid[:3], grid[-3:]
    left = [2 * a[0] - a[2], a[0] + a[1] - a[2]]
    right = [b[2] + b[1] - b[0], 2 * b[2] - b[0]]
    return np.array([*left, *grid, *right])


def _extended_values(x: Array, z: Array) -> Array:
    """Two more rows on each side of `z`, which belongs to x[2:-2]: chords continued linearly."""
    if len(z) == 2:
        step = z[1] - z[0]
        return np.vstack([z[0] - 2 * step, z[0] - step, z, z[1] + step, z[1] + 2 * step])
    d = np.diff(z[:3], axis=0) / np.diff(x[2:5])[:, None]
    first = z[0] - (2 * d[0] - d[1]) * (x[2] - x[1])
    zeroth = first - (3 * d[0] - 2 * d[1]) * (x[1] - x[0])
    e = np.diff(z[-3:], axis=0) / np.diff(x[-5:-2])[:, None]
    last = z[-1] + (2 * e[1] - e[0]) * (x[-2] - x[-3])
    beyond = last + (3 * e[1] - 2 * e[0]) * (x[-1] - x[-2])
    return np.vstack([zeroth, first, z, last, beyond])


# ------------------------------------------------------------------------------ outside the grid


def _with_outside(cells: Array, axis: int, grid: Sequence[float], kind: Extrapolation) -> Array:
    """The cells with one more on each side of an axis: the edge's value, or its tangent."""
    if len(grid) == 1:
        return cells
    moved = np.moveaxis(cells, (axis, 2 + axis), (0, 1))
    h = grid[-1] - grid[-2]
    value, slope = np.zeros_like(moved[-1, 0]), np.zeros_like(moved[-1, 0])
    for coefficient in moved[-1, ::-1]:
        slope = slope * h + value
        value = value * h + coefficient
    left, right = np.zeros_like(moved[:1]), np.zeros_like(moved[:1])
    left[0, 0], right[0, 0] = moved[0, 0], value
    if kind not in _ONE_SIDED:
        left[0, 1], right[0, 1] = moved[0, 1], slope
    return np.moveaxis(np.concatenate([left, moved, right]), (0, 1), (axis, 2 + axis))
