"""Discrete events that the symbolic core does not transform yet are refused by name."""

from __future__ import annotations

from collections.abc import Iterator

from acausal.errors import Span, UnsupportedProblem, fail
from acausal.lang.flat import FlatModel
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.expressions.operators import KNOWN_AT_EVENTS
from acausal.symbolic.leaves import all_leaves

_REFUSED = KNOWN_AT_EVENTS | {"pre"}


def refuse_hybrid(flat: FlatModel) -> None:
    """Raise UnsupportedProblem `unsupported.when` or `unsupported.OPERATOR` for what only events change."""
    for when in flat.whens:
        raise fail(
            UnsupportedProblem,
            "unsupported.when",
            "`when` cannot be simulated yet",
            when.span,
            names=[leaf.name for leaf in when.assigned],
            hint="the flat model has it: `acausal compile --show flat`",
        )
    seen: set[Expr] = set()
    for root, span in _roots(flat):
        for node in _new_nodes(root, seen):
            if node.op in _REFUSED:
                names = [leaf.name for leaf in all_leaves(node.args) if leaf.op == "sym"]
                message = f"`{node.op}(...)` cannot be simulated yet"
                raise fail(UnsupportedProblem, f"unsupported.{node.op}", message, span, names=names)


def _roots(flat: FlatModel) -> Iterator[tuple[Expr, Span]]:
    for equation in (*flat.equations, *flat.initial_equations):
        yield equation.left, equation.span
        yield equation.right, equation.span
    for assertion in flat.assertions:
        yield assertion.condition, assertion.span


def _new_nodes(root: Expr, seen: set[Expr]) -> Iterator[Expr]:
    stack = [root]
    while stack:
        node = stack.pop()
        if node not in seen:
            seen.add(node)
            yield node
            stack.extend(node.args)
