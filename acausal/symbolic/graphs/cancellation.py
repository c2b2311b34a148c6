"""Sums of rows in which everything cancels, though every row has a column of its own.

Exact elimination over the rationals. Rows that hold a column alone take part in no such sum and are peeled
off first, which leaves nothing of most systems; of the rest the shortest row is the next pivot row, in its
rarest column (Markowitz, Management Science 3, 1957). Work is bounded: what a few hundred operations for each
entry do not find is not found.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from heapq import heapify, heappop, heappush

from acausal.symbolic.graphs.matching import Matcher
from acausal.symbolic.graphs.types import Eq, Var

Row = Mapping[Var, int]
"""Column -> entry, zeros left out."""

_EFFORT = 200
_LEAST = 100_000


def cancelling_sums(rows: Sequence[Row]) -> list[dict[Eq, Fraction]]:
    """Independent sums `row -> factor` that are zero; last the row that the others make up (factor 1).

    Left out are those whose rows have no complete matching with columns: structure shows them. Near-linear
    where peeling leaves little.
    """
    elimination = _Elimination(rows, _peeled(rows))
    return [found for found in elimination.run() if _is_hidden(rows, found)]


def _peeled(rows: Sequence[Row]) -> list[Eq]:
    """The rows of which every column is in another one that is left, too; none without columns."""
    users: dict[Var, dict[Eq, None]] = {}
    for i, row in enumerate(rows):
        for column in row:
            users.setdefault(column, {})[Eq(i)] = None
    single = [column for column, own in users.items() if len(own) == 1]
    gone = [not row for row in rows]
    while single:
        for eq in tuple(users[single.pop()]):
            gone[eq] = True
            for column in rows[eq]:
                users[column].pop(eq, None)
                if len(users[column]) == 1:
                    single.append(column)
    return [Eq(i) for i, out in enumerate(gone) if not out]


class _Elimination:
    """What is left of the rows, what they are sums of, and who has a column."""

    def __init__(self, rows: Sequence[Row], left: Sequence[Eq]) -> None:
        self._rows = {eq: {c: Fraction(a) for c, a in rows[eq].items()} for eq in left}
        self._sums = {eq: {eq: Fraction(1)} for eq in left}
        self._users: dict[Var, dict[Eq, None]] = {}
        for eq, row in self._rows.items():
            for column in row:
                self._users.setdefault(column, {})[eq] = None
        self._budget = _LEAST + _EFFORT * sum(map(len, self._rows.values()))

    def run(self) -> list[dict[Eq, Fraction]]:
        """The sums of every row that vanishes."""
        heap = [(len(row), eq) for eq, row in self._rows.items()]
        heapify(heap)
        found: list[dict[Eq, Fraction]] = []
        while heap and self._budget > 0:
            length, eq = heappop(heap)
            row = self._rows.get(eq)
            if row is None or len(row) != length:
                continue
            del self._rows[eq]
            if not row:
                own = self._sums[eq]
                found.append({**{k: f for k, f in own.items() if k != eq}, eq: own[eq]})
                continue
            for column in row:
                del self._users[column][eq]
            pivot = min(row, key=lambda column: (len(self._users[column]), column))
            for other in sorted(self._users[pivot]):
                self._subtract(eq, row, other, pivot)
                heappush(heap, (len(self._rows[other]), other))
        return found

    def _subtract(self, eq: Eq, row: Mapping[Var, Fraction], other: Eq, pivot: Var) -> None:
        """Takes the pivot row out of another one."""
        target, sums = self._rows[other], self._sums[other]
        factor = target[pivot] / row[pivot]
        for column, entry in row.items():
            value = target.get(column, Fraction(0)) - factor * entry
            if value:
                target[column] = value
                self._users[column][other] = None
            elif column in target:
                del target[column]
                del self._users[column][other]
        for member, share in self._sums[eq].items():
            sums[member] = sums.get(member, Fraction(0)) - factor * share
        self._budget -= len(row) + len(self._sums[eq])


def _is_hidden(rows: Sequence[Row], found: Mapping[Eq, Fraction]) -> bool:
    """Whether every row of the sum can have a column of its own."""
    members = [eq for eq, factor in found.items() if factor]
    columns = dict.fromkeys(column for eq in members for column in rows[eq])
    position = {column: Var(i) for i, column in enumerate(columns)}
    matcher = Matcher([[position[c] for c in rows[eq]] for eq in members], len(columns))
    return not matcher.augment([Eq(i) for i in range(len(members))])
