"""The run-time's sparse LU against NumPy: any pattern, new values with the same pivots, pivots that decay."""

from __future__ import annotations

import ctypes

import numpy as np
import pytest
from casadi import DM
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from acausal.runtime import binding, build
from acausal.simulate.elimination import eliminate
from acausal.simulate.matrices import Vector

pytestmark = pytest.mark.skipif(build.compiler() is None, reason="no C compiler")


class Factors:
    """An `ac_lu` over the pattern of a square matrix with a full diagonal."""

    def __init__(self, pattern: NDArray[np.bool_], capacity: int | None = None) -> None:
        size = len(pattern)
        self.library = build.run_time()
        self.run_time = binding.RunTime()
        self.found = eliminate(DM(pattern.astype(float)).sparsity(), size)
        self.lu = binding.LuStructure()
        self.lu.n, self.lu.capacity = size, self.found.capacity if capacity is None else capacity
        self.lu.ap, self.lu.ai = self.found.columns.ctypes.data, self.found.rows.ctypes.data
        self.lu.q = self.found.order.ctypes.data
        entries = self.found.rows.size
        self.doubles = np.zeros(self.run_time.lu_doubles(size, entries, self.lu.capacity))
        self.ints = np.zeros(self.run_time.lu_ints(size, self.lu.capacity), dtype=np.int32)
        lu, doubles, ints = self.lu, self.doubles.ctypes.data, self.ints.ctypes.data
        self.run_time.lu_init(lu, doubles, ints, entries)

    def factor(self, matrix: Vector) -> int:
        columns = np.repeat(np.arange(self.lu.n), np.diff(self.found.columns))
        self.doubles[: self.found.rows.size] = matrix[self.found.rows, columns]
        return int(self.library.ac_lu_factor(ctypes.byref(self.lu)))

    def solve(self, right: Vector) -> Vector:
        out = np.zeros(self.lu.n)
        address = ctypes.c_void_p
        self.library.ac_lu_solve(ctypes.byref(self.lu), address(right.ctypes.data), address(out.ctypes.data))
        return out


def random_matrix(size: int, density: float, seed: int) -> Vector:
    """Entries in a pattern, some of them small, the diagonal always there."""
    values = np.modf(np.sin(np.arange(1, size * size + 1) * (seed + 1.7)) * 1e4)[0].reshape(size, size)
    keep = np.abs(np.modf(np.cos(np.arange(size * size) * (seed + 0.3)) * 1e3)[0]).reshape(size, size)
    return np.where((keep < density) | np.eye(size, dtype=bool), values, 0.0)


def residual(matrix: Vector, x: Vector, right: Vector) -> float:
    scale = np.abs(matrix) @ np.abs(x) + np.abs(right)
    return float((np.abs(matrix @ x - right) / scale).max())


@given(st.integers(1, 30), st.floats(0.02, 0.7), st.integers(0, 1000))
def test_solves_what_numpy_solves(size: int, density: float, seed: int) -> None:
    matrix = random_matrix(size, density, seed)
    right = np.cos(np.arange(size) + seed)
    factors = Factors(matrix != 0)
    if factors.factor(matrix) != 0:
        assert np.linalg.cond(matrix) > 1e12
        return
    assert residual(matrix, factors.solve(right), right) < 1e-9


@given(st.integers(2, 25), st.integers(0, 1000))
def test_new_values_reuse_the_pivots_while_they_are_good(size: int, seed: int) -> None:
    matrix = random_matrix(size, 0.2, seed) + 3.0 * np.eye(size)
    right = np.cos(np.arange(size) + seed)
    factors = Factors(matrix != 0)
    assert factors.factor(matrix) == 0
    other = np.where(matrix != 0, matrix + 0.01 * np.sin(matrix * 50), 0.0)
    assert factors.factor(other) == 0
    assert (factors.lu.searches, factors.lu.repeats) == (1, 1)
    assert residual(other, factors.solve(right), right) < 1e-12
    decayed = other.copy()
    decayed[0, 0] *= 1e-13
    if np.linalg.cond(decayed) < 1e8:
        assert factors.factor(decayed) == 0
        assert residual(decayed, factors.solve(right), right) < 1e-9


def test_singular_matrix_and_too_little_memory_are_told() -> None:
    matrix = np.ones((3, 3))
    assert Factors(matrix != 0).factor(matrix) == binding.SINGULAR
    full = random_matrix(8, 1.0, 3) + 5.0 * np.eye(8)
    assert Factors(full != 0, capacity=10).factor(full) == binding.MEMORY
