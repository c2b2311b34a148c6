"""Does an `if` jump? A proof that its branches meet where its condition switches."""

from __future__ import annotations

import math
from collections.abc import Callable

from acausal.symbolic.expressions.evaluate import EvaluationFailed, Lookup, NotConstant, evaluate, number_of
from acausal.symbolic.expressions.expr import (
    ZERO,
    Expr,
    const,
    div,
    fold,
    neg,
    rebuild,
    sub,
    substitute,
    unknown_leaves,
)
from acausal.symbolic.expressions.linear import linear_coefficient
from acausal.symbolic.expressions.simplify import collect_terms, split_factor

_INEQUALITIES = frozenset({"lt", "le", "gt", "ge"})
_TOLERANCE = 1e-9
_ROUNDING = 1e-13


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


def decided(condition: Expr, values: Lookup) -> bool | None:
    """What a condition in parameters is with their `values`; None for any other."""
    try:
        value = evaluate(condition, values)
    except (NotConstant, EvaluationFailed):
        return None
    return value if isinstance(value, bool) else None


def _solve(difference: Expr, leaf: Expr, moves: Callable[[Expr], bool], values: Lookup) -> Expr | None:
    parts = linear_coefficient(difference, leaf)
    if parts is None or any(moves(other) for other in unknown_leaves(parts[0])):
        return None
    slope = number_of(parts[0], values)
    return None if slope is None or slope == 0 else neg(div(parts[1], parts[0]))


def _equal(a: Expr, b: Expr, values: Lookup) -> bool:
    if collect_terms(sub(a, b)) is ZERO:
        return True
    left, right = (_with_values(side, values) for side in (a, b))
    scale = max(_largest_factor(left), _largest_factor(right))
    off = _largest_factor(collect_terms(sub(left, right)))
    return off <= _TOLERANCE * scale or off <= _ROUNDING * max(_size(side, values) for side in (a, b))


def _size(expr: Expr, values: Lookup) -> float:
    """The sum of the absolute values of all terms, of which the rounding of the whole is a share."""

    def visit(node: Expr, args: list[float]) -> float:
        if node.op == "add":
            return sum(args)
        if node.op == "mul":
            return math.prod(args)
        if node.op in ("neg", "noEvent", "smooth"):
            return args[0]
        value = number_of(node, values)
        return 0.0 if value is None else abs(value)

    return fold([expr], visit)[expr]


def _with_values(expr: Expr, values: Lookup) -> Expr:
    """The expression with the values of its parameters, as a sum of terms as far as it is one."""
    known = {leaf: const(value) for leaf in _symbols(expr) if (value := values(leaf.name)) is not None}
    memo: dict[Expr, Expr] = dict(known)

    def visit(node: Expr, args: list[Expr]) -> Expr:
        return rebuild(node, tuple(args)) if args else node

    return fold([expr], visit, memo)[expr]


def _symbols(expr: Expr) -> list[Expr]:
    return [leaf for leaf in unknown_leaves(expr) if leaf.op == "sym"]


def _largest_factor(expr: Expr) -> float:
    """The largest literal factor of the terms of a sum: 0 only for zero."""
    terms = expr.args if expr.op == "add" else (expr,)
    return max(abs(split_factor(term)[0]) for term in terms)
