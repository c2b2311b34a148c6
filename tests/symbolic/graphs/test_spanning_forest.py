"""Spanning forests of virtual connection graphs."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from acausal.symbolic.graphs.spanning_forest import Edge, spanning_forest


def test_a_loop_loses_one_optional_edge() -> None:
    forest = spanning_forest(3, [(0, 1)], [(1, 2), (2, 0)], [0], {})
    assert forest.kept == (True, False)
    assert forest.depth == (0, 1, 2)


def test_two_definite_roots_are_never_joined() -> None:
    forest = spanning_forest(4, [], [(0, 1), (1, 2), (2, 3)], [0, 3], {})
    assert forest.kept == (True, True, False)
    assert forest.roots == (0, 3)


def test_potential_root_with_the_lowest_priority_number() -> None:
    forest = spanning_forest(4, [], [(0, 1), (2, 3)], [], {0: 2, 1: 1, 2: 0, 3: 0})
    assert forest.roots == (1, 2)


def test_potential_root_yields_to_a_definite_one() -> None:
    assert spanning_forest(2, [(0, 1)], [], [1], {0: 0}).roots == (1,)


def test_part_without_roots() -> None:
    forest = spanning_forest(3, [(1, 2)], [], [0], {})
    assert forest.rootless == (1,)
    assert forest.roots == (0, 1)


def test_required_edges_that_close_a_circle() -> None:
    assert spanning_forest(2, [(0, 1), (1, 0)], [], [0], {}).circles == ((1, 0),)
    assert spanning_forest(2, [(0, 1)], [], [0, 1], {}).circles == ((0, 1),)


_EDGES = st.lists(st.tuples(st.integers(0, 7), st.integers(0, 7)), max_size=14)


@given(_EDGES, st.sets(st.integers(0, 7)))
def test_every_node_hangs_on_one_root_and_kept_edges_are_a_forest(
    optional: list[Edge], definite: set[int]
) -> None:
    forest = spanning_forest(8, [], optional, sorted(definite), {})
    assert all(depth >= 0 for depth in forest.depth)
    assert sum(forest.kept) + len(forest.roots) == 8
