"""Functions that are evaluated at events are evaluated only where their values are used.

An expression graph evaluates both branches of an `if`. What a when-clause computes with a function that is
kept as a unit would be computed at every event, from values that may make no sense yet; so the condition under
which the value is used becomes an argument of the call.
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
"""Conditions inside each other that are looked at: branches that share their parts are walked once for each."""


def guarded(assignments: Sequence[Assignment]) -> list[Assignment]:
    """The assignments, with the condition in each call below an `if`. Near-linear."""
    guard = _Guards()
    return [replace(a, value=guard.put(a.value, TRUE, 0)) for a in assignments]


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
        if guard is TRUE:
            return node
        memo = self._memos.setdefault(guard, {})

        def visit(node: Expr, args: list[Expr]) -> Expr:
            if node.op == "call" and isinstance(node.kernel, Part):
                return self._called(node.kernel, (guard, *args))
            new = tuple(args)
            return node if new == node.args else rebuild(node, new)

        return fold([node], visit, memo, {})[node]

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
