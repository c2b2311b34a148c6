"""Names and texts of a model in C: identifiers, string literals and comments that nothing breaks out of."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

_OTHER = re.compile(r"[^A-Za-z0-9]+")
_LONGEST = 100
_SAFE = frozenset(
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 _.,:;()[]{}<>=+-/*^|&!~@#$'"
)


def identifier(name: str) -> str:
    """Letters, digits and underscores of a Modelica name: `a[1].'b c'` is `a_1_b_c`."""
    return (_OTHER.sub("_", name).strip("_") or "unnamed")[:_LONGEST]


def identifiers(names: Iterable[str]) -> list[str]:
    """One for each name, all different: what comes again gets a number."""
    taken: set[str] = set()
    found: list[str] = []
    for name in names:
        base = identifier(name)
        chosen, number = base, 1
        while chosen.upper() in taken:
            number += 1
            chosen = f"{base}_{number}"
        taken.add(chosen.upper())
        found.append(chosen)
    return found


def literal(text: str) -> str:
    """A C string literal, in which all but plain characters are octal escapes of their UTF-8 bytes.

    So quotes, backslashes, line ends, trigraphs and other encodings mean themselves.
    """
    return '"' + "".join(map(_escaped, text.encode("utf-8", "replace"))) + '"'


def _escaped(byte: int) -> str:
    character = chr(byte)
    return character if character in _SAFE else f"\\{byte:03o}"


def literals(texts: Sequence[str]) -> str:
    """Literals one below the other, for a table."""
    return ",\n    ".join(map(literal, texts))


def comment(text: str) -> str:
    """A text inside a comment, cut to one line: what could end or nest a comment is replaced."""
    plain = "".join(c if c in _SAFE and c != "*" else "_" for c in text)
    return plain[:_LONGEST]
