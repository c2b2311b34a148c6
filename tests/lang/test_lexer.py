"""Lexical units of Modelica 3.6, and what is not one."""

from __future__ import annotations

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from acausal.errors import Source, SyntaxProblem
from acausal.lang.lexer import (
    EOF,
    IDENT,
    INTEGER,
    KEYWORDS,
    REAL,
    STRING,
    Tokens,
    decode,
    string_value,
    tokenize,
)


def tokens(text: str) -> list[tuple[str, str]]:
    result = tokenize(Source("t.mo", text))
    assert result.kinds[-1] == EOF
    return [pair for pair in zip(result.kinds, result.texts, strict=True) if pair[0] != EOF]


def tokens_or_none(text: str) -> Tokens | None:
    try:
        return tokenize(Source("t.mo", text))
    except SyntaxProblem:
        return None


def refused(text: str) -> tuple[str, int, int, str]:
    with pytest.raises(SyntaxProblem) as caught:
        tokenize(Source("t.mo", text))
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.span is not None
    return diagnostic.code, diagnostic.span.line, diagnostic.span.column, diagnostic.hint


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        ("abc _a1 A", [IDENT, IDENT, IDENT]),
        ("0 12 007", [INTEGER] * 3),
        ("1. 1.5 .5 1e3 1.e-3 .5E+2 1.5e0", [REAL] * 7),
        ("2.*x", [REAL, "*", IDENT]),
        ("2 .*x", [INTEGER, ".*", IDENT]),
        ("1:2", [INTEGER, ":", INTEGER]),
        ("a.b", [IDENT, ".", IDENT]),
        ("a<>b<=c>=d==e:=f", [IDENT, "<>", IDENT, "<=", IDENT, ">=", IDENT, "==", IDENT, ":=", IDENT]),
        (".+ .- .* ./ .^", [".+", ".-", ".*", "./", ".^"]),
        ("(){}[];,.", list("(){}[];,.")),
        ('"" "a" "\\"" "a\nb"', [STRING] * 4),
        ("'a b' '' '\\'' '\"'", [IDENT] * 4),
        ("model models", ["model", IDENT]),
        ("a//b\nc", [IDENT, IDENT]),
        ("a/*b\n*/c/**/d/***/e/*/*/f", [IDENT] * 5),
        ('a"//"b', [IDENT, STRING, IDENT]),
        ("\ufeffmodel", ["model"]),
        ("", []),
        (" \t\r\n", []),
        ("// only a comment", []),
    ],
)
def test_kinds(text: str, kinds: list[str]) -> None:
    assert [kind for kind, _ in tokens(text)] == kinds


def test_keywords_are_their_own_kind() -> None:
    for word in sorted(KEYWORDS):
        assert tokens(word) == [(word, word)]
        assert tokens(f"'{word}'") == [(IDENT, f"'{word}'")]


def test_positions_point_into_the_text() -> None:
    source = Source("t.mo", 'model M // comment\n  Real x = "a"; /* b */ end M;\n')
    result = tokenize(source)
    for text, start, end in zip(result.texts, result.starts, result.ends, strict=True):
        assert source.text[start:end] == text


def test_redundant_escapes_in_names_mean_the_character() -> None:
    assert tokens(r"""'a\?\"\'\\'""") == [(IDENT, r"""'a?"\'\\'""")]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ('""', ""),
        (r'"\"\\\'\?\a\b\f\n\r\t\v"', "\"\\'?\a\b\f\n\r\t\v"),
        (r'"a\\n"', "a\\n"),
        ('"a\r\nb\rc"', "a\nb\nc"),
        ('"Grüße"', "Grüße"),
    ],
)
def test_string_values(text: str, value: str) -> None:
    assert tokens(text) == [(STRING, text)]
    assert string_value(text) == value


