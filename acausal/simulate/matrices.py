"""Solving scaled linear systems, dense or sparse, and telling what is singular.

SciPy takes as long to import as a small model to run, and most runs have no sparse blocks: it comes late.
"""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from scipy.sparse import csc_array

Vector: TypeAlias = NDArray[np.float64]
Matrix: TypeAlias = "Vector | csc_array"
DENSE_UP_TO = 200
"""Matrices of more rows are kept sparse."""
_SINGULAR = 1e-13
_SVD_UP_TO = 2000


def row_sums(matrix: Matrix, columns: Vector) -> Vector:
    """`|A| columns`."""
    return np.asarray(abs(matrix) @ columns, dtype=np.float64)


def scaled(matrix: Matrix, rows: Vector, columns: Vector) -> Matrix:
    """Divided by `rows`, multiplied by `columns`."""
    if isinstance(matrix, np.ndarray):
        return np.asarray(matrix * columns / rows[:, None], dtype=np.float64)
    from scipy.sparse import csc_array, diags_array

    return csc_array(diags_array(1 / rows) @ matrix @ diags_array(columns))


def transposed(matrix: Matrix) -> Matrix:
    """Rows as columns."""
    if isinstance(matrix, np.ndarray):
        return matrix.T
    from scipy.sparse import csc_array

    return csc_array(matrix.T)


def is_finite(matrix: Matrix) -> bool:
    """Whether every entry is a finite number."""
    data = matrix if isinstance(matrix, np.ndarray) else matrix.data
    return bool(np.isfinite(data).all())


def solve_regular(matrix: Matrix, right: Vector) -> Vector | None:
    """The solution; None where the matrix is singular to rounding."""
    probe = 0.5 + np.modf(np.arange(1, len(right) + 1) * 0.6180339887498949)[0]
    both = np.column_stack([right, probe])
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = _solved(matrix, both)
    except (np.linalg.LinAlgError, RuntimeError):
        return None
    growth = np.abs(found[:, 1]).sum()
    if not np.isfinite(found).all() or growth > 0.1 / _SINGULAR:
        return None
    return np.asarray(found[:, 0], dtype=np.float64)


def _solved(matrix: Matrix, right: Vector) -> Vector:
    if isinstance(matrix, np.ndarray):
        return np.asarray(np.linalg.solve(matrix, right), dtype=np.float64)
    from scipy.sparse.linalg import splu

    return splu(matrix).solve(right)


def minimum_norm(matrix: Matrix, right: Vector) -> Vector:
    """The shortest of the vectors that come closest to solving the system."""
    dense = _dense(matrix)
    if dense is None:
        from scipy.sparse.linalg import lsmr

        return np.asarray(lsmr(matrix, right, atol=1e-14, btol=1e-14, maxiter=20_000)[0], dtype=np.float64)
    return np.asarray(np.linalg.lstsq(dense, right, rcond=1e-10)[0], dtype=np.float64)


def dependent_rows(matrix: Matrix) -> tuple[int, ...] | None:
    """The rows that depend on each other if the matrix is singular to rounding; None if it is regular."""
    dense = _dense(matrix)
    if dense is None:
        return None if solve_regular(matrix, np.ones(matrix.shape[0])) is not None else ()
    left, values, _ = np.linalg.svd(dense)
    if values[-1] > _SINGULAR * max(values[0], 1e-300):
        return None
    weights = np.abs(left[:, -1])
    return tuple(int(i) for i in np.flatnonzero(weights > 1e-6 * weights.max()))


def _dense(matrix: Matrix) -> Vector | None:
    """As a dense array, unless it is too large for one."""
    if isinstance(matrix, np.ndarray):
        return matrix
    return np.asarray(matrix.toarray(), dtype=np.float64) if len(matrix.indptr) <= _SVD_UP_TO else None
