"""Modifications as trees: what `(a.b(start = 1) = 2, redeclare model M = X)` says, and in which context.

Merging follows Modelica 3.6, 7.2.4: an outer modification wins over an inner one, attribute by attribute;
a `final` one cannot be overridden (7.2.6); `each` gives every element of an array the same value (7.2.5).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from acausal.errors import Span, TypeProblem, UnsupportedProblem, fail
from acausal.lang import ast

if TYPE_CHECKING:
    from acausal.lang.instance import Instance
    from acausal.lang.scope import Scope


@dataclass(frozen=True, slots=True, eq=False)
class Context:
    """Where an expression was written: its class and the component it belongs to.

    `instance` is None in the modifiers of classes until a component is built from them (`bound`), and in
    packages and functions.
    """

    scope: Scope
    instance: Instance | None


@dataclass(frozen=True, slots=True, eq=False)
class Binding:
    """An expression in its context.

    `selectors` pick the part that falls to one element of an array (an index from 0) or one field of a
    record (its name). `memo` holds the translated whole, shared by all parts.
    """

    expression: ast.Expression
    context: Context
    span: Span
    selectors: tuple[int | str, ...] = ()
    each: bool = False
    memo: list[Any] = field(default_factory=lambda: [])

    def part(self, selector: int | str) -> Binding:
        return replace(self, selectors=(*self.selectors, selector))


@dataclass(frozen=True, slots=True, eq=False)
class Redeclaration:
    """`redeclare ...` or a `replaceable` inside a modification, in its context."""

    element: ast.ShortClass | ast.LongClass | ast.EnumerationClass | ast.DerClass | ast.ComponentClause
    context: Context
    span: Span


@dataclass(frozen=True, slots=True, eq=False)
class Modifier:
    """One node of a modification tree."""

    binding: Binding | None = None
    children: dict[str, Modifier] = field(default_factory=lambda: {})
    redeclaration: Redeclaration | None = None
    final: bool = False
    span: Span | None = None

    def child(self, name: str) -> Modifier:
        return self.children.get(name, NO_MODIFIER)

    @property
    def is_empty(self) -> bool:
        return self.binding is None and not self.children and self.redeclaration is None


NO_MODIFIER = Modifier()


def modifier_of(modification: ast.Modification | None, context: Context, span: Span | None = None) -> Modifier:
    """The tree of one modification as written."""
    if modification is None:
        return NO_MODIFIER
    tree = modifier_of_arguments(modification.arguments, context)
    value = modification.value
    if value is None:
        return replace(tree, span=span or modification.span)
    if isinstance(value, ast.Break):
        raise fail(UnsupportedProblem, "unsupported.break", "`= break` is not supported yet", value.span)
    return replace(tree, binding=Binding(value, context, modification.span), span=span or modification.span)


def modifier_of_arguments(arguments: Iterable[ast.Argument], context: Context) -> Modifier:
    """The tree of a list of arguments. Two modifications of one element are an error (7.2.4)."""
    children: dict[str, Modifier] = {}
    for argument in arguments:
        if isinstance(argument, ast.BreakConnect):
            raise fail(
                UnsupportedProblem, "unsupported.selective-extension", "`break` in a modification is not supported yet", argument.span
            )
        name, child = _argument(argument, context)
        children[name] = _join(children[name], child, name) if name in children else child
    return Modifier(children=children) if children else NO_MODIFIER


def _argument(argument: ast.ElementModification | ast.ElementRedeclaration, context: Context) -> tuple[str, Modifier]:
    if isinstance(argument, ast.ElementRedeclaration):
        element = argument.element
        redeclaration = Redeclaration(element, context, argument.span)
        name = element.name if isinstance(element, ast.ClassDefinition) else element.declarations[0].name
        return name, Modifier(redeclaration=redeclaration, final=argument.final, span=argument.span)
    tree = modifier_of(argument.modification, context, argument.span)
    if argument.each:
        tree = _as_each(tree)
    if argument.final:
        tree = replace(tree, final=True)
    for name in reversed(argument.name[1:]):
        tree = Modifier(children={name: tree}, span=argument.span)
    return argument.name[0], tree


def _as_each(tree: Modifier) -> Modifier:
    binding = None if tree.binding is None else replace(tree.binding, each=True)
    return replace(tree, binding=binding, children={name: _as_each(c) for name, c in tree.children.items()})


def _join(first: Modifier, second: Modifier, name: str) -> Modifier:
    """Two arguments of one list that address parts of the same element: `a.x = 1, a.y = 2`."""
    clash = (first.binding is not None and second.binding is not None) or (
        first.redeclaration is not None and second.redeclaration is not None
    )
    if clash:
        raise fail(
            TypeProblem,
            "modification.duplicate",
            f"`{name}` is modified twice in one modification",
            second.span,
            names=[name],
            hint="remove one of the two (Modelica 3.6, 7.2.4)",
        )
    children = dict(first.children)
    for key, child in second.children.items():
        children[key] = _join(children[key], child, f"{name}.{key}") if key in children else child
    return Modifier(
        binding=first.binding or second.binding,
        children=children,
        redeclaration=first.redeclaration or second.redeclaration,
        final=first.final or second.final,
        span=first.span,
    )


def merge(outer: Modifier, inner: Modifier, path: str = "") -> Modifier:
    """`outer` over `inner`. Raises `TypeProblem` `modification.final` when `inner` is final and overridden."""
    if inner is NO_MODIFIER or inner.is_empty:
        return outer
    if outer is NO_MODIFIER or outer.is_empty:
        return inner
    overridden = (outer.binding is not None and inner.binding is not None) or (
        outer.redeclaration is not None and inner.redeclaration is not None
    )
    if inner.final and (overridden or outer.binding is not None or outer.redeclaration is not None):
        raise overrides_final(path, outer.span, inner.span)
    children = dict(inner.children)
    for name, child in outer.children.items():
        mine = children.get(name)
        children[name] = child if mine is None else merge(child, mine, f"{path}.{name}" if path else name)
    return Modifier(
        binding=outer.binding or inner.binding,
        children=children,
        redeclaration=outer.redeclaration or inner.redeclaration,
        final=outer.final or inner.final,
        span=outer.span or inner.span,
    )


def overrides_final(path: str, span: Span | None, where: Span | None) -> TypeProblem:
    error = fail(
        TypeProblem,
        "modification.final",
        f"`{path}` is final and cannot be modified",
        span,
        names=[path],
        hint=f"it is declared final at {where}" if where else "it is declared final",
    )
    assert isinstance(error, TypeProblem)
    return error


def element_of(modifier: Modifier, index: int) -> Modifier:
    """The part of an array's modifier that falls to element `index` (from 0) of its first dimension."""
    if modifier.is_empty:
        return modifier
    binding = modifier.binding
    if binding is not None and not binding.each:
        binding = binding.part(index)
    return replace(
        modifier,
        binding=binding,
        children={name: element_of(child, index) for name, child in modifier.children.items()},
    )


