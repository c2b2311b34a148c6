"""What a `connect` names in expandable connectors, declared or not (Modelica 3.6, 9.1.3)."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

from acausal.lang import ast
from acausal.lang.arithmetic import as_value, type_error
from acausal.lang.instance import Absent, Array, Instance, Member, Outer
from acausal.lang.light import light_object
from acausal.lang.references import Selection, select, select_part_of
from acausal.lang.translation import Env, Translation
from acausal.lang.values import index_offset

MAX_INDEX = 10_000
"""Largest index of an array that connections introduce."""


@light_object
class Missing:
    """An element of an expandable connector that nothing has declared yet; `index` counts from 1."""

    bus: Instance
    name: str
    index: tuple[int, ...]


@light_object
class Place:
    """One side of a connection; `passed` are the members of expandable connectors on the way to it."""

    items: tuple[Member | Missing, ...]
    shape: tuple[int, ...]
    passed: tuple[Member, ...]

    @property
    def is_complete(self) -> bool:
        return not any(isinstance(item, Missing) for item in self.items)


def locate(translation: Translation, node: ast.ComponentReference, env: Env) -> Place | None:
    """Where a side of `connect` leads; None if it leads through something undeclared.

    Raises what `connect` itself raises for names outside expandable connectors.
    """
    env = env.with_connecting()
    instance = env.context.instance
    first = None if instance is None else translation.instances.member(instance, node.parts[0].name)
    if first is None:
        return None  # an error that the connection itself reports
    selection = select(translation, first, node.parts[:1], env, constant=False)
    passed: list[Member] = []
    for i, part in enumerate(node.parts[1:], start=2):
        buses = [m for m in selection.members if isinstance(m, Instance) and m.is_expandable]
        if buses and len(buses) == len(selection.members):
            missing = _missing(translation, buses, part, env)
            if missing is not None:
                whole = missing[0] if i == len(node.parts) else None
                shape = selection.shape + missing[1]
                return None if whole is None else Place(tuple(whole), shape, tuple(passed))
            selection = select_part_of(translation, selection, part, env)
            passed += [m for m in selection.members if not isinstance(m, Absent)]
            passed += [a for bus in buses if isinstance(a := bus.members[part.name], Array)]
        else:
            selection = select_part_of(translation, selection, part, env)
    return Place(_elements(selection), _shape(selection), tuple(passed))


def _elements(selection: Selection) -> tuple[Member, ...]:
    if not selection.shape and len(selection.members) == 1 and isinstance(selection.members[0], Array):
        return selection.members[0].items
    return selection.members


def _shape(selection: Selection) -> tuple[int, ...]:
    if not selection.shape and len(selection.members) == 1 and isinstance(selection.members[0], Array):
        return selection.members[0].shape
    return selection.shape


def _missing(
    translation: Translation, buses: Sequence[Instance], part: ast.NamePart, env: Env
) -> tuple[list[Member | Missing], tuple[int, ...]] | None:
    """Elements of that name, those not yet there among them; None if all are there."""
    found = [bus.members.get(part.name) for bus in buses]
    if part.subscripts is None:
        whole = [_present(bus, part.name, ()) for bus in buses]
        return (whole, ()) if any(isinstance(member, Missing) for member in whole) else None
    if any(isinstance(item, ast.Colon) for item in part.subscripts.items) and None not in found:
        return None
    axes = [_indices(translation, item, env) for item in part.subscripts.items]
    shape = tuple([len(axis) for axis, single in axes if not single])
    elements = [
        _present(bus, part.name, index) for bus in buses for index in product(*[axis for axis, _ in axes])
    ]
    if any(isinstance(element, Missing) for element in elements):
        return elements, shape
    return None


def _present(bus: Instance, name: str, index: tuple[int, ...]) -> Member | Missing:
    """The element, if it is there."""
    member = bus.members.get(name)
    missing = Missing(bus, name, index)
    if member is None or isinstance(member, Outer):
        return missing
    if not index:
        empty = isinstance(member, Array) and not member.items
        return missing if empty and is_growing(bus, name) else member
    if not isinstance(member, Array) or len(index) != len(member.shape):
        return member  # refused when the subscripts are applied
    if any(not 1 <= i <= size for i, size in zip(index, member.shape, strict=True)):
        return missing if is_growing(bus, name) else member
    item = member.items[index_offset(member.shape, [i - 1 for i in index])]
    return missing if isinstance(item, Absent) else item


def is_growing(bus: Instance, name: str) -> bool:
    """Whether an array of an expandable connector has no declared size."""
    entry = bus.scope.table.components.get(name)
    if entry is None:
        return True
    written = (entry.declaration.dimensions, entry.clause.dimensions)
    return any(isinstance(item, ast.Colon) for d in written if d is not None for item in d.items)


def _indices(translation: Translation, item: ast.Expression, env: Env) -> tuple[list[int], bool]:
    """The indices of one subscript, and whether it is a single one."""
    if isinstance(item, ast.Colon):
        message = "the size of an array that only connections declare is not known here"
        raise type_error("expandable.sizeless", message, item.span, "name its elements by their index")
    value = as_value(translation.value(item, env), item.span)
    found = [translation.evaluate_expr(x, item.span, "the subscript of a connector") for x in value.items]
    numbers = [n for n in found if isinstance(n, int) and not isinstance(n, bool) and 1 <= n <= MAX_INDEX]
    if len(numbers) != len(found) or len(value.shape) > 1:
        message = f"a subscript in `connect` is an Integer from 1 to {MAX_INDEX}"
        raise type_error("type.subscript", message, item.span)
    return numbers, not value.shape
