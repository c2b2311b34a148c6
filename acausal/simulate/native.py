"""The run-time in C as a `Solver`: RODAS5P with variable steps, and all methods with fixed ones.

Between two events nothing of Python runs, unless an input is a function of the user's. The run-time shares
the evaluator's parameters, modes, frozen values, inputs and guesses; the point at which it evaluates is its
own.
"""

from __future__ import annotations

import ctypes
from dataclasses import replace
from time import perf_counter, process_time

import numpy as np

from acausal.errors import AcausalError
from acausal.runtime import binding
from acausal.runtime.binding import (
    FILL,
    METHODS,
    RESCUE,
    ModelStructure,
    RunTime,
    SolverStructure,
)
from acausal.runtime.event_binding import CROWDED
from acausal.simulate.buffered import Robust
from acausal.simulate.cruise import Cruise, Stretch, is_possible
from acausal.simulate.elimination import eliminate
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.events import EventGuard, operators
from acausal.simulate.failures import COLLAPSED, failure
from acausal.simulate.machine import WORTH, bound, machine_of, pointer
from acausal.simulate.matrices import Vector
from acausal.simulate.memory import Memory, flags, numbers, table_structures
from acausal.simulate.pace import Pace
from acausal.simulate.schedule import Schedule, is_reached
from acausal.simulate.settle import Settling
from acausal.simulate.solver import Arrival, Influence, Sweep, Tolerances, Work

_BUDGET = 2_000
"""Steps after which the run-time returns for a moment, so that a run can be interrupted."""
_EVALUATIONS = dict(zip(METHODS, (10, 1, 1, 2, 3, 6, 1, 3), strict=True))
"""Evaluations in a step."""
_CHUNK = 2**17
"""Numbers in a block of rows."""


