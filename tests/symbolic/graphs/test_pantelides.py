from itertools import permutations

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from acausal.symbolic.graphs.dulmage_mendelsohn import Part, StructurallySingular
from acausal.symbolic.graphs.matching import maximum_matching
from acausal.symbolic.graphs.pantelides import Reduction, TooManyDifferentiations, pantelides
from acausal.symbolic.graphs.types import Eq, Var
from tests.symbolic.graphs.samples import lines_executed, rows_of
from tests.symbolic.graphs.systems import (
    HIDDEN,
    INTEGRATORS,
    LINEAR,
    PENDULUM,
    PENDULUM_FIRST_ORDER,
    REACTOR,
    Signature,
    System,
    all_names,
    cells,
    derivative_chain,
    random_signature,
    system,
)


@pytest.mark.parametrize(
    ("sample", "differentiations", "highest"),
    [
        (PENDULUM, (0, 2, 0), {"x''", "y''", "T"}),
        (PENDULUM_FIRST_ORDER, (1, 1, 0, 0, 2), {"x''", "y''", "w'", "z'", "T"}),
        (REACTOR, (1, 0, 1, 2), {"C''", "T'", "R'", "Tc"}),
        (HIDDEN, (0, 1), {"x'", "y'"}),
        (LINEAR, (2, 2, 1, 0), {"x1''", "x2''", "x3''", "x4'"}),
        (INTEGRATORS, (2, 1, 0), {"x''", "y'", "z"}),
        (system([{"x": [1], "y": [0]}, {"x": [0], "y": [0]}]), (0, 0), {"x'", "y"}),
    ],
    ids=["pendulum", "first-order pendulum", "reactor", "hidden", "linear", "integrators", "index one"],
)
def test_examples_of_the_papers(sample: System, differentiations: tuple[int, ...], highest: set[str]) -> None:
    reduction = sample.reduce()
    assert reduction.differentiations == differentiations
    names = all_names(sample, reduction)
    assert {names[var] for var in reduction.matching.var_of_eq if var is not None} == highest
    assert_consistent(sample, reduction)


def test_derivatives_of_the_pendulum_are_appended_in_order() -> None:
    reduction = PENDULUM.reduce()
    names = all_names(PENDULUM, reduction)
    assert names == ["x", "T", "y", "x'", "y'", "x''", "y''"]
    assert reduction.equation_derivative == (None, 3, None, 4, None)
    assert [[names[var] for var in row] for row in reduction.incidence[3:]] == [
        ["x", "y", "x'", "y'"],
        ["x", "y", "x'", "y'", "x''", "y''"],
    ]


def assert_consistent(sample: System, reduction: Reduction) -> None:
    """Every claim `Reduction` makes about itself."""
    n_eqs = len(reduction.incidence)
    assert len(reduction.equation_derivative) == n_eqs == len(sample.rows) + sum(reduction.differentiations)
    assert len(reduction.derivative_of) == reduction.n_vars == len(reduction.matching.eq_of_var)
    assert reduction.derivative_of[: sample.n_vars] == tuple(
        old if old is not None else new
        for old, new in zip(sample.derivative_of, reduction.derivative_of, strict=False)
    )
    assert [set(row) for row in reduction.incidence[: len(sample.rows)]] == [set(row) for row in sample.rows]
    for eq, count in enumerate(reduction.differentiations):
        assert len(derivative_chain(reduction, Eq(eq))) == count + 1
    for eq, derived in enumerate(reduction.equation_derivative):
        assert (reduction.matching.var_of_eq[eq] is None) == (derived is not None)
        if derived is not None:
            row = reduction.incidence[eq]
            higher = {reduction.derivative_of[var] for var in row}
            assert set(reduction.incidence[derived]) == set(row) | higher
            assert len(reduction.incidence[derived]) == len(set(reduction.incidence[derived]))
    pairs = [(eq, var) for eq, var in enumerate(reduction.matching.var_of_eq) if var is not None]
    assert all(var in reduction.incidence[eq] for eq, var in pairs)
    assert all(reduction.derivative_of[var] is None for _, var in pairs)
    assert all(reduction.matching.eq_of_var[var] == eq for eq, var in pairs)
    assert len(pairs) == len(sample.rows) == reduction.matching.size
    assert sum(eq is not None for eq in reduction.matching.eq_of_var) == len(pairs)


def offsets(signature: Signature) -> list[int] | None:
    """Pryce's canonical offsets by their definition: best transversal by brute force, then fixed point."""
    names = sorted({name for equation in signature for name in equation})
    sigma = [{name: max(orders) for name, orders in equation.items()} for equation in signature]
    transversals = [
        choice
        for choice in permutations(names, len(sigma))
        if all(name in row for name, row in zip(choice, sigma, strict=True))
    ]
    if not transversals:
        return None
    best = max(
        transversals,
        key=lambda choice: sum(row[name] for name, row in zip(choice, sigma, strict=True)),
    )
    c = [0] * len(sigma)
    while True:
        d = {
            name: max(row[name] + k for row, k in zip(sigma, c, strict=True) if name in row) for name in names
        }
        after = [d[name] - row[name] for name, row in zip(best, sigma, strict=True)]
        if after == c:
            return c
        c = after


