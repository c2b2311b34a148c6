"""Nodes of the tree that are read from their text when one first looks into them.

An unread node is an instance of a subclass whose late fields are properties. The first access reads the
node, fills the fields and makes it an instance of the node class itself: from then on it is a node like
any other, and before that `isinstance`, `match` and `==` see no difference.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from typing import Any, TypeVar

from acausal.errors import Span
from acausal.lang import ast
from acausal.lang.outline import ClassMark

_N = TypeVar("_N", bound=ast.ClassDefinition | ast.Annotation)


def unread_class(mark: ClassMark, span: Span, read: Callable[[], ast.ClassDefinition]) -> ast.ClassDefinition:
    """The class of a mark; `read` gives it in full."""
    base = mark.node_type
    known = (mark.name, mark.kind, mark.prefixes, mark.class_prefixes, span)
    node = _unread(base, ("name", "kind", "prefixes", "class_prefixes", "span"), known, read)
    if base is ast.LongClass:
        _SLOTS[base]["extends"].__set__(node, mark.extends)
    return node


def unread_annotation(span: Span, read: Callable[[], ast.Annotation]) -> ast.Annotation:
    """An annotation of which only the place is known."""
    return _unread(ast.Annotation, ("span",), (span,), read)


_EARLY = frozenset(("name", "kind", "prefixes", "class_prefixes", "extends", "span"))
_BASES = (ast.LongClass, ast.ShortClass, ast.EnumerationClass, ast.Annotation)
_SLOTS: dict[type[object], dict[str, Any]] = {
    base: {field.name: vars(base)[field.name] for field in fields(base)} for base in _BASES
}
"""Where a node keeps its fields, past the properties of its unread variant."""
_LATE = {base: [name for name in slots if name not in _EARLY] for base, slots in _SLOTS.items()}


def _unread(
    base: type[_N], names: tuple[str, ...], values: tuple[object, ...], read: Callable[[], object]
) -> _N:
    """A node with some fields; `read` waits where the first late field will be."""
    node: _N = object.__new__(_VARIANTS[base])
    slots = _SLOTS[base]
    for name, value in zip(names, values, strict=True):
        slots[name].__set__(node, value)
    slots[_LATE[base][0]].__set__(node, read)
    return node


def _variant(base: type[object]) -> type[Any]:
    """The subclass of unread nodes."""
    late = {name: _SLOTS[base][name] for name in _LATE[base]}
    first = late[_LATE[base][0]]

    def load(node: Any) -> None:
        if node.__class__ is base:
            return  # another thread was faster
        whole = first.__get__(node)()
        for slot in late.values():
            slot.__set__(node, slot.__get__(whole))
        node.__class__ = base

    def value_of(name: str) -> property:
        def value(node: Any) -> object:
            load(node)
            return late[name].__get__(node)

        return property(value)

    def equals(node: Any, other: object) -> bool:
        load(node)
        return node == other

    members = {name: value_of(name) for name in late} | {"__slots__": (), "__eq__": equals}
    return type(base.__name__, (base,), members)


_VARIANTS: dict[type[object], type[Any]] = {base: _variant(base) for base in _BASES}
