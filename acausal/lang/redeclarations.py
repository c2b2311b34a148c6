"""Redeclared classes, and what a redeclaration may not change (Modelica 3.6, 7.3.2 and 7.3.3)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from acausal.errors import AcausalError, LookupProblem, Span, TypeProblem, fail
from acausal.lang import ast
from acausal.lang.library import ClassNode
from acausal.lang.light import light_object
from acausal.lang.modifiers import (
    NO_MODIFIER,
    Context,
    Modifier,
    Redeclaration,
    merge,
    modifier_of,
    not_replaceable,
    overrides_final,
)

if TYPE_CHECKING:  # the table of a class asks here while it is built
    from acausal.lang.class_table import ClassEntry, ComponentEntry
    from acausal.lang.scope import Scope


def check_component_element(old: ComponentEntry, new: ComponentEntry) -> None:
    """A `redeclare` element for an inherited component. Raises `redeclare.*`, `modification.final`."""
    if old.clause.prefixes.final:
        raise overrides_final(old.name, new.declaration.span, old.declaration.span)
    check_not_constant(old, new.declaration.span)
    if old.protected != new.protected:
        raise _visibility(old.name, old.protected, new.declaration.span, old.declaration.span)


def check_class_element(old: ClassEntry, new: ast.ClassDefinition, protected: bool) -> None:
    """A `redeclare` element for an inherited class. Raises `redeclare.visibility`, `modification.final`."""
    definition = old.node.definition
    if definition.prefixes.final:
        raise overrides_final(old.name, new.span, definition.span)
    if protected != new.prefixes.protected:
        raise _visibility(old.name, protected, new.span, definition.span)


def same_class(a: ast.ClassDefinition, b: ast.ClassDefinition) -> bool:
    """Whether two definitions say the same, descriptions and annotations aside (7.1)."""
    if isinstance(a, ast.ShortClass) and isinstance(b, ast.ShortClass):
        return _short_contents(a) == _short_contents(b)
    return a is b or a == b


def _short_contents(definition: ast.ShortClass) -> tuple[object, ...]:
    constraint = definition.constraint
    return (
        definition.kind,
        definition.class_prefixes,
        definition.prefixes,
        definition.causality,
        definition.base,
        definition.dimensions,
        definition.modification,
        None if constraint is None else (constraint.type, constraint.modification),
    )


def inherited_class(name: str, span: Span, where: Span) -> AcausalError:
    """The error for a class that is inherited and declared too (7.1)."""
    return fail(
        TypeProblem,
        "redeclare.missing",
        f"`{name}` is inherited, so it cannot be declared again without `redeclare`",
        span,
        names=[name],
        hint=f"write `redeclare`, or use another name; it is inherited from {where}",
    )


def check_not_constant(old: ComponentEntry, span: Span) -> None:
    """Constants keep their declaration. Raises `redeclare.constant`."""
    if old.clause.variability == "constant":
        raise fail(
            TypeProblem,
            "redeclare.constant",
            f"`{old.name}` is constant and cannot be redeclared",
            span,
            names=[old.name],
            hint=f"it is declared at {old.declaration.span}; modify its value (Modelica 3.6, 7.3.3)",
        )


def _visibility(name: str, protected: bool, span: Span, where: Span) -> AcausalError:
    old, new = ("protected", "public") if protected else ("public", "protected")
    return fail(
        TypeProblem,
        "redeclare.visibility",
        f"the {old} `{name}` cannot be redeclared as {new}",
        span,
        names=[name],
        hint=f"redeclare it in a {old} section; it is declared at {where} (Modelica 3.6, 7.3.3)",
    )


# --------------------------------------------------------------------------- classes


@light_object
class NestedClass:
    """What the scope of a nested class is made of; see `Scope`."""

    node: ClassNode
    enclosing: Scope
    modifier: Modifier
    below: Modifier
    constraints: tuple[Scope, ...]


def redeclared_class(entry: ClassEntry) -> NestedClass:
    """A nested class that is redeclared or modified from outside. Raises `redeclare.*`."""
    if entry.busy:
        span = entry.node.definition.span
        message = f"the constraining class of `{entry.name}` is `{entry.name}` itself"
        raise fail(TypeProblem, "redeclare.cyclic", message, span, names=[entry.name])
    entry.busy = True
    try:
        return _nested_class(entry)
    finally:
        entry.busy = False


def _nested_class(entry: ClassEntry) -> NestedClass:
    modifier = entry.modifier
    redeclaration = modifier.redeclaration
    if redeclaration is None:
        return NestedClass(entry.node, entry.scope, modifier, NO_MODIFIER, ())
    rest = Modifier(children=modifier.children) if modifier.children else NO_MODIFIER
    if redeclaration.node is None:
        raise fail(
            LookupProblem,
            "redeclare.kind",
            f"`{entry.name}` is a class, but it is redeclared as a component",
            redeclaration.span,
            names=[entry.name],
        )
    prefixes = entry.node.definition.prefixes
    if not prefixes.replaceable:
        raise not_replaceable(entry.name, redeclaration.span, entry.node.definition.span)
    if prefixes.final:
        raise overrides_final(entry.name, redeclaration.span, entry.node.definition.span)
    where = redeclaration.context.scope
    constraints = (*redeclared_constraints(redeclaration), _constraint(entry))
    kept = merge(redeclared_modifier(redeclaration), kept_modifier(entry), entry.name)
    return NestedClass(redeclaration.node, where, rest, kept, constraints)


def redeclared_modifier(redeclaration: Redeclaration) -> Modifier:
    """What the constraining clauses of redeclarations modify, which all later ones keep (7.3.2)."""
    kept = NO_MODIFIER
    current: Redeclaration | None = redeclaration
    while current is not None:
        if current.constraint is not None:
            kept = merge(kept, modifier_of(current.constraint.modification, current.context))
        current = current.previous
    return kept


def redeclared_constraints(redeclaration: Redeclaration) -> tuple[Scope, ...]:
    """The constraining classes that redeclarations gave, the last first (7.3.2)."""
    found: list[Scope] = []
    current: Redeclaration | None = redeclaration
    while current is not None:
        if current.constraint is not None:
            found.append(current.context.scope.find_class(current.constraint.type))
        current = current.previous
    return tuple(found)


def kept_modifier(entry: ClassEntry) -> Modifier:
    """The modifications that every redeclaration of a replaceable class keeps (7.3.2)."""
    definition = entry.node.definition
    if definition.constraint is not None:
        return modifier_of(definition.constraint.modification, Context(entry.scope, None))
    if isinstance(definition, ast.ShortClass):
        return modifier_of(definition.modification, Context(entry.scope, None))
    return NO_MODIFIER


def _constraint(entry: ClassEntry) -> Scope:
    """The class that every redeclaration of a replaceable class must be compatible with."""
    constraint = entry.node.definition.constraint
    if constraint is not None:
        return entry.scope.find_class(constraint.type)
    return entry.scope.plain_nested(entry)


def constraints_of(redeclaration: Redeclaration, entry: ComponentEntry) -> tuple[Scope, ...]:
    """The constraining types of a redeclared component, the nearest first (7.3.2)."""
    return (*redeclared_constraints(redeclaration), *declared_constraints(entry))


def declared_constraints(entry: ComponentEntry) -> tuple[Scope, ...]:
    """The constraining types of a component and of those that it replaces, the nearest first (7.3.2)."""
    found: list[Scope] = []
    current: ComponentEntry | None = entry
    while current is not None:
        if current.clause.constraint is not None:
            found.append(current.scope.find_class(current.clause.constraint.type))
        elif current.replaces is None:
            found.append(current.scope.find_class(current.clause.type))
        current = current.replaces
    return tuple(found)
