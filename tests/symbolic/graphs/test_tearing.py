import random
from collections.abc import Callable

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from acausal.symbolic.graphs.tearing import Tearing, tear
from acausal.symbolic.graphs.types import Eq, Var
from tests.symbolic.graphs.samples import Rows, grid, lines_executed, random_loop, rows_of, shuffled


def anything(_eq: Eq, _var: Var) -> bool:
    return True


def share(rows: Rows, percent: int, seed: int) -> Callable[[Eq, Var], bool]:
    """That share of all pairs, chosen at random, is solvable."""
    rng = random.Random(seed)
    pairs = {(eq, var) for eq, row in enumerate(rows) for var in row if rng.randrange(100) < percent}
    return lambda eq, var: (eq, var) in pairs


def assert_valid(rows: Rows, solvable: Callable[[Eq, Var], bool], tearing: Tearing) -> None:
    known = set(tearing.tearing_vars)
    assert len(known) == len(tearing.tearing_vars) == len(tearing.residuals)
    for eq, var in tearing.assignments:
        assert solvable(eq, var)
        assert var not in known
        assert set(rows[eq]) <= known | {var}
        assert var in rows[eq]
        known.add(var)
    assert known == set(range(len(rows)))
    used = [eq for eq, _ in tearing.assignments]
    assert sorted([*used, *tearing.residuals]) == list(range(len(rows)))
    assert list(tearing.residuals) == sorted(tearing.residuals)


@given(st.integers(1, 40), st.integers(0, 3), st.integers(0, 100), st.integers(0, 10**6))
@settings(max_examples=300, deadline=None)
def test_assignments_are_causal_and_solvable(n: int, extra: int, percent: int, seed: int) -> None:
    rows = random_loop(n, extra, seed)
    solvable = share(rows, percent, seed)
    assert_valid(rows, solvable, tear(rows, solvable, n))


def test_ring_needs_one_guess() -> None:
    rows = random_loop(200, 0, seed=1)
    tearing = tear(rows, anything, 200)
    assert_valid(rows, anything, tearing)
    assert len(tearing.tearing_vars) == 1


def test_triangular_system_needs_no_guess_and_runs_in_order() -> None:
    rows = rows_of([2, 1], [0], [1, 0])
    assert tear(rows, anything, 3) == Tearing((), ((Eq(1), Var(0)), (Eq(2), Var(1)), (Eq(0), Var(2))), ())


def test_variable_of_one_equation_is_assigned_last() -> None:
    rows = rows_of([0, 1, 2], [0, 1], [1, 0])
    tearing = tear(rows, anything, 3)
    assert_valid(rows, anything, tearing)
    assert (len(tearing.tearing_vars), tearing.assignments[-1]) == (1, (0, 2))


def test_equation_solvable_for_nothing_is_the_residual() -> None:
    rows = rows_of([0, 1, 2], [0, 1], [1, 2])
    tearing = tear(rows, lambda eq, _var: eq != 0, 3)
    assert tearing.residuals == (0,)
    assert len(tearing.tearing_vars) == 1


def test_variable_solvable_nowhere_is_the_guess() -> None:
    rows = rows_of([0, 1, 2], [0, 1], [1, 2])
    assert tear(rows, lambda _eq, var: var != 1, 3).tearing_vars == (1,)


def test_nothing_solvable_means_everything_is_guessed() -> None:
    rows = random_loop(10, 1, seed=3)
    tearing = tear(rows, lambda _eq, _var: False, 10)
    assert sorted(tearing.tearing_vars) == list(range(10))
    assert tearing.residuals == tuple(range(10))


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_grid_needs_one_guess_per_row_in_any_numbering(seed: int) -> None:
    rows = shuffled(grid(20), 400, seed)
    tearing = tear(rows, anything, 400)
    assert_valid(rows, anything, tearing)
    assert len(tearing.tearing_vars) == 20


