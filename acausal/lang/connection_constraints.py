"""Equations for the broken connections of overconstrained connectors (Modelica 3.6, 9.4.2)."""

from __future__ import annotations

from collections.abc import Mapping

from acausal.lang.arithmetic import as_value
from acausal.lang.connections import ConnectionSets
from acausal.lang.flat import Equation, Origin
from acausal.lang.instance import Instance
from acausal.lang.modifiers import Context
from acausal.lang.references import Selection, selection_value
from acausal.lang.scope import Scope
from acausal.lang.translation import Env, Translation
from acausal.lang.value_calls import call_with
from acausal.symbolic.expressions import expr as ex


def constraint_equations(
    translation: Translation, sets: ConnectionSets, functions: Mapping[str, Scope], root: Instance
) -> list[Equation]:
    """`0 = equalityConstraint(a, b)` for every connection that is no part of a spanning tree."""
    env = Env(Context(root.scope, root))
    equations: list[Equation] = []
    for a, b, span, component in sets.constraints:
        values = [selection_value(translation, Selection((x,), (), None), span) for x in (a, b)]
        residue = as_value(call_with(translation, functions[a.path], values, span, env), span)
        equations += [Equation(item, ex.ZERO, span, component, Origin.CONNECTION) for item in residue.items]
    return equations
