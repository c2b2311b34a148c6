"""A robust Newton method for one torn block, for starting points that are far away.

Unknowns are scaled by `max(|z|, nominal)`, equations by the size of their row, so that neither units nor
the way an equation is written matter. A step is halved until the scaled residual falls, or until the next
simplified Newton step is shorter (Deuflhard's natural monotonicity test: Newton Methods for Nonlinear
Problems, 2004, 3.3), which also passes along curved valleys; where the Jacobian is singular, a
Levenberg-Marquardt step is taken. Where a derivative is infinite (a square root at zero) rows look large and
residuals small: a solution counts only if the residual is small beside differences over a short distance too.

Used for the initial problem, at events, and when the integrator's own Newton method fails; `continuation`
is the next resort.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from acausal.simulate.matrices import (
    Matrix,
    Vector,
    dependent_rows,
    is_finite,
    minimum_norm,
    row_sums,
    scaled,
    solve_regular,
)

System = Callable[[Vector], tuple[Vector, Matrix]]
"""`z -> (r, J)`."""

CONVERGED = 1e-12
ACCEPTED = 1e-8
MAX_ITERATIONS = 500
BRIEF, _STALE = 15, 4
"""With a limit up to this, iterations that gain less than half in so many are given up."""
_HALVINGS = 40
_ESCAPES = 4
_PROBE = 1e-6
_LONGEST = 1e8


@dataclass(frozen=True)
class Solution:
    """`z`, whether it solves the block, the scaled residuals there, and the number of iterations."""

    z: Vector
    converged: bool
    scaled: Vector
    iterations: int


@dataclass(frozen=True)
class _Point:
    """A point with everything that is known there; `rows` scale residuals, `columns` unknowns."""

    z: Vector
    residual: Vector
    jacobian: Matrix
    columns: Vector
    rows: Vector

    @property
    def scaled(self) -> Vector:
        return self.residual / self.rows

    @property
    def worst(self) -> float:
        return float(np.abs(self.scaled).max(initial=0.0))


def scales(z: Vector, jacobian: Matrix, nominal: Vector) -> tuple[Vector, Vector]:
    """Column scales (size of unknowns) and row scales (size of equations)."""
    columns = np.maximum(np.abs(z), nominal)
    rows = row_sums(jacobian, columns)
    return columns, np.where(rows > 0, rows, 1.0)


def null_rows(jacobian: Matrix, z: Vector, nominal: Vector) -> tuple[int, ...] | None:
    """The equations that depend on each other if the scaled Jacobian is singular; None if it is regular."""
    columns, rows = scales(z, jacobian, nominal)
    if not is_finite(jacobian):
        return None
    return dependent_rows(scaled(jacobian, rows, columns))


def solve(system: System, start: Vector, nominal: Vector, limit: int = MAX_ITERATIONS) -> Solution:
    """Damped Newton iterations from `start`, at most `limit`."""
    with np.errstate(all="ignore"):
        return _iterate(system, start, nominal, limit)


def _iterate(system: System, start: Vector, nominal: Vector, limit: int) -> Solution:
    point = _first(system, start, nominal)
    if point is None:
        return Solution(start, False, np.full(len(start), np.inf), 0)
    escapes = 0
    course: list[float] = []
    for iteration in range(limit):
        course.append(point.worst)
        if limit <= BRIEF and iteration >= _STALE and course[-1] > 0.5 * course[-1 - _STALE]:
            return Solution(point.z, False, point.scaled, iteration)
        done = point.worst <= CONVERGED
        if done and _is_solution(system, point):
            return Solution(point.z, True, point.scaled, iteration)
        step = point.columns * direction(point)
        following = None if done else _damped(system, point, step, nominal)
        if following is None and not done and point.worst <= ACCEPTED and _is_solution(system, point):
            return Solution(point.z, True, point.scaled, iteration)
        if done and escapes < _ESCAPES:
            escapes += 1
            away = point.columns * _shape(len(start)) * np.where(step < 0, -1.0, 1.0)
            far = point.z + 10.0 ** (escapes - _ESCAPES) * away
            following = _at(system, far, nominal)
        if following is None:
            return Solution(point.z, False, point.scaled, iteration)
        point = following
    return Solution(point.z, False, point.scaled, limit)


def _shape(size: int) -> Vector:
    """Different numbers around 1, so that a shift keeps no two unknowns at equal distance."""
    return 0.5 + np.modf(np.arange(1, size + 1) * 0.6180339887498949)[0]


def _at(system: System, z: Vector, nominal: Vector) -> _Point | None:
    """None where something is not finite."""
    residual, jacobian = system(z)
    if not (np.isfinite(residual).all() and is_finite(jacobian)):
        return None
    return _Point(z, residual, jacobian, *scales(z, jacobian, nominal))


def _first(system: System, start: Vector, nominal: Vector) -> _Point | None:
    """The start, or a point close to it where the equations can be evaluated."""
    size = np.maximum(np.abs(start), nominal)
    for distance in (0.0, 1e-6, -1e-6, 1e-3, -1e-3, 1e-1, -1e-1, 1.0, -1.0):
        point = _at(system, start + distance * size * _shape(len(start)), nominal)
        if point is not None:
            return point
    return None


def _is_solution(system: System, point: _Point) -> bool:
    """Whether the residual is also small beside its change over a short distance."""
    distance = _PROBE * point.columns * _shape(len(point.z))
    foreseen = np.abs(np.asarray(point.jacobian @ distance, dtype=np.float64))
    change = np.abs(system(point.z + distance)[0] - point.residual)
    steep = (foreseen > 1e-3 * _PROBE * point.rows) & (change < 0.1 * foreseen)
    size = np.where(steep, change / _PROBE, point.rows)
    return bool(np.all(np.abs(point.residual) <= ACCEPTED * size))


def direction(point: _Point) -> Vector:
    """The scaled Newton step, regularised where the matrix is close to singular."""
    matrix = scaled(point.jacobian, point.rows, point.columns)
    step = solve_regular(matrix, -point.scaled)
    if step is not None and np.abs(step).max(initial=0.0) < _LONGEST:
        return step
    if not isinstance(matrix, np.ndarray):
        return minimum_norm(matrix, -point.scaled)
    damping = 1e-6 * float(np.linalg.norm(matrix)) ** 2 + 1e-300
    normal: Vector = matrix.T @ matrix + damping * np.eye(len(point.z))
    return np.asarray(np.linalg.solve(normal, -(matrix.T @ point.scaled)), dtype=np.float64)


def _damped(system: System, point: _Point, step: Vector, nominal: Vector) -> _Point | None:
    """The longest of the steps 1, 1/2, 1/4, … that leads closer to a solution; None when none does."""
    matrix = scaled(point.jacobian, point.rows, point.columns)
    before = float(np.linalg.norm(point.scaled))
    length = float(np.linalg.norm(step / point.columns))
    factor = 1.0
    for _ in range(_HALVINGS):
        trial = _at(system, point.z + factor * step, nominal)
        if trial is not None:
            size = trial.residual / point.rows
            if float(np.linalg.norm(size)) <= (1 - 1e-4 * factor) * before:
                return trial
            simplified = solve_regular(matrix, -size)
            if simplified is not None and float(np.linalg.norm(simplified)) <= (1 - factor / 4) * length:
                return trial
        factor *= 0.5
    return None
