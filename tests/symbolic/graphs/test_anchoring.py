"""Chains of assignments that grow are cut, those that do not stay whole."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from acausal.symbolic.graphs.anchoring import Coefficients, anchored
from acausal.symbolic.graphs.tearing import Tearing, tear
from acausal.symbolic.graphs.types import Eq, Var
from tests.symbolic.graphs.samples import lines_executed

Rows = Sequence[Coefficients]


def anything(_eq: Eq, _var: Var) -> bool:
    return True


def ring(size: int, diagonal: float | None) -> Rows:
    """`diagonal x[i] = x[i-1] + x[i+1]`, closed to a ring."""
    return [{Var(i): diagonal, Var((i - 1) % size): -1.0, Var((i + 1) % size): -1.0} for i in range(size)]


def torn(rows: Rows) -> Tearing:
    return tear([list(row) for row in rows], anything, len(rows))


def solved(tearing: Tearing, rows: Rows, right: Sequence[float]) -> list[float]:
    """The solution by substitution along the assignments, which loses digits where they grow."""

    def run(guesses: Sequence[float], b: Sequence[float]) -> tuple[dict[int, float], list[float]]:
        x: dict[int, float] = dict(zip(tearing.tearing_vars, guesses, strict=True))
        for eq, var in tearing.assignments:
            rest = sum((a or 0.0) * x[v] for v, a in rows[eq].items() if v != var)
            x[var] = (b[eq] - rest) / (rows[eq][var] or 0.0)
        return x, [b[eq] - sum((a or 0.0) * x[v] for v, a in rows[eq].items()) for eq in tearing.residuals]

    count = len(tearing.tearing_vars)
    zero = [0.0] * len(rows)
    columns = [run(np.eye(count)[k].tolist(), zero)[1] for k in range(count)]
    guesses = np.linalg.solve(-np.array(columns).T, run([0.0] * count, right)[1])
    x = run(guesses.tolist(), right)[0]
    return [x[i] for i in range(len(rows))]


def matrix(rows: Rows) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    full = np.zeros((len(rows), len(rows)))
    for eq, row in enumerate(rows):
        for var, a in row.items():
            full[eq, var] = a
    return full


@pytest.mark.parametrize("size", [8, 60, 200])
@pytest.mark.parametrize("diagonal", [4.0, -3.0, 100.0])
def test_digits_of_the_solution_are_kept(size: int, diagonal: float) -> None:
    rows = ring(size, diagonal)
    right = [1.0 + (i * 0.37) % 1 for i in range(size)]
    exact = np.linalg.solve(matrix(rows), right)
    assert solved(anchored(torn(rows), rows), rows, right) == pytest.approx(exact, rel=1e-9)


@pytest.mark.parametrize(("size", "width"), [(60, 3), (90, 3), (120, 11)])
def test_bands_of_several_links_keep_their_digits(size: int, width: int) -> None:
    """Errors grow along the chains of such a ladder, and again where they are matched."""
    rows: list[dict[Var, float | None]] = [{Var(i): 0.2 + 0.001 * i} for i in range(size)]
    for step, g in ((1, 0.3), (width, 0.1)):
        for i in range(size - step):
            for a, b in ((i, i + step), (i + step, i)):
                rows[a][Var(a)] = (rows[a][Var(a)] or 0.0) + g
                rows[a][Var(b)] = -g
    right = [1.0 if i == 2 else 0.0 for i in range(size)]
    exact = np.linalg.solve(matrix(rows), right)
    assert solved(anchored(torn(rows), rows), rows, right) == pytest.approx(exact, abs=1e-11)


def test_a_growing_chain_needs_more_guesses_and_no_more_than_it_must() -> None:
    """Growth by 3.7 a step is 1e4 after seven: two guesses for every eight steps or so."""
    rows = ring(200, 4.0)
    plain, cut = torn(rows), anchored(torn(rows), ring(200, 4.0))
    assert len(plain.tearing_vars) == 2
    assert 20 <= len(cut.tearing_vars) <= 60
    assert len(cut.residuals) == len(cut.tearing_vars)
    guessed = [*cut.tearing_vars, *(var for _, var in cut.assignments)]
    assert sorted(guessed) == list(range(200))
    assert sorted([*cut.residuals, *(eq for eq, _ in cut.assignments)]) == list(range(200))


def test_a_chain_that_does_not_grow_stays_whole() -> None:
    """Forces along a train of rigid gears add up: no more than their number."""
    size = 1000
    rows: Rows = [
        {Var(i): 1.0, Var(i + 1): -1.0} if i < size - 1 else {Var(v): 1.0 for v in range(size)}
        for i in range(size)
    ]
    assert anchored(torn(rows), rows) == torn(rows)


def test_units_do_not_matter() -> None:
    """The same chain in other units, its equations times other numbers."""
    rows = ring(100, 4.0)
    other: Rows = [
        {var: (a or 0.0) * 10.0 ** (eq % 7 - 3) * 1e5 ** (var % 2) for var, a in row.items()}
        for eq, row in enumerate(rows)
    ]
    count = len(anchored(torn(rows), rows).tearing_vars)
    assert abs(len(anchored(torn(other), other).tearing_vars) - count) <= 4


def test_a_small_pivot_is_not_divided_by() -> None:
    rows: Rows = [
        {Var(0): 1e-9, Var(1): 1.0, Var(2): 1.0},
        {Var(0): 1.0, Var(1): -1.0},
        {Var(0): 1.0, Var(2): 2.0},
    ]
    tearing = Tearing((Var(1),), ((Eq(1), Var(0)), (Eq(0), Var(2))), (Eq(2),))
    assert anchored(tearing, rows) == tearing
    tearing = Tearing((Var(1), Var(2)), ((Eq(0), Var(0)),), (Eq(1), Eq(2)))
    assert anchored(tearing, rows) == Tearing((Var(1), Var(2), Var(0)), (), (Eq(0), Eq(1), Eq(2)))


def test_unknown_coefficients_count_as_the_largest() -> None:
    assert len(anchored(torn(ring(100, None)), ring(100, None)).tearing_vars) == 2
    assert len(anchored(torn(ring(100, 4.0)), ring(100, 4.0)).tearing_vars) > 10


def grid(size: int) -> Rows:
    """Kirchhoff's laws on a grid of resistors: potentials of the nodes and currents of the links."""
    node = {(i, j): Var(i * size + j) for i in range(size) for j in range(size)}
    links = [((i, j), (i + di, j + dj)) for i, j in node for di, dj in ((0, 1), (1, 0))]
    rows: list[dict[Var, float | None]] = [{var: 0.1} for var in node.values()]
    for number, (a, b) in enumerate([link for link in links if link[1] in node]):
        current = Var(len(node) + number)
        rows.append({node[a]: 1.0, node[b]: -1.0, current: -(1.0 + number % 3)})
        rows[node[a]][current] = 1.0
        rows[node[b]][current] = -1.0
    return rows


def test_of_a_large_grid_a_sparse_matrix_remains() -> None:
    """No row of it depends on more guesses than a few assignments do."""
    rows = grid(20)
    cut = anchored(torn(rows), rows)
    depends = {var: {var} for var in cut.tearing_vars}
    for eq, var in cut.assignments:
        depends[var] = set[Var]().union(*[depends[other] for other in rows[eq] if other != var])
    entries = sum(len(set[Var]().union(*[depends[var] for var in rows[eq]])) for eq in cut.residuals)
    assert entries < 10 * len(cut.tearing_vars)
    assert len(cut.tearing_vars) < 0.7 * len(rows)


def test_work_is_linear() -> None:
    tearings = {size: torn(ring(size, 4.0)) for size in (500, 2000)}
    work = [lines_executed(lambda n=n: anchored(tearings[n], ring(n, 4.0))) for n in (500, 2000)]
    assert work[1] < 4.2 * work[0]
