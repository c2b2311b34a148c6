"""Why the run-time gave up: an equation that is not finite, or states that change fast."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import replace

import numpy as np

from acausal.errors import AcausalError, SimulationProblem, fail
from acausal.runtime import binding
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import at, some
from acausal.simulate.solver import Tolerances

COLLAPSED = -1000

_EXPLICIT = ("euler", "ab2", "heun", "rk3", "dopri5")
_GROWTH = ("not-finite", "no-solution", "no-convergence", "singular")
"""How the codes of errors end that states without bound lead to."""

_CAUSES = {
    COLLAPSED: ("simulate.step-collapse", "its steps have become so short that the run would not end"),
    binding.STEP_TOO_SMALL: ("simulate.step-too-small", "the error test failed with the smallest step"),
    binding.TOO_MANY_STEPS: ("simulate.too-many-steps", "too many steps were needed"),
    binding.SINGULAR: ("simulate.singular-step", "the matrix of an implicit step was singular"),
    binding.NOT_FINITE: ("simulate.not-finite", "something was not a number with the smallest step too"),
}


@contextmanager
def advising(method: str, step: float) -> Generator[None, None, None]:
    """Adds to errors inside it, where explicit steps have one length, that the length may be the reason."""
    try:
        yield
    except AcausalError as error:
        if method not in _EXPLICIT or not error.codes[0].endswith(_GROWTH):
            raise
        advice = (
            f"the step of {step:g} s may exceed the stability limit of {method}: try a shorter step or the "
            "solver lieuler or rosenbrock; `acausal eigen` prints the limits"
        )
        first, *others = error.diagnostics
        hint = f"{first.hint}; {advice}" if first.hint else advice
        raise type(error)([replace(first, hint=hint), *others]) from error.__cause__


def failure(evaluator: Evaluator, limits: Tolerances, status: int, time: float, x: Vector) -> AcausalError:
    """The error of a step from (`time`, `x`) on; what was not finite is so at the evaluator's point."""
    if status in (binding.NOT_FINITE, binding.SINGULAR):
        if not evaluator.evaluate():
            evaluator.explain()
        elif status == binding.NOT_FINITE:
            status = binding.STEP_TOO_SMALL
    code, cause = _CAUSES.get(status, ("simulate.solver", f"status {status}"))
    names = _dominant(evaluator, limits, time, x)
    return fail(
        SimulationProblem,
        code,
        f"the integration stopped {at(time)}: {cause}; "
        f"states that change most for their tolerance: {some(names)}",
        names=names,
        hint="look for a discontinuity that is no event, a wrong nominal value, or a solution that ends",
    )


def _dominant(evaluator: Evaluator, limits: Tolerances, time: float, x: Vector) -> list[str]:
    """The states with the largest derivative in units of their tolerance, largest first."""
    evaluator.at(time, x)
    evaluator.evaluate()
    with np.errstate(all="ignore"):
        weighted = np.abs(evaluator.xdot) / (limits.rtol * np.abs(x) + limits.atol)
    order = np.argsort(-np.nan_to_num(weighted, nan=np.inf), kind="stable")[:3]
    return [evaluator.code.system.states[i] for i in order]
