"""Broken models: valid ones with tokens deleted, doubled, swapped, renamed or replaced. Deterministic."""

from __future__ import annotations

import re
from collections.abc import Iterator
from hashlib import sha256

_TOKEN = re.compile(r'\s+|//[^\n]*|"[^"]*"|[A-Za-z_]\w*|\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|<>|[:<>=]=|\S')
_SPICE = (
    "0", "-1", "1e308", "true", '"text"', "time", "end", "each", "final", "parameter", "constant", "input",
    "output", "flow", "redeclare", "replaceable", "protected", "x", "n", "(", ")", "{", "}", "[", "]", ",",
    ";", "=", ":=", ".", ":", "+", "*", "/", "^", "<", "der", "sum", "size", "if", "then", "else", "for",
    "loop", "in", "connect", "extends", "model", "partial", "Real", "Integer", "Boolean", "String", "not",
    "100000", "Test", "inner", "outer", "when", "pre", "while", "return", "break", "import", "encapsulated",
)  # fmt: skip


class Choices:
    """A stream of choices that depends on its seed alone, on any machine and version."""

    def __init__(self, seed: str) -> None:
        self._seed = seed
        self._count = 0

    def below(self, limit: int) -> int:
        self._count += 1
        digest = sha256(f"{self._seed}:{self._count}".encode()).digest()
        return int.from_bytes(digest[:8], "big") % limit


def mutations(text: str, seed: str, count: int) -> Iterator[str]:
    """`count` broken versions of a text, each with one to three changes."""
    tokens = _TOKEN.findall(text)
    places = [i for i, token in enumerate(tokens) if token.strip() and not token.startswith("//")]
    names = sorted({token for token in tokens if token[0].isalpha()})
    for number in range(count):
        choices = Choices(f"{seed}:{number}")
        changed = list(tokens)
        for _ in range(1 + choices.below(3)):
            _change(changed, places, names, choices)
        yield "".join(changed)


def _change(tokens: list[str], places: list[int], names: list[str], choices: Choices) -> None:
    place, other = places[choices.below(len(places))], places[choices.below(len(places))]
    match choices.below(6):
        case 0:
            tokens[place] = ""
        case 1:
            tokens[place] += " " + tokens[place]
        case 2:
            tokens[place], tokens[other] = tokens[other], tokens[place]
        case 3:
            tokens[place] = names[choices.below(len(names))]
        case 4:
            tokens[place] = _SPICE[choices.below(len(_SPICE))]
        case _:
            tokens[place] += " " + _SPICE[choices.below(len(_SPICE))] + " "
