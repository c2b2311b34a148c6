"""Stores accepted points and checks assertions there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acausal.errors import Diagnostic, SimulationProblem, Span
from acausal.lang.flat import Assertion
from acausal.simulate.branches import Branches
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import at
from acausal.simulate.rows import Rows
from acausal.simulate.texts import message_text
from acausal.symbolic.expressions.expr import Expr, symbols
from acausal.symbolic.expressions.text import to_text


@dataclass(frozen=True)
class Ending:
    """A run that `terminate` ended before its stop time."""

    time: float
    message: str
    span: Span


class Recorder:
    """Rows of outputs, one per accepted point. Warnings of assertions are kept once each.

    About `expected` rows will come.
    """

    watches_modes = False
    """Whether rows are read with the modes of the evaluator, so that Python has to handle the events."""

    def __init__(self, evaluator: Evaluator, expected: int = 0) -> None:
        self._evaluator = evaluator
        self._rows = Rows(len(evaluator.code.output_leaves), expected)
        self._violated: dict[Assertion, Diagnostic] = {}
        self._names = evaluator.code.output_names
        self.leaves = evaluator.code.output_leaves
        """What the columns of `data` are."""
        self._order: NDArray[np.int_] | None = None
        self._branches = Branches(evaluator)
        self._taken = 0
        self.count = 0
        """How many rows there were, those that were taken included."""

    def take(self) -> tuple[Vector, Vector]:
        """The times and rows that were not taken before. Only the last row stays here."""
        times, rows = self.time[self._taken :], self.data[self._taken :]
        self._rows.keep_last()
        self._taken = self._rows.count
        return times, rows

    @property
    def pending(self) -> int:
        """How many numbers there are to take."""
        return (self._rows.count - self._taken) * len(self.leaves)

    def last(self) -> tuple[float, dict[str, float]]:
        """The time and the values of the last row."""
        values = self._rows.data[-1].tolist()
        return self.last_time, dict(zip(self._names, values, strict=True))

    @property
    def last_time(self) -> float:
        return float(self._rows.times[-1])

    def columns(self, names: Sequence[str]) -> Vector:
        """The values of variables in the rows that are here."""
        position = {to_text(leaf): i for i, leaf in enumerate(self.leaves)}
        return self._rows.data[:, [position[name] for name in names]]

    def go_on_with(self, evaluator: Evaluator) -> None:
        """Record another choice of states of the same system from now on, in the same columns."""
        self._evaluator = evaluator
        self._branches.stop()
        position = {to_text(leaf): i for i, leaf in enumerate(evaluator.code.output_leaves)}
        self._order = np.array([position[to_text(leaf)] for leaf in self.leaves], dtype=np.int_)

    def add(self, time: float, x: Vector) -> None:
        """Evaluates all variables. Raises `SimulationProblem` (not finite, assertion violated)."""
        evaluator = self._evaluator
        evaluator.at(time, x)
        evaluator.output()
        row = evaluator.output.outputs[0]
        if not np.isfinite(row).all():
            evaluator.settle()
            evaluator.explain()
            evaluator.output()
        self.count += 1
        self._rows.add(time, row if self._order is None else row[self._order])
        self._look(1)
        if evaluator.code.system.assertions:
            self._assert(time)

    def is_at(self, time: float) -> bool:
        """Whether the last row is one of this very instant."""
        return self._rows.count > 0 and self.last_time == time

    def extend(self, times: Vector, rows: Vector) -> None:
        """Takes rows that were evaluated elsewhere; `look_again` is for those that need it."""
        self.count += len(times)
        self._rows.extend(times, rows if self._order is None else rows[:, self._order])
        self._look(len(times))

    def look_again(self, time: float, x: Vector) -> None:
        """Evaluates the last row anew, and its assertions. Raises `SimulationProblem` as `add` does."""
        self.count -= 1
        self._rows.drop()
        self.add(time, x)

    def _look(self, count: int) -> None:
        """Looks for jumps in the last `count` rows."""
        if self._branches.are_watched and self._rows.count > 1:
            first = max(0, self._rows.count - count - 1)
            self._branches.look(self._rows.times[first:], self._rows.data[first:])

    def _assert(self, time: float) -> None:
        evaluator = self._evaluator
        evaluator.condition()
        for i in np.flatnonzero(evaluator.condition.outputs[0] != 1.0):
            self.violated(evaluator.code.system.assertions[int(i)], time)

    def violated(self, assertion: Assertion, time: float) -> None:
        """Notes a warning; raises `SimulationProblem` (`simulate.assertion`) for an error."""
        text = self.text(assertion.message)
        names = symbols([assertion.condition])
        if assertion.level.endswith("warning"):
            message = f"{text} (first {at(time)}; `{to_text(assertion.condition)}` is false)"
            warning = Diagnostic("simulate.assertion", message, assertion.span, names, severity="warning")
            self._violated.setdefault(assertion, warning)
            return
        message = f"{text} ({at(time)}; `{to_text(assertion.condition)}` is false)"
        raise SimulationProblem(Diagnostic("simulate.assertion", message, assertion.span, names))

    def text(self, message: Expr) -> str:
        """A text of the model's own with the present values."""
        return message_text(message, self._evaluator)

    @property
    def warnings(self) -> tuple[Diagnostic, ...]:
        return (*self._evaluator.jumps.found.values(), *self._violated.values())

    @property
    def time(self) -> Vector:
        return self._rows.times

    @property
    def data(self) -> Vector:
        return self._rows.data
