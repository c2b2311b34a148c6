"""Ranges that are left out: `for i loop x[i] = ...` runs over what `i` subscripts (11.2.2.1)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import fields, is_dataclass, replace

from acausal.errors import AcausalError, LookupProblem
from acausal.lang import ast
from acausal.lang.arithmetic import type_error
from acausal.lang.modifiers import Context
from acausal.lang.translation import Env, Translation
from acausal.lang.values import Value, literal, shape_of


def implicit_values(translation: Translation, iterator: ast.Iterator, body: object, env: Env) -> list[Value]:
    """The values of an iterator without range. Raises `for.implicit-range` where `body` does not give one."""
    found: list[Value] | None = None
    for reference, at, position in _uses(iterator.name, body):
        values = _dimension(translation, reference, at, position, env)
        if found is not None and [v.item for v in values] != [v.item for v in found]:
            message = (
                f"`{iterator.name}` subscripts dimensions of different sizes: {len(found)}, {len(values)}"
            )
            raise _no_range(iterator, message)
        found = values
    if found is None:
        raise _no_range(
            iterator, f"`{iterator.name}` has no range and is no subscript that would give it one"
        )
    return found


def _no_range(iterator: ast.Iterator, message: str) -> AcausalError:
    hint = f"write `{iterator.name} in 1:n`"
    return type_error("for.implicit-range", message, iterator.span, hint, (iterator.name,))


def _uses(name: str, body: object) -> Iterator[tuple[ast.ComponentReference, int, int]]:
    """References with the iterator as a subscript: which part, and which of its subscripts."""
    for reference in _references(body):
        for at, part in enumerate(reference.parts):
            items = () if part.subscripts is None else part.subscripts.items
            for position, item in enumerate(items):
                if isinstance(item, ast.ComponentReference) and item.text == name and not item.global_:
                    yield reference, at, position


def _references(root: object) -> Iterator[ast.ComponentReference]:
    """All references in syntax nodes, in order. Iterative."""
    stack: list[object] = [root]
    while stack:
        node = stack.pop()
        if isinstance(node, tuple):
            stack.extend(reversed(node))  # pyright: ignore[reportUnknownArgumentType]  # any tuple of nodes
        elif is_dataclass(node):
            if isinstance(node, ast.ComponentReference):
                yield node
            names = [field.name for field in fields(node) if field.name not in ("span", "comment")]
            stack.extend([getattr(node, name) for name in reversed(names)])


def _dimension(
    translation: Translation, reference: ast.ComponentReference, at: int, position: int, env: Env
) -> list[Value]:
    """The values that subscript a dimension of the array which the first parts of a reference name."""
    kind = _declared_kind(translation, reference.parts[: at + 1], position, env)
    if kind is not None:
        return kind
    before = [_first_elements(part) for part in reference.parts[:at]]
    bare = replace(reference.parts[at], subscripts=None)
    array = replace(reference, parts=(*before, bare))
    shape = shape_of(translation.value(array, env))
    if position >= len(shape):
        message = f"`{array.text}` has {len(shape)} dimension(s), not {position + 1}"
        raise type_error("type.array-size", message, reference.span, "", (array.text,))
    return [literal(i) for i in range(1, shape[position] + 1)]


def _first_elements(part: ast.NamePart) -> ast.NamePart:
    """The part with 1 for each subscript: its size does not depend on them."""
    if part.subscripts is None:
        return part
    items = tuple([ast.IntegerLiteral(1, item.span) for item in part.subscripts.items])
    return replace(part, subscripts=replace(part.subscripts, items=items))


def _declared_kind(
    translation: Translation, parts: Sequence[ast.NamePart], position: int, env: Env
) -> list[Value] | None:
    """The values of the enumeration, or of Boolean, with which a dimension is declared; else None."""
    if parts[0].name in env.locals and env.context.instance is not None:
        return None
    scope = env.context.scope
    for part in parts[:-1]:
        entry = scope.table.components.get(part.name)
        if entry is None:
            return None
        scope = entry.scope.find_class(entry.clause.type)
    entry = scope.table.components.get(parts[-1].name)
    if entry is None:
        return None
    written = (entry.declaration.dimensions, entry.clause.dimensions)
    items = [item for dimensions in written if dimensions is not None for item in dimensions.items]
    if position >= len(items):
        return None
    try:
        return translation.enumerated(items[position], Env(Context(entry.scope, env.context.instance)))
    except LookupProblem:
        return None
