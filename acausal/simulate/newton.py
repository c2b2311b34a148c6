"""A robust Newton method for one torn block, for starting points that are far away.

Unknowns are scaled by `max(|z|, nominal)`, equations by the size of their row, so that neither units nor the way an
equation is written matter. Steps are damped until the scaled residual falls; where the Jacobian is singular, a
Levenberg-Marquardt step is taken. Used for the initial problem and when the integrator's own Newton method fails.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]
System = Callable[[Vector], tuple[Vector, Vector]]
"""`z -> (r, J)` with a dense Jacobian."""

CONVERGED = 1e-12
ACCEPTED = 1e-8
MAX_ITERATIONS = 100
_SINGULAR = 1e-13


@dataclass(frozen=True)
class Solution:
    """`z`, whether it solves the block, the scaled residuals there, and the number of iterations."""

    z: Vector
    converged: bool
    scaled: Vector
    iterations: int


def scales(z: Vector, jacobian: Vector, nominal: Vector) -> tuple[Vector, Vector]:
    """Column scales (size of unknowns) and row scales (size of equations)."""
    columns = np.maximum(np.abs(z), nominal)
    rows = np.abs(jacobian) @ columns
    return columns, np.where(rows > 0, rows, 1.0)


def null_rows(jacobian: Vector, z: Vector, nominal: Vector) -> tuple[int, ...] | None:
    """The equations that depend on each other where the scaled Jacobian is singular; None where it is regular."""
    columns, rows = scales(z, jacobian, nominal)
    if not np.isfinite(jacobian).all():
        return None
    left, singular, _ = np.linalg.svd(jacobian * columns / rows[:, None])
    if singular[-1] > _SINGULAR * max(singular[0], 1e-300):
        return None
    weights = np.abs(left[:, -1])
    return tuple(int(i) for i in np.flatnonzero(weights > 1e-6 * weights.max()))


def solve(system: System, start: Vector, nominal: Vector) -> Solution:
    """Damped Newton iterations from `start`, at most `MAX_ITERATIONS`."""
    z = start.copy()
    residual, jacobian = system(z)
    scaled = np.full(len(z), np.inf)
    for iteration in range(MAX_ITERATIONS):
        if not (np.isfinite(residual).all() and np.isfinite(jacobian).all()):
            return Solution(z, False, np.full(len(z), np.inf), iteration)
        columns, rows = scales(z, jacobian, nominal)
        scaled = residual / rows
        if np.abs(scaled).max(initial=0.0) <= CONVERGED:
            return Solution(z, True, scaled, iteration)
        step = columns * _direction(jacobian * columns / rows[:, None], scaled)
        trial = _damped(system, z, step, rows, float(np.linalg.norm(scaled)))
        if trial is None:
            break
        z, residual, jacobian = trial
    done = bool(np.abs(scaled).max(initial=0.0) <= ACCEPTED)
    return Solution(z, done, scaled, MAX_ITERATIONS)


def _direction(matrix: Vector, scaled: Vector) -> Vector:
    """`-matrix \\ scaled`, regularised where the matrix is close to singular."""
    try:
        step = np.linalg.solve(matrix, -scaled)
        if np.isfinite(step).all() and np.abs(step).max(initial=0.0) < 1e8:
            return step
    except np.linalg.LinAlgError:
        pass
    damping = 1e-6 * np.linalg.norm(matrix) ** 2 + 1e-300
    return -np.linalg.solve(matrix.T @ matrix + damping * np.eye(len(scaled)), matrix.T @ scaled)


def _damped(
    system: System, z: Vector, step: Vector, rows: Vector, norm: float
) -> tuple[Vector, Vector, Vector] | None:
    """The longest of the steps 1, 1/2, 1/4, … that reduces the scaled residual; None when none does."""
    factor = 1.0
    for _ in range(40):
        trial = z + factor * step
        residual, jacobian = system(trial)
        size = float(np.linalg.norm(residual / rows)) if np.isfinite(residual).all() else np.inf
        if size <= (1 - 1e-4 * factor) * norm:
            return trial, residual, jacobian
        factor *= 0.5
    return None