def bound(modifier: Modifier, instance: Instance) -> Modifier:
    """Give the expressions of a class's modifiers the component they are evaluated in."""
    if modifier.is_empty:
        return modifier
    binding = modifier.binding
    if binding is not None and binding.context.instance is None:
        binding = replace(binding, context=Context(binding.context.scope, instance))
    redeclaration = modifier.redeclaration
    if redeclaration is not None and redeclaration.context.instance is None:
        redeclaration = replace(redeclaration, context=Context(redeclaration.context.scope, instance))
    children = {name: bound(child, instance) for name, child in modifier.children.items()}
    return replace(modifier, binding=binding, redeclaration=redeclaration, children=children)


def arguments_for(
    modification: ast.Modification | None,
) -> dict[str, list[ast.Argument]]:
    """The arguments of an `extends` clause, by the first name they address."""
    grouped: dict[str, list[ast.Argument]] = {}
    if modification is None:
        return grouped
    for argument in modification.arguments:
        if isinstance(argument, ast.ElementModification):
            name = argument.name[0]
        elif isinstance(argument, ast.ElementRedeclaration):
            element = argument.element
            name = element.name if isinstance(element, ast.ClassDefinition) else element.declarations[0].name
        else:
            name = ""
        grouped.setdefault(name, []).append(argument)
    return grouped


def strip_first(arguments: Sequence[ast.Argument], context: Context) -> Modifier:
    """The modifier that a group of `arguments_for` puts on the element it addresses."""
    tree = modifier_of_arguments(arguments, context)
    return next(iter(tree.children.values()), NO_MODIFIER)
