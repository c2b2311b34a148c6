"""Errors in expressions that name no variables get those of the equation or declaration they stand in."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, replace

from acausal.errors import AcausalError
from acausal.lang import ast

_MOST_NAMES = 6
_NODES = (
    ast.EqualEquation, ast.CallEquation, ast.Subscripts, ast.NamePart, ast.Unary, ast.Binary, ast.If,
    ast.NamedArgument, ast.Iterator, ast.Call, ast.ArrayConstructor, ast.Matrix, ast.Range, ast.Tuple,
    ast.Subscripted, ast.ComponentReference,
)  # fmt: skip


def with_names(error: AcausalError, names: tuple[str, ...]) -> AcausalError:
    """The same error, with the names where it has none."""
    return type(error)([d if d.names else replace(d, names=names) for d in error.diagnostics])


def names_in(root: ast.Equation | ast.Expression, component: str) -> tuple[str, ...]:
    """Flat names of the references in an equation of a component, in order, at most six."""
    prefix = f"{component}." if component else ""
    found: dict[str, None] = {}
    for reference in references_in(root):
        if len(found) < _MOST_NAMES:
            found[prefix + reference.text] = None
    return tuple(found)


def names_in_when(node: ast.WhenEquation, component: str) -> tuple[str, ...]:
    """Flat names of the references in the conditions of a when-equation of a component, at most six."""
    prefix = f"{component}." if component else ""
    conditions = [condition for condition, _ in node.branches]
    found = dict.fromkeys([prefix + reference.text for reference in references_in(*conditions)])
    return tuple(found)[:_MOST_NAMES]


def references_in(*roots: object) -> Iterator[ast.ComponentReference]:
    """References below syntax nodes, in order; not the names of functions. Iterative."""
    stack: list[object] = list(reversed(roots))
    while stack:
        node = stack.pop()
        if isinstance(node, tuple):
            stack.extend(reversed(node))  # pyright: ignore[reportUnknownArgumentType]  # any tuple of nodes
            continue
        if isinstance(node, ast.ComponentReference):
            yield node
        if isinstance(node, _NODES):
            names = [field.name for field in fields(node) if field.name not in ("span", "function")]
            stack.extend([getattr(node, name) for name in reversed(names)])
