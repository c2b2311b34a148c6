"""The messages of the lexer: why a piece of text is not a Modelica token, and what to write instead."""

from __future__ import annotations

import re

from acausal.errors import Diagnostic, Source, Span, SyntaxProblem

_REPLACEMENTS = (
    ("!=", "<>", "Modelica writes 'not equal' as <>"),
    ("~=", "<>", "Modelica writes 'not equal' as <>"),
    ("&&", "and", "Modelica writes the logical operators as words: and, or, not"),
    ("||", "or", "Modelica writes the logical operators as words: and, or, not"),
    ("&", "and", "Modelica writes the logical operators as words: and, or, not"),
    ("|", "or", "Modelica writes the logical operators as words: and, or, not"),
    ("!", "not", "Modelica writes the logical operators as words: and, or, not"),
)
_TYPOGRAPHY = {
    "\u00a0": "a no-break space: replace it by an ordinary space",
    "\u2212": "a typographic minus sign: write -",
    "\u2013": "a typographic dash: write -",
    "\u2014": "a typographic dash: write -",
    "\u201c": 'a typographic quote: write "',
    "\u201d": 'a typographic quote: write "',
    "\u2018": "a typographic quote: write '",
    "\u2019": "a typographic quote: write '",
    "\u00d7": "a multiplication sign: write *",
    "\u00b7": "a multiplication dot: write *",
}
_OTHERS = {
    "#": "comments start with // in Modelica",
    "%": "comments start with // in Modelica; the remainder of a division is mod(a, b)",
    "\\": "a backslash is only allowed inside strings and quoted identifiers",
    "\f": "white space is space, tab, carriage return and line feed; remove this form feed",
    "\v": "white space is space, tab, carriage return and line feed; remove this vertical tab",
    "\ufeff": "a byte order mark is only allowed at the very beginning of a file; remove it",
}


def binary_file(source: Source) -> SyntaxProblem:
    """The text has NUL characters: it is not a text at all."""
    at = max(source.text.find("\0"), 0)
    return _problem(
        "not-modelica",
        f"{source.path} is not a Modelica text: it contains NUL bytes, as binary files do",
        Span(source, at, at + 1),
        "give the name of a .mo text file",
    )


def wrong_encoding(data: bytes, path: str, encoding: str) -> SyntaxProblem:
    """The bytes of a file are not UTF-8; `encoding` names the one it seems to be, or is empty."""
    source = Source(path, data.decode("utf-16" if encoding else "utf-8", "replace"))
    at = 0 if encoding else max(source.text.find("\ufffd"), 0)
    what = (
        f"it is {encoding}" if encoding else f"the byte at position {_first_bad_byte(data)} does not belong"
    )
    return _problem(
        "encoding",
        f"{path} is not UTF-8 text: {what}",
        Span(source, at, at + 1),
        "save the file as UTF-8, for example: iconv -f LATIN1 -t UTF-8 OLD.mo > NEW.mo",
    )


def _first_bad_byte(data: bytes) -> int:
    try:
        data.decode("utf-8")
    except UnicodeDecodeError as error:
        return error.start
    return 0


def illegal_token(source: Source, at: int, text: str, first: bool) -> SyntaxProblem:
    """The error for the token `text` at offset `at`; `first` says that the text begins with it."""
    character = text[0]
    if text.startswith("/*"):
        return _problem("comment", "this comment never ends", Span(source, at, at + 2), "close it with */")
    if text == "*/":
        hint = "a comment ends at the first */: comments do not nest; comment out blocks with //"
        return _problem("comment", "this */ closes no comment", Span(source, at, at + 2), hint)
    if character == '"':
        return _bad_string(source, at, text)
    if character == "'":
        return _bad_quoted_name(source, at)
    if character in "0123456789.":
        return _bad_number(source, at, text)
    if first:
        message = f"{source.path} is not a Modelica text: it begins with {_show(character)}"
        hint = "a Modelica text begins with `within` or a class, such as: model M ... end M;"
        return _problem("not-modelica", message, Span(source, at, at + 1), hint)
    return _illegal_character(source, at)


def _bad_string(source: Source, at: int, text: str) -> SyntaxProblem:
    if not re.fullmatch(r'"[^"\\]*+(?:\\.[^"\\]*+)*+"', text, re.DOTALL):
        hint = 'close it with "; a double quote inside a string is written \\"'
        return _problem("string", "this string never ends", Span(source, at, at + 1), hint)
    escapes = [match for match in re.finditer(r"\\(.)", text, re.DOTALL) if match[1] not in "'\"?\\abfnrtv"]
    hint = r"write a backslash as \\; the escapes are \' \" \? \\ \a \b \f \n \r \t \v"
    span = Span(source, at + escapes[0].start(), at + escapes[0].end())
    return _problem("escape", f"{_show(escapes[0][0])} is not an escape sequence of Modelica", span, hint)


def _bad_quoted_name(source: Source, at: int) -> SyntaxProblem:
    body = re.compile(r"(?:[^'\\\r\n]|\\[^\r\n])*+'").match(source.text, at + 1)
    if body is None:
        hint = "close it with '; strings are written with double quotes"
        return _problem("name", "this quoted identifier never ends", Span(source, at, at + 1), hint)
    hint = "only printable ASCII characters and the escapes of strings are allowed in a quoted identifier"
    bad = re.compile(r"""[^ -~]|\\[^'"?\\abfnrtv]""").search(
        re.sub(r"\\\\", "xx", source.text[at : body.end()])
    )
    start, end = (at + bad.start(), at + bad.end()) if bad else (at, body.end())
    return _problem(
        "name", f"{_show(source.text[start:end])} in a quoted identifier", Span(source, start, end), hint
    )


def _bad_number(source: Source, at: int, text: str) -> SyntaxProblem:
    shown = text if len(text) <= 30 else text[:27] + "..."
    span = Span(source, at, at + len(text))
    if text.isdigit():
        hint = "the largest Integer is 9223372036854775807; write a Real, with a decimal point"
        return _problem("number", f"the Integer {shown} is too large", span, hint)
    hint = "the largest Real is about 1.797e308; Modelica.Constants.inf serves as infinity"
    return _problem("number", f"the Real {shown} is too large", span, hint)


def _illegal_character(source: Source, at: int) -> SyntaxProblem:
    for wrong, right, reason in _REPLACEMENTS:
        if source.text.startswith(wrong, at):
            span = Span(source, at, at + len(wrong))
            return _problem(
                "operator", f"`{wrong}` is not an operator of Modelica", span, f"{reason}; write `{right}`"
            )
    character = source.text[at]
    hint = _OTHERS.get(character, "")
    if character in _TYPOGRAPHY:
        hint = f"this is {_TYPOGRAPHY[character]}"
    elif character.isalpha():
        hint = "identifiers are made of ASCII letters, digits and underscores; spell this letter out"
    span = Span(source, at, at + 1)
    return _problem("character", f"the character {_show(character)} is not allowed here", span, hint)


def _show(text: str) -> str:
    """The text in backquotes, unprintable characters by their code."""
    shown = "".join(c if c.isprintable() else f"U+{ord(c):04X}" for c in text)
    return f"`{shown}`"


def _problem(code: str, message: str, span: Span, hint: str) -> SyntaxProblem:
    return SyntaxProblem(Diagnostic(f"syntax.{code}", message, span, hint=hint))
