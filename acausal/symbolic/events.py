"""What makes an event: relations, and `integer(...)`, whose value changes between two instants.

A relation generates an event if it compares Reals, depends on time or on continuous unknowns, and stands
outside `noEvent` and `smooth` (Modelica 3.6, 8.5), and outside what is evaluated at events only (the bodies
of when-clauses). `==` and `<>` between Reals are not allowed there at all, but for `x == pre(x)`.

`integer(u)` holds n between events; `u < n` and `u >= n + 1` end that.

A relation whose sides are linear in time, and otherwise known between events, happens at a known instant.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from acausal.errors import Span, TypeProblem, fail
from acausal.lang.flat import Equation
from acausal.symbolic.causal import CausalEquation, ZeroCrossing
from acausal.symbolic.describe import base_name
from acausal.symbolic.expressions.expr import (
    ONE,
    TIME,
    Expr,
    add,
    div,
    neg,
    parts,
    postorder,
    relation,
    sub,
    substitute,
    sym,
)
from acausal.symbolic.expressions.linear import linear_coefficient
from acausal.symbolic.expressions.operators import OPERATORS, RELATIONS
from acausal.symbolic.expressions.text import to_text
from acausal.symbolic.leaves import Chains, all_leaves, is_moving
from acausal.symbolic.when_clauses import is_momentary

_INEQUALITIES = frozenset({"lt", "le", "gt", "ge"})
_OF_PARTS = frozenset({"add", "neg", "mul", "abs", "min", "max", "idiv", "mod", "rem", "noEvent", "smooth"})


@dataclass(frozen=True, slots=True)
class Holder:
    """`integer(u)`, constant between events, and the first equation that holds it."""

    node: Expr
    equation: CausalEquation


@dataclass(frozen=True)
class Switches:
    """What makes events, each once, in order of first appearance."""

    crossings: tuple[ZeroCrossing, ...]
    holders: tuple[Holder, ...]


def switches(
    equations: Sequence[CausalEquation], conditions: Sequence[tuple[Expr, Span]], chains: Chains
) -> Switches:
    """Relations and whole numbers of equations, then of conditions. O(nodes).

    Raises TypeProblem `type.real-equality`.
    """
    work = _Search(chains)
    for equation in equations:
        work.add((equation.left, equation.right), equation, equation.flat.span)
    for condition, span in conditions:
        work.add((condition,), None, span)
    return Switches(tuple(work.crossings.values()), tuple(work.holders.values()))


class _Search:
    """What was found so far."""

    def __init__(self, chains: Chains) -> None:
        self.crossings: dict[Expr, ZeroCrossing] = {}
        self.holders: dict[Expr, Holder] = {}
        self._chains = chains
        self._seen: set[Expr] = set()

    def add(self, roots: Iterable[Expr], equation: CausalEquation | None, span: Span) -> None:
        """Everything below `roots` that was not met before."""
        for node in self._nodes(roots, span):
            if node.op != "integer":
                self._cross(node, equation, span)
                continue
            flat = equation if equation is not None else _stated(node, span)
            self.holders[node] = Holder(node, flat)
            self._cross(relation("lt", node.args[0], node), equation, span)
            self._cross(relation("ge", node.args[0], add(node, ONE)), equation, span)

    def _cross(self, node: Expr, equation: CausalEquation | None, span: Span) -> None:
        self.crossings[node] = ZeroCrossing(node, equation, span, _instant(node, self._chains))

    def _nodes(self, roots: Iterable[Expr], span: Span) -> Iterator[Expr]:
        """Event-generating nodes below `roots`, outside first."""
        stack = [*roots]
        stack.reverse()
        while stack:
            node = stack.pop()
            if node in self._seen or node.op in ("noEvent", "smooth"):
                continue
            self._seen.add(node)
            below = parts(node)
            if node.op == "if" and is_momentary(node.args[0]):
                below = (node.args[0], node.args[2])
            stack.extend(reversed(below))
            if node.op in _INEQUALITIES or node.op == "integer":
                if varies(node, self._chains):
                    yield node
            elif node.op in ("eq", "ne") and varies(node, self._chains) and self._compares_reals(node):
                raise _equality(node, span)

    def _compares_reals(self, node: Expr) -> bool:
        """Whether one side is Real; Boolean, Integer and enumeration values may be compared."""
        return any(_is_real(side, self._chains) for side in node.args)


def _stated(node: Expr, span: Span) -> CausalEquation:
    """What stands for the equation of a whole number in a condition."""
    return CausalEquation(node, node, Equation(node, node, span))


def varies(node: Expr, chains: Chains) -> bool:
    """Whether an expression may change between two instants without an event elsewhere."""
    for leaf in all_leaves([node]):
        if leaf is TIME or leaf.op == "der":
            return True
        if leaf.op == "sym" and is_moving(chains.variables.get(leaf.name)):
            return True
    return any(below.op == "delay" for below in postorder([node]))


def _instant(node: Expr, chains: Chains) -> Expr | None:
    """The time at which both sides are equal, if it follows from what is constant between events."""
    held = [n for n in postorder([node]) if n.op == "integer" and varies(n, chains)]
    mapping = {n: sym(f"integer({i})") for i, n in enumerate(held)}
    memo: dict[Expr, Expr] = {}
    left, right = (substitute(side, mapping, memo) if held else side for side in node.args)
    if any(leaf is not TIME and varies(leaf, chains) for leaf in all_leaves([left, right])):
        return None
    if any((n.op in RELATIONS and varies(n, chains)) or n.op == "delay" for n in postorder([left, right])):
        return None
    parts = linear_coefficient(sub(left, right), TIME)
    if parts is None or (parts[0].op == "const" and parts[0].value == 0):
        return None
    back = {symbol: n for n, symbol in mapping.items()}
    instant = neg(div(parts[1], parts[0]))
    return substitute(instant, back) if held else instant


def _is_real(expr: Expr, chains: Chains) -> bool:
    if expr.op == "const":
        return isinstance(expr.value, float)
    if expr.op in ("sym", "pre"):
        variable = chains.variables.get(base_name(expr))
        return variable is None or variable.type.name == "Real"
    if expr.op in _OF_PARTS:
        return any(_is_real(arg, chains) for arg in expr.args)
    if expr.op == "if":
        return any(_is_real(arg, chains) for arg in expr.args[1:])
    if expr.op == "call":
        return expr.kernel.result == "Real"
    return expr.op not in ("integer", "sign") and OPERATORS[expr.op].shape not in (
        "relation",
        "logical",
        "event",
    )


def _equality(node: Expr, span: Span) -> TypeProblem:
    error = fail(
        TypeProblem,
        "type.real-equality",
        f"`{to_text(node)}` compares Real values for equality, which is only allowed in functions",
        span,
        names=[leaf.name for leaf in all_leaves([node]) if leaf.op == "sym"],
        hint="compare with a tolerance: abs(a - b) < eps",
    )
    return TypeProblem(error.diagnostics)
