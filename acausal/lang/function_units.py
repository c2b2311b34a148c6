"""The units that functions declare of their results (Modelica 3.6, 19): inlining leaves expressions only."""

from __future__ import annotations

from acausal.lang import ast
from acausal.lang.class_table import ComponentEntry
from acausal.lang.flat import REAL
from acausal.lang.translation import Translation
from acausal.lang.values import AnyValue, Value


def note_unit(translation: Translation, entry: ComponentEntry, value: AnyValue) -> None:
    """Remember the unit of an output: what its function makes of the units of others is its own business."""
    if not isinstance(value, Value) or value.type != REAL:
        return
    unit = _declared_unit(translation, entry)
    for item in value.items if unit else ():
        if not item.is_const:
            translation.declared_units[item] = unit


def _declared_unit(translation: Translation, entry: ComponentEntry) -> str:
    """The unit written in the declaration or in its type; empty if there is none."""
    modification = entry.declaration.modification
    for argument in () if modification is None else modification.arguments:
        if isinstance(argument, ast.ElementModification) and argument.name == ("unit",):
            return _text(None if argument.modification is None else argument.modification.value)
    simple = translation.instances.simple_type(entry.scope.find_class(entry.clause.type))
    binding = None if simple is None else simple.attributes.get("unit")
    return "" if binding is None else _text(binding.expression)


def _text(value: ast.Expression | ast.Break | None) -> str:
    return value.value if isinstance(value, ast.StringLiteral) else ""
