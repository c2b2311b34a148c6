"""The parser's messages about larger shapes: brackets, blocks, classes, equations, statements, files."""

from __future__ import annotations

from typing import TYPE_CHECKING

from acausal.errors import Span, SyntaxProblem
from acausal.lang.ast import Binary, Call, ComponentReference, Expression
from acausal.lang.lexer import EOF, IDENT, KEYWORDS
from acausal.lang.syntax_errors import after_previous, confusion, found, line_of, problem, token_span

if TYPE_CHECKING:
    from acausal.lang.cursor import Cursor

_BLOCK_SHAPES = {
    "if": "`if condition then ... elseif condition then ... else ... end if`",
    "for": "`for i in range loop ... end for`",
    "when": "`when condition then ... elsewhen condition then ... end when`",
    "while": "`while condition loop ... end while`",
}


# --------------------------------------------------------------------------- brackets and blocks


def unclosed(c: Cursor, bracket: str, opened: int) -> SyntaxProblem:
    """A bracket is not closed where it could be at the latest."""
    opening = c.texts[opened]
    line, column = c.source.position(c.starts[opened])
    hint = confusion(c)
    if not hint and c.kinds[c.position] == "=":
        hint = "a comparison is written =="
    if not hint and c.kinds[c.position] in (")", "]", "}"):
        hint = f"`{opening}` is closed by `{bracket}`"
    message = f"expected `{bracket}` to close the `{opening}` of line {line}, column {column}, {found(c)}"
    return problem("unclosed", message, token_span(c), hint or f"insert `{bracket}` or `,`")


def unclosed_block(c: Cursor, keyword: str, opened: int) -> SyntaxProblem:
    """`end if` and the like are missing or of the wrong kind."""
    at_end = c.kinds[c.position] == "end"
    what = found(c, c.position + 1).replace("found ", "found `end` and ") if at_end else found(c)
    message = f"expected `end {keyword}` to close the `{keyword}` of line {line_of(c, opened)}, {what}"
    hint = confusion(c) or f"the shape is {_BLOCK_SHAPES[keyword]}"
    if keyword == "if" and _has_else_if(c, opened):
        hint = "`else if` opens a second `if` that needs its own `end if`: write `elseif`"
    return problem("unclosed-block", message, token_span(c), hint)


def _has_else_if(c: Cursor, opened: int) -> bool:
    pairs = zip(c.kinds[opened : c.position], c.kinds[opened + 1 : c.position], strict=False)
    return ("else", "if") in pairs


def unclosed_class(c: Cursor, name: str, opened: int, annotated: bool) -> SyntaxProblem:
    """The text of a class ends in something that is no element, equation or `end`."""
    where = f"`{name}` (begun in line {line_of(c, opened)})"
    if c.kinds[c.position] == EOF:
        message = f"the class {where} is never closed: expected `end {name};`, {found(c)}"
        return problem("unclosed-class", message, token_span(c), f"add `end {name};`")
    if annotated:
        message = f"expected `end {name};` after the annotation of the class {where}, {found(c)}"
        hint = "the annotation of a class is its last part, just before `end`: move it there"
        return problem("unexpected", message, token_span(c), hint)
    message = f"expected a declaration, an equation section or `end {name};` in {where}, {found(c)}"
    return problem("unexpected", message, token_span(c), confusion(c) or _section_hint(c))


def _section_hint(c: Cursor) -> str:
    kind = c.kinds[c.position]
    if kind in ("if", "for", "when", "connect", "der", "("):
        return "equations come after the word `equation`, statements after `algorithm`"
    if kind in ("else", "elseif", "elsewhen"):
        return f"no block is open that this `{kind}` could continue"
    return "remove this `;`" if kind == ";" else ""


def wrong_end(c: Cursor, name: str, opened: int) -> SyntaxProblem:
    """`end` of a class with another name, or none."""
    line = line_of(c, opened)
    next_kind, other = c.kinds[c.position + 1], c.texts[c.position + 1]
    if next_kind == IDENT:
        message = f"`end {other}` does not match `{name}`, the class begun in line {line}"
        hint = f"write `end {name};`, or close what is open inside `{name}` first"
    elif next_kind in _BLOCK_SHAPES:
        message = f"`end {other}` closes nothing: no `{other}` is open in `{name}` (line {line})"
        hint = f"remove it, or close the class with `end {name};`"
    else:
        message = f"expected `end {name}` for the class begun in line {line}, {found(c, c.position + 1)}"
        hint = f"write `end {name};`"
    return problem("end-name", message, token_span(c, c.position + 1), hint)


