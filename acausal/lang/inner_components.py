"""`inner` components for `outer` ones: found around, or added at the top of the model (Modelica 3.6, 5.4)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Protocol

from acausal.errors import AcausalError, Diagnostic, Span, TypeProblem, fail
from acausal.lang import ast
from acausal.lang.class_table import ComponentEntry
from acausal.lang.compatibility import class_difference
from acausal.lang.instance import Instance, Member, Outer
from acausal.lang.instance_errors import outer_modified
from acausal.lang.modifiers import NO_MODIFIER
from acausal.lang.scope import Scope
from acausal.lang.simple_types import SimpleTypes
from acausal.lang.translation import Translation


class _Builder(Protocol):
    def member(self, instance: Instance, name: str) -> Member | None:
        """The member `name` of a component."""
        ...

    def automatic(self, entry: ComponentEntry, root: Instance) -> Member:
        """An `inner` component built from the declaration of an `outer` one."""
        ...


class Inners:
    """Finds `inner` components; every one that it adds comes with a warning."""

    def __init__(self, builder: _Builder, translation: Translation, types: SimpleTypes) -> None:
        self._builder = builder
        self._translation = translation
        self._simple = types
        self._members: dict[str, Member] = {}
        self._types: dict[str, Scope] = {}
        self._added: dict[str, None] = {}

    def find(self, entry: ComponentEntry, instance: Instance, path: str) -> Member:
        """The `inner` component of this name in the nearest component around that has one.

        Where there is none, one is added. Raises `inner.*`.
        """
        around = instance.parent
        while around is not None:
            candidate = around.scope.table.components.get(entry.name)
            if candidate is not None and candidate.clause.prefixes.inner:
                return self._found(entry, around, path)
            if around.parent is None:
                return self.inner(entry, around, path)
            around = around.parent
        return self.inner(entry, instance, path)

    def _found(self, entry: ComponentEntry, around: Instance, path: str) -> Member:
        target = self._builder.member(around, entry.name)
        found = around.members.get(entry.name)
        own = found.own if isinstance(found, Outer) else target
        assert own is not None  # an `inner` component stands there
        scope = entry.scope.find_class(entry.clause.type)
        why = ""
        if isinstance(own, Instance) and own.scope is not scope:
            why = class_difference(own.scope, scope, self._simple)
        if why:
            raise _incompatible(entry, own, path, scope, why)
        return own

    def inner(self, entry: ComponentEntry, root: Instance, path: str) -> Member:
        """The component for an `outer` declaration. Raises `inner.missing`, `inner.ambiguous`."""
        scope = entry.scope.find_class(entry.clause.type)
        found = self._members.get(entry.name)
        if found is not None:
            if self._types[entry.name].node is not scope.node:
                raise _ambiguous(entry, path, self._types[entry.name], scope)
            return found
        other = root.scope.table.components.get(entry.name)
        taken = other is not None and not other.clause.prefixes.outer
        if scope.definition.class_prefixes.partial or taken:
            raise _missing(entry, path, scope)
        self._types[entry.name] = scope
        self._translation.warnings.append(_added(entry, path, scope))
        made = self._builder.automatic(entry, root)
        self._members[entry.name] = made
        return made

    def added_to(self, root: Instance) -> Iterator[Member]:
        """Put new components into the model; they are still to be completed."""
        for name, member in list(self._members.items()):
            if name not in self._added:
                self._added[name] = None
                root.members[name] = member
                yield member


def check_unmodified(entry: ComponentEntry, instance: Instance, path: str) -> None:
    """An `outer` component takes no modifications. Raises `inner.outer-modified`."""
    modifier = instance.modifier.children.get(entry.name, NO_MODIFIER)
    for found in (entry.own, modifier, *entry.through):
        if not found.is_empty:
            raise outer_modified(path, found.span or entry.declaration.span)


def _incompatible(entry: ComponentEntry, own: Member, path: str, scope: Scope, why: str) -> AcausalError:
    return fail(
        TypeProblem,
        "inner.incompatible",
        f"`{path}` is an `outer` `{scope.path}`, for which the `inner` `{own.path}` cannot stand: {why}",
        entry.declaration.span,
        names=[path, own.path],
        hint="the `inner` component must have all that the class of the `outer` one has",
    )


def _missing(entry: ComponentEntry, path: str, scope: Scope) -> AcausalError:
    why = f"`{scope.path}` is partial, so none can be added"
    if not scope.definition.class_prefixes.partial:
        why = f"the model has another component of the name `{entry.name}`"
    return fail(
        TypeProblem,
        "inner.missing",
        f"`{path}` is `outer`, but no component around it declares an `inner` `{entry.name}`; {why}",
        entry.declaration.span,
        names=[path],
        hint=_message(scope) or f"declare `inner ... {entry.name};` in a model that contains this component",
    )


def _ambiguous(entry: ComponentEntry, path: str, first: Scope, second: Scope) -> AcausalError:
    return fail(
        TypeProblem,
        "inner.ambiguous",
        f"no `inner` `{entry.name}` is declared, and the `outer` ones are of different classes: "
        f"`{first.path}` and `{second.path}`",
        entry.declaration.span,
        names=[path],
        hint=f"declare `inner ... {entry.name};` at the top of the model",
    )


def _added(entry: ComponentEntry, path: str, scope: Scope) -> Diagnostic:
    message = (
        f"no `inner` `{entry.name}` is declared for `{path}`: `inner {scope.path} {entry.name};` is added"
    )
    hint = _message(scope) or "declare it at the top of the model to choose its parameters"
    span = entry.declaration.span
    return Diagnostic("inner.added", message, span, (entry.name,), hint, "warning")


def no_outer_around(name: str, span: Span) -> Diagnostic:
    """The warning about an `inner outer` component at the top of a model: it stands for itself."""
    message = f"`{name}` is `inner outer`, but nothing around the model declares it; it is taken as `inner`"
    hint = "compile a model that contains this one and declares it `inner`"
    return Diagnostic("inner.added", message, span, (name,), hint, "warning")


def _message(scope: Scope) -> str:
    """The annotation `missingInnerMessage` of a class."""
    definition = scope.definition
    if isinstance(definition, ast.LongClass):
        annotation = definition.body.annotation
    else:
        annotation = definition.comment.annotation
    for argument in () if annotation is None else annotation.arguments:
        if isinstance(argument, ast.ElementModification) and argument.name == ("missingInnerMessage",):
            value = None if argument.modification is None else argument.modification.value
            if isinstance(value, ast.StringLiteral):
                return value.value
    return ""
