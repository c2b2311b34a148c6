from dataclasses import replace

import pytest
from hypothesis import given, settings

from acausal.symbolic.graphs.dulmage_mendelsohn import (
    REPORTED,
    Part,
    StructurallySingular,
    decompose,
    overdetermined_subset,
    require_complete,
    underdetermined_subset,
)
from acausal.symbolic.graphs.matching import maximum_matching
from acausal.symbolic.graphs.types import Eq, Var
from tests.symbolic.graphs.samples import Rows, adverse_chain, incidences, lines_executed, rows_of

# Equations 0..2 with variables 0, 1 are one too many, equation 3 with variable 2 is right, and equations
# 4, 5 with variables 3..5 are one too few; 3 and 4 refer to other parts.
MIXED = rows_of([0, 1], [1, 0], [0], [2, 0], [3, 4, 2], [4, 5])


def rank(rows: Rows, eqs: tuple[Eq, ...]) -> int:
    return maximum_matching(
        [rows[eq] for eq in eqs], 1 + max((v for row in rows for v in row), default=0)
    ).size


def test_each_part_of_a_mixed_system() -> None:
    parts = decompose(MIXED, maximum_matching(MIXED, 6))
    assert parts.over == Part((Eq(0), Eq(1), Eq(2)), (Var(0), Var(1)))
    assert parts.well == Part((Eq(3),), (Var(2),))
    assert parts.under == Part((Eq(4), Eq(5)), (Var(3), Var(4), Var(5)))


@given(incidences())
@settings(max_examples=200, deadline=None)
def test_parts_divide_the_system_and_are_what_they_are_called(sample: tuple[Rows, int]) -> None:
    rows, n_vars = sample
    parts = decompose(rows, maximum_matching(rows, n_vars))
    over, under, well = parts.over, parts.under, parts.well
    assert sorted(over.equations + under.equations + well.equations) == list(range(len(rows)))
    assert sorted(over.variables + under.variables + well.variables) == list(range(n_vars))
    assert all(set(rows[eq]) <= set(over.variables) for eq in over.equations)
    assert not any(set(rows[eq]) & set(under.variables) for eq in over.equations + well.equations)
    assert rank(rows, over.equations) == len(over.variables)
    assert len(over.equations) > len(over.variables) or over == Part((), ())
    own = [[var for var in rows[eq] if var in under.variables] for eq in under.equations]
    assert maximum_matching(own, n_vars).size == len(under.equations)
    assert len(under.variables) > len(under.equations) or under == Part((), ())
    inner = [[var for var in rows[eq] if var in well.variables] for eq in well.equations]
    assert maximum_matching(inner, n_vars).size == len(well.equations) == len(well.variables)


@given(incidences())
@settings(deadline=None)
def test_parts_do_not_depend_on_the_matching(sample: tuple[Rows, int]) -> None:
    rows, n_vars = sample
    backwards = maximum_matching([row[::-1] for row in rows], n_vars, [Eq(i) for i in range(len(rows))][::-1])
    assert decompose(rows, backwards) == decompose(rows, maximum_matching(rows, n_vars))


@given(incidences())
@settings(max_examples=200, deadline=None)
def test_overdetermined_subset_is_minimal(sample: tuple[Rows, int]) -> None:
    rows, n_vars = sample
    matching = maximum_matching(rows, n_vars)
    for eq in matching.unmatched_equations():
        part = overdetermined_subset(rows, matching, eq)
        assert eq in part.equations
        assert set(part.variables) == {var for e in part.equations for var in rows[e]}
        assert len(part.equations) == len(part.variables) + 1
        for dropped in part.equations:
            rest = tuple(e for e in part.equations if e != dropped)
            assert rank(rows, rest) == len(rest)


@given(incidences())
@settings(max_examples=200, deadline=None)
def test_any_variable_of_an_underdetermined_subset_may_be_the_free_one(sample: tuple[Rows, int]) -> None:
    rows, n_vars = sample
    matching = maximum_matching(rows, n_vars)
    for var in matching.unmatched_variables():
        part = underdetermined_subset(rows, matching, var)
        assert var in part.variables
        assert len(part.variables) == len(part.equations) + 1
        for given_var in part.variables:
            others = set(part.variables) - {given_var}
            inner = [[v for v in rows[eq] if v in others] for eq in part.equations]
            assert maximum_matching(inner, n_vars).size == len(others)


def test_complete_matching_is_returned() -> None:
    assert require_complete(rows_of([0, 1], [0]), 2).var_of_eq == (1, 0)


def test_singular_system_names_its_equations_and_minimal_subsets() -> None:
    rows = rows_of([0], [0], [1, 2], [3], [3])
    with pytest.raises(StructurallySingular, match=r"equations \[1, 4\]") as caught:
        require_complete(rows, 4)
    assert caught.value.equations == (1, 4)
    assert caught.value.subsets == (Part((Eq(0), Eq(1)), (Var(0),)), Part((Eq(3), Eq(4)), (Var(3),)))


def test_all_unmatched_equations_but_not_all_subsets_are_reported() -> None:
    n = 2 * REPORTED
    with pytest.raises(StructurallySingular) as caught:
        require_complete([*adverse_chain(n), *adverse_chain(n)], n)
    assert len(caught.value.equations) == n
    assert len(caught.value.subsets) == REPORTED


def test_matching_that_is_not_maximum_is_refused() -> None:
    rows = rows_of([0, 1], [0])
    matching = maximum_matching(rows, 2)
    poor = replace(matching, var_of_eq=(Var(0), None), eq_of_var=(Eq(0), None), size=1)
    with pytest.raises(ValueError, match="not maximum: variable 1"):
        decompose(rows, poor)
    with pytest.raises(ValueError, match="not maximum: variable 1"):
        overdetermined_subset(rows, poor, Eq(1))
    with pytest.raises(ValueError, match="not maximum: equation 1"):
        underdetermined_subset(rows, poor, Var(1))
    with pytest.raises(ValueError, match="equation 0 is matched"):
        overdetermined_subset(rows, matching, Eq(0))
    with pytest.raises(ValueError, match="variable 0 is matched"):
        underdetermined_subset(rows, matching, Var(0))


def test_work_is_linear_in_a_chain() -> None:
    work: list[int] = []
    for n in (1_000, 4_000):
        rows = [*adverse_chain(n), *rows_of([0], [n // 2])]
        matching = maximum_matching(rows, n)
        work.append(lines_executed(lambda rows=rows, matching=matching: decompose(rows, matching)))
    assert work[1] < 5 * work[0]
