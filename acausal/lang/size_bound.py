"""How large a model will become, told from its classes long before all of it is built."""

from __future__ import annotations

from collections.abc import Iterable
from math import prod

from acausal.errors import AcausalError
from acausal.lang import ast
from acausal.lang.class_table import ComponentEntry
from acausal.lang.instance import Array, Instance, Member, Outer
from acausal.lang.instance_errors import too_large
from acausal.lang.scope import Scope
from acausal.lang.simple_types import SimpleTypes

MAX_MEMBERS = 500_000
"""Most components and scalars of a model."""
_FIRST_LOOK = 10_000
_OPEN = -1
_MOST_RECURSIVE = 10_000
"""The same where a class contains itself, under a condition: it may branch for ever."""
_ABSURD = 20
"""Classes count conditional components as there: they must promise this many times too much to be refused."""


class SizeBound:
    """Counts what is built, and looks ahead after the first ten thousand, at every doubling from there."""

    def __init__(self, types: SimpleTypes) -> None:
        self._types = types
        self._sizes: dict[Scope, int] = {}
        self._next_look = _FIRST_LOOK
        self._recursive = False

    def look_ahead(self, count: int, waiting: Iterable[tuple[Member | Outer, int]]) -> None:
        """Refuse a model whose components that wait to be built promise too many. Raises `too-large`."""
        if count < self._next_look:
            return
        self._next_look = 2 * count
        for member, _ in waiting:
            if isinstance(member, (Instance, Array)) and self._promised(member) > _ABSURD * MAX_MEMBERS:
                raise too_large(member.path, member.span, MAX_MEMBERS)
            if self._recursive and count >= _MOST_RECURSIVE:
                raise too_large(member.path, member.span, _MOST_RECURSIVE)

    def _promised(self, member: Instance | Array) -> int:
        if isinstance(member, Instance):
            return self._size(member.scope)
        first = next((item for item in member.items if isinstance(item, (Instance, Array))), None)
        return 0 if first is None else len(member.items) * self._promised(first)

    def _size(self, scope: Scope) -> int:
        """Components and scalars below one of this class; 0 where it leads back to itself."""
        found = self._sizes.get(scope)
        if found is None:
            self._sizes[scope] = _OPEN
            found = sum([self._of_entry(entry) for entry in scope.table.components.values()])
            self._sizes[scope] = found
        if found == _OPEN:
            self._recursive = True
            return 0
        return found

    def _of_entry(self, entry: ComponentEntry) -> int:
        condition = entry.declaration.condition
        if isinstance(condition, ast.BooleanLiteral) and not condition.value:
            return 0
        try:
            type_ = entry.scope.find_class(entry.clause.type, complete=True)
            below = 0 if self._types.of(type_) is not None else self._size(type_)
        except AcausalError:  # told where the component is built, if it is
            return 1
        written = (entry.declaration.dimensions, entry.clause.dimensions)
        items = [item for sizes in written if sizes is not None for item in sizes.items]
        return (1 + below) * prod([item.value for item in items if isinstance(item, ast.IntegerLiteral)])
