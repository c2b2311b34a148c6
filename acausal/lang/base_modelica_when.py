"""When-equations as Base Modelica text (MCP-0031, "when-equations").

There they say nothing about initialisation: what Modelica implies is written out as initial equations, which
are `v = e` of the first branch with `initial()` among its conditions, or `v = pre(v)` without one.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from acausal.lang.flat import Equation, FlatModel, Reinit, When, WhenBranch
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.expressions.text import quoted_name, to_text


def when_lines(when: When) -> list[str]:
    """The lines of one clause, without a semicolon at the end; none if it acts at initialisation only."""
    lines: list[str] = []
    for branch in when.branches:
        conditions = [c for c in branch.conditions if c.op != "initial"]
        if conditions:
            word = "elsewhen" if lines else "when"
            texts = [_text(c) for c in conditions]
            test = texts[0] if len(texts) == 1 else f"{{{', '.join(texts)}}}"
            lines += [f"{word} {test} then", *[f"  {line};" for line in _actions(branch)]]
    return [*lines, "end when"] if lines else []


def initial_equations(flat: FlatModel) -> Iterator[Equation]:
    """What the when-clauses of a model say at initialisation (8.6)."""
    for when in flat.whens:
        active = next((b for b in when.branches if any(c.op == "initial" for c in b.conditions)), None)
        if active is None:
            for left in when.assigned:
                yield Equation(left, ex.pre(left), when.span, when.component)
        else:
            yield from active.equations
            yield from [_equality(reinit) for reinit in active.reinits]


def _equality(reinit: Reinit) -> Equation:
    return Equation(reinit.state, reinit.value, reinit.span, reinit.component)


def _actions(branch: WhenBranch) -> Iterator[str]:
    for equation in branch.equations:
        yield f"{_text(equation.left)} = {_text(equation.right)}"
    for reinit in branch.reinits:
        yield f"reinit({_text(reinit.state)}, {_text(reinit.value)})"
    for assertion in branch.assertions:
        yield assertion_text(assertion.condition, assertion.message, assertion.level)
    for termination in branch.terminations:
        yield f"terminate({_text(termination.message)})"


def assertion_text(condition: Expr, message: Expr, level: str) -> str:
    """`assert(condition, message, level)`, without the level where it is the usual one."""
    level = level.removeprefix("AssertionLevel.")
    arguments = [_text(condition), _text(message)]
    if level != "error":
        arguments.append(f"AssertionLevel.{level}")
    return f"assert({', '.join(arguments)})"


def _text(value: Expr) -> str:
    return to_text(value, quoted_name)


def with_initial(flat: FlatModel) -> FlatModel:
    """The model with the initial equations of its when-clauses written out."""
    if not flat.whens:
        return flat
    return replace(flat, initial_equations=(*flat.initial_equations, *initial_equations(flat)))
