"""A component about to be built, and what its modifier says about its elements and fields."""

from __future__ import annotations

from collections.abc import Callable

from acausal.errors import TypeProblem, fail
from acausal.lang import ast
from acausal.lang.access import is_protected
from acausal.lang.formals import record_class
from acausal.lang.instance import Array, Member, Prefixes
from acausal.lang.instance_errors import modifies_protected
from acausal.lang.light import light_object
from acausal.lang.lookup_errors import unknown_target
from acausal.lang.modifiers import NO_MODIFIER, Context, Modifier, element_of, merge
from acausal.lang.scope import Scope
from acausal.lang.simple_types import SimpleType


@light_object
class Plan:
    """A component about to be built, an array before its elements."""

    path: str
    clause: ast.ComponentClause
    declaration: ast.Declaration
    context: Context
    prefixes: Prefixes
    type: Scope


def array_of(
    plan: Plan,
    shape: tuple[int, ...],
    simple: SimpleType | None,
    modifier: Modifier,
    build: Callable[[str, Modifier], Member],
) -> Array:
    """The elements, row by row; what array types say of all their elements is added where those begin."""
    items: list[Member] = []
    spread = () if simple is None else simple.spread

    def fill(index: str, part: Modifier, depth: int) -> None:
        for inner, rank in spread:
            if depth == len(shape) - rank:
                part = merge(part, inner, plan.path)
        if depth == len(shape):
            items.append(build(f"{plan.path}[{index}]", part))
            return
        for i in range(shape[depth]):
            inside = _element(part, i, shape[depth], plan)
            fill(f"{index},{i + 1}" if index else str(i + 1), inside, depth + 1)

    fill("", modifier, 0)
    scalar = None if simple is None else simple.scalar
    return Array(plan.path, shape, tuple(items), scalar, plan.declaration.span, plan.type)


def _element(modifier: Modifier, index: int, size: int, plan: Plan) -> Modifier:
    """As `element_of`, with what is said of this element alone: `a[2].x = 1` from the command line."""
    alone = {name: child for name, child in modifier.children.items() if name.startswith("[")}
    if not alone:
        return element_of(modifier, index, size)
    for name, child in alone.items():
        if not 1 <= int(name[1:-1]) <= size:
            message = f"`{plan.path}` has no element {name}: its size is {size}"
            names = [plan.path]
            raise fail(TypeProblem, "type.index-out-of-range", message, child.span, names=names)
    others = {name: child for name, child in modifier.children.items() if name not in alone}
    rest = Modifier(
        modifier.binding, others, modifier.redeclaration, modifier.final, modifier.span, modifier.beside
    )
    return merge(alone.get(f"[{index + 1}]", NO_MODIFIER), element_of(rest, index, size), plan.path)


def check_targets(scope: Scope, modifier: Modifier) -> None:
    """Raise unless a modification from outside addresses public elements of the class."""
    for name, child in modifier.children.items():
        if name in scope.table.components:
            continue
        entry = scope.find_class_entry(name)
        if entry is None:
            raise unknown_target(name, scope, child.span or scope.span)
        if is_protected(scope, entry):
            raise modifies_protected(name, scope, child)


def description_of(scope: Scope) -> str:
    """The description string of a class."""
    definition = scope.definition
    if isinstance(definition, ast.LongClass):
        return definition.comment or ""
    return definition.comment.text or ""


def spread_record(modifier: Modifier, scope: Scope) -> Modifier:
    """A record's value becomes the value of each field that has none written beside it or further out."""
    if modifier.binding is None or record_class(scope).kind != "record":
        return modifier
    children = dict(modifier.children)
    for name, entry in scope.table.components.items():
        child = children.get(name, NO_MODIFIER)
        stays = child.binding is not None and (modifier.beside is None or name in modifier.beside)
        is_constant = entry.clause.variability == "constant" or entry.clause.prefixes.final
        if not stays and not (is_constant and entry.written.binding is not None):
            part = Modifier(binding=modifier.binding.part(name), span=modifier.span)
            children[name] = merge(
                part, Modifier(None, child.children, child.redeclaration, False, child.span)
            )
    return Modifier(
        modifier.binding, children, modifier.redeclaration, modifier.final, modifier.span, modifier.beside
    )
