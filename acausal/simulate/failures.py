"""Why the run-time gave up: an equation that is not finite, or states that change fast."""

from __future__ import annotations

import numpy as np

from acausal.errors import AcausalError, SimulationProblem, fail
from acausal.runtime import binding
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.events import check_conditions
from acausal.simulate.folds import ending_block
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import at, leaf_name, number, some
from acausal.simulate.solver import Tolerances
from acausal.symbolic.causal import CausalEquation
from acausal.symbolic.describe import shown
from acausal.symbolic.expressions.expr import der, sym

COLLAPSED = -1000

_CAUSES = {
    COLLAPSED: (
        "simulate.step-collapse",
        "its steps have become so short that the run would need more of them than are allowed",
    ),
    binding.STEP_TOO_SMALL: ("simulate.step-too-small", "the error test failed with the smallest step"),
    binding.TOO_MANY_STEPS: ("simulate.too-many-steps", "too many steps were needed"),
    binding.SINGULAR: ("simulate.singular-step", "the matrix of an implicit step was singular"),
    binding.NOT_FINITE: ("simulate.not-finite", "something was not a number with the smallest step too"),
}

_FIXED_CAUSES = {
    binding.NOT_FINITE: "something was not a number within a step",
    COLLAPSED: "the run would need more steps than are allowed",
}
_HINT = "look for a discontinuity that is no event, a wrong nominal value, or a solution that ends"
_AT_ONCE = 1e-6
"""Of the simulated time."""


def failure(
    evaluator: Evaluator, limits: Tolerances, status: int, time: float, x: Vector, *, fixed: bool = False
) -> AcausalError:
    """The error of a step from (`time`, `x`) on; what was not finite is so at the evaluator's point.

    `fixed`: steps of one length, which are not tried shorter.
    """
    if status in (binding.NOT_FINITE, binding.SINGULAR):
        culprit(evaluator)
        if status == binding.NOT_FINITE and not fixed:
            status = binding.STEP_TOO_SMALL
    code, cause = _CAUSES.get(status, ("simulate.solver", f"status {status}"))
    if fixed:
        cause = _FIXED_CAUSES.get(status, cause)
    return stopped(evaluator, limits, "the integration", code, cause, time, x)


def culprit(evaluator: Evaluator) -> None:
    """Raises the error of a state, equation or condition that is not a number at the evaluator's point."""
    time, x = float(evaluator.t[0]), evaluator.x.copy()
    if not np.isfinite(x).all():
        raise _grown(evaluator, time, x)
    if not evaluator.evaluate():
        evaluator.explain()
    check_conditions(evaluator, time)


def stopped(
    evaluator: Evaluator, limits: Tolerances, who: str, code: str, cause: str, time: float, x: Vector
) -> AcausalError:
    """The error of an integrator that gave up at (`time`, `x`): the states and equations that hold it back.

    Where a nonlinear block is close to singular there, that is the reason.
    """
    evaluator.at(time, x)
    block = ending_block(evaluator)  # before the evaluator looks for another solution
    evaluator.evaluate()
    block = block or ending_block(evaluator)
    names = _dominant(evaluator, limits, x)
    message = f"{who} stopped {at(time)}: {cause}; states that change most for their tolerance: {some(names)}"
    if block is not None:
        unknowns = list(map(leaf_name, block.unknowns))
        equation = block.residuals[0].equation
        message += f"; the block of {some(unknowns)} is close to singular there: `{shown(equation)}`"
        hint = "its solution ends or turns back here (a fold): change the characteristic behind it"
        return fail(
            SimulationProblem, code, message, equation.flat.span, names=[*unknowns, *names], hint=hint
        )
    equation = equation_of(evaluator, names[0]) if names else None
    if equation is None:
        return fail(SimulationProblem, code, message, names=names, hint=_HINT)
    message += f"; the first follows from `{shown(equation)}`"
    hint = _escape(evaluator, limits, names[0], x) or _HINT
    return fail(SimulationProblem, code, message, equation.flat.span, names=names, hint=hint)


def _escape(evaluator: Evaluator, limits: Tolerances, name: str, x: Vector) -> str:
    """What to say of a state that changes by its own size at once; empty where it does not."""
    i = evaluator.code.system.states.index(name)
    size, rate = max(abs(float(x[i])), float(evaluator.x_nominal[i])), abs(float(evaluator.xdot[i]))
    if not rate > 0 or size / rate > _AT_ONCE * limits.span:
        return ""
    return (
        f"{name} = {number(float(x[i]))} changes by its own size within {number(size / rate)} s here: "
        "the solution escapes to infinity, or an equation jumps where no event is"
    )


def _grown(evaluator: Evaluator, time: float, x: Vector) -> AcausalError:
    """The error of a state that is no number any more."""
    i = int(np.flatnonzero(~np.isfinite(x))[0])
    name = evaluator.code.system.states[i]
    equation = equation_of(evaluator, name)
    what = "not a number" if np.isnan(x[i]) else "infinite"
    message = f"the state {name} became {what} {at(time)}"
    span = None
    if equation is not None:
        message, span = f"{message}, by `{shown(equation)}`", equation.flat.span
    return fail(SimulationProblem, "simulate.not-finite", message, span, names=[name], hint=_HINT)


def equation_of(evaluator: Evaluator, state: str) -> CausalEquation | None:
    """The equation that gives the derivative of a state."""
    wanted = der(sym(state))
    for block in evaluator.code.system.blocks:
        for assignment in block.assignments:
            if assignment.unknown is wanted:
                return assignment.equation
        if any(leaf is wanted for leaf in block.tearing):
            return block.residuals[0].equation
    return None


def _dominant(evaluator: Evaluator, limits: Tolerances, x: Vector) -> list[str]:
    """The states with the largest derivative in units of their tolerance, largest first."""
    with np.errstate(all="ignore"):
        weighted = np.abs(evaluator.xdot) / (limits.rtol * np.abs(x) + limits.atol)
    order = np.argsort(-np.nan_to_num(weighted, nan=np.inf), kind="stable")[:3]
    return [evaluator.code.system.states[i] for i in order]
