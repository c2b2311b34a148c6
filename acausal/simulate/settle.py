"""Event iteration: modes, discrete variables and continuous unknowns that agree right after an instant.

Inner loop. Continuous blocks, modes (see `events` for what happens at a zero root) and discrete equations
are evaluated in turn until nothing changes; values before the event stay fixed. Where that goes round in
circles, as it may for friction elements that share a loop, a root that rests at exactly zero, as that of a
brake on a shaft that another one holds, keeps its mode; then one mode at a time is changed (Murty's
least-index rule), and then every assignment of the modes that were in doubt is tried, up to `MOST_TRIED` of
them, with either for what rests at zero. At last one mode at a time is changed from the other end: clutches
in a row that are tied, where one locks while its neighbour is about to slip, settle from one end only.

Outer loop. In its first pass, a located relation has the value that its crossing gave it: a switch may turn
the derivative round, and must not undo itself. Then states are reset, what was found becomes the value before
the event, and the inner loop runs again, until that changes nothing (Modelica 3.6, appendix B).

Both are bounded; what does not settle is named.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import numpy as np
from numpy.typing import NDArray

from acausal.errors import AcausalError, Diagnostic, SimulationProblem
from acausal.simulate.cycle_hints import cycle_hint, endless_hint
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.event_errors import bad_reset, contradicts, no_value
from acausal.simulate.events import Instant, against, crossed_modes, operators, wanted_modes
from acausal.simulate.initial_modes import Switched, moving, same_values
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import at, crossing_text, leaf_name, some
from acausal.symbolic.causal import CausalSystem, ZeroCrossing
from acausal.symbolic.describe import place
from acausal.symbolic.expressions.expr import Expr, postorder, symbols

MAX_ITERATIONS = 50
_PER_MODE = 4
_FIRST, _LAST = 0, -1
_WAYS = ((None, False), (None, True), (_FIRST, False))
"""How to iterate: which of the modes that differ is changed (None: all), and whether what rests at exactly
zero keeps its mode. Where all of this goes round in circles, and no assignment is found: the last."""
_FOLLOWING = 10
MOMENT = 1e4
"""Times the small time to look ahead: then modes that contradict each other have shown it."""
MOST_NEAR = 8
"""Other modes whose assignments are all tried where equations contradict each other."""
MOST_TRIED = 10
"""Modes whose assignments are all tried."""


class Settling:
    """Settles events of one evaluator, looking `ahead` by a small time where a root is zero."""

    def __init__(self, evaluator: Evaluator, ahead: float) -> None:
        system = evaluator.code.system
        part = system.discrete
        self.evaluator = evaluator
        self.fired: Vector = np.zeros(len(part.checks) + len(part.stops))
        """Which checks and stops were met at the event, and were not before."""
        self._ahead = ahead
        self._ops = operators(system)
        self._unknowns = slice(0, len(part.unknowns))
        self._memory = slice(len(part.unknowns), len(part.unknowns) + len(part.memory))
        first = self._memory.stop
        self.samples = slice(first, first + len(part.samples))
        self.phases = {leaf.op: first + len(part.samples) + i for i, leaf in enumerate(part.phases)}
        known = set(part.unknowns)
        self._judged = np.array(
            [_is_discrete(leaf.args[0].op, leaf.args[0] in known) for leaf in part.memory], bool
        )
        self._resets = [system.states.index(reset.state) for reset in part.resets]
        self._disputed = np.zeros(len(self._ops), dtype=np.bool_)
        self._met = np.zeros(len(self._ops), dtype=np.bool_)
        self._none = np.zeros(len(self._ops), dtype=np.bool_)
        self._instant = Instant(0.0, evaluator.x.copy(), ahead, self._none, np.zeros(len(self._ops)))
        self._whole = np.array([is_whole(crossing) for crossing in system.zero_crossings], bool)
        self._error: AcausalError | None = None

    def truth(self) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
        """Of every mode: whether it holds for positive roots, and whether for zero."""
        above = np.array([op in ("gt", "ge") for op in self._ops], np.int32)
        return above, np.array([op in ("ge", "le") for op in self._ops], np.int32)

    def judged(self) -> NDArray[np.int32]:
        """Of every remembered value: whether a change of it goes on with the event."""
        return self._judged.astype(np.int32)

    def released(self) -> NDArray[np.int32]:
        """Of every mode: whether it watches an `integer(...)`."""
        return self._whole.astype(np.int32)

    def reset_states(self) -> NDArray[np.int32]:
        """Which state each `reinit` sets."""
        return np.array(self._resets, np.int32)

    def remember(self) -> None:
        """What holds now is what held before the event."""
        if self._memory.stop > self._memory.start:
            self.evaluator.memory()
            self.evaluator.d[self._memory] = self.evaluator.memory.outputs[0]

    def settle(self, time: float, x: Vector, crossed: NDArray[np.int_] | None = None) -> Vector:
        """Iterates to a fixed point at this instant; the states after it.

        `crossed` marks the roots that brought the solver here: zero, whatever rounding left of them. Where
        modes go round in circles, what else is zero and about to cross at this instant has crossed, too.
        Raises `SimulationProblem` (`simulate.mode-cycle`, `simulate.event-iteration`) where nothing settles.
        """
        evaluator = self.evaluator
        before = evaluator.m.copy(), evaluator.d.copy(), evaluator.guess.copy()
        try:
            return self._settle(time, x, crossed)
        except SimulationProblem as problem:
            evaluator.m[:], evaluator.d[:], evaluator.guess[:] = before
            if "simulate.mode-cycle" not in problem.codes or not evaluator.d.size:
                raise
            more = self._crossing(time, x, np.zeros(len(self._ops), np.int_) if crossed is None else crossed)
            if more is None:
                raise
            return self._settle(time, x, more)

    def depart(self, time: float, x: Vector, stop: float) -> None:
        """Leaves modes that contradict each other a moment later, as a bridge of diodes at zero voltage."""
        evaluator = self.evaluator
        moment = min(time + MOMENT * self._ahead, stop)
        if not evaluator.m.size or evaluator.history is not None or moment <= time:
            return
        before = evaluator.m.copy(), evaluator.d.copy(), evaluator.guess.copy()
        evaluator.at(moment, x)
        contradict = not evaluator.evaluate() and contradicts(evaluator)
        evaluator.guess[:] = before[2]
        if contradict:
            try:
                self._settle(moment, x, None)
            except SimulationProblem:
                evaluator.m[:], evaluator.d[:], evaluator.guess[:] = before
        evaluator.at(time, x)

    def _crossing(self, time: float, x: Vector, crossed: NDArray[np.int_]) -> NDArray[np.int_] | None:
        """`crossed` with what is zero at this instant and crosses next; None if there is no more."""
        evaluator = self.evaluator
        evaluator.at(time, x)
        evaluator.settle()
        instant = Instant(time, x.copy(), self._ahead, self._none, self._instant.roots)
        wanted, near = wanted_modes(evaluator, self._ops, instant)
        more = near & (wanted != evaluator.m) & (crossed == 0)
        rising = np.array([op in ("gt", "ge") for op in self._ops], bool) == (wanted != 0.0)
        return np.where(more, np.where(rising, 1, -1), crossed) if more.any() else None

    def _settle(self, time: float, x: Vector, crossed: NDArray[np.int_] | None) -> Vector:
        evaluator = self.evaluator
        self.fired[:] = 0.0
        evaluator.at(time, x)
        self._arrive(time, x, crossed)
        if not evaluator.d.size:
            self._agree()
            return x
        visited: list[Vector] = []
        for _ in range(MAX_ITERATIONS):
            anchored = self._instant.anchored
            self._agree()
            self._instant = replace(self._instant, anchored=False)
            reset = self._act()
            before = evaluator.d[self._memory].copy()
            self.remember()
            now = evaluator.d[self._memory]
            if not (reset or anchored) and same_values(before[self._judged], now[self._judged]):
                return self._instant.x
            visited.append(now.copy())
        raise _no_end(evaluator.code.system, visited[MAX_ITERATIONS // 2 :], time)

    def _arrive(self, time: float, x: Vector, crossed: NDArray[np.int_] | None) -> None:
        """Notes the instant, and gives crossed relations their new values."""
        evaluator = self.evaluator
        self._met[:] = False
        if crossed is None:
            none, roots = self._none, self._instant.roots
            self._instant = Instant(time, x.copy(), self._ahead, none, roots, met=self._met)
            return
        self._met[:] = crossed != 0
        evaluator.settle()
        wrong = against(evaluator, crossed, self._ahead)
        evaluator.event()
        roots, anchored = evaluator.roots.copy(), bool(evaluator.d.size)
        self._instant = Instant(
            time,
            x.copy(),
            self._ahead,
            crossed != 0,
            roots,
            anchored=anchored,
            met=self._met,
            released=self._whole | wrong,
        )
        evaluator.m[:] = crossed_modes(self._ops, evaluator.m, np.where(wrong, 0, crossed))

    def _act(self) -> bool:
        """Notes checks and stops that are met, and resets states; whether any was reset."""
        part = self.evaluator.code.system.discrete
        if not (part.resets or part.checks or part.stops):
            return False
        evaluator = self.evaluator
        evaluator.actions()
        values = evaluator.actions.outputs[0]
        n, c = len(part.resets), len(part.checks)
        met, holds, ends = values[2 * n : 2 * n + c], values[2 * n + c : 2 * (n + c)], values[2 * (n + c) :]
        violated = (met != 0.0) & (holds != 1.0)
        self.fired[:] = np.maximum(self.fired, np.concatenate([violated, ends != 0.0]))
        resets = np.flatnonzero(values[:n] != 0.0)
        if not resets.size:
            return False
        x = self._instant.x.copy()
        for i in resets:
            if not np.isfinite(values[n + i]):
                raise bad_reset(evaluator, part.resets[i], float(values[n + i]), self._instant.time)
            x[self._resets[i]] = values[n + i]
        self._instant = replace(self._instant, x=x)
        evaluator.at(self._instant.time, x)
        return True

    def _agree(self) -> None:
        """The inner loop."""
        evaluator = self.evaluator
        if not self._ops and not evaluator.d.size:
            evaluator.settle()
            return
        self._error = None
        self._disputed[:] = False
        start = Switched(evaluator.m.copy(), evaluator.d.copy())
        circle: list[Switched] = []
        for single, undecided in _WAYS:
            self._instant = replace(self._instant, undecided=undecided)
            circle = self._iterate(single)
            if not circle:
                break
            evaluator.m[:], evaluator.d[:] = start.m, start.d
        self._instant = replace(self._instant, undecided=False)
        if not circle:
            return
        if self._error is not None and len(circle) == 1:
            if self._try_near(start):
                return
            raise self._error
        if not self._try_all(circle):
            evaluator.m[:], evaluator.d[:] = start.m, start.d
            if not self._iterate(_LAST):
                return
            raise _cycle(evaluator, circle, self._instant.time)

    def _iterate(self, single: int | None) -> list[Switched]:
        """Until nothing changes: nothing; what came round again, or the place of an error, otherwise."""
        evaluator = self.evaluator
        visited: list[Switched] = []
        for _ in range(MAX_ITERATIONS + (_PER_MODE * len(evaluator.m) if single is not None else 0)):
            present = Switched(evaluator.m.copy(), evaluator.d.copy())
            if not self._step(present, single):
                return [present]
            following = Switched(evaluator.m.copy(), evaluator.d.copy())
            if following.agrees(present):
                return []
            visited.append(present)
            again = [i for i, seen in enumerate(visited) if seen.agrees(following)]
            if again:
                return visited[again[0] :]
        return visited

    def _step(self, present: Switched, single: int | None) -> bool:
        """One pass; False where something cannot be computed (the error is kept)."""
        evaluator = self.evaluator
        try:
            evaluator.settle()
            modes, near = wanted_modes(evaluator, self._ops, self._instant)
        except SimulationProblem as error:
            self._error = self._error or error
            return False
        self._met |= near
        self._disputed |= modes != present.m
        different = np.flatnonzero(modes != present.m)
        if single is not None and different.size:
            modes = np.where(np.arange(len(modes)) == different[single], modes, present.m)
        evaluator.m[:] = modes
        return self._follow()

    def _follow(self) -> bool:
        """The discrete equations, once, with the present modes."""
        evaluator = self.evaluator
        if self._unknowns.stop == 0:
            return True
        evaluator.update()
        found = evaluator.update.outputs[0]
        if not np.isfinite(found).all():
            self._error = self._error or no_value(evaluator, found, self._instant.time)
            return False
        evaluator.d[self._unknowns] = found
        return True

    def _try_all(self, circle: list[Switched]) -> bool:
        """Every assignment of the modes in doubt; whether one is consistent, which then holds."""
        evaluator = self.evaluator
        which = np.flatnonzero(self._disputed)
        if len(which) > MOST_TRIED or len(circle) == 1:
            return False
        for undecided in (False, True):
            self._instant = replace(self._instant, undecided=undecided)
            for values in product((0.0, 1.0), repeat=len(which)):
                evaluator.m[:], evaluator.d[:] = circle[0].m, circle[0].d
                evaluator.m[which] = values
                if self._is_consistent(which):
                    return True
        return False

    def _try_near(self, start: Switched) -> bool:
        """Where the equations of `start` contradict each other, the nearest modes in which they do not.

        Two ideal diodes that both conduct join their sources. What crossed keeps its new value.
        """
        evaluator, error = self.evaluator, self._error
        which = np.flatnonzero(~self._instant.crossed)
        if error is None or "simulate.singular-block" not in error.codes or len(which) > MOST_NEAR:
            return False
        changes = sorted(product((0.0, 1.0), repeat=len(which)), key=sum)
        for change in changes[1:]:
            evaluator.m[:], evaluator.d[:] = start.m, start.d
            evaluator.m[which] = np.abs(start.m[which] - np.array(change))
            if self._is_consistent(np.arange(len(start.m))):
                return True
        evaluator.m[:], evaluator.d[:] = start.m, start.d
        return False

    def _is_consistent(self, which: NDArray[np.intp]) -> bool:
        """Whether everything agrees once what is not in `which` has followed."""
        evaluator = self.evaluator
        chosen = evaluator.m[which].copy()
        for _ in range(_FOLLOWING):  # the discrete values of these modes, before the modes are judged
            before = evaluator.d.copy()
            if not self._follow():
                return False
            if same_values(before, evaluator.d):
                break
        for _ in range(MAX_ITERATIONS):
            present = Switched(evaluator.m.copy(), evaluator.d.copy())
            if not self._step(present, None) or not np.array_equal(evaluator.m[which], chosen):
                return False
            if present.agrees(Switched(evaluator.m.copy(), evaluator.d.copy())):
                return True
        return False


def is_whole(crossing: ZeroCrossing) -> bool:
    """Whether it is one of the two that end what `integer(...)` holds."""
    return any(node.op == "integer" for node in postorder([crossing.relation]))


def _is_discrete(op: str, is_known: bool) -> bool:
    """Whether the past of this changes at events only: a discrete variable or a condition."""
    return is_known or op not in ("sym", "der")


def _cycle(evaluator: Evaluator, circle: list[Switched], time: float) -> AcausalError:
    system = evaluator.code.system
    switching = moving([s.m for s in circle])
    crossings = [c for c, changes in zip(system.zero_crossings, switching, strict=True) if changes]
    frozen = zip(system.discrete.assignments, moving([s.d for s in circle]), strict=False)
    discrete = [a for a, changes in frozen if changes]
    if not crossings:
        return _circling(system, [a.unknown for a in discrete], time)
    texts = some([crossing_text(crossing) for crossing in crossings])
    names = [*symbols([c.relation for c in crossings]), *(leaf_name(a.unknown) for a in discrete)]
    message = f"the conditions {texts} switch back and forth {at(time)} and do not settle"
    hint = cycle_hint(evaluator, circle, switching, [a.unknown for a in discrete])
    return SimulationProblem(
        Diagnostic("simulate.mode-cycle", message, crossings[0].span, tuple(dict.fromkeys(names)), hint)
    )


def _no_end(system: CausalSystem, visited: list[Vector], time: float) -> AcausalError:
    changing = moving(visited)
    sources = [leaf.args[0] for leaf, on in zip(system.discrete.memory, changing, strict=True) if on]
    return _circling(system, sources, time)


def _circling(system: CausalSystem, leaves: Sequence[Expr], time: float) -> AcausalError:
    """The event goes on for ever because of these discrete values."""
    names = symbols(leaves)
    by_unknown = {a.unknown: a.equation.flat for a in system.discrete.assignments}
    spans = [by_unknown[leaf].span for leaf in leaves if leaf in by_unknown]
    texts = [
        f"`{leaf_name(leaf)}`" + (f" ({place(by_unknown[leaf].span)})" if leaf in by_unknown else "")
        for leaf in leaves
    ]
    message = (
        f"the event {at(time)} does not end: {some(texts)} changed in each of {MAX_ITERATIONS} iterations"
    )
    hint = endless_hint([a for a in system.discrete.assignments if a.unknown in leaves])
    span = spans[0] if spans else system.flat.span
    return SimulationProblem(Diagnostic("simulate.event-iteration", message, span, names, hint))
