import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from acausal.symbolic.graphs.blt import Component, strong_components
from acausal.symbolic.graphs.matching import Matching, maximum_matching
from acausal.symbolic.graphs.types import Eq, Var
from tests.symbolic.graphs.samples import Rows, adverse_chain, lines_executed, random_rows, rows_of, shuffled


def dependencies(rows: Rows, matching: Matching) -> list[tuple[Eq, Eq]]:
    """(e, f) where e needs the variable matched with f."""
    edges: list[tuple[Eq, Eq]] = []
    for eq, row in enumerate(rows):
        owners = [matching.eq_of_var[var] for var in row if matching.var_of_eq[eq] is not None]
        edges += [(Eq(eq), owner) for owner in owners if owner is not None]
    return edges


def test_solving_order_of_a_small_system() -> None:
    rows = rows_of([0, 1], [1, 2, 3], [2, 3], [3, 2], [0, 1, 4])
    found = strong_components(rows, maximum_matching(rows, 5))
    assert [component.equations for component in found] == [(2, 3), (1,), (0,), (4,)]
    assert [component.variables for component in found] == [(2, 3), (1,), (0,), (4,)]


def test_independent_equations_keep_their_order() -> None:
    rows = rows_of([3], [1], [2, 1], [0])
    found = strong_components(rows, maximum_matching(rows, 4))
    assert [component.equations for component in found] == [(0,), (1,), (2,), (3,)]


def test_unmatched_equations_are_left_out_and_unmatched_variables_are_known() -> None:
    rows = rows_of([0, 1], [0], [0, 2])
    matching = Matching((Var(0), None, Var(2)), (Eq(0), None, Eq(2)), 2)
    assert strong_components(rows, matching) == (
        Component((Eq(0),), (Var(0),)),
        Component((Eq(2),), (Var(2),)),
    )


@given(st.integers(1, 60), st.floats(1, 4), st.integers(0, 10**6))
@settings(max_examples=150, deadline=None)
def test_components_are_those_of_scipy_and_come_in_solving_order(n: int, degree: float, seed: int) -> None:
    rows = random_rows(n, n, degree, seed)
    matching = maximum_matching(rows, n)
    found = strong_components(rows, matching)
    position = {eq: at for at, component in enumerate(found) for eq in component.equations}
    assert sorted(position) == [eq for eq in range(n) if matching.var_of_eq[eq] is not None]
    assert sum(len(component.equations) for component in found) == len(position)
    for component in found:
        assert list(component.equations) == sorted(component.equations)
        assert component.variables == tuple(matching.var_of_eq[eq] for eq in component.equations)
    edges = dependencies(rows, matching)
    assert all(position[needed] <= position[eq] for eq, needed in edges)
    ends = np.array(edges, dtype=np.int64).reshape(-1, 2)
    graph = coo_array((np.ones(len(ends), dtype=np.int8), (ends[:, 0], ends[:, 1])), shape=(n, n))
    _, labels = connected_components(graph, directed=True, connection="strong")
    expected = {frozenset(np.flatnonzero(labels == label).tolist()) for label in labels[sorted(position)]}
    assert {frozenset[int](component.equations) for component in found} == expected


def test_work_is_linear_in_chains_and_rings() -> None:
    for seed in (None, 1):
        for closing in ([], [0]):
            work: list[int] = []
            for n in (1_000, 4_000):
                rows = [*adverse_chain(n)[:-1], *rows_of([n - 1, *closing])]
                rows = rows if seed is None else shuffled(rows, n, seed)
                matching = maximum_matching(rows, n)
                work.append(
                    lines_executed(lambda rows=rows, matching=matching: strong_components(rows, matching))
                )
                assert len(strong_components(rows, matching)) == (1 if closing else n)
            assert work[1] < 4.5 * work[0]


def test_long_chain_needs_no_recursion() -> None:
    n = 100_000
    rows = adverse_chain(n)
    found = strong_components(rows, maximum_matching(rows, n))
    assert [component.equations[0] for component in found] == list(range(n))[::-1]


def test_matching_of_another_system_is_refused() -> None:
    with pytest.raises(ValueError, match="matching of 1 equations for 2"):
        strong_components(rows_of([0], [1]), Matching((Var(0),), (Eq(0), None), 1))
