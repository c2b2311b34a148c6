"""How much a model may make the front end do: bounds that end in an error instead of a hang."""

from __future__ import annotations

from typing import TypeVar

from acausal.errors import Span
from acausal.lang.parameter_errors import too_many_steps, too_much_work
from acausal.lang.values import AnyValue, Value

MAX_STEPS = 50_000
"""Statements that one call of a function may run."""
MAX_WORK = 10_000_000
"""Elements of arrays that are computed, and ten for each turn of a loop, in one compilation."""

_V = TypeVar("_V", bound=AnyValue)


class Budget:
    """What one compilation has done so far."""

    def __init__(self) -> None:
        self.steps = 0
        self.work = 0

    def count_step(self, function: str, span: Span) -> None:
        """Count a statement of a function. Raises `function.too-long`."""
        self.steps += 1
        if self.steps > MAX_STEPS:
            raise too_many_steps(function, MAX_STEPS, span)

    def count_work(self, amount: int, span: Span) -> None:
        """Count what loops and arrays make of the model's text. Raises `model.too-much-work`."""
        self.work += amount
        if self.work > MAX_WORK:
            raise too_much_work(MAX_WORK, span)

    def counted(self, value: _V, span: Span) -> _V:
        """A computed value, its elements counted."""
        if isinstance(value, Value) and value.shape:
            self.count_work(len(value.items), span)
        return value
