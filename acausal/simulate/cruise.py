"""Events handled by the run-time in C, so that a run comes back to Python for those only that need more.

What settles at once, and has nothing to say, is done in C: both rows, modes, discrete variables and states,
the next known instant, and the integrator's restart. Anything else, such as modes that go round in circles,
an assertion or a `terminate`, is left to `settle` with everything as it was before the event. Both do the
same operations in the same order. Not for models with delays, with functions that only Python has, or with
states that are chosen during the run.
"""

from __future__ import annotations

import ctypes
from dataclasses import dataclass

import numpy as np

from acausal.codegen.c_text import event_functions
from acausal.codegen.functions import Code
from acausal.codegen.kernels import is_evaluated_in_python
from acausal.runtime.binding import ModelStructure, SolverStructure
from acausal.runtime.event_binding import CruiseStructure, EventRunTime, EventStructure
from acausal.simulate.events import EventGuard
from acausal.simulate.machine import bound, pointer
from acausal.simulate.matrices import Vector
from acausal.simulate.memory import Memory, numbers
from acausal.simulate.schedule import Schedule
from acausal.simulate.settle import Settling

_LEAST = 16
"""Rows that there is room for, at least: an event takes up to four."""


def is_possible(code: Code) -> bool:
    """Whether there are events that the run-time can handle."""
    system = code.system
    if not (system.zero_crossings or system.discrete.frozen):
        return False
    if system.delays or len(system.events) != len(system.zero_crossings):
        return False
    return not any(is_evaluated_in_python(function) for function in event_functions(code).values())


@dataclass(frozen=True)
class Stretch:
    """What one call did: its code, rows at `times`, and how many of the targets are passed."""

    code: int
    times: Vector
    rows: Vector
    taken: int


class Cruise:
    """The events of one run in C; `known` are the Functions' inputs by name, as those of the model."""

    def __init__(
        self,
        library: ctypes.CDLL,
        model: ModelStructure,
        solver: SolverStructure,
        known: dict[str, Vector],
        settling: Settling,
        schedule: Schedule,
        guard: EventGuard,
        ahead: float,
    ) -> None:
        self._run_time = EventRunTime(library)
        self._memory = Memory()
        self._event, self._cruise = EventStructure(), CruiseStructure()
        self._known, self._settling, self._schedule, self._guard = known, settling, schedule, guard
        self._evaluator = settling.evaluator
        self._describe(model, ahead)
        self._hand_out()
        self._set_up(solver, ahead)

    def _describe(self, model: ModelStructure, ahead: float) -> None:
        evaluator, event, memory = self._evaluator, self._event, self._memory
        part, settling = evaluator.code.system.discrete, self._settling
        event.model = ctypes.addressof(model)
        event.modes, event.frozen, event.unknowns = evaluator.m.size, evaluator.d.size, len(part.unknowns)
        event.memory, event.samples, event.resets = len(part.memory), len(part.samples), len(part.resets)
        event.checks, event.stops = len(part.checks), len(part.stops)
        event.located, event.instants, event.brief = evaluator.located.size, evaluator.instants.size, 1
        above, at_zero = settling.truth()
        event.located_at = memory.array(evaluator.located.astype(np.int32))
        event.above, event.at_zero = memory.array(above), memory.array(at_zero)
        event.judged, event.whole = memory.array(settling.judged()), memory.array(settling.released())
        event.reset_state = memory.array(settling.reset_states())
        event.m, event.d = memory.array(evaluator.m), memory.array(evaluator.d)
        event.shift, event.band = memory.array(evaluator.shift), memory.array(evaluator.band)
        event.kept_z = memory.array(evaluator.settled_z)
        event.sample_start = memory.array(self._schedule.starts)
        event.sample_interval = memory.array(self._schedule.intervals)
        event.ahead = ahead

    def _hand_out(self) -> None:
        event, memory = self._event, self._memory
        doubles = np.zeros(int(self._run_time.doubles(event)) + 1)
        ints = np.zeros(int(self._run_time.ints(event)) + 1, np.int32)
        self._run_time.init(event, memory.array(doubles), memory.array(ints))

    def _set_up(self, solver: SolverStructure, ahead: float) -> None:
        cruise, memory, guard = self._cruise, self._memory, self._guard
        cruise.solver, cruise.event = ctypes.addressof(solver), ctypes.addressof(self._event)
        cruise.held, cruise.shortest = 1e4 * ahead, guard.shortest
        cruise.resolved = guard.resolved
        cruise.recent, cruise.involved = memory.array(guard.recent), memory.array(guard.involved)
        cruise.tally = memory.array(guard.tally)
        self._run_time.cruise_init(
            cruise, memory.array(np.zeros(int(self._run_time.cruise_doubles(self._event)) + 1))
        )

    def bind(self, library: ctypes.CDLL | None) -> None:
        """Takes the functions from the library, or CasADi's virtual machine."""
        code, event = self._evaluator.code, self._event
        functions = event_functions(code)
        names = {"update": "update", "memory": "recall", "actions": "actions"}
        results = {"update": event.new_d, "memory": event.new_memory, "actions": event.action}
        for name, function in functions.items():
            inputs = [self._known[given] for given in function.name_in()]
            found = numbers(results[name], function.nnz_out(0))
            structure, kept = bound(function, inputs, [found], library)
            self._memory.kept.append(kept)
            setattr(event, names[name], structure)
        if event.instants:
            found = numbers(event.instant, event.instants)
            inputs = [self._evaluator.p, self._evaluator.d]
            event.ahead_of, kept = bound(code.instants, inputs, [found], None)
            self._memory.kept.append(kept)

    def make_room(self, most: int, width: int) -> None:
        """Room for so many rows."""
        room = max(_LEAST, most)
        self._times, self._rows = np.zeros(room), np.zeros((room, width))
        self._cruise.times, self._cruise.rows = pointer(self._times), pointer(self._rows)
        self._cruise.room = room

    def go(self, targets: Vector, until: float, budget: int) -> Stretch:
        """Integrates to `until` at most, through events, with outputs at the increasing `targets`."""
        cruise, guard = self._cruise, self._guard
        self._event.sample_count = pointer(self._schedule.counts)
        cruise.stops, cruise.events = guard.stops, guard.count
        done = ctypes.c_int(0)
        wanted = np.ascontiguousarray(targets)
        code = self._run_time.go(cruise, pointer(wanted), len(wanted), until, budget, ctypes.addressof(done))
        guard.stops, guard.count = cruise.stops, cruise.events
        filled = cruise.filled
        return Stretch(code, self._times[:filled], self._rows[:filled], done.value)

    def at(self, last_row: float, upcoming: float) -> None:
        """When the last row is, and the next known instant, as the event loop knows it."""
        self._cruise.last_row, self._cruise.next = last_row, upcoming

    @property
    def next(self) -> float:
        """The next event at a known instant."""
        return self._cruise.next
