from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import csr_array
from scipy.sparse.csgraph import maximum_bipartite_matching

from acausal.symbolic.graphs.matching import Matcher, Matching, maximum_matching
from acausal.symbolic.graphs.types import Eq, Var
from tests.symbolic.graphs.samples import (
    Rows,
    adverse_chain,
    adverse_chains,
    grid,
    incidences,
    lines_executed,
    random_rows,
    rows_of,
    shuffled,
    width,
)


def assert_valid(rows: Rows, matching: Matching) -> None:
    pairs = [(eq, var) for eq, var in enumerate(matching.var_of_eq) if var is not None]
    assert all(var in rows[eq] for eq, var in pairs)
    assert pairs == sorted((eq, var) for var, eq in enumerate(matching.eq_of_var) if eq is not None)
    assert matching.size == len(pairs)
    assert len(matching.unmatched_equations()) == len(rows) - len(pairs)
    assert len(matching.unmatched_variables()) == len(matching.eq_of_var) - len(pairs)


def brute_force_size(rows: Rows) -> int:
    """The largest matching by trying, for each equation, every variable and none."""
    reachable: set[frozenset[int]] = {frozenset()}
    for row in rows:
        reachable |= {used | {var} for used in reachable for var in row if var not in used}
    return max(len(used) for used in reachable)


@given(incidences())
@settings(max_examples=300, deadline=None)
def test_size_is_that_of_brute_force(sample: tuple[Rows, int]) -> None:
    rows, n_vars = sample
    matching = maximum_matching(rows, n_vars)
    assert_valid(rows, matching)
    assert matching.size == brute_force_size(rows)


@given(st.integers(1, 120), st.integers(1, 120), st.floats(0.5, 4), st.integers(0, 10**6))
@settings(max_examples=80, deadline=None)
def test_size_is_that_of_scipy(n_eqs: int, n_vars: int, degree: float, seed: int) -> None:
    rows = random_rows(n_eqs, n_vars, degree, seed)
    matching = maximum_matching(rows, n_vars)
    assert_valid(rows, matching)
    dense = np.zeros((n_eqs, n_vars), dtype=np.int8)
    for eq, row in enumerate(rows):
        dense[eq, row] = 1
    assert matching.size == int((maximum_bipartite_matching(csr_array(dense)) >= 0).sum())


@given(incidences(), st.data())
@settings(deadline=None)
def test_any_order_gives_the_same_size_and_keeps_the_first_choice(
    sample: tuple[Rows, int], data: st.DataObject
) -> None:
    rows, n_vars = sample
    order = data.draw(st.permutations([Eq(i) for i in range(len(rows))]))
    matching = maximum_matching(rows, n_vars, order)
    assert_valid(rows, matching)
    assert matching.size == brute_force_size(rows)
    first = next((eq for eq in order if rows[eq]), None)
    assert first is None or matching.var_of_eq[first] is not None


def test_first_variable_in_the_list_is_preferred() -> None:
    assert maximum_matching(rows_of([2, 0], [1, 2]), 3).var_of_eq == (2, 1)
    assert maximum_matching(rows_of([0, 2], [2, 1]), 3).var_of_eq == (0, 2)


def test_order_decides_who_chooses_first_and_who_takes_part() -> None:
    rows = rows_of([0, 1], [0, 2])
    assert maximum_matching(rows, 3, [Eq(0), Eq(1)]).var_of_eq == (0, 2)
    assert maximum_matching(rows, 3, [Eq(1), Eq(0)]).var_of_eq == (1, 0)
    assert maximum_matching(rows, 3, [Eq(1)]).var_of_eq == (None, 0)


@pytest.mark.parametrize("bad", [[3], [-1]])
def test_unknown_variable_is_an_error(bad: list[int]) -> None:
    with pytest.raises(ValueError, match="equation 1 names a variable outside"):
        maximum_matching(rows_of([0], bad), 3)


def test_matcher_extends_what_is_matched() -> None:
    matcher = Matcher(rows_of([0], [0]), 1)
    assert matcher.augment([Eq(0), Eq(1)]) == [1]
    assert matcher.reached == [1, 0]
    extra = matcher.add_variable()
    third = matcher.add_equation([Var(0), extra])
    assert matcher.augment([third]) == []
    assert matcher.freeze() == Matching((Var(0), None, extra), (Eq(0), third), 2)


def test_no_search_passes_a_retired_variable() -> None:
    rows = rows_of([0, 1], [0])
    free, blocked = Matcher(rows, 2), Matcher(rows, 2)
    for matcher in (free, blocked):
        assert matcher.augment([Eq(0)]) == []
    blocked.retire(Var(0))
    assert free.augment([Eq(1)]) == []
    assert blocked.augment([Eq(1)]) == [1]


def shuffled_grid(n: int) -> Rows:
    return shuffled(grid(round(n**0.5)), round(n**0.5) ** 2, seed=n)


def shuffled_chains(n: int) -> Rows:
    rows = adverse_chains(n, 3)
    return shuffled(rows, width(rows), seed=n)


FAMILIES: dict[str, Callable[[int], Rows]] = {
    "chain": adverse_chain,
    "shuffled chain": lambda n: shuffled(adverse_chain(n), n, seed=n),
    "chains": lambda n: adverse_chains(n, 3),
    "shuffled chains": shuffled_chains,
    "shuffled grid": shuffled_grid,
    "singular chain": lambda n: [*adverse_chain(n), *rows_of(*([i] for i in range(n)))],
}


@pytest.mark.parametrize("family", FAMILIES)
def test_work_is_nearly_linear(family: str) -> None:
    work: list[float] = []
    for n in (1_000, 2_000, 4_000, 8_000):
        rows = FAMILIES[family](n)
        n_vars = width(rows)
        work.append(
            lines_executed(lambda rows=rows, n_vars=n_vars: maximum_matching(rows, n_vars)) / len(rows)
        )
    assert all(after < 1.7 * before for before, after in pairwise(work))
    assert work[-1] < 2 * work[0]


def test_long_chain_needs_no_recursion() -> None:
    n = 100_000
    matching = maximum_matching(adverse_chain(n), n)
    assert matching.var_of_eq == tuple(range(n))
