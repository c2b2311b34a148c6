"""Snapshots at instants of a stored result: its states, with the modes and discrete values that go with them.

A table holds the states; discrete values are in it if they were stored. If some are missing, the rows before
the instant are gone through, and what a run does at an event is done at each: discrete equations follow the
states, of which none is reset, because the next row has them. What the table holds beyond the states must
then come out of the model, else the snapshot says so.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import inf

import numpy as np
from numpy.typing import NDArray

from acausal.analysis.linearize import At, Setting, snapshot_of
from acausal.analysis.snapshot import Snapshot
from acausal.codegen.functions import Code
from acausal.errors import AcausalError, LookupProblem, UsageProblem, fail
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.events import Instant, crossed_modes, operators, wanted_modes
from acausal.simulate.initialize import initialize
from acausal.simulate.messages import number, some
from acausal.simulate.result import Result
from acausal.simulate.schedule import Schedule
from acausal.simulate.settle import Settling
from acausal.symbolic.expressions.text import to_text

Vector = NDArray[np.float64]
Columns = Mapping[str, Vector]

_TOLERANCE = 1e-4
"""By how much a stored value may differ from the model's, relative to the largest in its column."""
_AHEAD = 1e-9
_NEAR = 1e-7
"""A root this small beside its sides was located."""
_PASSES = 50


def columns_of(code: Code, result: Result) -> dict[str, Vector]:
    """What a snapshot needs of a result in memory."""
    discrete = map(to_text, code.system.discrete.unknowns)
    known = frozenset(map(to_text, result.leaves))
    names = dict.fromkeys([*code.system.states, *(name for name in discrete if name in known)])
    return {"time": result.time, **{name: result.values(name) for name in names}}


def stored_snapshots(
    code: Code, columns: Columns, at: Sequence[At], setting: Setting | None = None
) -> tuple[Snapshot, ...]:
    """The snapshots at instants of a table with `time` and a column for every state.

    `initial` is its first row. Raises LookupProblem `stored.states` for a table without all states,
    UsageProblem `stored.instant` for an instant outside it, `stored.states` for a model whose states change.
    """
    table = _Table(code, columns)
    given = setting or Setting()
    return tuple(table.snapshot(one, given) for one in at)


