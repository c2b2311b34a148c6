"""Anchors: more guesses where the assignments of a torn loop lose digits.

A long chain of assignments is a recurrence, and one whose solutions grow (`x[i+1] = 4 x[i] - x[i-1]`: by 3.7
a step) loses all digits of a solution that does not grow. Guessing some variables of the chain as well makes
several short chains of it, whose ends are matched by a matrix that is solved with pivoting: multiple shooting
(Ascher, Mattheij and Russell, "Numerical Solution of Boundary Value Problems for Ordinary Differential
Equations", 1988, 4.3), with as many shots as the numbers call for.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from acausal.symbolic.graphs.tearing import Tearing
from acausal.symbolic.graphs.types import Eq, Var

GROWTH = 1e4
"""How much larger than the rounding errors they begin with errors may get along assignments."""
STALE = 1e2
"""The same for errors that the beginning of a new chain should have ended."""
LARGE = 60
"""Guesses from which on a sparse matrix counts for more than a small one."""
NEAR = 6
"""Guesses that an assignment may depend on then."""
_GOLDEN, _ROOT = (5**0.5 - 1) / 2, 2**0.5

Coefficients = Mapping[Var, float | None]
"""Of the variables in one equation; None where it is not a number: it counts as the largest of the others."""


def anchored(tearing: Tearing, rows: Sequence[Coefficients]) -> Tearing:
    """`tearing` with those variables guessed, too, whose errors would grow more than `GROWTH` times.

    Rows and then columns of the matrix are scaled to a largest entry of 1. An error of a generic number for
    each guess, and of that times the sum of its coefficients for each equation, is sent through the
    assignments. Where one of them makes an error too large, the variable it is from is guessed, its equation
    becomes a residual, and the error begins anew; so does that of another variable in the same assignment,
    if it is from before this beginning and above `STALE`: several variables connect the parts of a chain.
    A variable with a small pivot is guessed itself.

    Where that leaves more than `LARGE` guesses, whose matrix had better be sparse, variables are guessed so
    that no assignment depends on more than `NEAR` guesses: of a grid of resistors, its nodes remain. O(E).
    """
    scaled = _equilibrated(rows)
    found = _run(tearing, scaled, len(rows))
    return found if len(found.tearing_vars) <= LARGE else _run(tearing, scaled, NEAR)


def _run(tearing: Tearing, rows: Sequence[Mapping[Var, float]], most: int) -> Tearing:
    chain = _Chain(tearing, rows, most)
    for eq, var in tearing.assignments:
        chain.run(eq, var)
    if not chain.anchors:
        return tearing
    kept = tuple([(eq, var) for eq, var in tearing.assignments if var not in chain.anchors])
    residuals = sorted((*tearing.residuals, *chain.anchors.values()))
    return Tearing((*tearing.tearing_vars, *chain.anchors), kept, tuple(residuals))


class _Chain:
    """Errors along the assignments; the round of a variable is the number of beginnings before it."""

    def __init__(self, tearing: Tearing, rows: Sequence[Mapping[Var, float]], most: int) -> None:
        self.anchors: dict[Var, Eq] = {}
        self._rows = rows
        self._error = {var: _generic(var) for var in tearing.tearing_vars}
        self._round = dict.fromkeys(tearing.tearing_vars, 0)
        self._rounds = 0
        self._equation: dict[Var, Eq] = {}
        self._most = most
        self._guesses = {var: frozenset([var]) for var in tearing.tearing_vars}
        """Which guesses each variable depends on; not kept where `most` allows all."""

    def run(self, eq: Eq, var: Var) -> None:
        """Takes the next assignment."""
        row = self._rows[eq]
        pivot = abs(row[var])
        others = [(other, a) for other, a in row.items() if other != var]
        grown = [other for other, a in others if self._from(other, a) > GROWTH * pivot]
        if sum([self._cut(other, self._rounds + 1) for other in grown]):
            self._rounds += 1
        latest = max((self._round[other] for other, _ in others), default=0)
        for other, a in others:
            if self._round[other] < latest and self._from(other, a) > STALE * pivot:
                self._cut(other, latest)
        error = _generic(eq) * sum(map(abs, row.values()))
        error -= sum(a * self._error[other] for other, a in others)
        self._equation[var] = eq
        self._round[var] = latest
        self._guesses[var] = self._depends([other for other, _ in others])
        if abs(error) > GROWTH * pivot:
            self._cut(var, latest)
        else:
            self._error[var] = error / row[var]

    def _depends(self, others: list[Var]) -> frozenset[Var]:
        """The guesses that these depend on; where they are too many, those with the most are guessed."""
        if self._most >= len(self._rows):
            return frozenset()
        for other in sorted(others, key=lambda v: -len(self._guesses[v])):
            found = frozenset[Var]().union(*[self._guesses[v] for v in others])
            if len(found) <= self._most:
                return found
            self._cut(other, self._round[other])
        return frozenset[Var]().union(*[self._guesses[v] for v in others])

    def _from(self, other: Var, coefficient: float) -> float:
        return abs(coefficient * self._error[other])

    def _cut(self, var: Var, number: int) -> bool:
        """Guesses a variable; False if it was guessed already."""
        if var in self.anchors or var not in self._equation:
            return False
        self.anchors[var] = self._equation[var]
        self._error[var], self._round[var], self._guesses[var] = _generic(var), number, frozenset([var])
        return True


def _equilibrated(rows: Sequence[Coefficients]) -> list[dict[Var, float]]:
    """All coefficients as numbers, with the largest of every row and column 1."""
    scaled: list[dict[Var, float]] = []
    largest: dict[Var, float] = {}
    for row in rows:
        size = max((abs(a) for a in row.values() if a is not None), default=0.0) or 1.0
        numbers = {var: 1.0 if a is None else a / size for var, a in row.items()}
        scaled.append(numbers)
        for var, a in numbers.items():
            largest[var] = max(largest.get(var, 0.0), abs(a))
    return [{var: a / largest[var] if a else 0.0 for var, a in row.items()} for row in scaled]


def _generic(number: int) -> float:
    """A number around 1 without structure; as many have one sign as the other."""
    return (0.5 + (number + 1) * _GOLDEN % 1.0) * (-1.0 if (number + 1) * _ROOT % 1.0 < 0.5 else 1.0)
