"""Modifications as trees: what `(a.b(start = 1) = 2, redeclare model M = X)` says, and in which context.

A tree is built once per class, without an instance, and `bound` to each component built from the class.
Merging follows Modelica 3.6, 7.2.4: an outer modification wins over an inner one, attribute by attribute;
a `final` one cannot be overridden (7.2.6); `each` gives every element of an array the same value (7.2.5).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import field
from typing import TYPE_CHECKING

from acausal.errors import AcausalError, Span, TypeProblem, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.library import ClassNode
from acausal.lang.light import light_object
from acausal.lang.values import AnyValue

if TYPE_CHECKING:  # the three kinds of data refer to each other
    from acausal.lang.instance import Instance
    from acausal.lang.scope import Scope

Selector = tuple[int, int] | str
_LITERALS = (ast.RealLiteral, ast.IntegerLiteral, ast.BooleanLiteral, ast.StringLiteral)


@light_object
class Context:
    """Where an expression was written: its class and the component it belongs to.

    `instance` is None in the modifiers of classes until a component is built from them (`bound`), and in
    packages and functions.
    """

    scope: Scope
    instance: Instance | None


@light_object
class Binding:
    """An expression in its context.

    `selectors` pick the part that falls to one element of an array (its index from 0, and the array's size)
    or to one field of a record (its name). `memo` holds the translated whole, shared by all parts.
    """

    expression: ast.Expression
    context: Context
    span: Span
    selectors: tuple[Selector, ...] = ()
    each: bool = False
    memo: list[AnyValue] = field(default_factory=list[AnyValue])

    def part(self, selector: Selector) -> Binding:
        selectors = (*self.selectors, selector)
        return Binding(self.expression, self.context, self.span, selectors, self.each, self.memo)

    @property
    def needs_instance(self) -> bool:
        """Whether the value may depend on the component that is built."""
        return self.context.instance is None and not isinstance(self.expression, _LITERALS)


@light_object
class Redeclaration:
    """`redeclare ...` or a `replaceable` inside a modification, in its context; `node` is that of a class.

    `constraint` is its own constraining clause, `previous` what it redeclares again if that had one (7.3.2).
    `over` is the redeclaration that `redeclare model extends M` extends (7.3.1); None: the declared class.
    """

    element: ast.ClassDefinition | ast.ComponentClause
    context: Context
    span: Span
    replaceable: bool
    node: ClassNode | None
    constraint: ast.Constraint | None = None
    previous: Redeclaration | None = None
    over: Redeclaration | None = None

    @property
    def extends(self) -> bool:
        """Whether the class extends the one that it replaces."""
        return isinstance(self.element, ast.LongClass) and self.element.extends

    def again(self, previous: Redeclaration) -> Redeclaration:
        """The same after another redeclaration: its constraint counts, and a class may extend it."""
        constrained = previous.constraint is not None or previous.previous is not None
        if not constrained and not self.extends:
            return self
        over = self.over
        if self.extends:
            over = previous if over is None else over.again(previous)
        return Redeclaration(
            self.element,
            self.context,
            self.span,
            self.replaceable,
            self.node,
            self.constraint,
            previous if constrained else self.previous,
            over,
        )


@light_object
class Modifier:
    """One node of a modification tree.

    `beside` names the children written with the binding or further out, which it does not override; None
    means all of them.
    """

    binding: Binding | None = None
    children: dict[str, Modifier] = field(default_factory=dict[str, "Modifier"])
    redeclaration: Redeclaration | None = None
    final: bool = False
    span: Span | None = None
    beside: frozenset[str] | None = None

    def child(self, name: str) -> Modifier:
        return self.children.get(name, NO_MODIFIER)

    @property
    def is_empty(self) -> bool:
        return self.binding is None and not self.children and self.redeclaration is None


NO_MODIFIER = Modifier()


# --------------------------------------------------------------------------- from the source


def modifier_of(
    modification: ast.Modification | None, context: Context, span: Span | None = None
) -> Modifier:
    """The tree of one modification as written."""
    if modification is None:
        return NO_MODIFIER
    tree = modifier_of_arguments(modification.arguments, context)
    value = modification.value
    binding: Binding | None = None
    if isinstance(value, ast.Break):
        raise fail(UnsupportedProblem, "unsupported.break", "`= break` is not supported yet", value.span)
    if value is not None:
        binding = Binding(value, context, value.span)
    return Modifier(binding, tree.children, None, False, span or modification.span)


def modifier_of_arguments(arguments: Iterable[ast.Argument], context: Context) -> Modifier:
    """The tree of a list of arguments. Two modifications of one element are an error (7.2.4)."""
    children: dict[str, Modifier] = {}
    for argument in arguments:
        if isinstance(argument, ast.BreakConnect):
            message = "`break` in a modification is not supported yet"
            raise fail(UnsupportedProblem, "unsupported.selective-extension", message, argument.span)
        name, child = _argument(argument, context)
        children[name] = _join(children[name], child, name) if name in children else child
    return Modifier(children=children) if children else NO_MODIFIER


def _argument(
    argument: ast.ElementModification | ast.ElementRedeclaration, context: Context
) -> tuple[str, Modifier]:
    if isinstance(argument, ast.ElementRedeclaration):
        element = argument.element
        is_class = isinstance(element, ast.ClassDefinition)
        redeclaration = redeclaration_of(
            element, context, argument.span, argument.replaceable, argument.constraint
        )
        name = element.name if is_class else element.declarations[0].name
        return name, Modifier(redeclaration=redeclaration, final=argument.final, span=argument.span)
    tree = Modifier(span=argument.span)
    if argument.modification is not None:
        tree = modifier_of(argument.modification, context, argument.span)
    if argument.each:
        tree = _as_each(tree)
    if argument.final:
        tree = Modifier(tree.binding, tree.children, tree.redeclaration, True, tree.span)
    for name in reversed(argument.name[1:]):
        tree = Modifier(children={name: tree}, span=argument.span)
    return argument.name[0], tree


def redeclaration_of(
    element: ast.ClassDefinition | ast.ComponentClause,
    context: Context,
    span: Span,
    replaceable: bool,
    constraint: ast.Constraint | None = None,
) -> Redeclaration:
    """A redeclaration written in `context`."""
    is_class = isinstance(element, ast.ClassDefinition)
    node = ClassNode(element, context.scope.node, None) if is_class else None
    return Redeclaration(element, context, span, replaceable, node, constraint or element.constraint)


def _as_each(tree: Modifier) -> Modifier:
    binding = tree.binding
    if binding is not None:
        binding = Binding(
            binding.expression, binding.context, binding.span, binding.selectors, True, binding.memo
        )
    children = {name: _as_each(child) for name, child in tree.children.items()}
    return Modifier(binding, children, tree.redeclaration, tree.final, tree.span)


def _join(first: Modifier, second: Modifier, name: str) -> Modifier:
    """Two arguments of one list that address parts of the same element: `a.x = 1, a.y = 2`."""
    if (first.binding and second.binding) or (first.redeclaration and second.redeclaration):
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
        first.binding or second.binding,
        children,
        first.redeclaration or second.redeclaration,
        first.final or second.final,
        first.span,
    )


# --------------------------------------------------------------------------- merging


def merge(outer: Modifier, inner: Modifier, path: str = "") -> Modifier:
    """`outer` over `inner`. Raises `modification.final` and `redeclare.not-replaceable`."""
    if inner is NO_MODIFIER or inner.is_empty:
        return outer
    if outer is NO_MODIFIER or outer.is_empty:
        return inner
    if inner.final:
        raise overrides_final(path, outer.span, inner.span)
    mine, other = inner.redeclaration, outer.redeclaration
    if mine is not None and other is not None and not mine.replaceable:
        raise not_replaceable(path, other.span, mine.span)
    children = _merge_children(outer.children, inner.children, path)
    if outer.binding is not None:
        binding = outer.binding
        beside = frozenset(outer.children) if outer.beside is None else outer.beside
    else:
        binding = inner.binding
        beside = None if inner.beside is None else inner.beside.union(outer.children)
    if mine is not None and other is not None:
        other = other.again(mine)
    return Modifier(binding, children, other or mine, outer.final, outer.span or inner.span, beside)


def _merge_children(outer: dict[str, Modifier], inner: dict[str, Modifier], path: str) -> dict[str, Modifier]:
    if not outer or not inner:
        return outer or inner
    children = dict(inner)
    for name, child in outer.items():
        below = children.get(name)
        deeper = f"{path}.{name}" if path else name
        children[name] = child if below is None else merge(child, below, deeper)
    return children


def same_contents(a: Modifier, b: Modifier) -> bool:
    """Whether two trees say the same with the same expressions."""
    first = None if a.binding is None else a.binding.expression
    second = None if b.binding is None else b.binding.expression
    if first != second or len(a.children) != len(b.children) or a.final != b.final:
        return False
    if a.redeclaration is not b.redeclaration:
        return False
    return all(name in b.children and same_contents(x, b.children[name]) for name, x in a.children.items())


def overrides_final(path: str, span: Span | None, where: Span | None) -> AcausalError:
    """The error for a modification of something final."""
    return fail(
        TypeProblem,
        "modification.final",
        f"`{path}` is final and cannot be modified",
        span,
        names=[path],
        hint=f"it is declared final at {where}" if where else "it is declared final",
    )


def not_replaceable(path: str, span: Span, where: Span) -> AcausalError:
    """The error for a redeclaration of something that is not replaceable."""
    return fail(
        TypeProblem,
        "redeclare.not-replaceable",
        f"`{path}` is not replaceable and cannot be redeclared",
        span,
        names=[path],
        hint=f"declare it `replaceable` at {where}",
    )


# --------------------------------------------------------------------------- for one element or component


def element_of(modifier: Modifier, index: int, size: int) -> Modifier:
    """The part of an array's modifier for element `index` (from 0) of `size` in the first dimension.

    `each` keeps what is said about the parts of the elements whole; the array's own value is always split.
    """
    binding = modifier.binding
    if binding is not None:
        binding = binding.part((index, size))
    children = _parts_of(modifier.children, index, size)
    return _with(modifier, binding, modifier.redeclaration, children)


def _parts_of(children: dict[str, Modifier], index: int, size: int) -> dict[str, Modifier]:
    if not children:
        return children
    parts = {name: _part_of(child, index, size) for name, child in children.items()}
    return children if all(parts[name] is child for name, child in children.items()) else parts


def _part_of(modifier: Modifier, index: int, size: int) -> Modifier:
    binding = modifier.binding
    if binding is not None and not binding.each:
        binding = binding.part((index, size))
    return _with(modifier, binding, modifier.redeclaration, _parts_of(modifier.children, index, size))


def _with(
    modifier: Modifier,
    binding: Binding | None,
    redeclaration: Redeclaration | None,
    children: dict[str, Modifier],
) -> Modifier:
    """The modifier with other parts; itself when they are the same."""
    if (
        binding is modifier.binding
        and redeclaration is modifier.redeclaration
        and children is modifier.children
    ):
        return modifier
    return Modifier(binding, children, redeclaration, modifier.final, modifier.span, modifier.beside)


def bound(modifier: Modifier, instance: Instance) -> Modifier:
    """Give the expressions of a class's modifiers the component they are evaluated in.

    That is `instance` or the nearest component around it whose class holds the expression's text. What
    depends on no component is shared.
    """
    binding = modifier.binding
    if binding is not None and binding.needs_instance:
        owner = instance.nearest(binding.context.scope)
        if owner is not None:
            context = Context(binding.context.scope, owner)
            binding = Binding(binding.expression, context, binding.span, binding.selectors, binding.each)
    redeclaration = modifier.redeclaration
    if redeclaration is not None and redeclaration.context.instance is None:
        redeclaration = _bound_redeclaration(redeclaration, instance)
    children = modifier.children
    if children:
        parts = {name: bound(child, instance) for name, child in children.items()}
        if any(parts[name] is not child for name, child in children.items()):
            children = parts
    return _with(modifier, binding, redeclaration, children)


def _bound_redeclaration(redeclaration: Redeclaration, instance: Instance) -> Redeclaration:
    owner = instance.nearest(redeclaration.context.scope)
    if owner is None:
        return redeclaration
    return Redeclaration(
        redeclaration.element,
        Context(redeclaration.context.scope, owner),
        redeclaration.span,
        redeclaration.replaceable,
        redeclaration.node,
        redeclaration.constraint,
        redeclaration.previous,
        redeclaration.over,
    )
