"""Text -> AST: the complete concrete syntax of Modelica 3.6 (appendix A), by recursive descent.

Strict: what the grammar does not allow is refused, with a hint. The first error ends the parse. Time is
linear in the length of the text and nesting is bounded (`nesting.NESTING_LIMIT`).

The productions are in `parser_expressions`, `parser_modifications`, `parser_equations`, `parser_imports` and
`parser_classes`; each imports only the ones before it.
"""

from __future__ import annotations

import gc
from collections.abc import Callable
from typing import TypeVar

from acausal.errors import Source
from acausal.lang import ast
from acausal.lang.cursor import Cursor, accept, expect
from acausal.lang.lexer import EOF, IDENT, tokenize
from acausal.lang.nesting import stack_room
from acausal.lang.parser_classes import class_definition
from acausal.lang.parser_expressions import expression
from acausal.lang.parser_imports import dotted_name
from acausal.lang.parser_modifications import CLASS_WORDS, NO_PREFIXES
from acausal.lang.structure_errors import no_class, not_modelica

_T = TypeVar("_T")


def parse(source: Source) -> ast.StoredDefinition:
    """The classes of one file or text. Raises SyntaxProblem (codes `syntax.*`)."""
    return _run(_stored_definition, source)


def parse_expression(source: Source) -> ast.Expression:
    """A text that is one expression, such as the value of `-p name=value`. Raises SyntaxProblem."""
    return _run(_whole_expression, source)


def _whole_expression(c: Cursor) -> ast.Expression:
    result = expression(c)
    if c.kinds[c.position] != EOF:
        raise c.error("the end of the expression")
    return result


def _run(production: Callable[[Cursor], _T], source: Source) -> _T:
    """Read the whole source by one production.

    Python's cyclic garbage collector pauses meanwhile: a syntax tree has no cycles, and walking the
    growing tree again and again takes longer than building it.
    """
    collecting = gc.isenabled()
    gc.disable()
    try:
        with stack_room():
            return production(Cursor(tokenize(source)))
    finally:
        if collecting:
            gc.enable()


def _stored_definition(c: Cursor) -> ast.StoredDefinition:
    """A whole file."""
    within: tuple[str, ...] | None = None
    if c.kinds[c.position] == "within":
        c.position += 1
        within = dotted_name(c) if c.kinds[c.position] == IDENT else ()
        expect(c, ";", "after the `within` clause")
    classes: list[tuple[bool, ast.ClassDefinition]] = []
    while c.kinds[c.position] != EOF:
        final = accept(c, "final")
        if c.kinds[c.position] not in CLASS_WORDS:
            raise not_modelica(c, after_class=bool(classes))
        definition = class_definition(c, c.position, NO_PREFIXES)
        classes.append((final, definition))
        expect(c, ";", f"after the class `{definition.name}`")
    if not classes:
        raise no_class(c)
    return ast.StoredDefinition(within, tuple(classes), c.source.path)