@given(st.integers(1, 5), st.floats(0.1, 2), st.integers(0, 3), st.integers(0, 10**6))
@settings(max_examples=400, deadline=None)
def test_differentiations_are_the_canonical_offsets(n: int, extra: float, order: int, seed: int) -> None:
    signature = random_signature(n, extra, order, seed)
    sample = system(signature)
    reduction = sample.reduce()
    assert_consistent(sample, reduction)
    assert list(reduction.differentiations) == offsets(signature)


@given(st.integers(1, 5), st.floats(0.1, 2), st.integers(0, 10**6), st.data())
@settings(max_examples=200, deadline=None)
def test_singular_systems_are_told_from_others_before_any_work(
    n: int, extra: float, seed: int, data: st.DataObject
) -> None:
    signature = random_signature(n, extra, 2, seed)
    signature[0] = signature[data.draw(st.integers(0, n - 1))]
    sample = system(signature)
    names = {name for equation in signature for name in equation}
    assume(len(names) >= n)
    if offsets(signature) is not None:
        assert_consistent(sample, sample.reduce())
        return
    with pytest.raises(StructurallySingular) as caught:
        sample.reduce()
    for part in caught.value.subsets:
        inside = {name.rstrip("'") for eq in part.equations for name in signature[eq]}
        assert {sample.names[var] for var in part.variables} == inside
        assert len(part.equations) == len(part.variables) + 1


@given(st.integers(2, 40), st.floats(0.5, 2), st.integers(0, 10**6), st.data())
@settings(max_examples=60, deadline=None)
def test_order_of_equations_does_not_matter(n: int, extra: float, seed: int, data: st.DataObject) -> None:
    sample = system(random_signature(n, extra, 2, seed))
    order = data.draw(st.permutations(range(n)))
    permuted = pantelides([sample.rows[eq] for eq in order], sample.n_vars, sample.derivative_of)
    counts = sample.reduce().differentiations
    assert permuted.differentiations == tuple(counts[eq] for eq in order)


def test_singular_system_is_named_by_its_lowest_variables() -> None:
    sample = system([{"x": [0]}, {"x": [2]}, {"y": [1], "x": [0]}])
    with pytest.raises(StructurallySingular) as caught:
        sample.reduce()
    assert caught.value.equations == (1,)
    assert caught.value.subsets == (Part((Eq(0), Eq(1)), (Var(sample.names.index("x")),)),)


def test_too_many_differentiations_are_refused() -> None:
    chain = [{"x0": [0]}, *({f"x{i}": [1], f"x{i + 1}": [0]} for i in range(6))]
    sample = system(chain)
    assert sample.reduce().differentiations == (6, 5, 4, 3, 2, 1, 0)
    assert pantelides(sample.rows, sample.n_vars, sample.derivative_of, limit=6) == sample.reduce()
    with pytest.raises(TooManyDifferentiations, match=r"more than 4 .*\[0\]") as caught:
        pantelides(sample.rows, sample.n_vars, sample.derivative_of, limit=4)
    assert (caught.value.equations, caught.value.limit) == ((0,), 4)


@pytest.mark.parametrize(
    ("derivative_of", "message"),
    [
        ([None], "1 entries in derivative_of for 2 variables"),
        ([2, None], "variable 2, derivative of 0, does not exist"),
        ([1, 1], "variable 1, derivative of 1, does not exist or has two"),
        ([1, 0], "its own derivative"),
    ],
)
def test_impossible_derivatives_are_refused(derivative_of: list[Var | None], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        pantelides(rows_of([0], [1]), 2, derivative_of)


@pytest.mark.parametrize("linked", [False, True])
def test_work_is_linear_in_the_number_of_constraints(linked: bool) -> None:
    work: list[int] = []
    for count in (625, 2_500, 5_000):
        sample = cells(count, linked)
        assert sample.reduce().differentiations == (1, 0, 2) * count
        work.append(lines_executed(sample.reduce))
    assert work[1] < 4.4 * work[0]
    assert work[2] < 2.2 * work[1]


def test_highest_derivatives_of_linked_cells_are_all_matched() -> None:
    sample = cells(300, linked=True)
    reduction = sample.reduce()
    assert_consistent(sample, reduction)
    highest = [
        [var for var in row if reduction.derivative_of[var] is None]
        for row, derived in zip(reduction.incidence, reduction.equation_derivative, strict=True)
        if derived is None
    ]
    assert maximum_matching(highest, reduction.n_vars).size == len(sample.rows)
