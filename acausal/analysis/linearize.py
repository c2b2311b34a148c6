"""A compiled model linearised at its start, at an instant of a run, or where it is steady."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, TypeAlias

import numpy as np

from acausal.analysis.linear import matrices_at
from acausal.analysis.snapshot import Snapshot
from acausal.analysis.steady import steady_state
from acausal.codegen.functions import Code
from acausal.errors import UsageProblem, fail
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.initialize import initialize
from acausal.simulate.inputs import InputValue
from acausal.simulate.options import resolve
from acausal.simulate.overrides import Override
from acausal.simulate.simulate import integrate
from acausal.simulate.solvers import AUTO, chosen
from acausal.symbolic.expressions.text import to_text

At: TypeAlias = "float | Literal['initial', 'steady']"
_STEADY = 1e-6
"""Largest derivative of a state at rest, relative to its nominal value per second."""


def linearize(
    code: Code,
    at: At = "initial",
    *,
    parameters: Mapping[str, Override] | None = None,
    start: Mapping[str, float] | None = None,
    inputs: Mapping[str, InputValue] | None = None,
    rtol: float | None = None,
) -> Snapshot:
    """The snapshot at the start (`initial`), at the steady state near it (`steady`), or at a time of a run.

    Modes and discrete values are frozen as they are there. Raises `InitializationProblem`,
    `SimulationProblem`, and `UsageProblem` `linearize.dynamic-states` for a model whose choice of states
    changes during a run, and `linearize.at` for what is no instant of a run.
    """
    if code.system.dynamic is not None:
        raise fail(
            UsageProblem,
            "linearize.dynamic-states",
            f"{code.system.flat.name} has no choice of states that is valid everywhere",
            names=code.system.states,
            hint="choose states with stateSelect, or write it in coordinates that are valid everywhere",
        )
    began = code.system.flat.experiment.start_time or 0.0
    until = _instant(at, began)
    point = initialize(code, began, parameters, start, inputs, until)
    evaluator = point.evaluator
    evaluator.at(began, point.x)
    if until > began:
        experiment = code.system.flat.experiment
        options = resolve(
            experiment,
            start_time=began,
            stop_time=until,
            interval=until - began,
            rtol=rtol,
            solver=chosen(AUTO),
            has_events=bool(code.located),
        )
        run = integrate(point, options)
        evaluator.at(float(run.time[-1]), np.array([run.values(name)[-1] for name in code.system.states]))
    elif at == "steady":
        evaluator.at(began, steady_state(evaluator).x)
    evaluator.settle()
    return _snapshot(evaluator)


def _instant(at: At, began: float) -> float:
    """When the snapshot is taken. Raises UsageProblem `linearize.at` for what is no instant of a run."""
    if isinstance(at, str):
        if at in ("initial", "steady"):
            return began
    elif began <= at < float("inf"):
        return float(at)
    hint = f"give `initial`, `steady`, or seconds from {began:g} on"
    raise fail(UsageProblem, "linearize.at", f"`{at}` is no instant of a run", hint=hint)


def _snapshot(evaluator: Evaluator) -> Snapshot:
    code = evaluator.code
    rates: list[float] = np.abs(evaluator.xdot / evaluator.x_nominal).tolist()
    by_rate = sorted(zip(rates, code.system.states, strict=True), key=lambda pair: -pair[0])
    moving = [name for rate, name in by_rate if rate > _STEADY]
    warnings = (f"not at rest: {', '.join(moving[:5])} change",) if moving else ()
    return Snapshot(
        model=code.system.flat.name,
        time=float(evaluator.t[0]),
        states=code.system.states,
        inputs=tuple(variable.name for variable in code.system.flat.inputs),
        outputs=tuple(to_text(leaf) for leaf in code.output_leaves),
        matrices=matrices_at(evaluator),
        values=evaluator.x.copy(),
        rates=evaluator.xdot.copy(),
        nominals=evaluator.x_nominal.copy(),
        warnings=warnings,
    )
