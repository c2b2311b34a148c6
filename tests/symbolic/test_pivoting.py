"""Greedy independent columns: rank against NumPy, order of preference, constant pivots first."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from acausal.symbolic.pivoting import Column, Entry, independent_columns

matrices = st.integers(1, 5).flatmap(
    lambda rows: st.lists(
        st.lists(st.sampled_from([-2.0, -1.0, 0.0, 0.0, 1.0, 3.0]), min_size=rows, max_size=rows),
        min_size=1,
        max_size=7,
    )
)


def columns(matrix: list[list[float]], constant: bool = True) -> list[Column]:
    return [{i: Entry(v, constant) for i, v in enumerate(column) if v} for column in matrix]


def chosen(columns: list[Column], groups: Sequence[Sequence[int]], n_rows: int) -> list[int]:
    return [column for column, _ in independent_columns(columns, groups, n_rows)]


def rank(matrix: list[list[float]]) -> int:
    return int(np.linalg.matrix_rank(np.array(matrix, dtype=float))) if matrix else 0


@given(matrices, st.booleans())
def test_the_columns_chosen_are_a_basis(matrix: list[list[float]], constant: bool) -> None:
    n_rows = len(matrix[0])
    pivots = independent_columns(columns(matrix, constant), [range(len(matrix))], n_rows)
    basis = [column for column, _ in pivots]
    assert len({row for _, row in pivots}) == len(pivots)
    assert len(basis) == len(set(basis)) == rank(matrix)
    assert rank([matrix[i] for i in basis]) == len(basis)


@given(matrices)
def test_of_constant_columns_the_first_independent_ones_are_taken(matrix: list[list[float]]) -> None:
    n_rows = len(matrix[0])
    expected: list[int] = []
    for i in range(len(matrix)):
        if len(expected) < n_rows and rank([matrix[k] for k in [*expected, i]]) > len(expected):
            expected.append(i)
    assert chosen(columns(matrix), [range(len(matrix))], n_rows) == expected


def test_groups_go_before_constant_pivots() -> None:
    varying, constant = {0: Entry(0.5, False)}, {0: Entry(1.0, True)}
    assert chosen([varying, constant], [[0, 1]], 1) == [1]
    assert chosen([varying, constant], [[0], [1]], 1) == [0]


def test_small_varying_pivots_come_last() -> None:
    small, large = {0: Entry(0.01, False)}, {0: Entry(1.0, False)}
    assert chosen([small, large], [[0, 1]], 1) == [1]
    assert chosen([small], [[0]], 1) == [0]


def test_soundness_goes_before_soft_groups_only() -> None:
    small, large = {0: Entry(0.01, False)}, {0: Entry(1.0, False)}

    def first(soft: int) -> int:
        return independent_columns([small, large], [[0], [1]], 1, soft=soft)[0][0]

    assert [first(0), first(1), first(2)] == [0, 0, 1]


def test_a_long_band_costs_local_work() -> None:
    n = 3000
    band: list[Column] = [
        {row: Entry(1.0 + 0.1 * (row == i), True) for row in (i - 1, i, i + 1) if 0 <= row < n}
        for i in range(n)
    ]
    assert len(independent_columns(band, [range(n)], n)) == n
