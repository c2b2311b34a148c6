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
from acausal.lang.lexer import EOF, IDENT, STORED_CLASS, STORED_NOTE, tokenize, tokenize_around
from acausal.lang.nesting import stack_room
from acausal.lang.parser_classes import class_definition, one_element
from acausal.lang.parser_expressions import expression
from acausal.lang.parser_imports import dotted_name
from acausal.lang.parser_modifications import CLASS_WORDS, NO_PREFIXES, annotation
from acausal.lang.reading_time import reading
from acausal.lang.structure_errors import no_class, not_modelica

_T = TypeVar("_T")


Marks = list[ast.ClassDefinition | ast.Annotation]


def parse(source: Source) -> ast.StoredDefinition:
    """The classes of one file or text. Raises SyntaxProblem (codes `syntax.*`)."""
    return parse_with_marks(source)[0]


def parse_with_marks(source: Source) -> tuple[ast.StoredDefinition, Marks]:
    """As `parse`, with all classes and long annotations in it: what `parse_part` can read on its own."""
    c = Cursor(_within(lambda: tokenize(source)))
    return _within(lambda: _stored_definition(c)), c.marks


def parse_part(
    source: Source, start: int, end: int, stored: Marks, protected: bool | None
) -> ast.Element | ast.Annotation:
    """The class (`protected` or not), or for None the annotation, that the characters `start` to `end` hold.

    `stored` are nodes inside it, in order, to be taken as they are. Raises SyntaxProblem.
    """

    def read() -> ast.Element | ast.Annotation:
        holes = [
            (
                STORED_NOTE if isinstance(node, ast.Annotation) else STORED_CLASS,
                node.span.start,
                node.span.end,
            )
            for node in stored
        ]
        c = Cursor(tokenize_around(source, start, end, holes))
        c.stored = {node.span.start: node for node in stored}
        found = annotation(c) if protected is None else one_element(c, protected)
        if found is None or c.kinds[c.position] != EOF:
            raise c.error("the end of this part")
        return found

    return _within(read)


def parse_expression(source: Source) -> ast.Expression:
    """A text that is one expression, such as the value of `-p name=value`. Raises SyntaxProblem."""
    return _within(lambda: _whole_expression(Cursor(tokenize(source))))


def _whole_expression(c: Cursor) -> ast.Expression:
    result = expression(c)
    if c.kinds[c.position] != EOF:
        raise c.error("the end of the expression")
    return result


def _within(work: Callable[[], _T]) -> _T:
    """Do the work with room on the stack and without Python's garbage collector.

    The cyclic garbage collector pauses meanwhile: a syntax tree has no cycles, and walking the
    growing tree again and again takes longer than building it.
    """
    collecting = gc.isenabled()
    gc.disable()
    try:
        with stack_room(), reading():
            return work()
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
        c.marks.append(definition)
        expect(c, ";", f"after the class `{definition.name}`")
    if not classes:
        raise no_class(c)
    return ast.StoredDefinition(within, tuple(classes), c.source.path)
