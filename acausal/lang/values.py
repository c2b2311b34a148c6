"""What an expression of the source becomes: scalars and arrays of hash-consed expressions, and records."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import product
from math import prod
from typing import TYPE_CHECKING

from acausal.lang.flat import BOOLEAN, INTEGER, REAL, STRING, ScalarType
from acausal.lang.light import light_object
from acausal.symbolic.expressions.expr import FALSE, ZERO, EnumValue, Expr, const

if TYPE_CHECKING:  # a record knows its class, the modifiers of classes hold values
    from acausal.lang.scope import Scope

Shape = tuple[int, ...]


@light_object
class Value:
    """A scalar (`shape` is empty) or an array, row by row, of expressions of one scalar type."""

    type: ScalarType
    shape: Shape
    items: tuple[Expr, ...]

    @property
    def is_scalar(self) -> bool:
        return not self.shape

    @property
    def item(self) -> Expr:
        """The expression of a scalar."""
        return self.items[0]


@light_object
class RecordValue:
    """A record: its class's name, its fields in order of declaration, and its class, where known."""

    type_name: str
    fields: dict[str, AnyValue]
    scope: Scope | None = None

    def with_fields(self, fields: dict[str, AnyValue]) -> RecordValue:
        """A record of the same class."""
        return RecordValue(self.type_name, fields, self.scope)


@light_object
class RecordArray:
    """An array of records, row by row, and their class, where known."""

    shape: Shape
    items: tuple[RecordValue, ...]
    scope: Scope | None = None


AnyValue = Value | RecordValue | RecordArray


def scalar(type_: ScalarType, item: Expr) -> Value:
    """A scalar of any type."""
    return Value(type_, (), (item,))


def real(item: Expr) -> Value:
    """A Real scalar."""
    return Value(REAL, (), (item,))


def literal(value: float | int | bool | str) -> Value:
    """A literal of the matching predefined type."""
    if isinstance(value, bool):
        return Value(BOOLEAN, (), (const(value),))
    if isinstance(value, int):
        return Value(INTEGER, (), (const(value),))
    return Value(STRING if isinstance(value, str) else REAL, (), (const(value),))


def enumeration_literal(type_: ScalarType, index: int) -> Value:
    """Literal number `index` (from 1) of an enumeration type."""
    return Value(type_, (), (const(EnumValue(type_.name, type_.literals[index - 1], index)),))


def zero_of(type_: ScalarType) -> Expr:
    """The default of the attribute `start` (4.9)."""
    if type_.is_enumeration:
        return const(EnumValue(type_.name, type_.literals[0], 1))
    zeros = {"Boolean": FALSE, "Integer": const(0), "String": const("")}
    return zeros.get(type_.name, ZERO)


def describe(value: AnyValue) -> str:
    """Type and size for messages: `Real[3, 2]`, `record Fluid`."""
    if isinstance(value, RecordValue):
        return f"record {value.type_name}"
    if isinstance(value, RecordArray):
        return f"array of records[{', '.join(map(str, value.shape))}]"
    return value.type.name + (f"[{', '.join(map(str, value.shape))}]" if value.shape else "")


def unify(a: ScalarType, b: ScalarType) -> ScalarType | None:
    """The common type of two values: Integer becomes Real where needed; None if there is none."""
    if a == b:
        return a
    if a.is_numeric and b.is_numeric:
        return REAL
    return None


def assignable(source: ScalarType, target: ScalarType) -> bool:
    """Whether a value of type `source` may be bound to something of type `target`."""
    return source == target or (target == REAL and source == INTEGER)


def elementwise(function: Callable[[Expr], Expr], a: Value, type_: ScalarType) -> Value:
    """The function of every element."""
    return Value(type_, a.shape, tuple([function(item) for item in a.items]))


