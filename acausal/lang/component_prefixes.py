"""The prefixes of components: what is written under what the component around hands down."""

from __future__ import annotations

from dataclasses import replace

from acausal.lang import ast
from acausal.lang.class_table import ComponentEntry
from acausal.lang.flat import REAL, Causality, ScalarType, Variability
from acausal.lang.instance import Connection, Prefixes
from acausal.lang.scope import Scope
from acausal.lang.simple_types import CAUSALITY

_VARIABILITY = {
    "": Variability.CONTINUOUS,
    "discrete": Variability.DISCRETE,
    "parameter": Variability.PARAMETER,
    "constant": Variability.CONSTANT,
}
_CONNECTION = {"": Connection.POTENTIAL, "flow": Connection.FLOW, "stream": Connection.STREAM}


def component_prefixes(entry: ComponentEntry, clause: ast.ComponentClause, outer: Prefixes) -> Prefixes:
    """Those of the declaration (of a redeclaration where it has some) under those of the component around."""
    original = entry.clause
    connection = _CONNECTION[clause.flow or original.flow]
    causality = CAUSALITY[clause.causality or original.causality]
    return Prefixes(
        min(outer.variability, _VARIABILITY[clause.variability or original.variability]),
        causality if causality is not Causality.LOCAL else outer.causality,
        connection if connection is not Connection.POTENTIAL else outer.connection,
        outer.protected or entry.protected,
        clause.prefixes.final,
        _evaluated(entry, clause, outer),
    )


def _evaluated(entry: ComponentEntry, clause: ast.ComponentClause, outer: Prefixes) -> bool:
    """What the declaration's annotation `Evaluate` says; where it is silent, what the record around says."""
    declaration = entry.declaration if clause is entry.clause else clause.declarations[0]
    annotation = declaration.comment.annotation
    for argument in () if annotation is None else annotation.arguments:
        if isinstance(argument, ast.ElementModification) and argument.name == ("Evaluate",):
            value = None if argument.modification is None else argument.modification.value
            return isinstance(value, ast.BooleanLiteral) and value.value
    return outer.evaluate


def with_causality(prefixes: Prefixes, causality: Causality) -> Prefixes:
    """The same prefixes with another causality."""
    return replace(prefixes, causality=causality)


def inherit_kind(prefixes: Prefixes, scope: Scope) -> Prefixes:
    """Input and output reach into connectors and records, not into models.

    A connector may bring its own: `connector C = input R`.
    """
    definition = scope.definition
    if prefixes.causality is Causality.LOCAL and isinstance(definition, ast.ShortClass):
        own = CAUSALITY[definition.causality]
        return prefixes if own is Causality.LOCAL else with_causality(prefixes, own)
    if prefixes.causality is not Causality.LOCAL and scope.kind in ("model", "block", "class"):
        return with_causality(prefixes, Causality.LOCAL)
    return prefixes


def discrete_default(prefixes: Prefixes, type_: ScalarType) -> Prefixes:
    """Variables that are not Real change only at events (Modelica 3.6, 4.5)."""
    if prefixes.variability is Variability.CONTINUOUS and type_ != REAL:
        return replace(prefixes, variability=Variability.DISCRETE)
    return prefixes
