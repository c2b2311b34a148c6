"""`simulate`: a compiled system over a time interval, as a `Result`."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from time import process_time
from typing import TypeAlias

from acausal.codegen.functions import Code
from acausal.errors import UsageProblem, fail
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.initialize import InitialPoint, initialize
from acausal.simulate.inputs import InputValue
from acausal.simulate.options import MAX_STEPS, Options, resolve
from acausal.simulate.overrides import Override
from acausal.simulate.record import Recorder
from acausal.simulate.result import Result, Statistics
from acausal.simulate.resume import resume
from acausal.simulate.run import Course, grid, run
from acausal.simulate.solver import Solver
from acausal.simulate.solvers import AUTO, FIXED, chosen, make_solver
from acausal.simulate.standing import Standing
from acausal.simulate.stream import Store, Stream, read_end
from acausal.simulate.suspects import naming_suspects
from acausal.simulate.unstable import ExplicitSteps

After: TypeAlias = "Standing | Result | str | Path"
"""What a run can go on from: another run, or the file of its result."""


_SPARE = 256
"""Rows beyond those of the grid that there is room for: both sides of events."""


def simulate(
    code: Code,
    *,
    stop_time: float | None = None,
    start_time: float | None = None,
    rtol: float | None = None,
    atol: float | None = None,
    max_step: float | None = None,
    interval: float | None = None,
    solver: str = AUTO,
    max_steps: int = MAX_STEPS,
    step: float | None = None,
    events: str = "locate",
    compiled: bool | None = None,
    keep: Callable[[Result], None] | None = None,
    parameters: Mapping[str, Override] | None = None,
    start: Mapping[str, float] | None = None,
    inputs: Mapping[str, InputValue] | None = None,
    store: str | Path | Store | None = None,
    variables: Sequence[str] | None = None,
    after: After | None = None,
    progress: Callable[[float], None] | None = None,
) -> Result:
    """Initialise and integrate. What is not given comes from the `experiment` annotation, else contract.md.

    `parameters` changes tunable parameters and `start` start values, without compiling again. `inputs` gives
    the model's inputs: constants, functions of time, or tables `(times, values)`. Times are in seconds.
    `solver` is one of `SOLVERS`; those of `FIXED` take steps of length `step` (the default is the interval),
    and `events` says whether they `locate` zero crossings inside a step or handle them at its end (`step`).
    `compiled` says whether the model's functions are compiled C; the default is what costs less. `keep` is
    given the result so far of a run that fails on the way or is interrupted, before the error goes on.
    `store` writes `variables` (by default the states and those of the top level) to a file as they come, and
    leaves only the last row in the result; its ending says the format: .csv, .mat, .nc or .parquet. `after`
    goes on where another run or a stored result ended, on the grid of that run. `progress` is told the time
    reached, now and then between events; from a `KeyboardInterrupt` that it raises a run can go on.
    Raises `InitializationProblem`, `SimulationProblem`, `UsageProblem` and `LookupProblem`.
    """
    standing = standing_after(after) if after is not None else None
    if standing is not None:
        _check_continued(standing, start_time, start)
        interval = standing.interval if interval is None else interval
    options = resolve(
        code.system.flat.experiment,
        stop_time=stop_time,
        start_time=start_time if standing is None else standing.start,
        rtol=rtol,
        atol=atol,
        max_step=max_step,
        interval=interval,
        solver=chosen(solver),
        max_steps=max_steps,
        has_events=bool(code.located),
        step=step,
        events=events,
        compiled=compiled,
    )
    options, point = _started(code, options, standing, parameters, start, inputs)
    if store is not None and not isinstance(store, Store):
        store = Store(Path(store), None if variables is None else tuple(variables))
    return integrate(point, options, keep, store, standing, progress)


def _started(
    code: Code,
    options: Options,
    after: Standing | None,
    parameters: Mapping[str, Override] | None,
    start: Mapping[str, float] | None,
    inputs: Mapping[str, InputValue] | None,
) -> tuple[Options, InitialPoint]:
    """The initial point with what it took, and the options of a run that begins there."""
    began = process_time()
    if after is None:
        point = initialize(code, options.start_time, parameters, start, inputs, options.stop_time)
    else:
        options = resumed(options, after)
        point = resume(code, after, parameters, inputs, options.stop_time)
    return options, replace(point, cpu_seconds=process_time() - began)


def standing_after(after: After) -> Standing:
    """Where a run stood: one in memory, or the one that a file's result is of. Raises `UsageProblem`."""
    if isinstance(after, str | Path):
        return read_end(Path(after))
    found = after.standing if isinstance(after, Result) else after
    if found is None:
        problem = "the run cannot be continued: the model ended it, or it stopped in the middle of an event"
        raise fail(UsageProblem, "usage.continue", problem)
    return found


