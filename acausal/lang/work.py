"""How much a model may make the front end do: bounds that end in an error instead of a hang."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TypeVar

from acausal.errors import Span
from acausal.lang.parameter_errors import too_many_steps, too_much_work
from acausal.lang.values import AnyValue, Value

MAX_STEPS = 60_000
"""Statements that one call of a function may come to; a call inside counts as `_STEPS_OF_CALL`."""
_STEPS_OF_CALL = 4
_FREE_STEPS = 200_000
_STEPS_PER_CALL = 200
"""All calls of a compilation together may take `_FREE_STEPS`, and this many more for each of them."""
MAX_WORK = 10_000_000
"""Elements of arrays that are computed, and `WORK_OF_TURN` for each turn of a loop, in one compilation."""
WORK_OF_TURN = 20

_V = TypeVar("_V", bound=AnyValue)
_T = TypeVar("_T")


class Budget:
    """What one compilation has done so far."""

    def __init__(self) -> None:
        self.steps = 0
        self.work = 0
        self._calls = 0
        self._steps_before = 0

    def begin_call(self) -> None:
        """Count a call that an equation or a declaration makes: it may take steps of its own."""
        self._calls += 1
        self._steps_before = self.steps

    def count_step(self, function: str, span: Span, *, call: bool = False) -> None:
        """Count a statement of a function, or a call. Raises `function.too-long`."""
        self.steps += _STEPS_OF_CALL if call else 1
        if self.steps - self._steps_before > MAX_STEPS:
            raise too_many_steps(function, MAX_STEPS, span)
        if self.steps > _FREE_STEPS + _STEPS_PER_CALL * self._calls:
            raise too_many_steps(function, _FREE_STEPS, span)

    def count_work(self, amount: int, span: Span) -> None:
        """Count what loops and arrays make of the model's text. Raises `model.too-much-work`."""
        self.work += amount
        if self.work > MAX_WORK:
            raise too_much_work(MAX_WORK, span)

    def turns(self, values: Sequence[_T], span: Span) -> Iterator[_T]:
        """The turns of a loop, counted. When the first is done it is known what all of them come to.

        Raises `model.too-much-work`.
        """
        before = self.work
        for turn, value in enumerate(values):
            self.count_work(WORK_OF_TURN, span)
            yield value
            if turn == 0 and self.work + (len(values) - 1) * (self.work - before) > 2 * MAX_WORK:
                raise too_much_work(MAX_WORK, span)

    def counted(self, value: _V, span: Span) -> _V:
        """A computed value, its elements counted."""
        if isinstance(value, Value) and value.shape:
            self.count_work(len(value.items), span)
        return value
