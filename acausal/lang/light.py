"""Immutable data that is built by the hundred thousand.

A frozen dataclass takes several times as long to build as a plain one, and a large model has millions of
members, bindings and equations. These decorators give classes that are immutable to the type checker and
plain slotted dataclasses at run time.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeVar, dataclass_transform

_T = TypeVar("_T")


@dataclass_transform(frozen_default=True, eq_default=True)
def light_value(cls: type[_T]) -> type[_T]:
    """A value: equal when its fields are, and hashable."""
    return dataclass(slots=True, eq=True, unsafe_hash=True)(cls)


@dataclass_transform(frozen_default=True, eq_default=False)
def light_object(cls: type[_T]) -> type[_T]:
    """A thing with an identity: equal to itself only."""
    return dataclass(slots=True, eq=False)(cls)
