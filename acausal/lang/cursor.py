"""The parser's place in the token lists, and the few helpers every production uses.

Productions are plain functions `production(c: Cursor) -> Node`: they read `c.kinds[c.position]`, advance
`c.position`, and raise SyntaxProblem. Nothing backtracks.
"""

from __future__ import annotations

from acausal.errors import Source, Span, SyntaxProblem
from acausal.lang import ast, structure_errors, syntax_errors
from acausal.lang.lexer import IDENT, Tokens
from acausal.lang.nesting import NESTING_LIMIT


class Cursor:
    """The tokens of one source, the index of the next one, and how deep the parser is inside what."""

    __slots__ = (
        "depth",
        "ends",
        "kinds",
        "marks",
        "position",
        "source",
        "starts",
        "stored",
        "subscripts",
        "texts",
    )

    def __init__(self, tokens: Tokens) -> None:
        self.source: Source = tokens.source
        self.kinds = tokens.kinds
        self.texts = tokens.texts
        self.starts = tokens.starts
        self.ends = tokens.ends
        self.position = 0
        self.depth = 0
        """Levels of nesting around the next token; see `enter`."""
        self.subscripts = 0
        """How many of them are array subscripts, where `end` is an expression."""
        self.marks: list[ast.ClassDefinition | ast.Annotation] = []
        """Classes and long annotations read so far: the nodes that can be read on their own."""
        self.stored: dict[int, ast.ClassDefinition | ast.Annotation] = {}
        """Nodes in place of tokens of the kinds `STORED_...`, by the character they begin at."""

    def span_from(self, first: int) -> Span:
        """From token `first` to the last token read."""
        return Span(self.source, self.starts[first], self.ends[self.position - 1])

    def error(self, expected: str, hint: str = "") -> SyntaxProblem:
        """The next token is not what the grammar allows; `expected` completes "expected ..."."""
        return syntax_errors.unexpected(self, expected, hint)


def enter(c: Cursor) -> None:
    """Go one level deeper; the caller does `c.depth -= 1` when it comes back (not needed on errors)."""
    c.depth += 1
    if c.depth > NESTING_LIMIT:
        raise syntax_errors.too_deep(c, NESTING_LIMIT)


def accept(c: Cursor, kind: str) -> bool:
    """Skip the next token if it is of this kind, and say whether it was."""
    if c.kinds[c.position] != kind:
        return False
    c.position += 1
    return True


def expect(c: Cursor, kind: str, where: str) -> None:
    """Skip a token that must be there; `where` completes "expected `kind` ..."."""
    if c.kinds[c.position] != kind:
        raise syntax_errors.missing(c, kind, where)
    c.position += 1


def close(c: Cursor, bracket: str, opened: int) -> None:
    """Skip the bracket that closes the one at token `opened`."""
    if c.kinds[c.position] != bracket:
        raise structure_errors.unclosed(c, bracket, opened)
    c.position += 1


def close_block(c: Cursor, keyword: str, opened: int) -> None:
    """Skip `end if`, `end for`, `end when` or `end while`; the block began at token `opened`."""
    kinds = c.kinds
    if kinds[c.position] != "end" or kinds[c.position + 1] != keyword:
        raise structure_errors.unclosed_block(c, keyword, opened)
    c.position += 2


def identifier(c: Cursor, what: str) -> str:
    """The next token as a name; `what` says of what, for the message: "a component name"."""
    position = c.position
    if c.kinds[position] != IDENT:
        raise syntax_errors.not_a_name(c, what)
    c.position = position + 1
    return c.texts[position]


def new_name(c: Cursor, what: str) -> str:
    """The name of something that is declared here: not one of the predefined types."""
    if c.texts[c.position] in syntax_errors.PREDEFINED:
        raise syntax_errors.predefined_name(c, what)
    return identifier(c, what)