@pytest.mark.parametrize(
    ("text", "code", "column", "hint"),
    [
        ("a != b", "syntax.operator", 3, "<>"),
        ("a ~= b", "syntax.operator", 3, "<>"),
        ("a && b", "syntax.operator", 3, "`and`"),
        ("a || b", "syntax.operator", 3, "`or`"),
        ("a !b", "syntax.operator", 3, "`not`"),
        ("a % b", "syntax.character", 3, "mod(a, b)"),
        ("a # b", "syntax.character", 3, "//"),
        ("a \\ b", "syntax.character", 3, "backslash"),
        ("größe", "syntax.character", 3, "ASCII"),
        ("a\u00a0b", "syntax.character", 2, "no-break space"),
        ("a \u2212 b", "syntax.character", 3, "write -"),
        ("a \u201cb", "syntax.character", 3, 'write "'),
        ("a\fb", "syntax.character", 2, "form feed"),
        ("a \ufeff", "syntax.character", 3, "byte order mark"),
        ('a "b', "syntax.string", 3, "close it"),
        ('a "b\\"', "syntax.string", 3, "close it"),
        ('a "b\\q"', "syntax.escape", 5, r"\\"),
        ('a "\\\\\\q"', "syntax.escape", 6, r"\\"),
        ("a 'b", "syntax.name", 3, "close it"),
        ("a 'b\n'", "syntax.name", 3, "close it"),
        ("a 'bä'", "syntax.name", 5, "ASCII"),
        ("a '\\q'", "syntax.name", 4, "escapes"),
        ("a /* b", "syntax.comment", 3, "*/"),
        ("a */ b", "syntax.comment", 3, "nest"),
        ("a 9223372036854775808", "syntax.number", 3, "9223372036854775807"),
        ("a " + "9" * 5000, "syntax.number", 3, "Real"),
        ("a 1e400", "syntax.number", 3, "1.797e308"),
        ("a \0", "syntax.not-modelica", 3, ".mo"),
        ("%PDF-1.4", "syntax.not-modelica", 1, "begins with"),
        ("#!/bin/sh", "syntax.not-modelica", 1, "begins with"),
    ],
)
def test_illegal_text(text: str, code: str, column: int, hint: str) -> None:
    found_code, _, found_column, found_hint = refused(text)
    assert (found_code, found_column) == (code, column)
    assert hint in found_hint


def test_the_line_of_an_illegal_character() -> None:
    assert refused("model M\n  Real x ? 3;\nend M;")[:3] == ("syntax.character", 2, 10)


@pytest.mark.parametrize(
    "text",
    [
        "/* " * 50_000,
        '"' + '\\"' * 50_000,
        "'" + "\\'" * 50_000,
        "?" * 50_000,
        "'" * 50_001,
        " " * 500_000 + "?",
    ],
)
def test_illegal_text_is_refused_in_linear_time(text: str) -> None:
    with pytest.raises(SyntaxProblem):
        tokenize(Source("t.mo", text + "?"))


def test_decode_drops_a_byte_order_mark() -> None:
    assert decode("\ufeffmodel M end M;".encode(), "m.mo") == Source("m.mo", "model M end M;")


@pytest.mark.parametrize(
    ("data", "code"),
    [
        ("größe".encode("latin-1"), "syntax.encoding"),
        ("model".encode("utf-16"), "syntax.encoding"),
        (b"\x7fELF\x02\x01\x01\x00\x00\x00", "syntax.not-modelica"),
        (b"abc\xff", "syntax.encoding"),
    ],
)
def test_decode_refuses(data: bytes, code: str) -> None:
    with pytest.raises(SyntaxProblem) as caught:
        decode(data, "m.mo")
    assert caught.value.codes == (code,)
    assert "m.mo" in str(caught.value)


@given(st.text())
@example("\r\r\n\t\v")
def test_tokens_and_the_space_between_them_are_the_whole_text(text: str) -> None:
    result = tokens_or_none(text)
    if result is None:
        return
    assert all(a <= b for a, b in zip(result.starts, result.ends, strict=True))
    assert all(end <= start for end, start in zip(result.ends, result.starts[1:], strict=False))
    gaps = zip([0, *result.ends], [*result.starts, len(text)], strict=True)
    for end, start in gaps:
        assert not text[end:start].strip("\ufeff \t\r\n") or text[end:start].lstrip().startswith(("//", "/*"))