class Reference:
    """The rules of `tear`, each count taken afresh."""

    def __init__(self, rows: Rows, solvable: Callable[[Eq, Var], bool]) -> None:
        self.eqs = {Eq(i): set(row) for i, row in enumerate(rows)}
        self.solvable = solvable
        self.guesses = 0

    def pairs(self, eq: Eq) -> list[Var]:
        return [var for var in self.eqs[eq] if self.solvable(eq, var)]

    def column(self, var: Var) -> list[Eq]:
        return [eq for eq, row in self.eqs.items() if var in row]

    def know(self, var: Var) -> None:
        for row in self.eqs.values():
            row.discard(var)

    def settle_one(self, unknown: set[Var]) -> bool:
        for eq, row in self.eqs.items():
            if not self.pairs(eq) or len(row) == 1:
                for var in self.pairs(eq):
                    unknown.discard(var)
                    self.know(var)
                del self.eqs[eq]
                return True
        for var in unknown:
            column = self.column(var)
            solving = [eq for eq in column if self.solvable(eq, var)]
            if not solving or len(column) == 1:
                unknown.discard(var)
                self.know(var)
                self.guesses += not solving
                for eq in solving:
                    del self.eqs[eq]
                return True
        return False

    def key(self, var: Var) -> tuple[int, int, int, Var]:
        column = self.column(var)
        short = [eq for eq in column if len(self.eqs[eq]) == 2]
        released = sum(other != var for eq in short for other in self.pairs(eq))
        unsolvable = sum(not self.solvable(eq, var) for eq in column)
        return (-released, -unsolvable, -len(column), var)

    def run(self) -> int:
        unknown = {var for row in self.eqs.values() for var in row}
        while True:
            while self.settle_one(unknown):
                pass
            if not self.eqs:
                return self.guesses
            key = min(self.key(var) for var in unknown)
            if key[0] == 0:
                fewest = min(self.eqs, key=lambda eq: (len(self.eqs[eq]), eq))
                key = min(self.key(var) for var in self.eqs[fewest])
            unknown.discard(key[-1])
            self.know(key[-1])
            self.guesses += 1


@pytest.mark.parametrize("percent", [30, 50, 70, 90, 100])
def test_guesses_follow_the_rule_stated(percent: int) -> None:
    for seed in range(30):
        n = 2 + seed
        rows = random_loop(n, 1 + seed % 3, seed)
        solvable = share(rows, percent, seed)
        assert len(tear(rows, solvable, n).tearing_vars) == Reference(rows, solvable).run()


def cellier_guesses(rows: Rows) -> int:
    """The textbook rule, naively: guess the most frequent variable of the equation with most unknowns."""
    open_rows = [set(row) for row in rows]
    guesses = 0
    while any(open_rows):
        ready = next((row for row in open_rows if len(row) == 1), None)
        if ready is None:
            longest = max(open_rows, key=len)
            var = max(sorted(longest), key=lambda var: sum(var in row for row in open_rows))
            guesses += 1
        else:
            (var,) = ready
            ready.clear()
        for row in open_rows:
            row.discard(var)
    return guesses


def test_fewer_guesses_than_the_textbook_rule() -> None:
    loops = [random_loop(150, 2, seed) for seed in range(5)]
    guesses = [len(tear(rows, anything, 150).tearing_vars) for rows in loops]
    assert sum(guesses) < 0.9 * sum(cellier_guesses(rows) for rows in loops)


@pytest.mark.parametrize("extra", [0, 2])
def test_work_is_nearly_linear(extra: int) -> None:
    work: list[int] = []
    for n in (1_000, 4_000):
        rows = random_loop(n, extra, seed=n)
        work.append(lines_executed(lambda rows=rows, n=n: tear(rows, anything, n)))
    assert work[1] < 4.8 * work[0]


def test_work_on_a_grid_is_nearly_linear() -> None:
    work: list[int] = []
    for m in (30, 60):
        rows = shuffled(grid(m), m * m, seed=m)
        work.append(lines_executed(lambda rows=rows, m=m: tear(rows, anything, m * m)))
    assert work[1] < 4.8 * work[0]


def test_loop_that_is_not_square_is_refused() -> None:
    with pytest.raises(ValueError, match="1 equations for 2 variables"):
        tear(rows_of([0, 1]), anything, 2)
    with pytest.raises(ValueError, match="outside"):
        tear(rows_of([0, 2], [0]), anything, 2)
