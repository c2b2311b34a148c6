"""The eigenvalue 0 of a matrix, taken out exactly: angles that turn, bodies that move on, integrators.

The generalised null space is built level by level: first N_1 with A N_1 = 0, then what A maps into what is
there already, until nothing more comes. Every level is a rank decision on a matrix whose rows are scaled to
equal size, so slow states of a stiff system are not taken for zeros: with drag d on an inertia J the angle's
0 and the speed's -d / J stay apart, however small that is.

Source: V. N. Kublanovskaya, USSR Comput. Math. Math. Phys. 6 (1966), 1-14; G. H. Golub, J. H. Wilkinson,
SIAM Review 18 (1976), 578-619.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import qr

Matrix = NDArray[np.float64]

_RANK = 1e3 * float(np.finfo(float).eps)
"""Singular value that counts as zero, relative to the largest and per row."""
_DUST = 1e-13
"""Entries of unit vectors below this are rounding."""


@dataclass(frozen=True, eq=False)
class Zeros:
    """Right and left bases (n, m) of the generalised null space, orthonormal; the first `vectors` columns of
    `right` are eigenvectors."""

    right: Matrix
    left: Matrix
    vectors: int

    @property
    def multiplicity(self) -> int:
        return self.right.shape[1]

    @property
    def dual(self) -> Matrix:
        """(m, n): `right @ dual` is the spectral projector."""
        return np.asarray(np.linalg.solve(self.left.T @ self.right, self.left.T), dtype=np.float64)

    @property
    def participation(self) -> Matrix:
        """Of the states: the diagonal of the spectral projector, as shares."""
        share = np.abs(np.einsum("ij,ji->i", self.right, self.dual))
        return np.asarray(share / share.sum(), dtype=np.float64)


def zeros_of(a: Matrix) -> Zeros:
    """Of a square matrix, best a balanced one. Nothing where rounding lets left and right disagree."""
    right, vectors = _chain(a)
    left, _ = _chain(a.T) if vectors else (right, 0)
    if left.shape != right.shape or _is_orthogonal(left, right):
        return Zeros(np.zeros((len(a), 0)), np.zeros((len(a), 0)), 0)
    return Zeros(right, left, vectors)


def _chain(a: Matrix) -> tuple[Matrix, int]:
    """The generalised null space, and how many of its first columns are the null space itself."""
    n, vectors = len(a), 0
    sizes = np.abs(a).max(axis=1, initial=0.0)
    sizes = np.where(sizes > 0, sizes, 1.0)  # of the rows before anything is taken off them
    basis = np.zeros((n, 0))
    while basis.shape[1] < n:
        left = (a - basis @ (basis.T @ a)) / sizes[:, None]
        more = _null(np.vstack([left, basis.T]), n)
        if not more.shape[1]:
            break
        more = more - basis @ (basis.T @ more)
        basis = np.hstack([basis, np.linalg.qr(more)[0]])
        basis[np.abs(basis) < _DUST] = 0.0
        vectors = vectors or basis.shape[1]
    return basis, vectors


def _null(matrix: Matrix, n: int) -> Matrix:
    _, values, adjoint = np.linalg.svd(matrix)
    return np.asarray(adjoint[values <= n * _RANK * max(float(values[0]), 1e-300)].T, dtype=np.float64)


def _is_orthogonal(left: Matrix, right: Matrix) -> bool:
    """Whether some of the left basis does not meet the right one, so that there is no projector."""
    if not right.shape[1]:
        return False
    return bool(np.linalg.svd(left.T @ right, compute_uv=False)[-1] < _DUST)


def complement(basis: Matrix) -> tuple[Matrix, NDArray[np.intp]]:
    """A basis (n, n - m) of what is orthogonal to the given one, and the rows in which it is the identity.

    States in which the given basis is zero are left as they are, so nothing of theirs is rounded.
    """
    n, m = basis.shape
    if not m:
        return np.eye(n), np.arange(n, dtype=np.intp)
    pivots, rest = pivots_of(basis)
    frame = np.zeros((n, n - m))
    frame[rest, np.arange(n - m)] = 1.0
    frame[pivots] = -np.linalg.solve(basis[pivots].T, basis[rest].T)
    return frame, rest


def pivots_of(basis: Matrix) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """As many rows as the basis has columns, on which it is well conditioned, and the others; ascending."""
    n, m = basis.shape
    order = np.asarray(qr(basis.T, pivoting=True, mode="r")[1], dtype=np.intp)
    is_pivot = np.zeros(n, dtype=np.bool_)
    is_pivot[order[:m]] = True
    return np.flatnonzero(is_pivot), np.flatnonzero(~is_pivot)
