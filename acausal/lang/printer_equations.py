"""Equations and statements -> lines of text.

Both have the same block shapes; what differs is only what stands inside, so the block printers take the
function that prints one item of the body.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TypeVar

from acausal.lang import ast
from acausal.lang.operators import RANGE
from acausal.lang.printer_expressions import (
    expression_text,
    iterators_text,
    reference_text,
    tuple_text,
)
from acausal.lang.printer_modifications import comment_text, connect_text

T = TypeVar("T", ast.Equation, ast.Statement)
Branches = tuple[tuple[ast.Expression, tuple[T, ...]], ...]
Lines = Callable[[T, str], Iterator[str]]


def equation_lines(equation: ast.Equation, indent: str) -> Iterator[str]:
    """The lines of one equation, with its indentation and semicolon."""
    match equation:
        case ast.EqualEquation():
            text = f"{expression_text(equation.left, RANGE)} = {expression_text(equation.right)}"
            yield _simple(text, equation.comment, indent)
        case ast.ConnectEquation():
            yield _simple(connect_text(equation), equation.comment, indent)
        case ast.CallEquation():
            yield _simple(expression_text(equation.call), equation.comment, indent)
        case ast.IfEquation():
            yield from _branch_lines("if", equation.branches, equation_lines, indent)
            yield from _else_lines(equation.otherwise, equation_lines, indent)
            yield _end("if", equation.comment, indent)
        case ast.ForEquation():
            yield from _for_lines(equation.iterators, equation.body, equation_lines, indent)
            yield _end("for", equation.comment, indent)
        case ast.WhenEquation():
            yield from _branch_lines("when", equation.branches, equation_lines, indent)
            yield _end("when", equation.comment, indent)


def statement_lines(statement: ast.Statement, indent: str) -> Iterator[str]:
    """The lines of one statement, with its indentation and semicolon."""
    match statement:
        case ast.Assignment():
            target = statement.target
            left = tuple_text(target) if isinstance(target, ast.Tuple) else reference_text(target)
            yield _simple(f"{left} := {expression_text(statement.value)}", statement.comment, indent)
        case ast.CallStatement():
            yield _simple(expression_text(statement.call), statement.comment, indent)
        case ast.BreakStatement():
            yield _simple("break", statement.comment, indent)
        case ast.ReturnStatement():
            yield _simple("return", statement.comment, indent)
        case ast.IfStatement():
            yield from _branch_lines("if", statement.branches, statement_lines, indent)
            yield from _else_lines(statement.otherwise, statement_lines, indent)
            yield _end("if", statement.comment, indent)
        case ast.ForStatement():
            yield from _for_lines(statement.iterators, statement.body, statement_lines, indent)
            yield _end("for", statement.comment, indent)
        case ast.WhileStatement():
            yield f"{indent}while {expression_text(statement.condition)} loop"
            yield from _body_lines(statement.body, statement_lines, indent)
            yield _end("while", statement.comment, indent)
        case ast.WhenStatement():
            yield from _branch_lines("when", statement.branches, statement_lines, indent)
            yield _end("when", statement.comment, indent)


def _simple(text: str, comment: ast.Comment, indent: str) -> str:
    return f"{indent}{text}{comment_text(comment, indent, len(indent) + len(text))};"


def _end(word: str, comment: ast.Comment, indent: str) -> str:
    return f"{indent}end {word}{comment_text(comment, indent)};"


def _body_lines(items: Iterable[T], lines: Lines[T], indent: str) -> Iterator[str]:
    for item in items:
        yield from lines(item, indent + "  ")


def _branch_lines(word: str, branches: Branches[T], lines: Lines[T], indent: str) -> Iterator[str]:
    for number, (condition, body) in enumerate(branches):
        yield f"{indent}{'else' if number else ''}{word} {expression_text(condition)} then"
        yield from _body_lines(body, lines, indent)


def _else_lines(body: tuple[T, ...], lines: Lines[T], indent: str) -> Iterator[str]:
    if body:
        yield f"{indent}else"
        yield from _body_lines(body, lines, indent)


def _for_lines(
    iterators: tuple[ast.Iterator, ...], body: tuple[T, ...], lines: Lines[T], indent: str
) -> Iterator[str]:
    yield f"{indent}for {iterators_text(iterators)} loop"
    yield from _body_lines(body, lines, indent)
