"""Text -> tokens: the lexical units of Modelica 3.6 (appendix A.1) as four parallel lists.

One regular expression cuts the whole text into (white space and comments, token) pairs; kinds are looked
up per distinct token text and positions are running sums, so almost all work happens in C. There are no
token objects: token `i` has a kind `kinds[i]`, a text `texts[i]` and the characters `starts[i]:ends[i]`.

The kind of a keyword, operator or bracket is its own text; all others are the constants below. The last
two tokens at least are `EOF`, with an empty text, so that one may always look one token ahead.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import accumulate
from sys import intern

from acausal.errors import Source
from acausal.lang.lexical_errors import binary_file, illegal_token, wrong_encoding

IDENT = "identifier"
STRING = "string"
INTEGER = "integer"
REAL = "real"
EOF = "end of file"
STORED_CLASS = "stored class"
STORED_NOTE = "stored annotation"
"""A class or an annotation that is known to stand here, and is not cut into tokens; see `tokenize_around`."""
ILLEGAL = "illegal"
_ESCAPED_NAME = "escaped name"

KEYWORDS = frozenset(
    """
    algorithm and annotation block break class connect connector constant constrainedby der discrete each
    else elseif elsewhen encapsulated end enumeration equation expandable extends external false final flow
    for function if import impure in initial inner input loop model not operator or outer output package
    parameter partial protected public pure record redeclare replaceable return stream then true type when
    while within
    """.split()
)
OPERATORS = frozenset(":= == <> <= >= .+ .- .* ./ .^ + - * / ^ = < > ( ) [ ] { } ; , : .".split())

LARGEST_INTEGER = 2**63 - 1
"""Integer literals above this are refused; Modelica's Integer is a machine integer."""

_TOKENS = re.compile(
    r"""
    ( (?: [ \t\r\n]++ | //[^\r\n]*+ | /\*(?:[^*]|\*(?!/))*+\*/ | \A\ufeff )*+ )
    ( [A-Za-z_][A-Za-z0-9_]*+
    | [(){},;\[\]]
    | =(?!=)
    | (?: [0-9]++ (?:\.[0-9]*+)?+ | \.[0-9]++ ) (?: [eE][+-]?[0-9]++ )?+
    | "[^"\\]*+(?:\\.[^"\\]*+)*+"
    | '(?: [ -&(-\[\]-~] | \\['"?\\abfnrtv] )*+'
    | ".*+ | '[^\r\n]*+ | /\*.*+ | \*/    # never closed, and so on: illegal, taken whole to stay linear
    | := | == | <> | <= | >= | \.[-+*/^] | [-+*/^<>:.]
    | \Z
    | .
    )
    """,
    re.VERBOSE | re.DOTALL,
)

_STRING = re.compile(r"""\"[^"\\]*+(?:\\['"?\\abfnrtv][^"\\]*+)*+\"""")
_QUOTED_NAME = re.compile(r"""'(?:[ -&(-\[\]-~]|\\['"?\\abfnrtv])*+'""")
_ESCAPE = re.compile(r"\\(.)", re.DOTALL)
_ESCAPES = {"a": "\a", "b": "\b", "f": "\f", "n": "\n", "r": "\r", "t": "\t", "v": "\v"}
_DIGITS = frozenset("0123456789")
_LETTERS = frozenset("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_")


@dataclass(frozen=True, slots=True)
class Tokens:
    """The tokens of one source as parallel lists, ended by at least two of kind `EOF`."""

    source: Source
    kinds: list[str]
    texts: list[str]
    starts: list[int]
    ends: list[int]


class _Kinds(dict[str, str]):
    """Token text -> kind; a text not met before is classified by its first character and remembered."""

    def __missing__(self, text: str) -> str:
        kind = _classify(text)
        if kind != STRING:
            self[text] = kind
        return kind


_FIXED_KINDS = {intern(text): intern(text) for text in sorted(KEYWORDS | OPERATORS)} | {"": EOF}


def _classify(text: str) -> str:
    """The kind of a token that is not a keyword or an operator."""
    first = text[0]
    if first in _LETTERS:
        return IDENT
    if first in _DIGITS or (first == "." and len(text) > 1):
        return _classify_number(text)
    if first == '"':
        return STRING if _STRING.fullmatch(text) else ILLEGAL
    if first == "'" and _QUOTED_NAME.fullmatch(text):
        return _ESCAPED_NAME if "\\" in text else IDENT
    return ILLEGAL