class _Table:
    """A stored result of one model."""

    def __init__(self, code: Code, columns: Columns) -> None:
        if code.system.dynamic is not None:
            message = f"{code.system.flat.name} chooses its states during a run, which a table does not tell"
            raise fail(UsageProblem, "stored.states", message, hint="give the instant without --result")
        missing = [name for name in code.system.states if name not in columns]
        if missing:
            message = f"the result does not hold the states {some([f'`{name}`' for name in missing])}"
            hint = "was it made by this model? `acausal simulate MODEL -o FILE.csv` stores all states"
            raise fail(LookupProblem, "stored.states", message, names=missing, hint=hint)
        self.code = code
        self.columns = columns
        self.time = columns["time"]
        self.x = np.column_stack([columns[name] for name in code.system.states])
        self.x = self.x.reshape(len(self.time), len(code.system.states))
        self.discrete = {
            i: columns[name]
            for i, leaf in enumerate(code.system.discrete.unknowns)
            if (name := to_text(leaf)) in columns
        }

    def snapshot(self, at: At, setting: Setting) -> Snapshot:
        """The snapshot at one instant, with what does not fit as a note."""
        row, instant = self._row(at)
        evaluator = self._evaluator(row, setting)
        x = self.x[row] if self.time[row] == instant else self._between(evaluator, row, instant)
        evaluator.at(instant, x)
        evaluator.settle()
        self._modes(evaluator, x, instant)
        found = snapshot_of(evaluator)
        if self.time[row] == instant:
            return replace(found, notes=(*found.notes, *self._notes(evaluator, row)))
        return replace(found, notes=(*found.notes, *self._gap(found, row)))

    def _row(self, at: At) -> tuple[int, float]:
        """The last row that is not after the instant, and the instant."""
        first, last = float(self.time[0]), float(self.time[-1])
        try:
            instant = first if at == "initial" else float(at)
        except ValueError:
            instant = inf
        if not first <= instant <= last:
            hint = f"give `initial`, or seconds from {first:g} to {last:g}"
            raise fail(UsageProblem, "stored.instant", f"the result has no instant `{at}`", hint=hint)
        near = self.time[np.abs(self.time - instant) <= 1e-12 * max(abs(instant), 1e-300)]
        instant = float(near[-1]) if near.size else float(instant)
        return int(np.searchsorted(self.time, instant, side="right")) - 1, instant

    def _evaluator(self, row: int, setting: Setting) -> Evaluator:
        """An evaluator with the parameters of the setting and the discrete values of a row."""
        began = float(self.time[0])
        point = initialize(
            self.code, began, setting.parameters, setting.start, setting.inputs, float(self.time[-1])
        )
        e = point.evaluator
        part = self.code.system.discrete
        settling = Settling(e, _AHEAD * max(float(self.time[-1]) - began, _AHEAD))
        for phase in settling.phases.values():
            e.d[phase] = 0.0
        if e.history is not None or len(self.discrete) < len(part.unknowns):
            self._go_through(e, settling, row)
        for i, values in self.discrete.items():
            e.d[i] = values[row]
        e.d[settling.samples] = 0.0
        e.at(float(self.time[row]), self.x[row])
        e.settle()
        settling.remember()
        return e

    def _go_through(self, e: Evaluator, settling: Settling, last: int) -> None:
        """Settles every row up to `last`, as an event there would be."""
        schedule = Schedule(e, float(self.time[0]))
        for row in range(last + 1):
            time = float(self.time[row])
            for i, values in self.discrete.items():
                e.d[i] = values[row]
            if row < last and self.time[row + 1] == time:
                continue  # the row before an event: the one after it is settled
            before = self.x[row - 1] if row and self.time[row - 1] == time else self.x[row]
            e.at(time, before)
            e.settle()
            settling.remember()
            crossed = self._crossed(e, time, before)
            e.d[settling.samples] = schedule.due(time)
            try:
                settling.settle(time, before, crossed if crossed.any() else None)
            except AcausalError as error:
                raise _stuck(time, error) from None
            e.d[settling.samples] = 0.0
            e.at(time, self.x[row])
            e.keep_past(_AHEAD)

    def _crossed(self, e: Evaluator, time: float, x: Vector) -> NDArray[np.int_]:
        """Which roots pass through zero here, as a run would have located them: +1 rising, -1 falling."""
        ops = operators(self.code.system)
        if not ops:
            return np.zeros(0, dtype=np.int_)
        e.event()
        e.size()
        roots, sizes, slope = e.roots.copy(), e.sizes.copy(), e.xdot.copy()
        e.at(time + _AHEAD, x + _AHEAD * slope)
        e.event()
        signs = np.where(np.abs(roots) <= _NEAR * sizes, np.sign(e.roots - roots), 0.0).astype(np.int_)
        e.at(time, x)
        return np.where(crossed_modes(ops, e.m, signs) != e.m, signs, 0)

    def _modes(self, e: Evaluator, x: Vector, time: float) -> None:
        """Gives the relations the values that they have here, whatever came before."""
        ops = operators(self.code.system)
        none = np.zeros(len(ops), dtype=np.bool_)
        for _ in range(_PASSES):
            instant = Instant(time, x.copy(), _AHEAD, none, np.zeros(len(ops)))
            wanted = wanted_modes(e, ops, instant)[0] if ops else e.m
            if np.array_equal(wanted, e.m):
                return
            e.m[:] = wanted
            e.settle()

    def _between(self, e: Evaluator, row: int, instant: float) -> Vector:
        """States between two rows without an event between them: cubic, with the slopes at both."""
        t0, t1 = float(self.time[row]), float(self.time[row + 1])
        slopes: list[Vector] = []
        for time, x in ((t0, self.x[row]), (t1, self.x[row + 1])):
            e.at(time, x)
            e.settle()
            self._modes(e, x, time)
            slopes.append(e.xdot * (t1 - t0))
        s = (instant - t0) / (t1 - t0)
        change = self.x[row + 1] - self.x[row]
        a, b = slopes[0] - change, change - slopes[1]
        return np.asarray(self.x[row] + s * change + s * (1 - s) * ((1 - s) * a + s * b), dtype=np.float64)

    def _gap(self, found: Snapshot, row: int) -> tuple[str, ...]:
        """Whether the model can move between two rows in ways that they do not show."""
        gap = float(self.time[row + 1] - self.time[row])
        fastest = float(np.abs(found.eigenvalues).max(initial=0.0))
        if gap * fastest <= 1:
            return ()
        rows = f"interpolated between the rows at {self.time[row]:g} s and {self.time[row + 1]:g} s"
        advice = "take the instant of a row, or store with a shorter interval"
        return (f"{rows}, {number(gap * fastest)} fastest time constants apart: {advice}",)

    def _notes(self, e: Evaluator, row: int) -> tuple[str, ...]:
        """Stored values that the model does not give at this point."""
        e.output()
        model = dict(zip(map(to_text, self.code.output_leaves), e.output.outputs[0].tolist(), strict=True))
        wrong: list[str] = []
        for name, values in self.columns.items():
            if name not in model or not np.isfinite(values[row]):
                continue
            size = max(float(np.nanmax(np.abs(values))), 1e-300)
            if abs(model[name] - values[row]) > _TOLERANCE * size:
                wrong.append(f"{name} = {number(float(values[row]))}, here {number(model[name])}")
        if not wrong:
            return ()
        advice = "were its parameters others, or are discrete values missing (store it with --all)?"
        return (f"the result does not agree with the model: {some(wrong)}; {advice}",)


def _stuck(time: float, error: AcausalError) -> AcausalError:
    why = error.diagnostics[0].message
    message = f"the discrete values at {time:g} s cannot be found from the result: {why}"
    hint = "store the result with --all, so that it holds them"
    return fail(UsageProblem, "stored.discrete", message, hint=hint)
