"""A CausalSystem as text: the ordered list of assignments and blocks a person can follow."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from acausal.lang.flat import Variability
from acausal.symbolic.causal import (
    Assignment,
    Block,
    BlockKind,
    CausalEquation,
    CausalSystem,
    InitialValue,
    ZeroCrossing,
)
from acausal.symbolic.describe import equation_text, place
from acausal.symbolic.expressions.text import to_text


def print_causal(system: CausalSystem) -> str:
    """The whole system as text: states, aliases, running blocks, initial blocks, events, assertions."""
    sections = (
        _summary(system),
        _section("states", _states(system)),
        _section("parameters", _parameters(system)),
        _section("aliases", _aliases(system)),
        _section("running system", _blocks(system.blocks)),
        _section("discrete system, at events", _discrete(system)),
        _section("initial values", (_initial_value(value, system) for value in system.initial.values)),
        _section("initial system", _blocks(system.initial.blocks)),
        _section("discrete initial system", map(_assignment, system.discrete.initial)),
        _section(
            "initial checks", (f"0 = {to_text(c.value)}{_source(c.equation)}" for c in system.initial.checks)
        ),
        _section("zero crossings", (_crossing(i, z) for i, z in enumerate(system.events, 1))),
        _section("states chosen anew", _monitors(system)),
        _section("assertions", (f"{to_text(a.condition)}  // {place(a.span)}" for a in system.assertions)),
    )
    return "\n".join(line for section in sections for line in section) + "\n"


def _section(title: str, lines: Iterable[str]) -> Iterator[str]:
    """A title and its lines, indented; nothing where there are none."""
    for i, line in enumerate(lines):
        if i == 0:
            yield ""
            yield title
        yield "  " + line


def _summary(system: CausalSystem) -> Iterator[str]:
    yield f"causal system {system.flat.name}"
    yield (
        f"  {len(system.flat.equations)} equations, {len(system.aliases)} aliases, "
        f"index {system.index}, {len(system.states)} states, {len(system.blocks)} blocks"
    )


def _states(system: CausalSystem) -> Iterator[str]:
    reasons = {choice.name: choice for choice in system.choices}
    for name in system.states:
        reason = reasons[name].reason if name in reasons else ""
        yield f"{name}  // {reason}"
    for choice in system.choices:
        if not choice.is_state:
            yield f"not {choice.name}  // {choice.reason}"


def _parameters(system: CausalSystem) -> Iterator[str]:
    evaluated = frozenset(system.evaluated)
    for name in system.parameters:
        variable = system.flat.by_name[name]
        kind = "constant" if variable.variability is Variability.CONSTANT else "parameter"
        value = variable.binding if variable.binding is not None else variable.start
        if not variable.is_fixed:
            yield f"{kind} {name}  // determined by the initial system"
        else:
            note = "  // evaluated" if name in evaluated else ""
            yield f"{kind} {name} = {'?' if value is None else to_text(value)}{note}"


def _aliases(system: CausalSystem) -> Iterator[str]:
    for alias in system.aliases:
        yield f"{alias.name} = {to_text(alias.value)}  // {place(alias.equation.span)}"


def _blocks(blocks: Iterable[Block]) -> Iterator[str]:
    for number, block in enumerate(blocks, 1):
        if block.kind is BlockKind.EXPLICIT:
            yield f"{number}: {_assignment(block.assignments[0])}"
        else:
            yield from _loop(number, block)


def _loop(number: int, block: Block) -> Iterator[str]:
    names = ", ".join([to_text(leaf) for leaf in block.tearing])
    head = f"{number}: {block.kind.value} block of {block.size}, torn to {len(block.tearing)}"
    yield f"{head}: solve for {names}"
    for assignment in block.assignments:
        yield f"     {_assignment(assignment)}"
    for residual in block.residuals:
        yield f"     0 = {to_text(residual.value)}{_source(residual.equation)}"


def _assignment(assignment: Assignment) -> str:
    return f"{to_text(assignment.unknown)} := {to_text(assignment.value)}{_source(assignment.equation)}"


def _source(equation: CausalEquation) -> str:
    """Where the equation stands, and how often it was differentiated."""
    times = equation.differentiations
    often = {0: "", 1: ", differentiated once", 2: ", differentiated twice"}
    derived = often.get(times, f", differentiated {times} times")
    return f"  // {place(equation.flat.span)}: {equation_text(equation.flat)}{derived}"


def _crossing(number: int, crossing: ZeroCrossing) -> str:
    known = "" if crossing.instant is None else f"  // at time = {to_text(crossing.instant)}"
    return f"{number}: {to_text(crossing.relation)}{known}"


def _discrete(system: CausalSystem) -> Iterator[str]:
    """Discrete equations in order, what they remember, and what else happens."""
    part = system.discrete
    for number, assignment in enumerate(part.assignments, 1):
        yield f"{number}: {_assignment(assignment)}"
    if part.memory:
        yield f"remembered: {', '.join([to_text(leaf) for leaf in part.memory])}"
    for reset in part.resets:
        test = to_text(reset.condition)
        yield f"when {test}: {reset.state} := {to_text(reset.value)}  // {place(reset.span)}"
    for check in part.checks:
        test, wanted = to_text(check.condition), to_text(check.assertion.condition)
        yield f"when {test}: assert {wanted}  // {place(check.assertion.span)}"
    for stop in part.stops:
        yield f"when {to_text(stop.condition)}: terminate  // {place(stop.termination.span)}"


def _monitors(system: CausalSystem) -> Iterator[str]:
    """When other states are chosen while the model runs, and among which variables."""
    for monitor in system.dynamic.monitors if system.dynamic is not None else ():
        texts = "; ".join(equation_text(constraint.flat) for constraint in monitor.constraints)
        yield (
            f"when not {to_text(monitor.relation)}: {', '.join(monitor.alternatives)} instead of "
            f"{', '.join(monitor.solved_for)}  // solved from {texts}"
        )


def _initial_value(value: InitialValue, system: CausalSystem) -> str:
    variable = system.flat.by_name.get(value.name)
    default = variable is None or (variable.start is None and variable.binding is None)
    return f"{value.name} = {to_text(value.value)}  // {value.reason}{', default start' if default else ''}"
