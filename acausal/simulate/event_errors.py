"""Values at events that are no numbers: which variable, by what equation, from which values."""

from __future__ import annotations

import numpy as np

from acausal.errors import AcausalError, SimulationProblem, fail
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import at, leaf_name
from acausal.simulate.texts import point_text
from acausal.symbolic.causal import Reset
from acausal.symbolic.describe import short_text, shown
from acausal.symbolic.expressions.expr import symbols


def no_value(evaluator: Evaluator, found: Vector, time: float) -> AcausalError:
    """The error of the first discrete variable whose equation gives no number."""
    part = evaluator.code.system.discrete
    i = int(np.flatnonzero(~np.isfinite(found))[0])
    assignment = part.assignments[i]
    name = leaf_name(assignment.unknown)
    what = "not a number" if np.isnan(found[i]) else "infinite"
    names = tuple(n for n in symbols([assignment.value]) if n != name)
    message = f"`{name}` is {what} {at(time)}, computed from `{shown(assignment.equation)}`"
    span = assignment.equation.flat.span
    return fail(
        SimulationProblem,
        "simulate.not-finite",
        message,
        span,
        names=(name, *names),
        hint=_given(evaluator, names),
    )


def bad_reset(evaluator: Evaluator, reset: Reset, value: float, time: float) -> AcausalError:
    """The error of a `reinit` whose value is no number."""
    names = tuple(n for n in symbols([reset.value]) if n != reset.state)
    message = f"`reinit({reset.state}, {short_text(reset.value)})` gives {value} {at(time)}"
    known = (*names, reset.state)
    return fail(
        SimulationProblem,
        "simulate.not-finite",
        message,
        reset.span,
        names=(reset.state, *names),
        hint=_given(evaluator, known),
    )


def _given(evaluator: Evaluator, names: tuple[str, ...]) -> str:
    values = point_text(evaluator, names)
    return f"with {values}" if values else ""


def contradicts(evaluator: Evaluator) -> bool:
    """Whether equations of a block have no common solution at the present point."""
    try:
        evaluator.explain()
    except SimulationProblem as error:
        return "simulate.singular-block" in error.codes
    return False
