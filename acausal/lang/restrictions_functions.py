"""The formal parameters and variables of a function, judged by their types (Modelica 3.6, 4.5.1 and 12.2).

`complete_formals` runs once per function, before its first call.
"""

from __future__ import annotations

from dataclasses import replace

from acausal.errors import AcausalError, TypeProblem, fail
from acausal.lang.class_table import ComponentEntry
from acausal.lang.compatibility import check_class_constraints
from acausal.lang.flat import Causality
from acausal.lang.predefined import EXTERNAL_OBJECT
from acausal.lang.scope import Scope
from acausal.lang.simple_types import SimpleTypes

_KINDS = ("record", "type", "function")


def check_used(scope: Scope, types: SimpleTypes) -> None:
    """What is checked at the first use of a class: its constraints, and the formals of a function."""
    check_class_constraints(scope, types)
    if scope.kind == "function":
        complete_formals(scope, types)


def complete_formals(function: Scope, types: SimpleTypes) -> None:
    """Give parameters the direction of their type (`type In = input Real`), and check them all.

    Raises `function.component` for a model and the like, `function.public` for a public variable.
    """
    components = function.table.components
    for name, entry in components.items():
        type_ = entry.scope.find_class(entry.clause.type)
        simple = types.of(type_)
        if simple is None and type_.kind not in _KINDS and not _is_external(type_):
            what = (
                f"is of the {type_.kind} `{type_.path}`, but functions hold types, records and functions only"
            )
            raise _error("function.component", function, entry, what)
        if entry.clause.causality or entry.protected:
            continue
        if simple is not None and simple.causality is not Causality.LOCAL:
            direction = "input" if simple.causality is Causality.INPUT else "output"
            components[name] = replace(entry, clause=replace(entry.clause, causality=direction))
        else:
            raise _error("function.public", function, entry, "is public, but neither input nor output")


def _is_external(scope: Scope) -> bool:
    return scope.path == EXTERNAL_OBJECT or any(b.scope.path == EXTERNAL_OBJECT for b in scope.table.bases)


def _error(code: str, function: Scope, entry: ComponentEntry, what: str) -> AcausalError:
    return fail(
        TypeProblem,
        code,
        f"`{entry.name}` of the function `{function.path}` {what}",
        entry.declaration.span,
        names=[function.path, entry.name],
        hint="make it protected, or give it `input` or `output`; see Modelica 3.6, 12.2",
    )
