"""Interface compatibility of redeclarations (Modelica 3.6, 6.3 to 6.5 and 7.3.2).

A class may stand for its constraining class when it has every public component of it, of a compatible type
and with the same prefixes that connect to the outside, and every public class. What derives from the
constraining class is compatible by construction, and is not compared.
"""

from __future__ import annotations

from acausal.errors import AcausalError, Span, TypeProblem, fail
from acausal.lang import ast
from acausal.lang.class_table import ComponentEntry
from acausal.lang.redeclarations import declared_constraints
from acausal.lang.scope import Scope
from acausal.lang.simple_types import SimpleType, SimpleTypes

_MOST_LEVELS = 4
_MODELS = ("model", "block", "class")


def check_class_constraints(scope: Scope, types: SimpleTypes) -> None:
    """A class against its constraining clause and what it redeclares. Raises `redeclare.incompatible`."""
    _check_declaration(scope, types)
    new = scope
    for constraint in scope.constraints:
        why = _difference(new, constraint, types, 0)
        if why:
            raise _incompatible(f"`{scope.node.name}` is redeclared as", new, constraint, scope.span, why)
        new = constraint


def _check_declaration(scope: Scope, types: SimpleTypes) -> None:
    definition = scope.definition
    if definition.constraint is None or scope.enclosing is None:
        return
    constraint = scope.enclosing.find_class(definition.constraint.type)
    declared = scope.table.bases[0].scope if isinstance(definition, ast.ShortClass) else scope
    why = _difference(declared, constraint, types, 0)
    if why:
        raise _incompatible(f"`{scope.node.name}` is declared as", declared, constraint, scope.span, why)


def check_component_redeclaration(
    path: str, new: Scope, constraints: tuple[Scope, ...], span: Span, types: SimpleTypes
) -> None:
    """A component's type against its constraining types, each of which must be a subtype of the next.

    Raises `redeclare.incompatible`.
    """
    for constraint in constraints:
        why = _difference(new, constraint, types, 0)
        if why:
            raise _incompatible(f"`{path}` has the type", new, constraint, span, why)
        new = constraint


def check_component_declaration(entry: ComponentEntry, type_: Scope, types: SimpleTypes) -> None:
    """A declaration against its constraining clause and what it replaces. Raises `redeclare.incompatible`."""
    if entry.clause.constraint is not None or entry.replaces is not None:
        own = declared_constraints(entry)
        check_component_redeclaration(entry.name, type_, own, entry.declaration.span, types)


def class_difference(new: Scope, old: Scope, types: SimpleTypes) -> str:
    """Why a component of the class `new` cannot stand for one of `old`; empty if it can."""
    return _difference(new, old, types, 0)


def _incompatible(what: str, new: Scope, constraint: Scope, span: Span, why: str) -> AcausalError:
    return fail(
        TypeProblem,
        "redeclare.incompatible",
        f"{what} `{new.path}`, which cannot stand for `{constraint.path}`: {why}",
        span,
        names=[new.path, constraint.path],
        hint=f"extend `{constraint.path}`, or add what is missing",
    )


def _difference(new: Scope, old: Scope, types: SimpleTypes, level: int) -> str:
    """Why `new` cannot stand for `old`; empty if it can."""
    if new.node is old.node or old.node in new.table.lineage or level > _MOST_LEVELS:
        return ""
    simple = types.of(new)
    if isinstance(old.definition, ast.EnumerationClass) and old.definition.literals is None:
        return "" if simple is not None and simple.scalar.is_enumeration else "it is no enumeration"
    wanted = types.of(old)
    if simple is not None and wanted is not None:
        if simple.scalar.literals == wanted.scalar.literals and (
            simple.scalar.is_enumeration or simple.scalar == wanted.scalar
        ):
            same = level > 0 or _rank(simple) == _rank(wanted)  # of components, all dimensions are compared
            return "" if same else "the numbers of dimensions differ"
        return f"one is {simple.scalar}, the other {wanted.scalar}"
    if (simple is None) != (wanted is None) and (old.table.components or wanted is not None):
        return "only one of them is a simple type"
    if new.kind != old.kind and not (new.kind in _MODELS and old.kind in _MODELS):
        return f"one is a {new.kind}, the other a {old.kind}"
    return _missing_parts(new, old, types, level)


def _missing_parts(new: Scope, old: Scope, types: SimpleTypes, level: int) -> str:
    for name, entry in old.table.components.items():
        if entry.protected or (old.kind == "function" and not entry.clause.causality):
            continue
        mine = new.table.components.get(name)
        if mine is None:
            return f"it has no `{name}`"
        if mine.protected:
            return f"its `{name}` is protected"
        why = _entry_difference(mine, entry, types, level)
        if why:
            return f"in `{name}`, {why}"
    for name in old.table.classes:
        if new.find_class_entry(name) is None:
            return f"it has no class `{name}`"
    return ""


def _entry_difference(mine: ComponentEntry, entry: ComponentEntry, types: SimpleTypes, level: int) -> str:
    if mine.clause.flow != entry.clause.flow:
        return "one is a flow variable, the other is not"
    if mine.clause.causality != entry.clause.causality:
        return "one is an input or an output, the other is not the same"
    new, old = mine.scope.find_class(mine.clause.type), entry.scope.find_class(entry.clause.type)
    if _dimensions(mine) + _rank(types.of(new)) != _dimensions(entry) + _rank(types.of(old)):
        return "the numbers of dimensions differ"
    if mine.clause.variability == "" and entry.clause.variability in ("parameter", "constant"):
        return f"one is a variable, the other a {entry.clause.variability}"
    return _difference(new, old, types, level + 1)


def _rank(simple: SimpleType | None) -> int:
    return 0 if simple is None else sum(len(subscripts.items) for subscripts, _ in simple.dimensions)


def _dimensions(entry: ComponentEntry) -> int:
    written: list[ast.Subscripts | None] = [entry.declaration.dimensions, entry.clause.dimensions]
    return sum(len(d.items) for d in written if d is not None)
