"""The messages of the parser: what was expected, what is there instead, and what to write.

Each function looks at the tokens around the place where the parser is stuck and builds the SyntaxProblem;
the caller raises it. None of this runs on a correct text.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from acausal.errors import Diagnostic, Span, SyntaxProblem
from acausal.lang.lexer import EOF, IDENT, INTEGER, KEYWORDS, REAL, STRING

if TYPE_CHECKING:
    from acausal.lang.cursor import Cursor

PREDEFINED = frozenset(("Real", "Integer", "Boolean", "String"))

_RIGHT_SPELLING = {
    "elif": "elseif",
    "elsif": "elseif",
    "elseIf": "elseif",
    "elsewhere": "elsewhen",
    "endif": "end if",
    "endfor": "end for",
    "endwhen": "end when",
    "endwhile": "end while",
    "extend": "extends",
    "equations": "equation",
    "algorithms": "algorithm",
    "parameters": "parameter",
    "const": "constant",
    "var": "",
    "let": "",
}


def problem(code: str, message: str, span: Span, hint: str = "") -> SyntaxProblem:
    """A SyntaxProblem with the code `syntax.<code>`."""
    return SyntaxProblem(Diagnostic(f"syntax.{code}", message, span, hint=hint))


_NO_INCREMENT = "Modelica has no such operator: write x := x + 1"
_FOREIGN_PAIRS = {
    **dict.fromkeys(("++", "--", "+=", "-=", "*=", "/=", "^="), _NO_INCREMENT),
    "**": "a power is written with ^",
    "=>": "greater or equal is written >=",
    "=<": "less or equal is written <=",
}
"""Two tokens without a space between them that are one operator elsewhere."""


# --------------------------------------------------------------------------- describing tokens


def found(c: Cursor, position: int | None = None) -> str:
    """The next token (or the one at `position`) in words: "found `x`"."""
    at = c.position if position is None else position
    kind, text = c.kinds[at], c.texts[at]
    if kind == EOF:
        return "found the end of the file"
    first_line = text.splitlines()[0]
    text = first_line if first_line == text else first_line + "..."
    shown = text if len(text) <= 40 else text[:37] + "..."
    if kind == STRING:
        return f"found the string {shown}"
    return f"found the keyword `{shown}`" if kind in KEYWORDS else f"found `{shown}`"


def token_span(c: Cursor, position: int | None = None) -> Span:
    """The next token (or the one at `position`)."""
    at = c.position if position is None else position
    return Span(c.source, c.starts[at], max(c.ends[at], c.starts[at] + 1))


def after_previous(c: Cursor) -> Span:
    """The place just behind the last token read, where a missing `;` or `)` belongs."""
    end = c.ends[c.position - 1] if c.position else 0
    return Span(c.source, end, end + 1)


def touching(c: Cursor, position: int | None = None) -> bool:
    """Whether nothing stands between the next token (or the one at `position`) and the one before."""
    at = c.position if position is None else position
    return 0 < at < len(c.starts) and c.ends[at - 1] == c.starts[at]


def line_of(c: Cursor, position: int) -> int:
    """The line of token `position`."""
    return c.source.position(c.starts[position])[0]


# --------------------------------------------------------------------------- general


def unexpected(c: Cursor, expected: str, hint: str = "") -> SyntaxProblem:
    """The next token is not what the grammar allows."""
    return problem("unexpected", f"expected {expected}, {found(c)}", token_span(c), confusion(c) or hint)


def missing(c: Cursor, kind: str, where: str) -> SyntaxProblem:
    """The token `kind` is not there; a missing `;` is shown at the end of the token before."""
    span = after_previous(c) if kind == ";" and c.position else token_span(c)
    code = {";": "missing-semicolon", "then": "missing-then", "loop": "missing-loop"}.get(kind, "unexpected")
    hint = confusion(c) or _missing_hint(c, kind)
    return problem(code, f"expected `{kind}` {where}, {found(c)}", span, hint)


def _missing_hint(c: Cursor, kind: str) -> str:
    next_kind, next_text = c.kinds[c.position], c.texts[c.position]
    if kind == "else":
        return "an `if` expression has a value in every case: `if c then a else b`"
    if kind in ("then", "loop"):
        if next_text in (":", "do", "begin", "{", "then", "loop"):
            return f"write `{kind}` instead of `{next_text}`"
        if next_kind == "=":
            return (
                "a comparison is written =="
                if kind == "then"
                else "the range follows the word `in`: for i in 1:n"
            )
        return f"insert `{kind}`"
    return _semicolon_hint(c, next_kind) if kind == ";" else ""


def _semicolon_hint(c: Cursor, next_kind: str) -> str:
    if next_kind == STRING:
        return "a description has one string, before the annotation and the `;`; join strings with +"
    if next_kind == "annotation":
        return "this construct has no annotation here, or has one already"
    if next_kind == "=":
        return "there is one = in an equation; a comparison is written =="
    if c.kinds[c.position - 1] in (INTEGER, REAL) and next_kind == IDENT and touching(c):
        return "a name cannot begin with a digit; a product is written with *"
    if next_kind in (")", "]", "}"):
        return f"no bracket is open that this `{next_kind}` could close"
    return "insert `;`"


def confusion(c: Cursor) -> str:
    """A hint when the token at hand (or the one before) is a well-known slip from another language."""
    for position in (c.position, c.position - 1):
        text = c.texts[position] if position >= 0 else ""
        if text in _RIGHT_SPELLING and c.kinds[position] == IDENT:
            right = _RIGHT_SPELLING[text]
            return (
                f"write `{right}` instead of `{text}`"
                if right
                else f"Modelica has no `{text}`: write the type first"
            )
    for position in (c.position, c.position + 1):
        pair = "".join(c.texts[max(position - 1, 0) : position + 1])
        if pair in _FOREIGN_PAIRS and touching(c, position):
            return _FOREIGN_PAIRS[pair]
    if c.kinds[c.position] == ":=":
        return "`:=` assigns in algorithms; here write ="
    if c.kinds[c.position] == "==":
        return "`==` compares two values; to bind or equate write ="
    return ""


def too_deep(c: Cursor, limit: int) -> SyntaxProblem:
    """More than `limit` levels inside each other."""
    hint = "give inner parts names of their own; a chain of `else if` is written with `elseif`"
    return problem("nesting", f"more than {limit} levels of nesting", token_span(c), hint)


# --------------------------------------------------------------------------- names


def not_a_name(c: Cursor, what: str) -> SyntaxProblem:
    """An identifier was expected."""
    text = c.texts[c.position]
    hint = confusion(c)
    if text in KEYWORDS and text not in ("end", "annotation", "equation", "algorithm"):
        message = f"expected {what}, but `{text}` is a keyword"
        hint = f"choose another name, such as `{text}_`, or quote it: '{text}'"
        return problem("keyword", message, token_span(c), hint)
    if c.kinds[c.position] in (INTEGER, REAL):
        hint = "a name begins with a letter or an underscore"
    if c.kinds[c.position] in ("=", ":=", "(", "+", "-", "*", "/") and what == "a component name":
        hint = "equations come after the word `equation`, statements after `algorithm`"
    return problem("unexpected", f"expected {what}, {found(c)}", token_span(c), hint)


def predefined_name(c: Cursor, what: str) -> SyntaxProblem:
    """`Real`, `Integer`, `Boolean` or `String` declared anew (Modelica 3.6, section 2.3.3)."""
    name = c.texts[c.position]
    message = f"expected {what}, but `{name}` is a predefined type and cannot be declared"
    return problem("keyword", message, token_span(c), "choose another name")


# --------------------------------------------------------------------------- expressions


def chained(c: Cursor) -> SyntaxProblem:
    """The operator at hand follows one of its own kind but does not associate."""
    operator = c.kinds[c.position]
    if operator in ("^", ".^"):
        hint = "write (a^b)^c or a^(b^c)"
    elif operator == ":":
        hint = "a range is start : stop or start : step : stop"
    else:
        hint = "write for example `a < b and b < c`, or put parentheses around one comparison"
    return problem("chain", f"a second `{operator}` cannot follow without parentheses", token_span(c), hint)


def misplaced_operator(c: Cursor) -> SyntaxProblem:
    """A sign or `not` where the grammar wants a factor: `2*-3`, `a + -b`, `- -a`, `a == not b`."""
    operator = c.texts[c.position]
    previous = c.texts[c.position - 1] if c.position else ""
    next_text = c.texts[c.position + 1]
    space = " " if operator == "not" else ""
    what = "`not`" if operator == "not" else f"the sign `{operator}`"
    named = next_text if next_text and len(next_text) <= 20 else "..."
    hint = confusion(c) or f"put parentheses around it: {previous} ({operator}{space}{named})"
    return problem("sign", f"{what} cannot follow `{previous}` directly", token_span(c), hint)


def misplaced_subscript(c: Cursor) -> SyntaxProblem:
    """`(a + b)[1]`."""
    hint = "give the expression a name and subscript that (Modelica 3.6, section 3.2)"
    return problem("subscript", "only a name can have a subscript, not parentheses", token_span(c), hint)


def positional_after_named(c: Cursor) -> SyntaxProblem:
    """`f(a = 1, 2)`."""
    hint = "put all arguments without a name first"
    return problem("argument-order", "an argument without a name follows a named one", token_span(c), hint)


def stray_expression(c: Cursor) -> SyntaxProblem:
    """An expression was expected."""
    kind, previous = c.kinds[c.position], c.texts[c.position - 1] if c.position else ""
    hint = confusion(c) or _stray_hints(kind, previous)
    after = f" after `{previous}`" if previous and len(previous) < 20 else ""
    return problem("expression", f"expected an expression{after}, {found(c)}", token_span(c), hint)


def _stray_hints(kind: str, previous: str) -> str:
    match kind, previous:
        case "if", _:
            return "put parentheses around the `if` expression"
        case "function", _:
            return "`function f(...)` is only allowed as an argument of a call"
        case "end", ";" | ",":
            return "a bracket before this is still open"
        case "]", "[":
            return "a whole dimension is written `:`, as in a[:]"
        case "end", "+" | "-" | "*" | "/" | "(" | ":":
            return "`end` is a value only inside a subscript, as in a[end]"
        case "=", "=":
            return "a comparison is written ==, without a space"
        case _:
            return ""
