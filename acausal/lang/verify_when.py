"""Proof of what the symbolic core relies on in when-clauses and assertions of a flat model."""

from __future__ import annotations

from collections.abc import Iterator

from acausal.errors import Diagnostic, Span
from acausal.lang.expression_types import (
    TypeMistake,
    article,
    assignable,
    short_text,
)
from acausal.lang.flat import (
    BOOLEAN,
    REAL,
    STRING,
    Assertion,
    Equation,
    Reinit,
    ScalarType,
    Variability,
    When,
    WhenBranch,
)
from acausal.lang.flat_typing import Typing, mistake_in
from acausal.symbolic.expressions.expr import Expr, symbols, trigger


def when_problems(typing: Typing, when: When) -> Iterator[Diagnostic]:
    """What is wrong with a when-clause; `typing.at_event` is set."""
    for branch in when.branches:
        for condition in branch.conditions:
            try:
                typing.kind(trigger(condition))
            except TypeMistake as mistake:
                yield mistake_in(mistake, branch.span)
        yield from _branch(typing, branch)
    assigned = [frozenset(e.left for e in branch.equations) for branch in when.branches]
    if len(dict.fromkeys(assigned)) > 1:
        names = symbols(when.assigned)
        message = "the branches of a when-clause must determine the same variables"
        yield Diagnostic("when.assigned", message, when.span, names)


def _branch(typing: Typing, branch: WhenBranch) -> Iterator[Diagnostic]:
    for equation in branch.equations:
        yield from _assigned(typing, equation)
    for reinit in branch.reinits:
        yield from _reinit(typing, reinit)
    for assertion in branch.assertions:
        yield from assertion_problems(typing, assertion)
    for termination in branch.terminations:
        yield from _of_type(typing, "message of terminate", termination.message, STRING, termination.span)


def _assigned(typing: Typing, equation: Equation) -> Iterator[Diagnostic]:
    try:
        left, right = typing.kind(equation.left), typing.kind(equation.right)
    except TypeMistake as mistake:
        yield mistake_in(mistake, equation.span)
        return
    names = symbols([equation.left, equation.right])
    if equation.left.op != "sym" or left.variability is not Variability.DISCRETE:
        message = f"a when-clause determines discrete variables, but {short_text(equation.left)} is none"
        yield Diagnostic("when.left-side", message, equation.span, names)
    if not assignable(left.type, right.type):
        target, value = short_text(equation.left), short_text(equation.right)
        message = f"{target} is {article(left.type)}, but it is given {value}, {article(right.type)}"
        yield Diagnostic("type.equation", message, equation.span, names)


def _reinit(typing: Typing, reinit: Reinit) -> Iterator[Diagnostic]:
    try:
        state, value = typing.kind(reinit.state), typing.kind(reinit.value)
    except TypeMistake as mistake:
        yield mistake_in(mistake, reinit.span)
        return
    names = symbols([reinit.state, reinit.value])
    if reinit.state.op != "sym" or state.type != REAL or state.variability is not Variability.CONTINUOUS:
        message = f"reinit needs a continuous Real variable, not {short_text(reinit.state)}"
        yield Diagnostic("reinit.state", message, reinit.span, names)
    elif not assignable(state.type, value.type):
        message = (
            f"{short_text(reinit.state)} is a Real, but {short_text(reinit.value)} is {article(value.type)}"
        )
        yield Diagnostic("type.equation", message, reinit.span, names)


def assertion_problems(typing: Typing, assertion: Assertion) -> Iterator[Diagnostic]:
    """What is wrong with the types of an assertion."""
    yield from _of_type(typing, "condition of an assert", assertion.condition, BOOLEAN, assertion.span)
    yield from _of_type(typing, "message of an assert", assertion.message, STRING, assertion.span)


def _of_type(typing: Typing, what: str, part: Expr, needed: ScalarType, span: Span) -> Iterator[Diagnostic]:
    try:
        found = typing.kind(part)
    except TypeMistake as mistake:
        yield mistake_in(mistake, span)
        return
    if found.type != needed:
        text = f"{short_text(part)} is {article(found.type)}"
        message = f"the {what} must be {article(needed)}, but {text}"
        yield Diagnostic("type.assertion", message, span, symbols([part]))
