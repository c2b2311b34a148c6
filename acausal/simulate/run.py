"""The event loop: from grid point to grid point, stopping at events."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from acausal.errors import AcausalError
from acausal.simulate.costs import Costs, EventCost, StateCost, event_costs
from acausal.simulate.cruise import Cruise
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.events import EventGuard, check_conditions, crossed_modes, operators
from acausal.simulate.matrices import Vector
from acausal.simulate.options import Options
from acausal.simulate.record import Ending, Recorder
from acausal.simulate.reselect import Reselection
from acausal.simulate.schedule import Schedule, is_reached
from acausal.simulate.settle import Settling
from acausal.simulate.solver import Solver, Sweeper, Work
from acausal.simulate.standing import Standing, standing_of

_Scalar = TypeVar("_Scalar", bound=np.generic)
_AHEAD = 1e-9
"""How far to look forward for the side of a zero root, relative to the simulated time."""
_ROUND = 64 * np.finfo(float).eps


def grid(options: Options) -> Vector:
    """Output times after the first one: the chosen ones, or multiples of the interval; then the stop time."""
    start, stop, interval = options.start_time, options.stop_time, options.interval
    if options.times:
        return np.array([*(time for time in options.times if options.first < time < stop), stop])
    if not stop > start:
        return np.zeros(0)
    count = int(np.ceil((stop - start) / interval * (1 - 1e-12)))
    done = 1 if options.resumed is None else int((options.first - start) / interval * (1 + 1e-12)) + 1
    return np.append(start + np.arange(done, count) * interval, stop)


@dataclass(frozen=True)
class Course:
    """How a run went: event instants, new choices of states, and what the integrator did.

    `compiling` are the CPU seconds that compiling systems with other states took; `ended` what a `terminate`
    said, None where the run reached its end.
    """

    events: int
    state_selections: int
    compiling: float
    work: Work
    ended: Ending | None = None
    state_costs: tuple[StateCost, ...] = ()
    event_costs: tuple[EventCost, ...] = ()
    standing: Standing | None = None
    """From where another run can go on."""


Observer = Callable[[float, Callable[[], Standing]], None]
"""Is told on the way, between events, how far the run is, and can ask where it stands."""


def run(
    evaluator: Evaluator,
    solver: Callable[[Evaluator], Solver] | None,
    x: Vector,
    options: Options,
    recorder: Recorder,
    stopped: Callable[[Course], None] | None = None,
    observe: Observer | None = None,
    after: Standing | None = None,
) -> Course:
    """Integrates and records. `stopped` is told how far a run came that fails or is interrupted.

    `observe` is called on the way and may interrupt the run. It goes on from `after`, if that is given.

    `solver` makes an integrator; it is None for a model without states and located events, which is only
    evaluated. Raises `SimulationProblem`, and ReductionProblem where no states can be chosen any more.
    """
    loop = _Loop(evaluator, solver, options, recorder)
    try:
        if after is None:
            loop.begin(options.start_time, x)
        else:
            loop.go_on(x, after)
        targets = grid(options)
        done = 0
        while done < len(targets) and loop.ended is None:
            done += loop.pace(targets[done:])
            if observe is not None:
                observe(loop.time, loop.standing)
        loop.finish()
    except (AcausalError, KeyboardInterrupt):
        if stopped is not None:
            stopped(loop.course())
        raise
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
        self._sweeper = self.solver if isinstance(self.solver, Sweeper) else None
        self.options = options
        self.recorder = recorder
        self.guard = EventGuard(evaluator.code.system, options.span)
        self.reselection = Reselection(evaluator, options.span)
        self.ended: Ending | None = None
        self._before = Work(0, 0, 0)
        self._costs = Costs()
        self._operators = operators(evaluator.code.system)
        self._ahead = _AHEAD * (options.span or 1.0)
        self._settling = Settling(evaluator, self._ahead)
        self._schedule = Schedule(evaluator, options.start_time)
        self._cruise = self._handing_over()
        self._next = math.inf
        """The next event at a known instant."""
        self._time = options.first
        self._x = evaluator.x.copy()
        self._between = False
        """Whether no event is under way, so that it can be said where the run stands."""
        self._last: Standing | None = None

    def _handing_over(self) -> Cruise | None:
        """Has the solver handle events on the way, if it can."""
        if self._sweeper is None or self.recorder.watches_modes:
            return None
        return self._sweeper.handle(self._settling, self._schedule, self.guard, self._ahead)

    def begin(self, time: float, x: Vector) -> None:
        """From the initial values through the first event; what holds before it is no part of the course."""
        self._time, self._x = time, x.copy()
        evaluator, settling = self.evaluator, self._settling
        evaluator.at(time, x)
        evaluator.settle()
        self._keep_past()
        settling.remember()
        if "initial" in settling.phases:
            evaluator.d[settling.phases["initial"]] = 0.0
        evaluator.d[settling.samples] = self._schedule.due(time)
        self._x = settling.settle(time, x)
        settling.depart(time, self._x, self.options.stop_time)
        self.recorder.add(time, self._x)
        self._close()
        self._restart()

    def go_on(self, x: Vector, after: Standing) -> None:
        """From where another run stood; the evaluator has its modes, discrete values and past."""
        self._x = x.copy()
        self.evaluator.at(self._time, x)
        self.evaluator.settle()
        self._schedule.go_on(after.samples)
        self.recorder.add(self._time, x)
        self._restart()

    @property
    def time(self) -> float:
        return self.recorder.last_time

    def standing(self) -> Standing:
        """Where the run stands at the last row."""
        time, row = self.recorder.last()
        own = self.reselection.own(self.evaluator)
        return standing_of(
            self.evaluator, own, self.options, time, self.recorder.count, row, self._schedule.counts
        )

    def pace(self, targets: Vector) -> int:
        """As `reach`, and notes whether it was interrupted."""
        self._between = False
        done = self.reach(targets)
        self._between = True
        return done

    def reach(self, targets: Vector) -> int:
        """Advances over the first of the grid points `targets`; says over how many."""
        if self._sweeper is not None:
            return self._sweep(self._sweeper, targets)
        self._reach(float(targets[0]))
        return 1

    def _sweep(self, solver: Sweeper, targets: Vector) -> int:
        """To the next event, or as far as the solver goes at once; records the grid points on the way."""
        if self._cruise is not None:
            self._cruise.at(self.recorder.last_time, self._next)
            found = solver.sweep(targets, self.options.stop_time)
            self._next = self._cruise.next
        elif is_reached(self._time, self._next):
            self._event(None)
            return 0
        else:
            found = solver.sweep(targets, min(self.options.stop_time, self._next, self._piece()))
        self.recorder.extend(found.times, found.rows)
        if found.is_crowded:
            raise self.guard.crowded()
        if found.is_suspect:
            self.recorder.look_again(found.time, found.x)
        elif found.crossed is not None:
            self._time, self._x = found.time, found.x
            self._event(found.crossed)
        elif found.is_there:
            self._time, self._x = found.time, found.x
            if is_reached(self._time, self._next):
                self._event(None)
            else:
                self._keep_past()
        return found.taken

    def _piece(self) -> float:
        """Until when to integrate in one go: delayed values must be known."""
        history = self.evaluator.history
        if history is None:
            return math.inf
        return self._time + history.piece(self.options.interval)

    def _keep_past(self) -> None:
        if self.evaluator.history is not None:
            self.evaluator.at(self._time, self._x)
            self.evaluator.keep_past(self._ahead)

    def _reach(self, target: float) -> None:
        """Advances to the grid point `target` through all events before it."""
        stop = self.options.stop_time
        while self.ended is None and target - self._time > _ROUND * max(abs(target), abs(self._time)):
            if is_reached(self._time, self._next):
                self._event(None)
                continue
            limit = min(target, self._next, self._piece())
            if self.solver is None:
                self._time = limit
            else:
                arrival = self.solver.advance(limit, min(stop, self._next))
                self._time, self._x = arrival.time, arrival.x
                if arrival.crossed is not None:
                    self._event(arrival.crossed)
                    continue
            if is_reached(self._time, self._next):
                self._time = self._next
                self._event(None)
            elif self.solver is not None and self._operators and not self._modes_hold():
                self._event(None)
            else:
                self._keep_past()
        if self.ended is None and not self.recorder.is_at(target):
            self.recorder.add(target, self._x)

    def finish(self) -> None:
        """The event at the end, if the model asks for it."""
        if self.recorder.count:
            self._last = self.standing()
        phase = self._settling.phases.get("terminal")
        if phase is not None:
            self.evaluator.at(self._time, self._x)
            self._settling.remember()
            self.evaluator.d[phase] = 1.0
            before = self._switched()
            self._x = self._settling.settle(self._time, self._x)
            if not np.array_equal(before, self._switched()):
                self.recorder.add(self._time, self._x)
            self._act()

    def course(self) -> Course:
        """What happened so far."""
        chosen = self.reselection
        if self._last is None and self._between:
            self._last = self.standing()
        self._costs.add(self.solver, self.evaluator.code.system.states)
        return Course(
            self.guard.count,
            chosen.count,
            chosen.compiling,
            self._work(),
            self.ended,
            self._costs.states(),
            event_costs(self.guard.system, self.guard.tally),
            self._last if self.ended is None else None,
        )

    def _work(self) -> Work:
        return self._before if self.solver is None else self._before + self.solver.work

    def _own(self, modes: NDArray[_Scalar]) -> NDArray[_Scalar]:
        """The modes of the model's events, without those that watch the choice of states."""
        return modes[: self.reselection.own(self.evaluator)]

    def _switched(self) -> Vector:
        """The model's modes and the values of discrete variables."""
        count = len(self.evaluator.code.system.discrete.unknowns)
        return np.concatenate([self._own(self.evaluator.m), self.evaluator.d[:count]])

    def _modes_hold(self) -> bool:
        """Whether no relation clearly lost its mode: a net below the solver's root search."""
        evaluator = self.evaluator
        evaluator.at(self._time, self._x)
        evaluator.event()
        if not np.isfinite(evaluator.roots[evaluator.located]).all():
            check_conditions(evaluator, self._time)
        evaluator.size()
        clear = (np.abs(evaluator.roots) > 1e-6 * evaluator.sizes) & ~evaluator.within(evaluator.roots)
        if not clear.any():
            return True
        signs = np.sign(evaluator.roots).astype(np.int_)
        return not np.any(clear & (crossed_modes(self._operators, evaluator.m, signs) != evaluator.m))

    def _event(self, crossed: NDArray[np.int_] | None) -> None:
        """Records both sides of an event and starts the solver anew."""
        evaluator, settling = self.evaluator, self._settling
        if is_reached(self._time, self._next):
            self._time = self._next
        before = self._switched()
        own = crossed is None or bool(self._own(crossed).any())
        if own and not self.recorder.is_at(self._time):
            self.recorder.add(self._time, self._x)
        self._keep_past()
        evaluator.at(self._time, self._x)
        settling.remember()
        due = self._schedule.due(self._time)
        evaluator.d[settling.samples] = due
        x = settling.settle(self._time, self._x, crossed)
        settling.depart(self._time, x, self.options.stop_time)
        jumped = not np.array_equal(x, self._x)
        self._x = x
        changed = self._switched() != before
        happened = bool(changed.any() or jumped or due.any())
        if happened:
            self.recorder.add(self._time, self._x)
        if own:
            found = (
                self._own(crossed != 0)
                if crossed is not None
                else self._own(np.zeros(len(evaluator.m), bool))
            )
            changed[: len(found)] |= found
            self.guard.add(self._time, changed, happened)
        self._close()
        self._restart()

    def _close(self) -> None:
        """Acts on what the event met, and ends the moment in which samples are true."""
        self._act()
        samples = self.evaluator.d[self._settling.samples]
        if not samples.any():
            return
        before = self._switched()
        self._settling.remember()
        samples[:] = 0.0
        self._x = self._settling.settle(self._time, self._x)
        if not np.array_equal(before, self._switched()):
            self.recorder.add(self._time, self._x)
        self._act()

    def _act(self) -> None:
        """Raises the assertions that were violated at the event; notes its `terminate`."""
        fired = self._settling.fired
        if not fired.any():
            return
        part = self.evaluator.code.system.discrete
        for i in np.flatnonzero(fired[: len(part.checks)]):
            self.recorder.violated(part.checks[i].assertion, self._time)
        for i in np.flatnonzero(fired[len(part.checks) :]):
            termination = part.stops[i].termination
            self.ended = self.ended or Ending(
                self._time, self.recorder.text(termination.message), termination.span
            )

    def _restart(self) -> None:
        """Starts the solver at the present point, with other states where these have become unfit."""
        if self.reselection.is_due(self.evaluator) and self.make_solver is not None:
            self._before = self._work()
            self._costs.add(self.solver, self.evaluator.code.system.states)
            self.evaluator, self._x = self.reselection(self.evaluator, self._time, self._x)
            self._operators = operators(self.evaluator.code.system)
            self._settling = Settling(self.evaluator, self._ahead)
            self.recorder.go_on_with(self.evaluator)
            self.solver = self.make_solver(self.evaluator)
            self._sweeper = self.solver if isinstance(self.solver, Sweeper) else None
            self._cruise = self._handing_over()
        self._keep_past()
        self._next = self._schedule.next(self.evaluator, self._time)
        if self.evaluator.history is not None:
            self._next = min(self._next, self.evaluator.history.next_jump(self._time))
        if self.solver is not None:
            self.evaluator.at(self._time, self._x)
            self.evaluator.hold(1e4 * self._ahead)
            self.solver.restart(self._time, self._x)
