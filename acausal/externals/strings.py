"""Strings: MSL's ModelicaStrings functions. Positions count from 1, and only ASCII has letters and digits."""

from __future__ import annotations

import re
from collections.abc import Sequence

from acausal.externals.arguments import Argument, Changed, Routine, text, whole

_LONGEST_TOKEN = 100
_IDENTIFIER = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_INTEGER = re.compile(r"[+-]?[0-9]+(?![.eE0-9])")
_REAL = re.compile(r"[+-]?[0-9]*(?:\.[0-9]*)?(?:[eE][+-]?[0-9]+)?")
_STRING = re.compile(r'"((?:[^"\\]|\\.)+)"', re.DOTALL)
_SPACE = " \t\n\r\v\f"


def length(args: Sequence[Argument]) -> Changed:
    """Number of bytes in UTF-8, which is what the C function counts."""
    return {-1: len(text(args[0]).encode())}


def substring(args: Sequence[Argument]) -> Changed:
    """The characters from a first to a last position; an end before the start gives an empty string."""
    data = text(args[0]).encode()
    start, end = max(1, whole(args[1])), whole(args[2])
    end = start if end < 0 else end
    return {-1: data[start - 1 : max(end, 0)].decode(errors="replace") if end >= start else ""}


def compare(args: Sequence[Argument]) -> Changed:
    """1 less, 2 equal, 3 greater."""
    a, b = text(args[0]), text(args[1])
    if not whole(args[2]):
        a, b = _lower(a), _lower(b)
    return {-1: 2 + (a.encode() > b.encode()) - (a.encode() < b.encode())}


def _lower(value: str) -> str:
    return "".join([c.lower() if c.isascii() else c for c in value])


def skip_white_space(args: Sequence[Argument]) -> Changed:
    """(string, start): the first position from there that is no white space."""
    return {-1: _skipped(text(args[0]), whole(args[1]))}


def _skipped(value: str, start: int) -> int:
    while 1 <= start <= len(value) and value[start - 1] in _SPACE:
        start += 1
    return start


def scan_identifier(args: Sequence[Argument]) -> Changed:
    """(string, start, next, identifier)."""
    value, start = text(args[0]), whole(args[1])
    begin = _skipped(value, start)
    found = _IDENTIFIER.match(value, begin - 1)
    return {2: start, 3: ""} if found is None else {2: found.end() + 1, 3: found.group()}


def scan_integer(args: Sequence[Argument]) -> Changed:
    """(string, start, unsigned, next, number)."""
    value, start = text(args[0]), whole(args[1])
    found = _INTEGER.match(value, _skipped(value, start) - 1)
    if found is None or len(found.group()) >= _LONGEST_TOKEN or _signed(found.group(), args[2]):
        return {3: start, 4: 0}
    return {3: found.end() + 1, 4: int(found.group())}


def scan_real(args: Sequence[Argument]) -> Changed:
    """(string, start, unsigned, next, number)."""
    value, start = text(args[0]), whole(args[1])
    found = _REAL.match(value, _skipped(value, start) - 1)
    token = "" if found is None else found.group()
    broken = (
        found is not None and "e" not in token.lower() and value[found.end() : found.end() + 1] in ("e", "E")
    )
    has_digits = any(c.isdigit() for c in re.split("[eE]", token)[0])
    if found is None or broken or not has_digits or len(token) >= _LONGEST_TOKEN or _signed(token, args[2]):
        return {3: start, 4: 0.0}
    return {3: found.end() + 1, 4: float(token)}


def _signed(token: str, unsigned: Argument) -> bool:
    return bool(whole(unsigned)) and token[0] in "+-"


def scan_string(args: Sequence[Argument]) -> Changed:
    """(string, start, next, text between quotes)."""
    value, start = text(args[0]), whole(args[1])
    found = _STRING.match(value, _skipped(value, start) - 1)
    return {2: start, 3: ""} if found is None else {2: found.end() + 1, 3: found.group(1)}


def hash_string(args: Sequence[Argument]) -> Changed:
    """Arash Partow's AP hash of the bytes, as a signed 32-bit number."""
    value = 0xAAAAAAAA
    for i, byte in enumerate(text(args[0]).encode()):
        mixed = (
            (value << 7) ^ (byte * (value >> 3)) if i % 2 == 0 else ~((value << 11) + (byte ^ (value >> 5)))
        )
        value = (value ^ mixed) & 0xFFFFFFFF
    return {-1: value - (1 << 32) if value >> 31 else value}


STRINGS: dict[str, Routine] = {
    "ModelicaStrings_length": length,
    "ModelicaStrings_substring": substring,
    "ModelicaStrings_compare": compare,
    "ModelicaStrings_skipWhiteSpace": skip_white_space,
    "ModelicaStrings_scanIdentifier": scan_identifier,
    "ModelicaStrings_scanInteger": scan_integer,
    "ModelicaStrings_scanReal": scan_real,
    "ModelicaStrings_scanString": scan_string,
    "ModelicaStrings_hashString": hash_string,
}
