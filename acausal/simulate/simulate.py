"""`simulate`: a compiled system over a time interval, as a `Result`."""

from __future__ import annotations

from collections.abc import Mapping
from time import process_time

from acausal.codegen.functions import Code
from acausal.errors import UsageProblem, fail
from acausal.simulate.cvode import Cvode
from acausal.simulate.initialize import InitialPoint, initialize
from acausal.simulate.names import did_you_mean
from acausal.simulate.options import MAX_STEPS, Options, resolve
from acausal.simulate.record import Recorder
from acausal.simulate.result import Result, Statistics
from acausal.simulate.run import run
from acausal.simulate.solver import Solver, SolverFactory, Tolerances, Work

_ROUND = 7e-15
"""The shortest step relative to time: below it, time no longer advances by what the step says."""
SOLVERS: dict[str, SolverFactory] = {"cvode": Cvode}


def simulate(
    code: Code,
    *,
    stop_time: float | None = None,
    start_time: float | None = None,
    rtol: float | None = None,
    atol: float | None = None,
    max_step: float | None = None,
    interval: float | None = None,
    solver: str = "cvode",
    max_steps: int = MAX_STEPS,
    parameters: Mapping[str, float] | None = None,
    start: Mapping[str, float] | None = None,
) -> Result:
    """Initialise and integrate. What is not given comes from the `experiment` annotation, else contract.md.

    `parameters` changes tunable parameters and `start` start values, without compiling again. Times are in
    seconds. Raises `InitializationProblem`, `SimulationProblem`, `UsageProblem` and `LookupProblem`.
    """
    if solver not in SOLVERS:
        hint = did_you_mean(solver, SOLVERS) or f"there is {', '.join(SOLVERS)}"
        raise fail(UsageProblem, "simulate.solver", f"there is no solver '{solver}'", names=[solver], hint=hint)
    options = resolve(
        code.system.flat.experiment,
        stop_time=stop_time,
        start_time=start_time,
        rtol=rtol,
        atol=atol,
        max_step=max_step,
        interval=interval,
        solver=solver,
        max_steps=max_steps,
        has_events=bool(code.system.zero_crossings),
    )
    return integrate(initialize(code, options.start_time, parameters, start), options)


def integrate(point: InitialPoint, options: Options) -> Result:
    """Integrate from an initial point; the point's evaluator is used up."""
    evaluator = point.evaluator
    code = evaluator.code
    recorder = Recorder(evaluator)
    began = process_time()
    solver: Solver | None = None
    if (code.system.states or code.system.zero_crossings) and options.span > 0:
        atol = options.atol * evaluator.x_nominal
        shortest = _ROUND * max(abs(options.start_time), abs(options.stop_time))
        limits = Tolerances(options.rtol, atol, shortest, options.max_step, options.max_steps)
        solver = SOLVERS[options.solver](evaluator, limits)
    events = run(evaluator, solver, point.x, options, recorder)
    cpu = process_time() - began
    work = solver.work if solver is not None else Work(0, 0, 0)
    return Result(
        system=code.system,
        time=recorder.time,
        leaves=code.output_leaves,
        data=recorder.data,
        parameters=dict(zip(code.system.parameters, evaluator.p.tolist(), strict=True)),
        statistics=Statistics(
            solver=options.solver,
            stop_time=options.stop_time,
            steps=work.steps,
            rhs_evaluations=work.rhs_evaluations,
            jacobian_evaluations=work.jacobian_evaluations,
            events=events,
            cpu_seconds=cpu,
            real_time_factor=cpu / options.span if options.span else 0.0,
        ),
        starts=point.used,
        warnings=recorder.warnings,
    )
