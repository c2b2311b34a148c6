"""The words that text, HTML and JSON share: equations with their places, counts, lists."""

from __future__ import annotations

from collections.abc import Sequence

from acausal.errors import Span
from acausal.explain.collect import Differentiated
from acausal.lang.flat import Equation, Origin
from acausal.symbolic.causal import (
    Block,
    BlockKind,
    CausalEquation,
    CausalSystem,
    InitialConflict,
    InitialValue,
    StateMonitor,
)
from acausal.symbolic.describe import condition_text, equation_text, leaf_texts, place
from acausal.symbolic.expressions.text import to_text
from acausal.symbolic.leaves import is_moving

MOST_CHARACTERS = 2_000
"""Longer equations are cut for people to read; JSON has them whole."""

_USES = {
    "assumed": "assumed: not fixed, but needed as an equation",
    "guess": "guess: where an iteration starts",
}


def short(text: str, most: int = MOST_CHARACTERS) -> str:
    """A text, cut where it is endless."""
    return text if len(text) <= most else f"{text[:most]} ... ({len(text)} characters)"


def counted(number: int, what: str, several: str = "") -> str:
    """`1 block`, `2 blocks`."""
    return f"{number} {what if number == 1 else several or what + 's'}"


def often(times: int) -> str:
    """`once`, `twice`, `3 times`."""
    return {1: "once", 2: "twice"}.get(times, f"{times} times")


def cut(items: Sequence[str], most: int | None) -> str:
    """`a, b, c and 4 more`."""
    if most is None or len(items) <= most:
        return ", ".join(items)
    return f"{', '.join(items[:most])} and {len(items) - most} more"


def where(equation: Equation | CausalEquation) -> str:
    """`Tank.mo:12, connection in tank, differentiated once`."""
    flat = equation.flat if isinstance(equation, CausalEquation) else equation
    parts = [place(flat.span)]
    if flat.origin is not Origin.EQUATION:
        parts.append(flat.origin.value)
    text = ", ".join(parts) + (f" in {flat.component}" if flat.component else "")
    times = equation.differentiations if isinstance(equation, CausalEquation) else 0
    return f"{text}, differentiated {often(times)}" if times else text


def spot(span: Span) -> dict[str, object]:
    """The keys `file` and `line` of JSON."""
    return {"file": span.file, "line": span.line}


def by_whom(entry: Differentiated) -> str:
    """Who differentiated an equation."""
    return f"while {entry.alias} was eliminated" if entry.alias else "by index reduction"


def kind_of(block: Block) -> str:
    """`explicit`, or `nonlinear, 3 unknowns torn to 1`."""
    if block.kind is BlockKind.EXPLICIT:
        return "explicit"
    return f"{block.kind.value}, {counted(block.size, 'unknown')}, {len(block.tearing)} after tearing"


def use(value: InitialValue, system: CausalSystem) -> str:
    """What a start value is good for, and whether anybody gave it."""
    variable = system.flat.by_name.get(value.name)
    given = variable is not None and (variable.start is not None or variable.binding is not None)
    meaning = _USES.get(value.reason, value.reason)
    return meaning if given else f"{meaning}; nobody gave it"


def conditions_text(system: CausalSystem) -> str:
    """How many conditions the start needs, and where they come from, without those of discrete variables."""
    initial = system.initial
    discrete = {v.name for v in system.flat.unknowns if not is_moving(v)}
    assumed = sum(v.reason == "assumed" and v.name not in discrete for v in initial.values)
    parts = [
        counted(initial.equations, "initial equation"),
        counted(initial.needed - initial.equations - assumed, "fixed start value"),
        f"{counted(assumed, 'start value')} assumed though not fixed",
    ]
    return f"{counted(initial.needed, 'condition')} needed beside the equations: {', '.join(parts)}"


def surplus_text(conflict: InitialConflict) -> str:
    """A condition that must hold as well, and what it competes with."""
    others = ", ".join([condition_text(other) for other in conflict.others])
    beside = f"with {others}" if others else "with the equations alone"
    return f"one too many: {condition_text(conflict.condition)} must agree {beside}"


def when_not(monitor: StateMonitor) -> tuple[str, str, str]:
    """The condition of a choice of states, what may replace what, and the constraints behind it."""
    return (
        to_text(monitor.relation),
        f"{', '.join(monitor.alternatives)} solved for instead of {', '.join(monitor.solved_for)}"
        if monitor.alternatives
        else f"another choice than solving for {', '.join(monitor.solved_for)}",
        "; ".join([f"{equation_text(c.flat)} ({where(c)})" for c in monitor.constraints]),
    )


def unknown_texts(block: Block) -> tuple[str, ...]:
    """The unknowns of a block, tearing variables first."""
    return leaf_texts(block.unknowns)
