"""Functions that are evaluated at events are evaluated only where their values are used.

An expression graph evaluates both branches of an `if`, and all parts of an `or`. What a when-clause computes
with a function that is kept as a unit would be computed at every event, from values that may make no sense
yet; so the condition under which the value is used becomes an argument of the call.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from acausal.symbolic.causal import Assignment
from acausal.symbolic.expressions.expr import (
    TRUE,
    Expr,
    calls,
    fold,
    if_then_else,
    logical_and,
    logical_not,
    rebuild,
)
from acausal.symbolic.expressions.kernel import Guarded, Part, Whole

_DEEPEST = 8
"""Conditions inside each other that are looked at: parts that branches share are walked for each of them."""


def guarded(assignments: Sequence[Assignment]) -> list[Assignment]:
    """The assignments, with a condition in each call that is not always needed. Near-linear."""
    values = guarded_values([a.value for a in assignments])
    return [replace(a, value=value) for a, value in zip(assignments, values, strict=True)]


def guarded_values(roots: Sequence[Expr]) -> list[Expr]:
    """As `guarded`, of expressions."""
    guards = _Guards()
    return [guards.put(root, TRUE, 0) for root in roots]


class _Guards:
    def __init__(self) -> None:
        self._calling: dict[Expr, bool] = {}
        self._wholes: dict[Whole, Guarded] = {}
        self._memos: dict[Expr, dict[Expr, Expr]] = {}

    def put(self, node: Expr, guard: Expr, depth: int) -> Expr:
        """The expression where `guard` holds."""
        if not self._calls(node):
            return node
        if node.op == "if" and depth < _DEEPEST:
            test, *branches = node.args
            tests = (test, logical_not(test))
            taken = [
                self.put(branch, logical_and(guard, own), depth + 1)
                for branch, own in zip(branches, tests, strict=True)
            ]
            return if_then_else(self.put(test, guard, depth + 1), *taken)
        if node.op in ("and", "or") and depth < _DEEPEST:
            return self._put_in_order(node, guard, depth)
        if guard is TRUE:
            return node
        memo = self._memos.setdefault(guard, {})

        def visit(node: Expr, args: list[Expr]) -> Expr:
            if node.op == "call" and isinstance(node.kernel, Part):
                return self._called(node.kernel, (guard, *args))
            new = tuple(args)
            return node if new == node.args else rebuild(node, new)

        return fold([node], visit, memo, {})[node]

    def _put_in_order(self, node: Expr, guard: Expr, depth: int) -> Expr:
        """Parts that call nothing decide whether the others matter."""
        calling = [arg for arg in node.args if self._calls(arg)]
        rest = [arg for arg in node.args if not self._calls(arg)]
        open_ = [arg if node.op == "and" else logical_not(arg) for arg in rest]
        guard = logical_and(guard, *open_)
        return rebuild(node, (*rest, *[self.put(arg, guard, depth + 1) for arg in calling]))

    def _called(self, part: Part, args: tuple[Expr, ...]) -> Expr:
        whole = self._wholes.get(part.whole)
        if whole is None:
            whole = self._wholes[part.whole] = Guarded(part.whole)
        return calls([Part(whole, part.index, part.name, part.result)], args)[0]

    def _calls(self, root: Expr) -> bool:
        """Whether there is a call that is evaluated at events."""

        def visit(node: Expr, args: list[bool]) -> bool:
            return any(args) or (node.op == "call" and isinstance(node.kernel, Part))

        return fold([root], visit, self._calling, closed=lambda _: True)[root]
