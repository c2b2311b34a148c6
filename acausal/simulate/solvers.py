"""Every solver by the name that `--solver` knows."""

from __future__ import annotations

from acausal.errors import UsageProblem, fail
from acausal.runtime.binding import METHODS
from acausal.runtime.build import compiler
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.names import did_you_mean
from acausal.simulate.native import NativeSolver
from acausal.simulate.options import MAX_STEPS, Options
from acausal.simulate.solver import Solver, Tolerances

AUTO = "auto"
FIXED = tuple(name for name in METHODS if name != "rodas")
"""The solvers with steps of one length."""
SOLVERS = (AUTO, "cvode", "cvode-adams", "ida", "rodas", "scikits-odes", *FIXED)

_ROUND = 7e-15
"""The shortest step relative to time: below it, time no longer advances by what the step says."""


def chosen(name: str) -> str:
    """The solver that runs for a name: `auto` is `rodas` where there is a C compiler, else `cvode`.

    Raises `UsageProblem` for what is no solver's name.
    """
    if name not in SOLVERS:
        hint = did_you_mean(name, SOLVERS) or f"there is {', '.join(SOLVERS)}"
        raise fail(UsageProblem, "simulate.solver", f"there is no solver `{name}`", names=[name], hint=hint)
    if name != AUTO:
        return name
    return "rodas" if compiler() is not None else "cvode"


def make_solver(evaluator: Evaluator, options: Options) -> Solver:
    """An integrator over the evaluator's derivatives, by `options.solver`.

    Raises `UnsupportedProblem` where the solver needs a C compiler and there is none.
    """
    evaluator.walks.span = options.span
    limits = Tolerances(
        options.rtol,
        options.atol * evaluator.x_nominal,
        _ROUND * max(abs(options.start_time), abs(options.stop_time)),
        options.max_step,
        _allowed(options),
        options.span,
        start=options.start_time,
        sample=options.sample,
        step=options.step if options.solver in FIXED else _regular(options),
        locate=options.locate,
    )
    name = options.solver
    if name in METHODS and (name not in FIXED or compiler() is not None):
        return NativeSolver(evaluator, limits, name, options.compiled)
    return _other(evaluator, limits, name)


def _allowed(options: Options) -> int:
    """The number of steps after which a run is given up: of steps of one length more than the run has."""
    if options.solver not in FIXED or options.max_steps != MAX_STEPS:
        return options.max_steps
    return max(MAX_STEPS, int(4 * options.span / options.step))


def _regular(options: Options) -> float:
    """The longest step where a whole number of them makes an output interval to end steps at; else 0."""
    if not options.max_step or options.times:
        return 0.0
    count = options.interval / options.max_step
    return options.interval / round(count) if abs(count - round(count)) < 1e-9 * count else 0.0


def _other(evaluator: Evaluator, limits: Tolerances, name: str) -> Solver:
    """The solvers that need SciPy or SUNDIALS, which take as long to import as a small model to run."""
    if name in FIXED:
        from acausal.simulate.fallback import FixedStep

        return FixedStep(evaluator, limits, name)
    if name == "ida":
        from acausal.simulate.ida import Ida

        return Ida(evaluator, limits)
    if name == "scikits-odes":
        from acausal.simulate.scikits import ScikitsOdes

        return ScikitsOdes(evaluator, limits)
    from acausal.simulate.cvode import Cvode

    return Cvode(evaluator, limits, "Adams" if name == "cvode-adams" else "BDF")
