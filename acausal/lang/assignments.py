"""Assignments in functions and algorithm sections: variables, elements, fields (Modelica 3.6, 11.2.1)."""

from __future__ import annotations

from itertools import product

from acausal.lang import ast
from acausal.lang.algorithm_targets import store_component
from acausal.lang.arithmetic import as_value, type_error
from acausal.lang.function_frame import Frame
from acausal.lang.index_choices import Choice, VariableIndex, check_size, with_changes, with_index
from acausal.lang.subscripts import subscript_values
from acausal.lang.values import (
    AnyValue,
    RecordArray,
    RecordValue,
    Value,
    assignable,
    describe,
    index_offset,
    stack,
)


def assign(frame: Frame, statement: ast.Assignment) -> None:
    """`target := value`, `(a, , b) := f(x)`."""
    if not isinstance(statement.target, ast.Tuple):
        store(frame, statement.target, frame.value(statement.value))
        return
    if not isinstance(statement.value, ast.Call):
        raise type_error("type.tuple", "only a function call has several results", statement.span)
    results = frame.results(statement.value)
    targets = statement.target.items
    if len(targets) > len(results):
        name = statement.value.function.text
        message = f"`{name}` has only {len(results)} result(s)"
        raise type_error("call.results", message, statement.span, "", (name,))
    for target, value in zip(targets, results, strict=False):
        if isinstance(target, ast.ComponentReference):
            store(frame, target, value)


def store(frame: Frame, target: ast.ComponentReference, value: AnyValue) -> None:
    """Give a variable, or a part of one, its new value; an index may vary at run time."""
    if frame.instance is not None:
        store_component(frame, target, value)
        return
    try:
        _store_variable(frame, target, value)
    except VariableIndex as varying:
        if varying.choice is None:
            raise
        _store_somewhere(frame, target, value, varying.choice)


def _store_somewhere(frame: Frame, target: ast.ComponentReference, value: AnyValue, choice: Choice) -> None:
    """`x[i] := value` with an index that is known at run time only: each element may be the one."""
    check_size(choice)
    name = target.parts[0].name
    old = frame.variables[name]
    result = old
    for k in range(1, choice.size + 1):
        frame.variables[name] = old
        store(frame, with_index(target, choice, k), value)
        result = with_changes(choice.test(k), old, frame.variables[name], result)
    frame.variables[name] = result
    choice.check(frame.translation, frame.guard)


def _store_variable(frame: Frame, target: ast.ComponentReference, value: AnyValue) -> None:
    name = target.parts[0].name
    entry = frame.entries.get(name)
    if entry is None or entry.clause.causality == "input" or entry.clause.variability == "constant":
        what = "is not a variable" if entry is None else f"is {_kind(entry.clause)}"
        message = f"`{name}` {what} of `{frame.scope.path}` and cannot be assigned"
        raise type_error("function.assignment", message, target.span, "", (name,))
    frame.variables[name] = _updated(frame, frame.variables[name], list(target.parts), value)
    frame.assigned.add(name)


def _kind(clause: ast.ComponentClause) -> str:
    return "an input" if clause.causality == "input" else "a constant"


def _updated(frame: Frame, old: AnyValue, parts: list[ast.NamePart], value: AnyValue) -> AnyValue:
    """`old` with the part that the reference names replaced by `value`."""
    part = parts[0]
    if part.subscripts is not None:
        return _store_elements(frame, old, parts, value)
    if len(parts) > 1:
        if not isinstance(old, RecordValue) or parts[1].name not in old.fields:
            message = f"{describe(old)} has no field `{parts[1].name}`"
            raise type_error("lookup.unknown-field", message, parts[1].span, "", (parts[1].name,))
        inner = _updated(frame, old.fields[parts[1].name], parts[1:], value)
        return old.with_fields({**old.fields, parts[1].name: inner})
    if isinstance(old, Value) != isinstance(value, Value):
        message = f"`{part.name}` is {describe(old)}, but it is assigned {describe(value)}"
        raise type_error("type.mismatch", message, part.span, "", (part.name,))
    if isinstance(old, Value) and isinstance(value, Value):
        if not assignable(value.type, old.type):
            message = f"`{part.name}` is {old.type}, but it is assigned {describe(value)}"
            raise type_error("type.mismatch", message, part.span, "", (part.name,))
        if len(value.shape) != len(old.shape) or not _fits(frame, part.name, old, value):
            message = f"`{part.name}` is {describe(old)}, but it is assigned {describe(value)}"
            raise type_error("type.array-size", message, part.span, "", (part.name,))
        return Value(old.type, value.shape, value.items)
    return value


def _fits(frame: Frame, name: str, old: Value, value: Value) -> bool:
    """Whether the sizes are the same; those declared `:` may change with each assignment (12.4.5)."""
    if not old.items or value.shape == old.shape:
        return True
    entry = frame.entries.get(name)
    if entry is None or frame.variables.get(name) is not old:
        return False
    written = [entry.declaration.dimensions, entry.clause.dimensions]
    sizes = [item for subscripts in written if subscripts is not None for item in subscripts.items]
    return len(sizes) == len(old.shape) and all(
        isinstance(size, ast.Colon) or a == b
        for size, a, b in zip(sizes, old.shape, value.shape, strict=True)
    )


def _store_elements(frame: Frame, old: AnyValue, parts: list[ast.NamePart], value: AnyValue) -> AnyValue:
    part = parts[0]
    if isinstance(old, RecordValue):
        message = f"`{part.name}` is {describe(old)}, not an array"
        raise type_error("type.not-array", message, part.span, "", (part.name,))
    picks = subscript_values(frame.translation, part.subscripts, old.shape, frame.env(), part.name)
    ranges = [(p,) if isinstance(p, int) else p for p in picks]
    targets = [index_offset(old.shape, index) for index in product(*ranges)]
    if isinstance(old, RecordArray):
        return _store_records(frame, old, targets, parts, value)
    new = as_value(value, part.span)
    if len(targets) != len(new.items) or len(parts) > 1:
        message = f"{describe(new)} does not fit this part of `{part.name}`"
        raise type_error("type.array-size", message, part.span, "", (part.name,))
    if not assignable(new.type, old.type):
        message = f"`{part.name}` holds {old.type}, but it is assigned {describe(new)}"
        raise type_error("type.mismatch", message, part.span, "", (part.name,))
    items = list(old.items)
    for offset, item in zip(targets, new.items, strict=True):
        items[offset] = item
    return Value(old.type, old.shape, tuple(items))


def _store_records(
    frame: Frame, old: RecordArray, targets: list[int], parts: list[ast.NamePart], value: AnyValue
) -> RecordArray:
    """One record of an array, or one field of it."""
    if len(targets) != 1:
        message = f"only one element of the array of records `{parts[0].name}` can be assigned at a time"
        raise type_error("type.record", message, parts[0].span, "", (parts[0].name,))
    (offset,) = targets
    items = list(old.items)
    bare = ast.NamePart(parts[0].name, None, parts[0].span)
    new = _updated(frame, items[offset], [bare, *parts[1:]], value)
    if not isinstance(new, RecordValue):
        message = f"{describe(new)} is assigned to a record of `{parts[0].name}`"
        raise type_error("type.mismatch", message, parts[0].span, "", (parts[0].name,))
    items[offset] = new
    result = stack(items, old.shape)
    assert isinstance(result, RecordArray)
    return result
