"""Does an `if` jump? A proof that its branches meet where its condition switches."""

from __future__ import annotations

from collections.abc import Callable

from acausal.symbolic.expressions.evaluate import EvaluationFailed, Lookup, NotConstant, evaluate
from acausal.symbolic.expressions.expr import ZERO, Expr, div, neg, sub, substitute, unknown_leaves
from acausal.symbolic.expressions.linear import linear_coefficient
from acausal.symbolic.expressions.simplify import collect_terms

_INEQUALITIES = frozenset({"lt", "le", "gt", "ge"})
_TOLERANCE = 1e-9


def is_continuous(node: Expr, moves: Callable[[Expr], bool], values: Lookup) -> bool:
    """Whether the branches of `if u < v then a else b` provably meet where u = v.

    u = v is solved for a moving leaf in which it is linear; put into both branches, these must agree, as
    expressions or, if only parameters are left, in value to 1e-9. False where no proof is found.
    """
    condition, then, otherwise = node.args
    while condition.op in ("not", "noEvent"):
        condition = condition.args[0]
    if condition.op not in _INEQUALITIES:
        return False
    difference = sub(*condition.args)
    for leaf in unknown_leaves(difference):
        boundary = _solve(difference, leaf, moves, values) if moves(leaf) else None
        if boundary is not None:
            mapping = {leaf: boundary}
            if _equal(substitute(then, mapping), substitute(otherwise, mapping), values):
                return True
    return False


def _solve(difference: Expr, leaf: Expr, moves: Callable[[Expr], bool], values: Lookup) -> Expr | None:
    parts = linear_coefficient(difference, leaf)
    if parts is None or any(moves(other) for other in unknown_leaves(parts[0])):
        return None
    slope = _number(parts[0], values)
    return None if slope is None or slope == 0 else neg(div(parts[1], parts[0]))


def _equal(a: Expr, b: Expr, values: Lookup) -> bool:
    if collect_terms(sub(a, b)) is ZERO:
        return True
    left, right = _number(a, values), _number(b, values)
    if left is None or right is None:
        return False
    return abs(left - right) <= _TOLERANCE * max(abs(left), abs(right))


def _number(expr: Expr, values: Lookup) -> float | None:
    try:
        value = evaluate(expr, values)
    except (NotConstant, EvaluationFailed):
        return None
    return float(value) if isinstance(value, int | float) else None
