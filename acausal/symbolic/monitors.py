"""Where a choice of states is valid only near the present point: what to watch while the model runs.

A constraint set is solved for its dummies; the Jacobian J of the constraints with respect to them must stay
regular. Where its entries vary, a `StateMonitor` watches the quality

    q = det(J)^2 / product over the rows of (sum of the squares of all entries the row could be solved for),

for every irreducible block of J by itself. By Hadamard's inequality q is at most 1; for one constraint it is
the squared cosine of the angle between the surface of the constraint and the axes of the states. Columns
count in nominal values. The choice is to be made anew when q falls below `THRESHOLD`, or below a quarter
of what it was where the choice was made, if no better one exists.

The determinant is division-free, so that no point of the state space is excluded: Bird, "A simple
division-free algorithm for computing determinants", Information Processing Letters 111 (2011).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from acausal.symbolic.causal import CausalEquation, StateMonitor
from acausal.symbolic.expressions.expr import ZERO, Expr, add, const, mul, neg, relation
from acausal.symbolic.graphs.blt import Component, strong_components
from acausal.symbolic.graphs.matching import Matching
from acausal.symbolic.graphs.types import Eq, Var

THRESHOLD = 0.1
"""Quality below which a better choice of states is looked for; a good one of two has at least 0.5."""
LARGEST_BLOCK = 12
"""Larger blocks are watched row by row, each for the share of its own dummy: a determinant would be too long.
That says less of the block as a whole, and a choice may be looked for where none is needed.
"""

Number = Callable[[Expr], float | None]
"""The value of an expression at the point where the choice is made."""


@dataclass(frozen=True)
class Row:
    """A constraint: its coefficients (in nominal values) of everything it could be solved for, by name."""

    constraint: CausalEquation
    coefficients: Mapping[str, Expr]
    pivot: str
    """The dummy it is paired with."""


def state_monitors(
    rows: Sequence[Row], is_constant: Callable[[Expr], bool], number: Number
) -> list[StateMonitor]:
    """What to watch of one level of one constraint set; nothing where the choice is valid everywhere."""
    if all(is_constant(a) for row in rows for a in row.coefficients.values()):
        return []
    monitors: list[StateMonitor] = []
    for component in _components(rows):
        own = [rows[eq] for eq in component.equations]
        dummies = [row.pivot for row in own]
        matrix = [[row.coefficients.get(name, ZERO) for name in dummies] for row in own]
        if all(is_constant(a) for entries in matrix for a in entries):
            continue
        taken = {row.pivot for row in rows}
        if len(own) <= LARGEST_BLOCK:
            monitors += _monitor(own, dummies, taken, matrix, number)
            continue
        for row in own:
            pivot = row.coefficients.get(row.pivot, ZERO)
            if not all(is_constant(a) for a in row.coefficients.values()):
                monitors += _monitor([row], [row.pivot], taken, [[pivot]], number)
    return monitors


def _components(rows: Sequence[Row]) -> tuple[Component, ...]:
    """Irreducible blocks of the constraints' Jacobian with respect to the dummies."""
    index = {row.pivot: Var(i) for i, row in enumerate(rows)}
    incidence = [[index[name] for name in row.coefficients if name in index] for row in rows]
    count = len(rows)
    pairs = Matching(tuple(Var(i) for i in range(count)), tuple(Eq(i) for i in range(count)), count)
    return strong_components(incidence, pairs)


def _monitor(
    rows: Sequence[Row], dummies: list[str], taken: set[str], matrix: list[list[Expr]], number: Number
) -> list[StateMonitor]:
    """The monitor of one block; none where nothing else could be chosen."""
    others = dict.fromkeys(name for row in rows for name in row.coefficients if name not in taken)
    if not others:
        return []
    allowed = {*dummies, *others}
    size = [add(*[mul(a, a) for name, a in row.coefficients.items() if name in allowed]) for row in rows]
    det = determinant(matrix)
    square, volume = mul(det, det), mul(*size)
    limit = _threshold(number(square), number(volume))
    if limit is None:
        return []
    holds = relation("gt", square, mul(const(limit), volume))
    constraints = tuple(row.constraint for row in rows)
    return [StateMonitor(holds, limit, constraints, tuple(dummies), tuple(others))]


def _threshold(square: float | None, volume: float | None) -> float | None:
    """`THRESHOLD`, or a power of two at most a quarter of the quality where that is hardly better."""
    if square is None or volume is None or not (square > 0 and 0 < volume < math.inf):
        return None
    quality = square / volume
    if quality > 1.5 * THRESHOLD:
        return THRESHOLD
    return 2.0 ** (math.floor(math.log2(quality)) - 2) if quality > 0 else None


def determinant(matrix: Sequence[Sequence[Expr]]) -> Expr:
    """The determinant as an expression without divisions; Bird 2011, O(n^4) products, zeros left out."""
    count = len(matrix)
    product = [list(row) for row in matrix]
    for _ in range(count - 1):
        product = _times(_upper(product), matrix)
    return neg(product[0][0]) if count % 2 == 0 else product[0][0]


def _upper(matrix: Sequence[Sequence[Expr]]) -> list[list[Expr]]:
    """Bird's mu: the part above the diagonal, and minus the sums of the rest of the diagonal on it."""
    count = len(matrix)
    result = [[matrix[i][j] if j > i else ZERO for j in range(count)] for i in range(count)]
    tail = ZERO
    for i in range(count - 1, -1, -1):
        result[i][i] = neg(tail)
        tail = add(tail, matrix[i][i])
    return result


def _times(left: Sequence[Sequence[Expr]], right: Sequence[Sequence[Expr]]) -> list[list[Expr]]:
    count = len(left)
    return [
        [
            add(*[mul(left[i][k], right[k][j]) for k in range(count) if not _zero(left[i][k], right[k][j])])
            for j in range(count)
        ]
        for i in range(count)
    ]


def _zero(left: Expr, right: Expr) -> bool:
    return (left.op == "const" and left.value == 0) or (right.op == "const" and right.value == 0)