def zip_with(function: Callable[[Expr, Expr], Expr], a: Value, b: Value, type_: ScalarType) -> Value | None:
    """Element by element; a scalar is paired with every element. None when the sizes differ."""
    if a.shape == b.shape:
        items = tuple([function(x, y) for x, y in zip(a.items, b.items, strict=True)])
        return Value(type_, a.shape, items)
    if not a.shape:
        return Value(type_, b.shape, tuple([function(a.items[0], y) for y in b.items]))
    if not b.shape:
        return Value(type_, a.shape, tuple([function(x, b.items[0]) for x in a.items]))
    return None


def index_offset(shape: Shape, index: Sequence[int]) -> int:
    """Row-major offset of a full index (from 0)."""
    offset = 0
    for size, i in zip(shape, index, strict=True):
        offset = offset * size + i
    return offset


def all_indices(shape: Shape) -> Iterator[tuple[int, ...]]:
    """All full indices (from 0), row by row."""
    return product(*[range(size) for size in shape])


def first_element(value: Value, index: int) -> Value:
    """`value[index]` (from 0) along the first dimension."""
    rest = value.shape[1:]
    size = prod(rest)
    return Value(value.type, rest, value.items[index * size : (index + 1) * size])


def shape_of(value: AnyValue) -> Shape:
    """The sizes of a value; none for a scalar and a record."""
    return () if isinstance(value, RecordValue) else value.shape


def first_size(value: AnyValue) -> int | None:
    """The size of the first dimension; None for a scalar and a record."""
    return value.shape[0] if not isinstance(value, RecordValue) and value.shape else None


def select_part(value: AnyValue, selector: int | str) -> AnyValue | None:
    """One element along the first dimension (from 0) or one field; None when there is no such part."""
    if isinstance(selector, str):
        if isinstance(value, RecordValue):
            return value.fields.get(selector)
        if isinstance(value, RecordArray):
            return stack([item.fields[selector] for item in value.items], value.shape)
        return None
    if isinstance(value, Value):
        return first_element(value, selector) if value.shape and selector < value.shape[0] else None
    if isinstance(value, RecordArray) and selector < value.shape[0]:
        rest = value.shape[1:]
        size = prod(rest)
        part = value.items[selector * size : (selector + 1) * size]
        return part[0] if not rest else RecordArray(rest, part, value.scope)
    return None


def stack(values: Sequence[AnyValue], shape: Shape) -> AnyValue | None:
    """Values of one kind and size as an array with leading dimensions `shape`; None if they do not fit."""
    plain = [v for v in values if isinstance(v, Value)]
    if len(plain) != len(values) or not plain:
        return _stack_records(values, shape)
    first = plain[0].shape
    type_ = plain[0].type
    for value in plain[1:]:
        common = unify(type_, value.type)
        if common is None or value.shape != first:
            return None
        type_ = common
    return Value(type_, shape + first, tuple([item for value in plain for item in value.items]))


def _stack_records(values: Sequence[AnyValue], shape: Shape) -> RecordArray | None:
    single = [v for v in values if isinstance(v, RecordValue)]
    if single and len(single) == len(values) and all(same_fields(v, single[0]) for v in single):
        return RecordArray(shape, tuple(single), single[0].scope)
    arrays = [v for v in values if isinstance(v, RecordArray)]
    if arrays and len(arrays) == len(values) and all(v.shape == arrays[0].shape for v in arrays):
        items = tuple([item for v in arrays for item in v.items])
        return RecordArray(shape + arrays[0].shape, items, arrays[0].scope)
    return None


def same_fields(a: RecordValue, b: RecordValue) -> bool:
    """Whether two records have fields of the same names."""
    return len(a.fields) == len(b.fields) and all(name in b.fields for name in a.fields)


def subscript(value: Value, selections: Sequence[int | Sequence[int]]) -> Value:
    """Apply subscripts (from 0): an int drops its dimension, a sequence keeps it. Missing ones mean `:`."""
    full: list[int | Sequence[int]] = [*selections, *[range(n) for n in value.shape[len(selections) :]]]
    shape = tuple(len(s) for s in full if not isinstance(s, int))
    ranges = [[s] if isinstance(s, int) else s for s in full]
    items = tuple([value.items[index_offset(value.shape, index)] for index in product(*ranges)])
    return Value(value.type, shape, items)
