"""Arrays of records: functions that move elements about, whatever the elements are (Modelica 3.6, 10.3)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from acausal.errors import Span
from acausal.lang.arithmetic import type_error
from acausal.lang.array_functions import ARRAY_FUNCTIONS
from acausal.lang.flat import INTEGER
from acausal.lang.values import (
    AnyValue,
    RecordArray,
    RecordValue,
    Value,
    describe,
    same_fields,
    shape_of,
    stack,
)
from acausal.symbolic.expressions import expr as ex

if TYPE_CHECKING:
    from acausal.lang.scope import Scope

REARRANGING = frozenset({"fill", "transpose", "vector", "scalar", "matrix", "cat", "symmetric"})
"""Functions whose result holds elements of their arguments, unchanged."""


def as_items(value: AnyValue) -> list[AnyValue]:
    """The elements of an array, or the one value itself."""
    if isinstance(value, RecordValue):
        return [value]
    if isinstance(value, RecordArray):
        return list(value.items)
    return [Value(value.type, (), (item,)) for item in value.items]


def as_array(items: Sequence[AnyValue], shape: tuple[int, ...], scope: Scope | None) -> AnyValue:
    """Elements as an array; without any, an array of records of `scope`."""
    result = stack(items, shape) if items else None
    return RecordArray(shape, (), scope) if result is None else result


def rearranged(name: str, args: Sequence[AnyValue], span: Span) -> AnyValue:
    """One of `REARRANGING` applied to records."""
    function = ARRAY_FUNCTIONS[name]
    if name == "cat":
        return renumbered(args[1:], lambda numbers: function([args[0], *numbers], span), span)
    if name == "fill":
        return renumbered(args[:1], lambda numbers: function([*numbers, *args[1:]], span), span)
    return renumbered(args, lambda numbers: function(numbers, span), span)


def renumbered(
    args: Sequence[AnyValue], function: Callable[[Sequence[Value]], Value], span: Span
) -> AnyValue:
    """A function that moves elements about, applied to the numbers of records; then numbers to records."""
    records: list[RecordValue] = []
    numbered: list[Value] = []
    fit = True
    for arg in args:
        items = [item for item in as_items(arg) if isinstance(item, RecordValue)]
        fit = fit and not isinstance(arg, Value)
        numbers = tuple([ex.const(len(records) + i) for i in range(len(items))])
        numbered.append(Value(INTEGER, shape_of(arg), numbers))
        records += items
    if not fit or any(not same_fields(record, records[0]) for record in records):
        kinds = ", ".join(dict.fromkeys(describe(arg) for arg in args))
        raise type_error("type.array-elements", f"these values do not fit together: {kinds}", span)
    chosen = function(numbered)
    picked = tuple([records[int(item.number)] for item in chosen.items])
    scope = next((arg.scope for arg in args if not isinstance(arg, Value)), None)
    return RecordArray(chosen.shape, picked, scope) if chosen.shape else picked[0]
