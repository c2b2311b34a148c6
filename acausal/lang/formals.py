"""What the inputs of overloaded functions take, to find the one that a call fits (Modelica 3.6, 14.2)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from acausal.lang import ast
from acausal.lang.flat import ScalarType
from acausal.lang.function_frame import declared_rank, default_of
from acausal.lang.library import ClassNode
from acausal.lang.light import light_object
from acausal.lang.scope import Scope
from acausal.lang.values import AnyValue, RecordArray, RecordValue, Value, shape_of

if TYPE_CHECKING:
    from acausal.lang.class_table import ComponentEntry
    from acausal.lang.translation import Translation


@light_object
class Formal:
    """An input of a function: its type (the class node of a record), its class, its number of dimensions."""

    name: str
    type: ScalarType | ClassNode
    scope: Scope
    rank: int
    optional: bool

    def takes(self, value: AnyValue, *, spread: bool = False) -> bool:
        """Whether a value is of this type; Integer and Real count as the same.

        With `spread` it may have more dimensions, for a call element by element.
        """
        rank = len(shape_of(value))
        if rank != self.rank and not (spread and rank > self.rank):
            return False
        if isinstance(value, Value):
            if not isinstance(self.type, ScalarType):
                return False
            return value.type == self.type or (value.type.is_numeric and self.type.is_numeric)
        scope = class_of(value)
        return scope is not None and record_class(scope).node is self.type


def formals_of(translation: Translation, function: Scope) -> tuple[Formal, ...]:
    """The public inputs of a function, found once."""
    found = translation.formals.get(function)
    if found is None:
        entries = [
            e for e in function.table.components.values() if e.clause.causality == "input" and not e.protected
        ]
        found = tuple([_formal(translation, entry) for entry in entries])
        translation.formals[function] = found
    return found


def _formal(translation: Translation, entry: ComponentEntry) -> Formal:
    scope = entry.scope.find_class(entry.clause.type)
    simple = translation.instances.simple_type(scope)
    type_ = record_class(scope).node if simple is None else simple.scalar
    return Formal(entry.name, type_, scope, declared_rank(translation, entry), default_of(entry) is not None)


def record_class(scope: Scope) -> Scope:
    """The record that a short class stands for."""
    while isinstance(scope.definition, ast.ShortClass):
        scope = scope.table.bases[0].scope
    return scope


def class_of(value: AnyValue) -> Scope | None:
    """The class of a record or of the elements of an array of records."""
    if isinstance(value, RecordArray):
        return value.items[0].scope if value.items else value.scope
    return value.scope if isinstance(value, RecordValue) else None