class NativeSolver:
    """A `Solver` over the run-time in C; `method` is one of `METHODS`, `step` the length of a fixed step."""

    def __init__(
        self,
        evaluator: Evaluator,
        tolerances: Tolerances,
        method: str = "rodas",
        compiled: bool | None = None,
    ) -> None:
        began = process_time()
        self._evaluator = evaluator
        self._limits = tolerances
        self._raised: BaseException | None = None
        self._machine = machine_of(evaluator.code)
        self._compiled = compiled
        self._run_time = RunTime()
        self._memory = Memory()
        self._model = ModelStructure()
        self._solver = SolverStructure()
        self._arrays: dict[str, Vector] = {}
        self._robust: Robust | None = None
        self._events: Cruise | None = None
        rising = [1.0 if op in ("gt", "ge") else -1.0 for op in operators(evaluator.code.system)]
        self._rising = np.array(rising)
        self._elimination = eliminate(evaluator.code.pattern, evaluator.x.size)
        self._time, self._x = tolerances.start, evaluator.x.copy()
        self._error_failures = np.zeros(max(1, evaluator.x.size), dtype=np.int64)
        self._convergence_failures = np.zeros(max(1, evaluator.x.size), dtype=np.int64)
        step = tolerances.max_step if method == "rodas" else tolerances.step
        self._machine.take(compiled, step and tolerances.span / step, _EVALUATIONS[method])
        self._stages = self._machine.stages(evaluator.p)
        self._bind()
        self._set_up(METHODS[method])
        self._longest, self._left = 0.0, 0.0
        self._failed = 0
        width = self._model.outputs
        self._rows = np.zeros((max(1, _CHUNK // max(1, width)), width))
        self._pace = Pace(tolerances)
        self._compiling = process_time() - began

    @property
    def is_compiled(self) -> bool:
        """Whether the model's functions are compiled C by now."""
        return self._machine.library is not None and self._compiled is not False

    def _bind(self) -> None:
        """Gives the model its arrays, and its functions pointers to them."""
        evaluator, model, memory = self._evaluator, self._model, self._memory
        code = evaluator.code
        model.states, model.crossings = evaluator.x.size, evaluator.m.size
        model.guesses, model.entries = evaluator.guess.size, code.pattern.nnz()
        model.outputs, model.conditions = code.outputs.nnz_out(0), code.conditions.nnz_out(0)
        sizes = {
            "t": 1,
            "x": model.states,
            "z": model.guesses,
            "xdot": model.states,
            "jacobian": model.entries,
            "rate": model.states,
            "roots": model.crossings,
            "sizes": model.crossings,
            "row": model.outputs,
            "ok": model.conditions,
        }
        self._arrays = {name: np.zeros(size) for name, size in sizes.items()}
        self._arrays["guess"] = evaluator.guess
        for name, array in self._arrays.items():
            setattr(model, name, memory.array(array))
        model.timed_at = np.nan
        self._bind_inputs()
        functions = self._machine.functions
        slopes, quick = functions.get("jac"), code.quick
        together = quick.slopes is not None
        model.takes_solution = int(together)
        model.free_roots = int(not code.events_need_blocks)
        has_rate = "derivative" in functions or (together and slopes is not None and slopes.nnz_out(1) > 0)
        model.exact_rate = (2 if together else 1) if has_rate and not evaluator.is_moving else 0
        model.autonomous = int(not has_rate and not evaluator.is_moving)
        if quick.ode is not None or model.guesses:
            rescue = RESCUE(self._rescue)
            memory.kept.append(rescue)
            model.rescue = ctypes.cast(rescue, ctypes.c_void_p).value
        self._bind_functions()

    def _bind_inputs(self) -> None:
        """Tables are the run-time's business; anything else that moves is asked for at every evaluation."""
        evaluator, model, memory = self._evaluator, self._model, self._memory
        tables = evaluator.inputs.tables
        if not evaluator.is_moving:
            return
        if evaluator.history is not None or tables is None:
            fill = FILL(self._fill)
            memory.kept.append(fill)
            model.fill = ctypes.cast(fill, ctypes.c_void_p).value
            return
        structures = table_structures(tables, memory)
        model.u, model.tables = pointer(evaluator.u), ctypes.addressof(structures)
        model.table_count = len(tables)

    def _bind_functions(self) -> None:
        library = self._machine.library if self.is_compiled else None
        if library is not None:
            self._evaluator.compile(library)
        if self._events is not None:
            self._events.bind(library)
        arrays = self._arrays
        results = {
            "ode": [arrays["xdot"], arrays["z"]],
            "jac": [arrays["jacobian"], arrays["rate"]],
            "derivative": [arrays["rate"]],
            "events": [arrays["roots"]],
            "scales": [arrays["sizes"]],
            "output": [arrays["row"]],
            "assertions": [arrays["ok"]],
            **{name: [array] for name, array in self._stages.items()},
        }
        for name, function in self._machine.functions.items():
            solves = name in ("ode", "derivative") or (name == "jac" and not self._model.takes_solution)
            known = self._known("guess" if solves else "z")
            inputs = [known[given] for given in function.name_in()]
            structure, kept = bound(function, inputs, results[name][: function.n_out()], library)
            self._memory.kept.append(kept)
            setattr(self._model, name, structure)

    def _known(self, tearing: str) -> dict[str, Vector]:
        """The Functions' inputs by name; `tearing` says which array is `z`."""
        arrays = self._arrays
        return {
            **self._evaluator.groups,
            **self._stages,
            "t": arrays["t"],
            "x": arrays["x"],
            "z": arrays[tearing],
        }

    def _rescue(self, owner: int | None, what: int) -> int:
        """Derivatives (0) or slopes (1) at the model's point by the functions that are slow and robust."""
        del owner
        arrays = self._arrays
        try:
            if self._robust is None:
                known = self._known("guess")
                self._robust = Robust(
                    self._evaluator.code, [known[n] for n in self._evaluator.code.ode.name_in()]
                )
            if what == 0:
                found = [arrays["xdot"], arrays["z"]]
                time, x = float(arrays["t"][0]), arrays["x"]
                return int(not (self._robust.ode(found) or self._evaluator.walk_into(found, time, x)))
            return int(not self._robust.slopes([arrays["jacobian"], arrays["rate"]]))
        except BaseException as problem:
            self._raised = problem
            return 1

    def _set_up(self, method: int) -> None:
        solver, memory, limits, found = self._solver, self._memory, self._limits, self._elimination
        memory.kept.append(self._model)
        solver.model = ctypes.addressof(self._model)
        solver.method, solver.locate = method, int(limits.locate)
        solver.rtol, solver.atol = limits.rtol, memory.array(limits.atol)
        solver.nominal = memory.array(self._evaluator.x_nominal)
        solver.min_step, solver.max_step, solver.sample = limits.min_step, limits.max_step, limits.sample
        solver.step, solver.origin, solver.max_steps = limits.step, limits.start, limits.max_steps
        if method != METHODS["rodas"]:
            solver.clock = self._run_time.clock
        solver.jmap, solver.diagonal = memory.array(found.entries), memory.array(found.diagonal)
        solver.lu.n = self._evaluator.x.size
        solver.lu.ap, solver.lu.ai = memory.array(found.columns), memory.array(found.rows)
        solver.lu.q = memory.array(found.order)
        solver.error_failures = memory.array(self._error_failures)
        solver.convergence_failures = memory.array(self._convergence_failures)
        self._hand_out()

    def _hand_out(self) -> None:
        n, m = self._evaluator.x.size, self._evaluator.m.size
        memory, count = self._memory, self._run_time.doubles(n, m, self._model.guesses, self._model.entries)
        doubles, ints = np.zeros(int(count) + 1), np.zeros(m + 1, dtype=np.int32)
        self._run_time.init(self._solver, memory.array(doubles), memory.array(ints))
        self._give_factors(self._elimination.capacity)

    def _give_factors(self, capacity: int) -> None:
        """Room for so many entries of L and of U."""
        n, entries, lu = self._evaluator.x.size, self._elimination.rows.size, self._solver.lu
        lu.capacity = capacity
        doubles = np.zeros(self._run_time.lu_doubles(n, entries, capacity))
        ints = np.zeros(self._run_time.lu_ints(n, capacity), dtype=np.int32)
        self._factors = (doubles, ints)
        self._run_time.lu_init(lu, pointer(doubles), pointer(ints), entries)

    @property
    def work(self) -> Work:
        model, solver = self._model, self._solver
        return Work(
            solver.steps,
            model.evaluations,
            model.jacobians,
            rejected=solver.rejected,
            factorisations=solver.lu.searches + solver.lu.repeats,
            compiling=self._compiling,
            longest=max(solver.longest, self._longest),
        )

    @property
    def influence(self) -> Influence:
        """What every state did to the step size so far."""
        size = self._evaluator.x.size
        return Influence(
            numbers(self._solver.influence, size).copy(),
            self._error_failures[:size].copy(),
            self._convergence_failures[:size].copy(),
        )

    def restart(self, time: float, x: Vector) -> None:
        """Begins anew at this point. Raises `SimulationProblem` where a root is not a number."""
        if self._left:
            self._longest = max(self._longest, perf_counter() - self._left + self._solver.latest)
        self._left = 0.0
        self._time, self._x = time, np.ascontiguousarray(x, dtype=np.float64)
        sides, slack = self._sides(), np.zeros(max(1, self._evaluator.m.size))
        slack[self._evaluator.located] = np.abs(self._evaluator.shift)
        code = self._run_time.restart(self._solver, time, pointer(self._x), pointer(sides), pointer(slack))
        self._look_for_interrupts()
        if code != 0:
            raise self._failure(code)

    def _fill(self, owner: int | None, time: float) -> None:
        """The inputs at `time`; what cannot pass through C (Ctrl-C) is raised when the run-time is back."""
        del owner
        try:
            self._evaluator.refill(time)
        except BaseException as problem:
            self._raised = problem
            self._evaluator.u[:] = np.nan

    def _look_for_interrupts(self) -> None:
        if self._raised is not None:
            problem, self._raised = self._raised, None
            raise problem

    def _sides(self) -> Vector:
        """The sign that each located root has in its mode; 0 for those that are not located."""
        evaluator = self._evaluator
        holds = np.where(evaluator.m != 0, 1.0, -1.0)
        sides = np.zeros(max(1, evaluator.m.size))
        sides[evaluator.located] = (holds * self._rising)[evaluator.located]
        return sides

    def advance(self, target: float, stop: float) -> Arrival:
        """To `target`, which is where the last step ends; `stop` is never beyond it."""
        del stop
        found = self.sweep(np.zeros(0), target)
        while found.crossed is None and found.time < target:
            found = self.sweep(np.zeros(0), target)
        return Arrival(found.time, found.x, found.crossed)

    def sweep(self, targets: Vector, until: float) -> Sweep:
        """Integrates towards `until` until an event, with the outputs at `targets` on the way.

        Comes back early, with the rows so far, where there are many, or where one needs a look. The rows are
        overwritten by the next call.
        """
        if self._failed:
            raise self._failure(self._failed)
        end = min(until, self._evaluator.inputs.next_kink(self._time))
        found = self._stretch(targets, end)
        self._look_for_interrupts()
        self._evaluator.judge_jumps(self._solver.t)
        code, times, rows, taken = found.code, found.times, found.rows, found.taken
        if code < 0 and code != binding.ROW_NOT_FINITE:
            if not len(times):
                raise self._failure(code)
            self._failed = code  # the rows so far first
            return Sweep(self._time, self._x, None, times, rows, False, False, taken)
        suspect = code in (binding.VIOLATED, binding.ROW_NOT_FINITE)
        arrived = code in (binding.REACHED, binding.EVENT, CROWDED)
        if code == binding.PAUSE and self._pace.is_hopeless(self._solver.steps, self._solver.t):
            raise self._failure(COLLAPSED)
        if suspect:
            time, x = float(self._arrays["t"][0]), self._arrays["x"].copy()
            return Sweep(time, x, None, times, rows, True, False, taken)
        x = numbers(self._solver.x, self._evaluator.x.size).copy() if arrived else self._x
        crossed = flags(self._solver.crossed, self._evaluator.m.size) if code == binding.EVENT else None
        self._left = perf_counter() if crossed is not None else 0.0
        if arrived:
            self._x = x
        self._time = self._solver.t
        self._maybe_compile()
        there = arrived and (self._time >= until or self._is_instant())
        return Sweep(self._time, x, crossed, times, rows, False, there, taken, code == CROWDED)

    def handle(
        self, settling: Settling, schedule: Schedule, guard: EventGuard, ahead: float
    ) -> Cruise | None:
        """Handles events on the way, if the model allows it."""
        self._events = None
        if is_possible(self._evaluator.code):
            known = self._known("z")
            self._events = Cruise(
                self._run_time.library, self._model, self._solver, known, settling, schedule, guard, ahead
            )
            self._events.make_room(len(self._rows), self._model.outputs)
            self._events.bind(self._machine.library if self.is_compiled else None)
        return self._events

    def _is_instant(self) -> bool:
        return self._events is not None and is_reached(self._solver.t, self._events.next)

    def _stretch(self, targets: Vector, end: float) -> Stretch:
        budget = 1 if self._evaluator.code.system.delays else _BUDGET
        if self._events is not None:
            found = self._events.go(targets, end, budget)
            if found.code != binding.MEMORY:
                return found
            self._give_factors(4 * self._solver.lu.capacity)
            return replace(found, code=binding.PAUSE)
        wanted = np.ascontiguousarray(targets[: np.searchsorted(targets, end, "right")])
        self._solver.room = len(self._rows)
        filled = ctypes.c_int(0)
        code = self._call(wanted, end, budget, filled)
        return Stretch(code, wanted[: filled.value], self._rows[: filled.value], filled.value)

    def _call(self, targets: Vector, end: float, budget: int, filled: ctypes.c_int) -> int:
        rows, count = pointer(self._rows), ctypes.addressof(filled)
        while True:
            code = self._run_time.sweep(
                self._solver, pointer(targets), len(targets), end, budget, rows, count
            )
            if code != binding.MEMORY:
                return code
            self._give_factors(4 * self._solver.lu.capacity)

    def _maybe_compile(self) -> None:
        """Has the model compiled once the run has become long, and goes over to what came of it."""
        evaluations = self._model.evaluations + self._model.jacobians
        if self._compiled is not None or self._machine.library is not None or evaluations <= WORTH:
            return
        began = process_time()
        self._machine.begin()
        self._machine.look_up()
        if self._machine.library is not None:
            self._bind_functions()
        self._compiling += process_time() - began

    def _failure(self, status: int) -> AcausalError:
        """Why the run-time gave up."""
        evaluator, solver = self._evaluator, self._solver
        if status in (binding.NOT_FINITE, binding.SINGULAR):
            evaluator.at(float(self._arrays["t"][0]), self._arrays["x"])
        stopped = solver.t0, numbers(solver.x0, evaluator.x.size)
        return failure(evaluator, self._limits, status, *stopped, fixed=solver.method != METHODS["rodas"])