def _check_continued(after: Standing, start_time: float | None, start: Mapping[str, float] | None) -> None:
    """Raises `UsageProblem` for what a run that goes on cannot be given."""
    given = "start_time" if start_time not in (None, after.start) else "start" if start else ""
    if given:
        problem = f"a run that goes on from a stored one takes no `{given}`"
        raise fail(UsageProblem, "usage.continue", problem, names=[given])


def resumed(options: Options, after: Standing) -> Options:
    """The options of a run that goes on. Raises `UsageProblem` where its stop time is past already."""
    if not options.stop_time > after.time:
        problem = f"the stored run ends at {after.time:g} s, not before the stop time {options.stop_time:g} s"
        raise fail(UsageProblem, "usage.continue", problem, hint="give a later stop time")
    return replace(options, resumed=after.time)


def integrate(
    point: InitialPoint,
    options: Options,
    keep: Callable[[Result], None] | None = None,
    store: Store | None = None,
    after: Standing | None = None,
    progress: Callable[[float], None] | None = None,
) -> Result:
    """Integrate from an initial point; the point's evaluator is used up."""
    evaluator = point.evaluator
    code = evaluator.code
    recorder = Recorder(evaluator, 0 if store is not None else len(grid(options)) + _SPARE)
    parameters = dict(zip(code.system.parameters, evaluator.p.tolist(), strict=True))
    stream = Stream(store, code.system, recorder, parameters) if store is not None else None
    steps = ExplicitSteps(evaluator, options, point.x)
    began = process_time()

    def solver(current: Evaluator) -> Solver:
        return make_solver(current, options)

    def observe(time: float, standing: Callable[[], Standing]) -> None:
        if stream is not None:
            stream.observe(time, standing)
        if progress is not None:
            progress(time)

    def result(course: Course) -> Result:
        cpu = process_time() - began - course.compiling - course.work.compiling
        stored = 0.0
        if stream is not None:
            stored = stream.spent
            stream.close(None if course.ended is not None else course.standing)
        found = _result(point, options, recorder, course, cpu - stored, stored)
        found = replace(found, warnings=(*found.warnings, *steps.warnings(recorder)))
        return found if store is None else replace(found, file=store.path)

    def stopped(course: Course) -> None:
        if stream is not None and stream.is_broken:
            return
        if (keep is not None or stream is not None) and recorder.count:
            found = result(course)
            if keep is not None:
                keep(found)

    moves = (code.system.states or code.located) and options.span > 0
    made = solver if moves else None
    watched = observe if stream is not None or progress is not None else None
    try:
        with naming_suspects(code, evaluator.p), steps.advising(recorder):
            return result(run(evaluator, made, point.x, options, recorder, stopped, watched, after))
    finally:
        if stream is not None:
            stream.abandon()


def _result(
    point: InitialPoint, options: Options, recorder: Recorder, course: Course, cpu: float, stored: float
) -> Result:
    evaluator = point.evaluator
    code = evaluator.code
    phases = {
        "start": point.cpu_seconds,
        "compile_c": course.work.compiling,
        "select_states": course.compiling,
    }
    return Result(
        system=code.system,
        time=recorder.time,
        leaves=recorder.leaves,
        data=recorder.data,
        parameters=dict(zip(code.system.parameters, evaluator.p.tolist(), strict=True)),
        standing=course.standing,
        statistics=Statistics(
            solver=options.solver,
            stop_time=options.stop_time,
            steps=course.work.steps,
            rhs_evaluations=course.work.rhs_evaluations,
            jacobian_evaluations=course.work.jacobian_evaluations,
            events=course.events,
            cpu_seconds=cpu,
            real_time_factor=cpu / options.span if options.span else 0.0,
            state_selections=course.state_selections,
            rejected=course.work.rejected,
            factorisations=course.work.factorisations,
            max_step_seconds=course.work.longest if options.solver in FIXED else None,
            phase_seconds=phases | {"run": cpu, "store": stored},
        ),
        starts=point.used,
        warnings=(*point.warnings, *recorder.warnings),
        ended=course.ended,
        state_costs=course.state_costs,
        event_costs=course.event_costs,
    )
