"""Zero crossings: the relations whose change of value is an event.

A relation generates an event if it compares Reals, depends on time or on unknowns, and stands outside
`noEvent` and `smooth` (Modelica 3.6, 8.5). `==` and `<>` between Reals are not allowed there at all.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from acausal.errors import Span, TypeProblem, fail
from acausal.lang.flat import Assertion
from acausal.symbolic.causal import CausalEquation, ZeroCrossing
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.expressions.operators import OPERATORS
from acausal.symbolic.expressions.text import to_text
from acausal.symbolic.leaves import Chains, all_leaves

_INEQUALITIES = frozenset({"lt", "le", "gt", "ge"})


def zero_crossings(
    equations: Sequence[CausalEquation], assertions: Sequence[Assertion], chains: Chains
) -> tuple[ZeroCrossing, ...]:
    """Every distinct relation once, in order of first appearance: equations, then assertions. O(nodes).

    Raises TypeProblem `type.real-equality`.
    """
    found: dict[Expr, ZeroCrossing] = {}
    seen: set[Expr] = set()
    for equation in equations:
        span = equation.flat.span
        for relation in _relations((equation.left, equation.right), seen, chains, span):
            found[relation] = ZeroCrossing(relation, equation, span)
    for assertion in assertions:
        for relation in _relations((assertion.condition,), seen, chains, assertion.span):
            found[relation] = ZeroCrossing(relation, None, assertion.span)
    return tuple(found.values())


def _relations(roots: Iterable[Expr], seen: set[Expr], chains: Chains, span: Span) -> Iterator[Expr]:
    """Event-generating relations below `roots` that were not seen before."""
    stack = [*roots]
    stack.reverse()
    while stack:
        node = stack.pop()
        if node in seen or node.op in ("noEvent", "smooth"):
            continue
        seen.add(node)
        stack.extend(reversed(node.args))
        if node.op in _INEQUALITIES and _varies(node, chains):
            yield node
        elif node.op in ("eq", "ne") and _varies(node, chains) and _compares_reals(node, chains):
            raise _equality(node, span)


def _varies(node: Expr, chains: Chains) -> bool:
    """Whether the relation may change between two instants without an event elsewhere."""
    for leaf in all_leaves([node]):
        variable = chains.variables.get(leaf.name) if leaf.op == "sym" else None
        if leaf.op == "sym" and leaf.name == "time":
            return True
        if leaf.op == "der" or (
            variable is not None and variable.is_unknown and variable.type.name == "Real"
        ):
            return True
    return False


def _compares_reals(node: Expr, chains: Chains) -> bool:
    """Whether one side is Real; Boolean, Integer and enumeration values may be compared."""
    return any(_is_real(side, chains) for side in node.args)


def _is_real(expr: Expr, chains: Chains) -> bool:
    if expr.op == "const":
        return isinstance(expr.value, float)
    variable = chains.variables.get(expr.name) if expr.op == "sym" else None
    if variable is not None:
        return variable.type.name == "Real"
    return expr.op != "integer" and OPERATORS[expr.op].shape not in ("relation", "logical")


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