# --------------------------------------------------------------------------- equations, statements, files


def bad_equation(c: Cursor, left: Expression, first: int) -> SyntaxProblem:
    """`left` was read as the left side of an equation, but no `=` follows."""
    if isinstance(left, Binary) and left.operator == "==" and c.kinds[c.position] == ";":
        hint = "an equation is written with a single ="
        return problem("equation", "an equation is written with =, not with ==", left.span, hint)
    if c.kinds[c.position] == ":=":
        hint = "write = in an equation section, or move the assignment into an `algorithm` section"
        return problem("equation", "`:=` assigns; an equation is written with =", token_span(c), hint)
    hint = confusion(c)
    if not hint and isinstance(left, ComponentReference) and c.kinds[c.position] == IDENT:
        hint = "declarations come before the word `equation`, or after `public` or `protected`"
    if not hint and c.kinds[c.position] == ";" and isinstance(left, Call):
        hint = f"the result of {left.function.text}(...) is not used: write an equation with ="
    hint = hint or "an equation is `left = right`, a call, or begins with if, for, when or connect"
    span = after_previous(c) if c.kinds[c.position] == ";" else token_span(c)
    where = f"in the equation of line {line_of(c, first)}"
    return problem("equation", f"expected `=` {where}, {found(c)}", span, hint)


def bad_statement(c: Cursor) -> SyntaxProblem:
    """No statement, or a target that is not followed by `:=`."""
    kind = c.kinds[c.position]
    if kind in ("=", "=="):
        hint = "write := in an algorithm section"
        return problem(
            "statement", f"`{kind}` does not assign; an assignment is written with :=", token_span(c), hint
        )
    if kind == "connect":
        hint = "move the connection into an `equation` section"
        return problem("statement", "a `connect` is an equation, not a statement", token_span(c), hint)
    if kind == ":=":
        hint = "the left of := is a variable, or a list of variables in parentheses"
        return problem("statement", "this cannot be assigned to", token_span(c), hint)
    hint = confusion(c)
    if not hint and c.kinds[c.position - 1] == IDENT and kind == IDENT:
        hint = "declarations come before the word `algorithm`, or after `public` or `protected`"
    return problem(
        "statement", f"expected a statement `variable := value` or a call, {found(c)}", token_span(c), hint
    )


def misordered_prefix(c: Cursor, order: str) -> SyntaxProblem:
    """A prefix stands behind one that it must precede, or twice."""
    message = f"the prefix `{c.kinds[c.position]}` is not allowed here"
    return problem("prefix", message, token_span(c), f"the order of prefixes is: {order}")


def no_class(c: Cursor) -> SyntaxProblem:
    """The text has no class at all."""
    blank = not c.source.text.strip("\ufeff \t\r\n")
    message = f"{c.source.path} is empty" if blank else f"{c.source.path} defines no class"
    span = Span(c.source, 0, 0)
    return problem("empty", message, span, "a Modelica text defines at least one class: model M ... end M;")


def not_modelica(c: Cursor, after_class: bool) -> SyntaxProblem:
    """Something else than a class definition at the outermost level of a text."""
    kind, text = c.kinds[c.position], c.texts[c.position]
    if not after_class and kind not in KEYWORDS and text.lower() not in KEYWORDS:
        looks = " (it looks like JSON)" if kind in ("{", "[") else ""
        message = f"{c.source.path} is not a Modelica text{looks}: expected a class definition, {found(c)}"
        hint = "a Modelica text begins with `within` or a class, such as: model M ... end M;"
        return problem("not-modelica", message, token_span(c), hint)
    message = f"expected a class definition (`model`, `package`, ...), {found(c)}"
    return problem("unexpected", message, token_span(c), confusion(c) or _file_hint(kind, text))


def _file_hint(kind: str, text: str) -> str:
    match kind:
        case ";":
            return "remove this `;`"
        case "end":
            return "this `end` closes no class: one `end` is too many, or a name does not match"
        case "within":
            return "`within` is allowed only once, at the beginning"
        case _ if kind not in KEYWORDS and text.lower() in KEYWORDS:
            return f"keywords are written in small letters: `{text.lower()}`"
        case _:
            return "a file holds classes: model M ... end M;"
