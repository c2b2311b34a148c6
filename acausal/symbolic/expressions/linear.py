"""Exact linearity: `a*x + b` taken apart, and which leaves an expression is linear in.

Switching: with `frozen=True` a relation counts as known even where it holds the unknown, which is right
outside `noEvent` and `smooth`, because there relations are modes that stay constant between events. So does
`integer` of anything. Inside them, and with `frozen=False`, a condition holding the unknown makes its `if`
nonlinear.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from acausal.symbolic.expressions.expr import (
    ONE,
    ZERO,
    Expr,
    Kind,
    add,
    div,
    fold,
    gather,
    if_then_else,
    mul,
    neg,
    no_event,
    parts,
    smooth,
)
from acausal.symbolic.expressions.operators import SWITCHING

_LEAVES = frozenset({"sym", "der", "pre"})

Parts = tuple[Expr, Expr]
"""Coefficient and rest of `coefficient * leaf + rest`."""


def linear_coefficient(root: Expr, leaf: Expr, *, frozen: bool = False) -> Parts | None:
    """(a, b) with root = a*leaf + b, neither holding the leaf; None if root is not linear in it. O(nodes)."""
    loose: dict[Expr, Parts | None] = {}
    strict: dict[Expr, Parts | None] = {}

    def visit_strict(node: Expr, args: list[Parts | None]) -> Parts | None:
        return _parts(node, args, leaf, frozen=False)

    def visit(node: Expr, args: list[Parts | None]) -> Parts | None:
        if frozen and node.op in ("noEvent", "smooth"):
            return fold([node], visit_strict, strict)[node]
        return _parts(node, args, leaf, frozen=frozen)

    return fold([root], visit, loose)[root]


def _parts(node: Expr, args: list[Parts | None], leaf: Expr, *, frozen: bool) -> Parts | None:
    if node.op in _LEAVES:
        return (ONE, ZERO) if node is leaf else (ZERO, node)
    if node.op == "derived":
        args = args[:1]
    if node.op == "delay" or (frozen and node.op in SWITCHING):
        return (ZERO, node)
    known: list[Parts] = []
    for part in args:
        if part is None:
            return None
        known.append(part)
    if all(_is_zero(a) for a, _ in known):
        return (ZERO, node)
    return _combine(node, known)


def _is_zero(node: Expr) -> bool:
    return node.op == "const" and node.value == 0


def _combine(node: Expr, parts: list[Parts]) -> Parts | None:
    """The parts of a node at least one argument of which holds the leaf."""
    op = node.op
    first, rest = parts[0]
    if op == "add":
        return add(*[a for a, _ in parts]), add(*[b for _, b in parts])
    if op == "neg":
        return neg(first), neg(rest)
    if op == "mul":
        return _product(node, parts)
    if op == "div" and _is_zero(parts[1][0]):
        return div(first, node.args[1]), ZERO if rest is ZERO else div(rest, node.args[1])
    if op == "if" and _is_zero(first):
        (a1, b1), (a2, b2) = parts[1:]
        return if_then_else(node.args[0], a1, a2), if_then_else(node.args[0], b1, b2)
    if op == "noEvent":
        return no_event(first), no_event(rest)
    if op == "smooth" and isinstance(node.value, int):
        return smooth(node.value, first), smooth(node.value, rest)
    return None


def _product(node: Expr, parts: list[Parts]) -> Parts | None:
    holders = [i for i, (a, _) in enumerate(parts) if not _is_zero(a)]
    if len(holders) != 1:
        return None
    at = holders[0]
    others = (*node.args[:at], *node.args[at + 1 :])
    a, b = parts[at]
    return mul(a, *others), ZERO if b is ZERO else mul(b, *others)


def linear_parts(
    root: Expr, leaves: Sequence[Expr], *, frozen: bool = False
) -> tuple[tuple[Expr, ...], Expr] | None:
    """(a1..an, b) with root = a1*leaf1 + ... + b, no leaf in any of them; None if not linear. O(nodes n)."""
    coefficients: list[Expr] = []
    rest = root
    for leaf in leaves:
        parts = linear_coefficient(rest, leaf, frozen=frozen)
        if parts is None:
            return None
        coefficients.append(parts[0])
        rest = parts[1]
    holders = _holding([*coefficients], leaves, frozen=frozen)
    return None if holders else (tuple(coefficients), rest)


def _holding(roots: Iterable[Expr], leaves: Sequence[Expr], *, frozen: bool) -> bool:
    wanted = dict.fromkeys(leaves)
    return any(leaf in wanted for root in roots for leaf in slopes(root, frozen=frozen))


Slopes = dict[Expr, Expr | None]
"""Per leaf the coefficient with which an expression is linear in it; None where it is not linear in it."""

_NOTHING: Slopes = {}


class _Nonlinear(Slopes):
    """Slopes of something linear in none of its leaves."""


def slopes(root: Expr, *, frozen: bool = True) -> Slopes:
    """For every leaf of `root`, in order of appearance, its coefficient, or None if root is not linear in it.

    Linear in each leaf by itself: `x*y` gives y for x and x for y. With `frozen`, leaves that occur only in
    relations outside `noEvent` and `smooth` do not appear: nothing can be solved for them. One pass over the
    nodes; O(nodes * leaves) at worst, O(nodes) for sums.
    """
    strict: dict[Expr, Slopes] = {}

    def visit_strict(node: Expr, args: list[Slopes]) -> Slopes:
        return _slopes(node, args, frozen=False)

    def closed_strict(node: Expr) -> Slopes:
        return closed_as(node, False)

    def visit(node: Expr, args: list[Slopes]) -> Slopes:
        if frozen and node.op in ("noEvent", "smooth"):
            return fold([node], visit_strict, strict, closed=closed_strict)[node]
        return _slopes(node, args, frozen=frozen)

    wides: dict[tuple[int, bool], Slopes] = {}

    def closed_as(node: Expr, frozen: bool) -> Slopes:
        key = (id(node.wide), frozen)
        if key not in wides:
            wides[key] = _Nonlinear.fromkeys(_slope_leaves(node, frozen=frozen))
        return wides[key]

    def closed(node: Expr) -> Slopes:
        return closed_as(node, frozen)

    return fold([root], visit, closed=closed)[root]


def _slope_leaves(call: Expr, *, frozen: bool) -> Sequence[Expr]:
    """The leaves with a slope in a call, which is linear in none: its shared arguments need no slopes."""
    if not frozen:
        return gather([call], _STRICT)
    nodes = gather([call], _FROZEN)
    if not any(node.op in ("noEvent", "smooth") for node in nodes):
        return nodes
    inner = [gather([n], _STRICT) if n.op in ("noEvent", "smooth") else (n,) for n in nodes]
    return tuple(dict.fromkeys(leaf for leaves in inner for leaf in leaves))


def _strictly_held(node: Expr) -> tuple[Expr, ...]:
    if node.op == "if":
        return (*node.args[1:], node.args[0])
    return () if node.op == "delay" else parts(node)


def _frozen_held(node: Expr) -> tuple[Expr, ...]:
    if node.op == "if":
        return node.args[1:]
    return () if node.op in ("delay", "integer") else parts(node)


_STRICT = Kind("slopes", _LEAVES, _strictly_held)
_FROZEN = Kind("frozen slopes", _LEAVES | {"noEvent", "smooth"}, _frozen_held)


def _slopes(node: Expr, args: list[Slopes], *, frozen: bool) -> Slopes:
    op = node.op
    if op in _LEAVES:
        return {node: ONE}
    if op == "derived":
        return args[0]
    if op == "delay" or (frozen and op in SWITCHING) or not any(args):
        return _NOTHING
    if op == "add":
        return _sum_slopes(args)
    if op == "neg":
        return {leaf: None if a is None else neg(a) for leaf, a in args[0].items()}
    if op == "mul":
        return _product_slopes(node, args)
    if op == "div" and not args[1]:
        return {leaf: None if a is None else div(a, node.args[1]) for leaf, a in args[0].items()}
    if op == "div":
        top = {
            leaf: None if a is None or leaf in args[1] else div(a, node.args[1])
            for leaf, a in args[0].items()
        }
        return {**top, **dict.fromkeys(args[1])}
    if op == "if":
        return _if_slopes(node, args)
    if op in ("noEvent", "smooth"):
        return args[0]
    distinct = list({id(inner): inner for inner in args if inner}.values())
    if len(distinct) == 1 and isinstance(distinct[0], _Nonlinear):
        return distinct[0]  # of the calls for the elements of one array, say: they share thousands of leaves
    return _Nonlinear.fromkeys(leaf for inner in distinct for leaf in inner)


def _sum_slopes(args: list[Slopes]) -> Slopes:
    terms: dict[Expr, list[Expr] | None] = {}
    for inner in args:
        for leaf, a in inner.items():
            known = terms.setdefault(leaf, [])
            if a is None:
                terms[leaf] = None
            elif known is not None:
                known.append(a)
    return {leaf: None if a is None else add(*a) for leaf, a in terms.items()}


def _product_slopes(node: Expr, args: list[Slopes]) -> Slopes:
    result: Slopes = {}
    for i, inner in enumerate(args):
        for leaf, a in inner.items():
            if leaf in result or a is None:
                result[leaf] = None
            else:
                result[leaf] = mul(a, *node.args[:i], *node.args[i + 1 :])
    return result


def _if_slopes(node: Expr, args: list[Slopes]) -> Slopes:
    condition, then, otherwise = args
    result: Slopes = {}
    for leaf in (*then, *otherwise):
        a, b = then.get(leaf, ZERO), otherwise.get(leaf, ZERO)
        result[leaf] = None if a is None or b is None else if_then_else(node.args[0], a, b)
    return {**result, **dict.fromkeys(condition)}
