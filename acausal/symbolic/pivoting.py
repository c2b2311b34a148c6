"""Choosing columns of a sparse matrix so that they are independent, cheapest first: greedy elimination.

Greedy in the linear matroid of the columns (Edmonds, "Matroids and the greedy algorithm", Math. Programming 1
(1971)): of all independent sets of full rank the one of least cost. Elimination is left-looking and sparse
(Gilbert and Peierls, SIAM J. Sci. Stat. Comput. 9 (1988)), so local structure costs local work.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from heapq import heapify, heappop, heappush


@dataclass(frozen=True, slots=True)
class Entry:
    """A matrix entry; `constant` if it has this value whatever the state of the system."""

    value: float
    constant: bool


Column = Mapping[int, Entry]
"""Row -> entry, zeros left out."""

_NEGLIGIBLE = 1e-10
"""Relative to the column's largest entry: below, an entry after elimination counts as zero."""


def independent_columns(
    columns: Sequence[Column], groups: Sequence[Sequence[int]], n_rows: int, *, soft: int = 0
) -> list[tuple[int, int]]:
    """`n_rows` independent columns (fewer if there are no more) in the order chosen, each with its pivot row.

    `groups` lists the columns, cheapest group first and cheapest column first within a group. Within a group
    columns with a constant pivot go first, so that the choice is valid for every state wherever one such
    choice exists greedily; then columns whose pivot is not small in its row; then the rest. Within
    the first `soft` groups together, small pivots come after all others: soundness goes before the group.
    Cost: that of sparse elimination of the columns tried.
    """
    elimination = _Elimination(columns)
    left = [list(group) for group in groups]
    for at, demand in _passes(len(groups), soft):
        left[at] = [
            column
            for column in left[at]
            if len(elimination.chosen) < n_rows and not elimination.accept(column, demand)
        ]
    return list(zip(elimination.chosen, elimination.pivot_rows, strict=True))


class _Demand(Enum):
    """What a pivot must be."""

    CONSTANT = "constant"
    LARGE = "large"
    ANY = "any"


def _passes(groups: int, soft: int) -> list[tuple[int, _Demand]]:
    """Which group is looked at with which demand, in order."""
    sound = (_Demand.CONSTANT, _Demand.LARGE)
    return [
        *((at, demand) for at in range(soft) for demand in sound),
        *((at, _Demand.ANY) for at in range(soft)),
        *((at, demand) for at in range(soft, groups) for demand in (*sound, _Demand.ANY)),
    ]


_LARGE = 0.5
"""A pivot is large if it is at least this times the largest entry of its row."""


class _Elimination:
    """The factors so far: per pivot row its step, and the multipliers of each step."""

    def __init__(self, columns: Sequence[Column]) -> None:
        self.chosen: list[int] = []
        self._columns = columns
        self._step_of_row: dict[int, int] = {}
        self.pivot_rows: list[int] = []
        self._multipliers: list[dict[int, Entry]] = []
        self._row_largest: dict[int, float] = {}
        for column in columns:
            for row, entry in column.items():
                self._row_largest[row] = max(self._row_largest.get(row, 0.0), abs(entry.value))

    def accept(self, column: int, demand: _Demand) -> bool:
        """Add the column if it is independent of those chosen, with a pivot as demanded."""
        reduced = self._reduce(self._columns[column])
        candidates = [
            (entry.constant, abs(entry.value), -row)
            for row, entry in reduced.items()
            if self._satisfies(row, entry, demand)
        ]
        if not candidates:
            return False
        row = -max(candidates)[2]
        pivot = reduced.pop(row)
        self._step_of_row[row] = len(self.chosen)
        self.pivot_rows.append(row)
        self._multipliers.append(
            {r: Entry(e.value / pivot.value, e.constant and pivot.constant) for r, e in reduced.items()}
        )
        self.chosen.append(column)
        return True

    def _satisfies(self, row: int, entry: Entry, demand: _Demand) -> bool:
        if demand is _Demand.CONSTANT:
            return entry.constant
        return demand is _Demand.ANY or abs(entry.value) >= _LARGE * self._row_largest.get(row, 0.0)

    def _reduce(self, column: Column) -> dict[int, Entry]:
        """The column after elimination of the pivot rows: what is left in rows without pivot."""
        work = dict(column)
        least = _NEGLIGIBLE * max((abs(e.value) for e in work.values()), default=0.0)
        steps = [self._step_of_row[row] for row in work if row in self._step_of_row]
        heapify(steps)
        done = -1
        while steps:
            step = heappop(steps)
            if step == done:
                continue
            done = step
            factor = work.pop(self.pivot_rows[step])
            for row, multiplier in self._multipliers[step].items():
                old = work.get(row)
                if old is None and row in self._step_of_row:
                    heappush(steps, self._step_of_row[row])
                work[row] = _minus(old, factor, multiplier)
        return {row: entry for row, entry in work.items() if abs(entry.value) > least}


def _minus(old: Entry | None, factor: Entry, multiplier: Entry) -> Entry:
    change = factor.value * multiplier.value
    constant = factor.constant and multiplier.constant
    if old is None:
        return Entry(-change, constant)
    return Entry(old.value - change, constant and old.constant)