def _classify_number(text: str) -> str:
    if text.isdigit():
        too_big = len(text) > 18 and (len(text) > 1000 or int(text) > LARGEST_INTEGER)
        return ILLEGAL if too_big else INTEGER
    return ILLEGAL if float(text) == float("inf") else REAL


def decode(data: bytes, path: str) -> Source:
    """The bytes of a file as a source text; a byte order mark is dropped.

    Raises SyntaxProblem: `syntax.not-modelica` for a binary file, `syntax.encoding` for anything that is
    not UTF-8 (Modelica 3.6, section 13.4, asks for it; no other encoding is guessed).
    """
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise wrong_encoding(data, path, "UTF-16")
    if b"\0" in data:
        raise binary_file(Source(path, data.decode("ascii", "replace")))
    try:
        return Source(path, data.decode("utf-8-sig"))
    except UnicodeDecodeError:
        raise wrong_encoding(data, path, "") from None


def tokenize(source: Source) -> Tokens:
    """Cut a source into tokens; raises SyntaxProblem at the first one that is not Modelica."""
    if "\0" in source.text:
        raise binary_file(source)
    parts = _TOKENS.split(source.text)
    texts = list(map(intern, parts[2::3]))
    positions = list(accumulate(map(len, parts)))
    kinds = list(map(_Kinds(_FIXED_KINDS).__getitem__, texts))
    starts, ends = positions[1::3], positions[2::3]
    if ILLEGAL in kinds:
        index = kinds.index(ILLEGAL)
        raise illegal_token(source, starts[index], texts[index], first=index == 0)
    if _ESCAPED_NAME in kinds:
        _normalise_names(kinds, texts)
    for column, value in ((kinds, EOF), (texts, "")):
        column.append(value)
    for column in (starts, ends):
        column.append(len(source.text))
    return Tokens(source, kinds, texts, starts, ends)


def tokenize_around(source: Source, start: int, end: int, holes: Sequence[tuple[str, int, int]]) -> Tokens:
    """The tokens of the characters `start` to `end`, each hole (kind, start, end) being one token."""
    kinds, texts, starts, ends = list[str](), list[str](), list[int](), list[int]()
    kind_of = _Kinds(_FIXED_KINDS).__getitem__
    for kind, opened, closed in (*holes, (EOF, end, end), (EOF, end, end)):
        parts = _TOKENS.split(source.text[start:opened])
        pieces = list(map(intern, parts[2::3]))
        positions = list(accumulate(map(len, parts), initial=start))
        count = len(pieces)
        while count and not pieces[count - 1]:
            count -= 1  # where this piece ends the text does not
        texts += [*pieces[:count], "" if kind == EOF else kind]
        kinds += [*map(kind_of, pieces[:count]), kind]
        starts += [*positions[2 : 2 + 3 * count : 3], opened]
        ends += [*positions[3 : 3 + 3 * count : 3], closed]
        start = closed
    if ILLEGAL in kinds:
        index = kinds.index(ILLEGAL)
        raise illegal_token(source, starts[index], texts[index], first=False)
    if _ESCAPED_NAME in kinds:
        _normalise_names(kinds, texts)
    return Tokens(source, kinds, texts, starts, ends)


def _normalise_names(kinds: list[str], texts: list[str]) -> None:
    r"""Turn the redundant escapes `\?` and `\"` of quoted identifiers into the characters they mean."""
    for index, kind in enumerate(kinds):
        if kind == _ESCAPED_NAME:
            kinds[index] = IDENT
            texts[index] = intern(_ESCAPE.sub(lambda m: m[1] if m[1] in '?"' else m[0], texts[index]))


def string_value(text: str) -> str:
    """The content of a string token: without its quotes, escapes applied, line ends as newlines."""
    value = text[1:-1]
    if "\r" in value:
        value = value.replace("\r\n", "\n").replace("\r", "\n")
    if "\\" in value:
        value = _ESCAPE.sub(lambda match: _ESCAPES.get(match[1], match[1]), value)
    return value
