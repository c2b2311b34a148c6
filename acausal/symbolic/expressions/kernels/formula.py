"""A function of many arguments whose results are expressions in them, kept as a unit.

What a when-clause computes from a whole array (the transform of a buffer, say) depends on every element;
written out, each of its results would be an expression of its own size in every equation.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from acausal.symbolic.expressions.evaluate import EvaluationFailed, NotConstant, evaluate
from acausal.symbolic.expressions.kernel import Whole
from acausal.symbolic.expressions.node import Constant, Expr


@dataclass(frozen=True, eq=False)
class Formula(Whole):
    """`results` as expressions in the leaves `formals`."""

    name: str
    key: str
    formals: tuple[Expr, ...]
    results: tuple[Expr, ...]

    @property
    def arity(self) -> int:  # pyright: ignore[reportIncompatibleVariableOverride]  # computed, never assigned
        return len(self.formals)

    @property
    def count(self) -> int:  # pyright: ignore[reportIncompatibleVariableOverride]  # as above
        return len(self.results)

    def values(self, args: tuple[Constant, ...]) -> Sequence[Constant | None]:
        memo = dict(zip(self.formals, args, strict=True))
        return [self._value(root, memo) for root in self.results]

    def _value(self, root: Expr, memo: dict[Expr, Constant]) -> Constant | None:
        try:
            return evaluate(root, lambda _: None, memo)
        except (EvaluationFailed, NotConstant):
            return None
