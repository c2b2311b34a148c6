"""Subscripts of component references and values (Modelica 3.6, 10.5)."""

from __future__ import annotations

from collections.abc import Sequence
from math import prod

from acausal.errors import TypeProblem
from acausal.lang import ast
from acausal.lang.arithmetic import as_value, type_error
from acausal.lang.flat import BOOLEAN, INTEGER
from acausal.lang.index_choices import (
    Choice,
    VariableIndex,
    check_size,
    chosen,
    element_of_nothing,
    variable_index,
    with_chosen,
)
from acausal.lang.translation import Env, Translation
from acausal.lang.values import (
    AnyValue,
    RecordArray,
    RecordValue,
    Value,
    describe,
    literal,
    select_part,
    subscript,
)
from acausal.symbolic.expressions import expr as ex

MAX_SELECTED = 200_000


def subscript_values(
    translation: Translation, subscripts: ast.Subscripts | None, shape: tuple[int, ...], env: Env, path: str
) -> list[int | Sequence[int]]:
    """Each subscript as an index or a list of indices (from 0), checked against the sizes."""
    items = () if subscripts is None else subscripts.items
    if subscripts is not None and len(items) > len(shape):
        message = f"`{path}` has {len(shape)} dimension(s), not {len(items)}"
        raise type_error("type.array-size", message, subscripts.span, "", (path,))
    picks: list[int | Sequence[int]] = []
    for item, size in zip(items, shape, strict=False):
        if isinstance(item, ast.Colon):
            picks.append(range(size))
            continue
        value = as_value(translation.value(item, env.with_size(literal(size))), item.span)
        indices = [_index(translation, value, k, size, item, path) for k in range(len(value.items))]
        if len(value.shape) > 1:
            raise type_error("type.subscript", "a subscript is a scalar or a vector", item.span, "", (path,))
        picks.append(indices if value.shape else indices[0])
    picks += [range(size) for size in shape[len(items) :]]
    if subscripts is not None and prod([len(p) for p in picks if not isinstance(p, int)]) > MAX_SELECTED:
        message = f"this part of `{path}` has more than {MAX_SELECTED} elements"
        raise type_error("array.bad-size", message, subscripts.span, "", (path,))
    return picks


def _index(translation: Translation, value: Value, k: int, size: int, item: ast.Expression, path: str) -> int:
    if value.type not in (INTEGER, BOOLEAN) and not value.type.is_enumeration:
        message = f"a subscript of `{path}` must be Integer, not {describe(value)}"
        raise type_error("type.subscript", message, item.span, "", (path,))
    try:
        constant = translation.evaluate_expr(value.items[k], item.span, f"the subscript of `{path}`")
    except TypeProblem as problem:
        if value.shape or problem.codes != ("structural.not-constant",):
            raise
        raise variable_index(problem, Choice(item, value.item, size, value.type, path)) from None
    number = ex.const(constant).number
    index = int(number) if value.type == BOOLEAN else int(number) - 1
    if not 0 <= index < size:
        message = f"index {int(number)} of `{path}` is outside 1 to {size}"
        raise type_error("type.index-out-of-range", message, item.span, "", (path,))
    return index


def subscripted(
    translation: Translation, value: AnyValue, subscripts: ast.Subscripts, env: Env, path: str
) -> AnyValue:
    """`value[subscripts]` of an array of scalars or of records; a subscript may vary at run time."""
    try:
        return _subscripted(translation, value, subscripts, env, path)
    except VariableIndex as varying:
        choice = varying.choice
        if choice is None or not any(item is choice.node for item in subscripts.items):
            raise
    if choice.size == 0:
        without = _subscripted(translation, value, with_chosen(subscripts, choice, None), env, path)
        return element_of_nothing(translation, without, choice)
    check_size(choice)
    values = [
        subscripted(translation, value, with_chosen(subscripts, choice, k), env, path)
        for k in range(1, choice.size + 1)
    ]
    choice.check(translation, ex.TRUE)
    return chosen(choice, values, subscripts.span)


def _subscripted(
    translation: Translation, value: AnyValue, subscripts: ast.Subscripts, env: Env, path: str
) -> AnyValue:
    if isinstance(value, RecordValue):
        message = f"`{path}` is {describe(value)}, not an array"
        raise type_error("type.not-array", message, subscripts.span, "", (path,))
    picks = subscript_values(translation, subscripts, value.shape, env, path)
    if isinstance(value, Value):
        return subscript(value, picks)
    numbers = Value(INTEGER, value.shape, tuple([ex.const(i) for i in range(len(value.items))]))
    chosen = subscript(numbers, picks)
    items = tuple([value.items[int(item.number)] for item in chosen.items])
    return RecordArray(chosen.shape, items, value.scope) if chosen.shape else items[0]


def part_of(translation: Translation, value: AnyValue, node: ast.ComponentReference, env: Env) -> AnyValue:
    """What a reference names of the value of its first part: fields and elements."""
    for i, part in enumerate(node.parts):
        if i > 0:
            field_value = select_part(value, part.name)
            if field_value is None:
                message = f"{describe(value)} has no field `{part.name}`"
                raise type_error("lookup.unknown-field", message, part.span, "", (part.name,))
            value = field_value
        if part.subscripts is not None:
            value = subscripted(translation, value, part.subscripts, env, part.name)
    return value
