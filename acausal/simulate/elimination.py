"""The pattern of W = 1/(h gamma) - J and the order of its columns, decided once for a run.

The columns are ordered by approximate minimum degree on the pattern of W + W' (AMD, through CasADi), since W
has a full diagonal that mostly serves as pivot.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from casadi import Sparsity
from numpy.typing import NDArray

_Ints = NDArray[np.int32]


@dataclass(frozen=True)
class Elimination:
    """W by columns, the order of elimination, and where Jacobian entries and diagonal are in W.

    `capacity` is the number of entries that L and U each have room for.
    """

    columns: _Ints
    rows: _Ints
    order: _Ints
    entries: _Ints
    diagonal: _Ints
    capacity: int


def eliminate(pattern: Sparsity, size: int) -> Elimination:
    """The analysis of a Jacobian's pattern. O(fill)."""
    given_rows, given_columns = (np.asarray(v, dtype=np.int64) for v in pattern.get_triplet())
    numbers = np.unique(np.concatenate([given_columns * size + given_rows, np.arange(size) * (size + 1)]))
    rows, columns = numbers % max(size, 1), numbers // max(size, 1)
    starts = np.searchsorted(columns, np.arange(size + 1))
    order, fill = _ordered(pattern, size)
    return Elimination(
        starts.astype(np.int32),
        rows.astype(np.int32),
        order,
        np.searchsorted(numbers, given_columns * size + given_rows).astype(np.int32),
        np.searchsorted(numbers, np.arange(size) * (size + 1)).astype(np.int32),
        min(size * size, 4 * fill + 16 * size) + 16,
    )


def _ordered(pattern: Sparsity, size: int) -> tuple[_Ints, int]:
    """The order of the columns, and how many entries L and U have if the diagonal is the pivot.

    Approximate minimum degree on the pattern made symmetric (Amestoy, Davis and Duff, ACM TOMS 30, 2004).
    """
    if size == 0:
        return np.zeros(0, dtype=np.int32), 0
    symmetric = pattern.unite(pattern.T).unite(Sparsity.diag(size))
    above, order = symmetric.ldl(True)
    return np.array(order, dtype=np.int32), int(2 * (above.nnz() + size))
