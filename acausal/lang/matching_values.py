"""The scalar equations of `left = right` between arrays and records, and of the branches of an `if`."""

from __future__ import annotations

from collections.abc import Sequence
from math import prod

from acausal.errors import Span
from acausal.lang.arithmetic import type_error
from acausal.lang.flat import Equation
from acausal.lang.values import (
    AnyValue,
    RecordArray,
    RecordValue,
    Value,
    describe,
    same_fields,
    shape_of,
    unify,
)
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.expressions.text import to_text

MAX_SHOWN = 60
"""Longer sides are not quoted in messages."""


def match_values(left: AnyValue, right: AnyValue, span: Span) -> list[tuple[Expr, Expr]]:
    """The scalar pairs of `left = right`. Raises `TypeProblem` when types or sizes differ."""
    if isinstance(left, RecordValue) and isinstance(right, RecordValue):
        if not same_fields(left, right):
            message = f"{describe(left)} is not compatible with {describe(right)}"
            raise type_error("type.mismatch", message, span)
        return [p for n in left.fields for p in match_values(left.fields[n], right.fields[n], span)]
    if isinstance(left, RecordArray) and isinstance(right, RecordArray) and left.shape == right.shape:
        return [p for a, b in zip(left.items, right.items, strict=True) for p in match_values(a, b, span)]
    if prod(shape_of(left)) == 0 and shape_of(left) == shape_of(right):
        return []
    if isinstance(left, Value) and isinstance(right, Value) and unify(left.type, right.type) is not None:
        if left.shape == right.shape:
            return list(zip(left.items, right.items, strict=True))
        message = f"the two sides have different sizes: {describe(left)} and {describe(right)}"
        raise type_error("type.array-size", message, span, "", _names(left, right))
    message = f"{_side(left)} is {describe(left)}, but {_side(right)} is {describe(right)}"
    raise type_error("type.mismatch", message, span, "both sides need one type", _names(left, right))


def _side(value: AnyValue) -> str:
    """A side of an equation as messages show it."""
    if isinstance(value, Value) and not value.shape:
        text = to_text(value.item)
        if len(text) <= MAX_SHOWN:
            return f"`{text}`"
    return "one side"


def _names(*sides: AnyValue) -> tuple[str, ...]:
    """Some of the variables on both sides."""
    items = [item for side in sides if isinstance(side, Value) for item in side.items[:3]]
    return ex.symbols(items)[:6]


def merge_branches(tests: Sequence[Expr], row: Sequence[Equation], span: Span) -> Equation:
    """One equation out of the corresponding ones of all branches: `left = if test then ... else ...`."""
    first = row[0]
    if all(e.left is first.left for e in row):
        left, sides = first.left, [e.right for e in row]
    else:
        left, sides = ex.ZERO, [ex.sub(e.left, e.right) for e in row]
    right = sides[-1]
    for test, side in zip(reversed(tests), reversed(sides[:-1]), strict=True):
        right = ex.if_then_else(test, side, right)
    return Equation(left, right, span, first.component, first.origin)
