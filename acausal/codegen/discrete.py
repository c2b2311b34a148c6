"""The discrete part as Functions: what the event loop calls when it settles an event.

All take `(t, x, p, m, u, d, z)` with `z` solved at that point, like the other dynamic Functions. New values
of discrete variables use the new values of those before them, and of those in a loop with them the ones in
`d`: calling again until nothing changes solves the loop.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
from casadi import SX, Function

from acausal.codegen.casadi_expressions import Converter
from acausal.codegen.lazy import guarded, guarded_values
from acausal.codegen.scope import Scope, column
from acausal.codegen.starts import start_leaf
from acausal.codegen.stitch import Stitching
from acausal.symbolic.causal import Assignment, CausalSystem
from acausal.symbolic.expressions.expr import ONE, Expr, add, relation


@dataclass(frozen=True)
class DiscreteCode:
    """The discrete part of a system, compiled."""

    update: Function
    """`-> v`: new values of `DiscretePart.unknowns`."""
    memory: Function
    """`-> v`: the present values of what `DiscretePart.memory` holds the past of."""
    actions: Function
    """`-> v`: conditions of resets, their values, conditions of checks, whether they hold, of stops."""
    schedule: Function
    """`p -> (start, interval)` of every `sample`."""
    start: Function
    """As `update` with the start values `s` as last input: `-> v`, unknowns and then memory."""
    delayed: Function
    """`-> (value, delay, longest)` of every `delay(value, delay, longest)`."""


def discrete_code(system: CausalSystem, stitching: Stitching, parameters: tuple[Expr, ...]) -> DiscreteCode:
    """Compile the discrete part. Raises `UnsupportedProblem` for what has no numeric code."""
    part = system.discrete
    update = _run(stitching, part.assignments, part.unknowns)
    sources = [node.args[0] for node in part.memory]
    actions = [
        *[reset.condition for reset in part.resets],
        *[reset.value for reset in part.resets],
        *[check.condition for check in part.checks],
        *[check.assertion.condition for check in part.checks],
        *[stop.condition for stop in part.stops],
    ]
    scope = Scope([("p", parameters)])
    samples = [scope.column([node.args[i] for node in part.samples]) for i in (0, 1)]
    delays = [
        stitching.column([node.args[0] for node in system.delays]),
        stitching.column([node.args[1] for node in system.delays]),
        stitching.column([node.args[-1] for node in system.delays]),
    ]
    return DiscreteCode(
        update=stitching.made("discrete", [("v", update)]),
        memory=stitching.made("memory", [("v", stitching.column(sources))]),
        actions=stitching.made("actions", [("v", stitching.column(guarded_values(actions)))]),
        schedule=scope.function("schedule", [("start", samples[0]), ("interval", samples[1])]),
        start=_start(system, stitching),
        delayed=stitching.made("delayed", list(zip(("value", "delay", "longest"), delays, strict=True))),
    )


def _start(system: CausalSystem, stitching: Stitching) -> Function:
    """All discrete values at the start; what nothing determines has the present value of its source."""
    part = system.discrete
    names = {value.name: value.value for value in system.initial.values}
    starts = {start_leaf(value.name): SX.sym(value.name) for value in system.initial.values}
    opened: list[Assignment] = []
    for assignment in part.initial:
        unknown = assignment.unknown
        name = unknown.args[0].name if unknown.op == "pre" and unknown.args[0].op == "sym" else ""
        given = name in names and assignment.value is names[name]
        value = start_leaf(name) if given else assignment.value
        opened.append(Assignment(unknown, value, assignment.equation))
    found = {assignment.unknown for assignment in part.initial}
    goal = [*part.unknowns, *(node if node in found else node.args[0] for node in part.memory)]
    values = _run(stitching, opened, goal, starts)
    return stitching.made("discrete_start", [("v", values)], [("s", column(list(starts.values())))])


def _run(
    stitching: Stitching,
    assignments: Sequence[Assignment],
    goal: Sequence[Expr],
    more: Mapping[Expr, SX] | None = None,
) -> SX:
    """Evaluates the assignments in order; the values of `goal` after that."""
    convert = stitching.converter()
    convert.leaves.update(more or {})
    for assignment in guarded(assignments):
        unknown = assignment.unknown
        if unknown.op == "integer":
            convert.modes[unknown] = _whole(unknown, convert)
        else:
            convert.leaves[unknown] = convert(assignment.value)
    return column([convert(node) for node in goal])


def _whole(node: Expr, convert: Converter) -> SX:
    """`integer(u)` at an event: its modes decide, which know where u goes; only jumps of u are computed."""
    arg = node.args[0]
    before, literal = convert(node), ca.floor(convert(arg))
    below, above = convert(relation("lt", arg, node)), convert(relation("ge", arg, add(node, ONE)))
    return ca.if_else(ca.fabs(literal - before) <= 1, before + above - below, literal)
