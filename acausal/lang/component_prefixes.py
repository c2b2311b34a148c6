"""The prefixes of components: what is written under what the component around hands down."""

from __future__ import annotations

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
    )


def with_causality(prefixes: Prefixes, causality: Causality) -> Prefixes:
    """The same prefixes with another causality."""
    return Prefixes(prefixes.variability, causality, prefixes.connection, prefixes.protected, prefixes.final)


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
        return Prefixes(
            Variability.DISCRETE,
            prefixes.causality,
            prefixes.connection,
            prefixes.protected,
            prefixes.final,
        )
    return prefixes
