"""Anchors: more guesses where the assignments of a torn loop lose digits.

A long chain of assignments is a recurrence, and one whose solutions grow (`x[i+1] = 4 x[i] - x[i-1]`: by 3.7 a
step) loses all digits of a solution that does not grow. Guessing some variables of the chain as well makes
several short chains of it, whose ends are matched by a matrix that is solved with pivoting: multiple shooting
(Ascher, Mattheij and Russell, "Numerical Solution of Boundary Value Problems for Ordinary Differential
Equations", 1988, 4.3), with as many shots as the numbers call for.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from acausal.symbolic.graphs.tearing import Tearing
from acausal.symbolic.graphs.types import Eq, Var

GROWTH = 1e6
"""How much larger than the rounding errors they begin with errors may get along assignments."""
STALE = 1e3
"""The same for errors that the beginning of a new chain should have ended."""
_GOLDEN = (5**0.5 - 1) / 2

Coefficients = Mapping[Var, float | None]
"""Of the variables in one equation; None where it is not a number: it counts as the largest of the others."""


def anchored(tearing: Tearing, rows: Sequence[Coefficients]) -> Tearing:
    """`tearing` with those variables guessed, too, where errors would have grown more than `GROWTH` times.

    Rows and then columns of the matrix are scaled to a largest entry of 1. An error of a generic number for
    each guess, and of that times the sum of its coefficients for each equation, is sent through the
    assignments; a variable that it makes too large is guessed, its equation becomes a residual, and the
    error begins anew. Where a variable depends on one after such a beginning and on one before it, whose
    error is above `STALE`, it is guessed as well: several variables connect the parts of a chain. Small
    pivots are found, too. O(E).
    """
    chain = _Chain(tearing, _equilibrated(rows))
    kept = [pair for pair in tearing.assignments if chain.keeps(*pair)]
    if len(kept) == len(tearing.assignments):
        return tearing
    residuals = sorted((*tearing.residuals, *chain.opened))
    return Tearing((*tearing.tearing_vars, *chain.anchors), tuple(kept), tuple(residuals))


class _Chain:
    """Errors along the assignments; `round_of` a variable is the number of beginnings before it."""

    def __init__(self, tearing: Tearing, rows: Sequence[Mapping[Var, float]]) -> None:
        self.anchors: list[Var] = []
        self.opened: list[Eq] = []
        self._rows = rows
        self._error = {var: _generic(var) for var in tearing.tearing_vars}
        self._round = dict.fromkeys(tearing.tearing_vars, 0)
        self._rounds = 0

    def keeps(self, eq: Eq, var: Var) -> bool:
        """Takes the next assignment; whether it may stay one."""
        row = self._rows[eq]
        others = [(other, a) for other, a in row.items() if other != var]
        latest = max((self._round[other] for other, _ in others), default=0)
        size = _generic(eq) * sum(map(abs, row.values()))
        error = size - sum(a * self._error[other] for other, a in others)
        stale = sum(abs(a * self._error[other]) for other, a in others if self._round[other] < latest)
        grown = abs(error) > GROWTH * abs(row[var])
        if not grown and stale <= STALE * abs(row[var]):
            self._error[var], self._round[var] = error / row[var], latest
            return True
        if grown and not stale:
            self._rounds += 1
            latest = self._rounds
        self._error[var], self._round[var] = _generic(var), latest
        self.anchors.append(var)
        self.opened.append(eq)
        return False


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
    """A number around 1 without structure, of either sign."""
    return (0.5 + (number + 1) * _GOLDEN % 1.0) * (-1.0 if number % 3 == 1 else 1.0)
