"""Sums of rows that cancel, although every row has a column of its own."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from acausal.symbolic.graphs.cancellation import cancelling_sums
from acausal.symbolic.graphs.types import Eq, Var


def rows(*entries: dict[int, int]) -> list[dict[Var, int]]:
    return [{Var(column): value for column, value in row.items()} for row in entries]


def test_balances_of_a_bridge_that_floats() -> None:
    """Six branches from three nodes to two, whose balances share the return current 6."""
    nodes = rows(
        {0: -1, 3: 1}, {1: -1, 4: 1}, {2: -1, 5: 1}, {0: 1, 1: 1, 2: 1, 6: -1}, {3: 1, 4: 1, 5: 1, 6: -1}
    )
    (found,) = cancelling_sums(nodes)
    assert sorted(found) == [0, 1, 2, 3, 4]
    assert {abs(factor) for factor in found.values()} == {1}
    assert found[list(found)[-1]] == 1


def test_a_column_of_its_own_keeps_a_row_out() -> None:
    assert cancelling_sums(rows({0: 1, 1: 1}, {0: 1, 1: 1, 2: 1})) == []


def test_what_structure_shows_is_left_out() -> None:
    """Two rows over one column: no matching, so index reduction sees it."""
    assert cancelling_sums(rows({0: 1}, {0: 2})) == []
    assert cancelling_sums(rows({}, {0: 1})) == []


def test_factors_are_exact() -> None:
    (found,) = cancelling_sums(rows({0: 3, 1: 7}, {0: 6, 1: 14}))
    assert sorted(found.values()) in ([Fraction(-2), Fraction(1)], [Fraction(-1, 2), Fraction(1)])


_ROWS = st.lists(st.dictionaries(st.integers(0, 4), st.sampled_from([-2, -1, 1, 2]), max_size=4), max_size=6)


@given(_ROWS)
def test_sums_vanish_and_are_independent(entries: list[dict[int, int]]) -> None:
    given_rows = rows(*entries)
    found = cancelling_sums(given_rows)
    table = np.zeros((len(entries), 5))
    for i, row in enumerate(entries):
        table[i, list(row)] = list(row.values())
    factors = np.zeros((len(found), len(entries)))
    for k, one in enumerate(found):
        factors[k, list(one)] = [float(value) for value in one.values()]
    assert np.abs(factors @ table).max(initial=0.0) < 1e-12
    last = [list(one)[-1] for one in found]
    assert len(set(last)) == len(last)
    kept = [i for i in range(len(entries)) if Eq(i) not in last]
    assert np.linalg.matrix_rank(table[kept]) == np.linalg.matrix_rank(table)
