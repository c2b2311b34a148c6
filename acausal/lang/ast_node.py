"""The decorator of syntax tree nodes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TypeVar, dataclass_transform

from acausal.errors import Span

_T = TypeVar("_T")


@dataclass_transform(frozen_default=True, kw_only_default=False, field_specifiers=(field,))
def node(cls: type[_T]) -> type[_T]:
    """Class decorator of AST nodes: immutable to a type checker, a plain slotted dataclass at run time."""
    make: Callable[[type[_T]], type[_T]] = dataclass(slots=True, eq=True)
    return make(cls)


def span_field() -> Span:
    """The span of a node: not part of its equality."""
    return field(compare=False, repr=False)
