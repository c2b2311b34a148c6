"""What is at rest: which derivatives are those of angles that turn, and which say that a model moves.

A shaft that turns at a constant speed has no equilibrium: its angle grows. Its speed is steady all the same,
because nothing depends on the angle: moving all angles that turn together changes no derivative. These
directions are the part of the Jacobian's null space that belongs to positions. A volume that fills is no
such case, though nothing may depend on its level either: its derivative comes from no speed.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]

NULL = 1e-10
"""Singular value of the balanced Jacobian, relative to the largest, that counts as zero."""
_ANGLES = frozenset({"rad", "deg", "rev"})
_POSITIONS = frozenset({"", "1", "m", "mm", "km"})


def turning(jacobian: Vector, units: Sequence[str]) -> Vector:
    """Orthonormal columns (n, k): the ways in which positions can move without changing any derivative.

    `jacobian` (n, n) in nominal values, `units` of the states. A state in rad may turn; one in m, or without
    a unit, only if its derivative comes from other states and from no position that moves along.
    """
    n = len(jacobian)
    driven = np.abs(jacobian).max(axis=1, initial=0.0) > 0
    candidates = np.array([_may_turn(unit, bool(row)) for unit, row in zip(units, driven, strict=True)], bool)
    for _ in range(n + 1):
        found = np.zeros((n, 0))
        if candidates.any():
            within = null_space(jacobian[:, candidates])
            found = np.zeros((n, within.shape[1]))
            found[candidates] = within
        moving = np.abs(found).max(axis=1, initial=0.0) > 1e-9
        fed = (np.abs(jacobian[:, moving]) > 0).any(axis=1)
        wrong = moving & fed & np.array([unit not in _ANGLES for unit in units], bool)
        if not wrong.any():
            return found
        candidates &= ~wrong
    return np.zeros((n, 0))


def _may_turn(unit: str, is_driven: bool) -> bool:
    return unit in _ANGLES or (unit in _POSITIONS and is_driven)


def null_space(matrix: Vector) -> Vector:
    """Orthonormal columns that span what the matrix maps to zero, its rows scaled to equal size."""
    if not matrix.shape[1]:
        return np.zeros((0, 0))
    sizes = np.abs(matrix).max(axis=1, initial=0.0)
    _, values, adjoint = np.linalg.svd(matrix / np.where(sizes > 0, sizes, 1.0)[:, None])
    padded = np.zeros(matrix.shape[1])
    padded[: len(values)] = values
    return np.asarray(adjoint[padded <= NULL * max(float(padded[0]), 1e-300)].T, dtype=np.float64)


def split(rates: Vector, null: Vector) -> tuple[Vector, Vector]:
    """Scaled derivatives: those of positions that turn, and the rest, which is zero at rest."""
    within = null @ (null.T @ rates)
    return within, rates - within
