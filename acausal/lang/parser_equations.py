"""Equations and statements: appendix A.2.6.

Both have the same four block shapes (`if`, `for`, `when`, `while`), read by the same functions; what
stands inside is read by the function that is passed.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from acausal.lang import ast
from acausal.lang.cursor import Cursor, close_block, enter, expect
from acausal.lang.lexer import EOF, IDENT, STORED_NOTE
from acausal.lang.parser_expressions import (
    call_arguments,
    component_reference,
    expression,
    for_indices,
    simple_expression,
    tuple_items,
)
from acausal.lang.parser_modifications import connect_clause, description
from acausal.lang.structure_errors import bad_equation, bad_statement

T = TypeVar("T")
Branches = tuple[tuple[ast.Expression, tuple[T, ...]], ...]

_ENDS = frozenset(
    "end else elseif elsewhen public protected equation algorithm external annotation".split()
) | {EOF, STORED_NOTE}
"""The tokens that end a list of equations or statements."""


def equations(c: Cursor) -> tuple[ast.Equation, ...]:
    """Equations, each with its semicolon, up to the end of the block or section."""
    return _list(c, _equation, "the equation")


def statements(c: Cursor) -> tuple[ast.Statement, ...]:
    """Statements, each with its semicolon, up to the end of the block or section."""
    return _list(c, _statement, "the statement")


def _list(c: Cursor, item: Callable[[Cursor], T], what: str) -> tuple[T, ...]:
    kinds = c.kinds
    items: list[T] = []
    while True:
        kind = kinds[c.position]
        if kind in _ENDS or (kind == "initial" and kinds[c.position + 1] in ("equation", "algorithm")):
            return tuple(items)
        first = c.position
        items.append(item(c))
        if kinds[c.position] != ";":
            expect(c, ";", f"after {what} of line {c.source.position(c.starts[first])[0]}")
        c.position += 1


# --------------------------------------------------------------------------- blocks


def _branches(c: Cursor, body: Callable[[Cursor], tuple[T, ...]], again: str) -> Branches[T]:
    """`if c then ... elseif c then ...` (or `when`, `elsewhen`), before `else` and `end`."""
    branches: list[tuple[ast.Expression, tuple[T, ...]]] = []
    while True:
        word = c.kinds[c.position]
        c.position += 1
        condition = expression(c)
        if c.kinds[c.position] != "then":
            expect(c, "then", f"after the condition of `{word}`")
        c.position += 1
        branches.append((condition, body(c)))
        if c.kinds[c.position] != again:
            return tuple(branches)


def _if(c: Cursor, body: Callable[[Cursor], tuple[T, ...]]) -> tuple[Branches[T], tuple[T, ...]]:
    first = c.position
    enter(c)
    branches = _branches(c, body, "elseif")
    otherwise: tuple[T, ...] = ()
    if c.kinds[c.position] == "else":
        c.position += 1
        otherwise = body(c)
    close_block(c, "if", first)
    c.depth -= 1
    return branches, otherwise


def _when(c: Cursor, body: Callable[[Cursor], tuple[T, ...]]) -> Branches[T]:
    first = c.position
    enter(c)
    branches = _branches(c, body, "elsewhen")
    close_block(c, "when", first)
    c.depth -= 1
    return branches


def _for(
    c: Cursor, body: Callable[[Cursor], tuple[T, ...]]
) -> tuple[tuple[ast.Iterator, ...], tuple[T, ...]]:
    first = c.position
    enter(c)
    c.position += 1
    iterators = for_indices(c)
    expect(c, "loop", "after the range of `for`")
    items = body(c)
    close_block(c, "for", first)
    c.depth -= 1
    return iterators, items


# --------------------------------------------------------------------------- equations


def _equation(c: Cursor) -> ast.Equation:
    first = c.position
    kind = c.kinds[first]
    if kind == "connect":
        left, right = connect_clause(c)
        return ast.ConnectEquation(left, right, description(c), c.span_from(first))
    if kind == "if":
        branches, otherwise = _if(c, equations)
        return ast.IfEquation(branches, otherwise, description(c), c.span_from(first))
    if kind == "for":
        iterators, body = _for(c, equations)
        return ast.ForEquation(iterators, body, description(c), c.span_from(first))
    if kind == "when":
        branches = _when(c, equations)
        return ast.WhenEquation(branches, description(c), c.span_from(first))
    return _equality_or_call(c)


def _equality_or_call(c: Cursor) -> ast.Equation:
    """`a = b` or `f(x)`."""
    first = c.position
    left = simple_expression(c)
    if c.kinds[c.position] == "=":
        c.position += 1
        right = expression(c)
        return ast.EqualEquation(left, right, description(c), c.span_from(first))
    if isinstance(left, ast.Call) and c.kinds[first] in (IDENT, "."):
        return ast.CallEquation(left, description(c), c.span_from(first))
    raise bad_equation(c, left, first)


# --------------------------------------------------------------------------- statements


def _statement(c: Cursor) -> ast.Statement:
    first = c.position
    kind = c.kinds[first]
    if kind in {IDENT, "."}:
        return _assignment_or_call(c)
    if kind in _STATEMENTS:
        return _STATEMENTS[kind](c)
    raise bad_statement(c)


def _assignment_or_call(c: Cursor) -> ast.Statement:
    first = c.position
    target = component_reference(c)
    kind = c.kinds[c.position]
    if kind == ":=":
        c.position += 1
        value = expression(c)
        return ast.Assignment(target, value, description(c), c.span_from(first))
    if kind != "(":
        raise bad_statement(c)
    call = call_arguments(c, first, target)
    if c.kinds[c.position] in (":=", "="):
        raise bad_statement(c)
    return ast.CallStatement(call, description(c), c.span_from(first))


def _multiple_assignment(c: Cursor) -> ast.Statement:
    """`(a, , b) := f(x)`."""
    first = c.position
    target = ast.Tuple(tuple_items(c), c.span_from(first))
    if c.kinds[c.position] != ":=":
        raise bad_statement(c)
    c.position += 1
    start = c.position
    function = component_reference(c)
    if c.kinds[c.position] != "(":
        raise c.error("a function call", "only a function call has several results to assign")
    value = call_arguments(c, start, function)
    return ast.Assignment(target, value, description(c), c.span_from(first))


def _break_statement(c: Cursor) -> ast.Statement:
    first = c.position
    c.position += 1
    return ast.BreakStatement(description(c), c.span_from(first))


def _return_statement(c: Cursor) -> ast.Statement:
    first = c.position
    c.position += 1
    return ast.ReturnStatement(description(c), c.span_from(first))


def _if_statement(c: Cursor) -> ast.Statement:
    first = c.position
    branches, otherwise = _if(c, statements)
    return ast.IfStatement(branches, otherwise, description(c), c.span_from(first))


def _for_statement(c: Cursor) -> ast.Statement:
    first = c.position
    iterators, body = _for(c, statements)
    return ast.ForStatement(iterators, body, description(c), c.span_from(first))


def _when_statement(c: Cursor) -> ast.Statement:
    first = c.position
    branches = _when(c, statements)
    return ast.WhenStatement(branches, description(c), c.span_from(first))


def _while_statement(c: Cursor) -> ast.Statement:
    first = c.position
    enter(c)
    c.position = first + 1
    condition = expression(c)
    expect(c, "loop", "after the condition of `while`")
    body = statements(c)
    close_block(c, "while", first)
    c.depth -= 1
    return ast.WhileStatement(condition, body, description(c), c.span_from(first))


_STATEMENTS: dict[str, Callable[[Cursor], ast.Statement]] = {
    "(": _multiple_assignment,
    "if": _if_statement,
    "for": _for_statement,
    "when": _when_statement,
    "while": _while_statement,
    "break": _break_statement,
    "return": _return_statement,
}
