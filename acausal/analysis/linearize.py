"""A compiled model linearised at its start, at instants of a run, or where it is steady."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import inf
from typing import TypeAlias

import numpy as np

from acausal.analysis.linear import Matrix, state_matrix
from acausal.analysis.modes import modes
from acausal.analysis.points import Point, points_of_run
from acausal.analysis.snapshot import Snapshot
from acausal.analysis.steady import steady_state
from acausal.analysis.truth import growing, relations
from acausal.codegen.functions import Code
from acausal.errors import SimulationProblem, UsageProblem, fail
from acausal.lang.flat import REAL, Causality
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.initialize import initialize
from acausal.simulate.inputs import InputValue
from acausal.simulate.messages import some
from acausal.simulate.options import resolve
from acausal.simulate.overrides import Override
from acausal.simulate.solvers import AUTO, chosen
from acausal.symbolic.expressions.text import to_text

At: TypeAlias = float | str
"""Seconds, `initial`, `steady`, or `steady@SECONDS`: the steady state near an instant of a run, whose time,
sources and modes it begins with."""


@dataclass(frozen=True)
class Setting:
    """What a run is given: parameters, start values, inputs and tolerance; nothing compiles again."""

    parameters: Mapping[str, Override] = field(default_factory=dict[str, Override])
    start: Mapping[str, float] = field(default_factory=dict[str, float])
    inputs: Mapping[str, InputValue] = field(default_factory=dict[str, InputValue])
    rtol: float | None = None


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

    Modes and discrete values are frozen as they are there. Raises what `snapshots` raises.
    """
    setting = Setting(parameters or {}, start or {}, inputs or {}, rtol)
    return snapshots(code, [at], setting)[0]


def snapshots(code: Code, at: Sequence[At], setting: Setting | None = None) -> tuple[Snapshot, ...]:
    """The snapshots at several instants, in the order in which they are given; one run visits all of them.

    Raises `InitializationProblem`, `SimulationProblem` (`steady.none`, `linearize.ended`), and `UsageProblem`
    `linearize.at` for what is no instant of a run.
    """
    began = code.system.flat.experiment.start_time or 0.0
    wanted = [parsed(one, began) for one in at]
    points = points_at(code, sorted({time for time, _ in wanted}), setting or Setting())
    return tuple(snapshot_at(points[time], how) for time, how in wanted)


def points_at(code: Code, instants: Sequence[float], setting: Setting) -> dict[float, Point]:
    """The points of one run at ascending instants; the first may be its start."""
    experiment = code.system.flat.experiment
    began, until = experiment.start_time or 0.0, max(instants)
    start = initialize(code, began, setting.parameters, setting.start, setting.inputs, until)
    span = resolve(experiment, start_time=began).span if experiment.stop_time is not None else until - began
    options = resolve(
        experiment,
        start_time=began,
        stop_time=until,
        interval=experiment.interval or (min(span, until - began) / 500 if until > began else None),
        rtol=setting.rtol,
        solver=chosen(AUTO),
        has_events=bool(code.located),
    )
    return dict(zip(instants, points_of_run(start, options, instants), strict=True))


def parsed(at: At, began: float) -> tuple[float, str]:
    """When a snapshot is taken, and whether `initial` or `steady`.

    Raises UsageProblem `linearize.at` for what is no instant of a run.
    """
    how, _, text = at.partition("@") if isinstance(at, str) else ("", "", "")
    try:
        time = began if at in ("initial", "steady") else float(text if how == "steady" else at)
    except (TypeError, ValueError):
        time = inf
    if began <= time < inf:
        return time, how
    hint = f"give `initial`, `steady`, seconds from {began:g} on, or `steady@` and seconds"
    raise fail(UsageProblem, "linearize.at", f"`{at}` is no instant of a run", hint=hint)


def snapshot_at(point: Point, at: str = "") -> Snapshot:
    """The snapshot at a point; `steady` goes to the steady state near it first."""
    evaluator = point.evaluator()
    if at == "steady":
        steady = steady_state(evaluator)
        evaluator = steady.evaluator
        evaluator.at(point.time, steady.x)
        evaluator.settle()
    return snapshot_of(evaluator, at)


def snapshot_of(evaluator: Evaluator, at: str = "") -> Snapshot:
    """The snapshot at the evaluator's present point, which is settled."""
    code = evaluator.code
    by_name = code.system.flat.by_name
    a = state_matrix(evaluator)
    _check(evaluator, a)
    found = modes(a, evaluator.x_nominal)
    known = relations(evaluator)
    leaves = tuple(to_text(leaf) for leaf in code.output_leaves)
    declared = tuple(v.name for v in by_name.values() if v.causality is Causality.OUTPUT and v.type == REAL)
    return Snapshot(
        model=code.system.flat.name,
        at=at,
        time=float(evaluator.t[0]),
        states=code.system.states,
        inputs=tuple(variable.name for variable in code.system.flat.inputs),
        outputs=tuple(dict.fromkeys((*leaves, *declared))),
        declared_outputs=declared,
        point=Point.of(evaluator),
        a=a,
        modes=found,
        values=evaluator.x.copy(),
        rates=evaluator.xdot.copy(),
        nominals=evaluator.x_nominal.copy(),
        units=tuple(by_name[name].unit for name in code.system.states),
        relations=known,
        growing=growing(evaluator, found, known),
        notes=_held(evaluator),
    )


def _check(evaluator: Evaluator, a: Matrix) -> None:
    """Raises SimulationProblem `linearize.not-finite` where a derivative has no slope."""
    wrong = np.argwhere(~np.isfinite(a))
    if not len(wrong):
        return
    states = evaluator.code.system.states
    pairs: list[tuple[int, int]] = [(int(i), int(j)) for i, j in wrong]
    rows = list(dict.fromkeys(states[i] for i, _ in pairs))
    columns = list(dict.fromkeys(states[j] for _, j in pairs))
    raise fail(
        SimulationProblem,
        "linearize.not-finite",
        f"the slope of {some([f'`der({name})`' for name in rows])} with respect to "
        f"{some([f'`{name}`' for name in columns])} is not finite at {evaluator.t[0]:g} s",
        names=dict.fromkeys([*rows, *columns]),
        hint="a root of zero has no slope: linearise a little away from there, or make it smooth",
    )


def _held(evaluator: Evaluator) -> tuple[str, ...]:
    """Delayed values do not react at once, so they are constants here."""
    delays = evaluator.code.system.delays
    if not delays:
        return ()
    texts = [f"`{to_text(node)}`" for node in delays]
    return (f"delayed values are held, so modes through them are not seen: {some(texts)}",)
