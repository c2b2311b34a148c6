"""The event loop: from grid point to grid point, stopping at events."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from acausal.simulate.evaluator import Evaluator
from acausal.simulate.events import EventGuard, crossed_modes, operators, settle_modes
from acausal.simulate.matrices import Vector
from acausal.simulate.options import Options
from acausal.simulate.record import Recorder
from acausal.simulate.reselect import Reselection
from acausal.simulate.solver import Solver, Sweeper, Work

_Scalar = TypeVar("_Scalar", bound=np.generic)
_AHEAD = 1e-9
"""How far to look forward for the side of a zero root, relative to the simulated time."""
_ROUND = 64 * np.finfo(float).eps


def grid(options: Options) -> Iterator[float]:
    """Output times after the start: multiples of the interval, then the stop time."""
    start, stop, interval = options.start_time, options.stop_time, options.interval
    count = int(np.ceil((stop - start) / interval * (1 - 1e-12))) if stop > start else 0
    for i in range(1, count):
        yield start + i * interval
    if stop > start:
        yield stop


@dataclass(frozen=True)
class Course:
    """How a run went: event instants, new choices of states, and what the integrator did.

    `compiling` are the CPU seconds that compiling systems with other states took.
    """

    events: int
    state_selections: int
    compiling: float
    work: Work


def run(
    evaluator: Evaluator,
    solver: Callable[[Evaluator], Solver] | None,
    x: Vector,
    options: Options,
    recorder: Recorder,
) -> Course:
    """Integrates and records.

    `solver` makes an integrator; it is None for a model without states and events, which is only evaluated.
    Raises `SimulationProblem`, and ReductionProblem where no states can be chosen any more.
    """
    loop = _Loop(evaluator, solver, options, recorder)
    loop.begin(options.start_time, x)
    targets = np.array(list(grid(options)))
    done = 0
    while done < len(targets):
        done += loop.reach(targets[done:])
    return loop.course()


class _Loop:
    """The present point of a run."""

    def __init__(
        self,
        evaluator: Evaluator,
        make_solver: Callable[[Evaluator], Solver] | None,
        options: Options,
        recorder: Recorder,
    ) -> None:
        self.evaluator = evaluator
        self.make_solver = make_solver
        self.solver = make_solver(evaluator) if make_solver is not None else None
        self.options = options
        self.recorder = recorder
        self.guard = EventGuard(evaluator.code.system, options.span)
        self.reselection = Reselection(evaluator, options.span)
        self._before = Work(0, 0, 0)
        self._operators = operators(evaluator.code.system)
        self._ahead = _AHEAD * (options.span or 1.0)
        self._time = options.start_time
        self._x = evaluator.x.copy()

    def begin(self, time: float, x: Vector) -> None:
        self._time, self._x = time, x.copy()
        before = self.evaluator.m.copy()
        self.evaluator.at(time, x)
        self.evaluator.settle()
        self.recorder.add(time, x)
        settle_modes(self.evaluator, time, x, self._ahead)
        if not np.array_equal(self._own(before), self._own(self.evaluator.m)):
            self.recorder.add(time, x)
        self._restart()

    def reach(self, targets: Vector) -> int:
        """Advances over the first of the grid points `targets`; says over how many."""
        if isinstance(self.solver, Sweeper):
            return self._sweep(self.solver, targets)
        self._reach(float(targets[0]))
        return 1

    def _sweep(self, solver: Sweeper, targets: Vector) -> int:
        """To the next event, or as far as the solver goes at once; records the grid points on the way."""
        found = solver.sweep(targets, self.options.stop_time)
        self.recorder.extend(found.times, found.rows)
        if found.is_suspect:
            self.recorder.look_again(found.time, found.x)
        elif found.crossed is not None:
            self._time, self._x = found.time, found.x
            self._event(crossed_modes(self._operators, self.evaluator.m, found.crossed), found.crossed)
        return len(found.times)

    def _reach(self, target: float) -> None:
        """Advances to the grid point `target` through all events before it."""
        if self.solver is None:
            self._time = target
            self.evaluator.at(target, self._x)
            self.evaluator.settle()
            self.recorder.add(target, self._x)
            return
        while target - self._time > _ROUND * max(abs(target), abs(self._time)):
            arrival = self.solver.advance(target, self.options.stop_time)
            self._time, self._x = arrival.time, arrival.x
            if arrival.crossed is not None:
                wanted = crossed_modes(self._operators, self.evaluator.m, arrival.crossed)
                self._event(wanted, arrival.crossed)
            elif self._operators and not self._modes_hold():
                self._event(self.evaluator.m.copy(), None)
        self.recorder.add(target, self._x)

    def course(self) -> Course:
        """What happened so far."""
        chosen = self.reselection
        return Course(self.guard.count, chosen.count, chosen.compiling, self._work())

    def _work(self) -> Work:
        return self._before if self.solver is None else self._before + self.solver.work

    def _own(self, modes: NDArray[_Scalar]) -> NDArray[_Scalar]:
        """The modes of the model's events, without those that watch the choice of states."""
        return modes[: self.reselection.own(self.evaluator)]

    def _modes_hold(self) -> bool:
        """Whether no relation clearly lost its mode: a net below CVODE's root search."""
        evaluator = self.evaluator
        evaluator.at(self._time, self._x)
        evaluator.event()
        evaluator.size()
        clear = np.abs(evaluator.roots) > 1e-6 * evaluator.sizes
        if not clear.any():
            return True
        signs = np.sign(evaluator.roots).astype(np.int_)
        return not np.any(clear & (crossed_modes(self._operators, evaluator.m, signs) != evaluator.m))

    def _event(self, wanted: Vector, crossed: NDArray[np.int_] | None) -> None:
        """Records both sides of an event and starts the solver anew where modes changed."""
        evaluator = self.evaluator
        before = evaluator.m.copy()
        own = crossed is None or bool(self._own(crossed).any())
        if own:
            self.recorder.add(self._time, self._x)
        evaluator.m[:] = wanted
        settle_modes(evaluator, self._time, self._x, self._ahead, crossed)
        changed = self._own(before != evaluator.m)
        if own:
            self.guard.add(self._time, changed | self._own(wanted != before))
        if changed.any():
            self.recorder.add(self._time, self._x)
        self._restart()

    def _restart(self) -> None:
        """Starts the solver at the present point, with other states where these have become unfit."""
        if self.reselection.is_due(self.evaluator) and self.make_solver is not None:
            self._before = self._work()
            self.evaluator, self._x = self.reselection(self.evaluator, self._time, self._x)
            self._operators = operators(self.evaluator.code.system)
            self.recorder.go_on_with(self.evaluator)
            self.solver = self.make_solver(self.evaluator)
        if self.solver is not None:
            self.solver.restart(self._time, self._x)
