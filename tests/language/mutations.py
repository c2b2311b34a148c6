"""Broken models: valid ones with a word, a number, an operator or a whole line changed. Deterministic.

Most changes put something of the same kind in the place, so that the text is still Modelica and the mistake
reaches the stages behind the parser; the others do not care.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from hashlib import sha256

_TOKEN = re.compile(r'\s+|//[^\n]*|"[^"]*"|[A-Za-z_]\w*|\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|<>|[:<>=]=|\S')
_KINDS: tuple[tuple[str, ...], ...] = (
    ("Real", "Integer", "Boolean", "String"),
    ("parameter", "constant", "discrete", "input", "output", "flow", "final", "each", "replaceable", "inner",
     "outer", "protected", "partial", "encapsulated", "redeclare"),
    ("+", "-", "*", "/", "^", "<", ">", "<=", ">=", "==", "<>", "and", "or"),
    ("der", "sum", "size", "sin", "noEvent", "integer", "max", "ndims", "abs", "fill", "cat", "sqrt"),
    ("0", "1", "2", "3", "4", "7", "-1", "1.5", "1e308", "5000", "2000000000", "true", '"text"', "time"),
)  # fmt: skip
_SPICE = (
    "end", "(", ")", "{", "}", "[", "]", ",", ";", "=", ":=", ".", ":", "if", "then", "else", "for", "loop",
    "in", "connect", "extends", "not", "when", "pre", "while", "return", "break", "import",
)  # fmt: skip


_FRAME = frozenset(
    "end if then else elseif for loop in while when equation algorithm initial import extends connect"
    " constrainedby external annotation model record connector package block class function type".split()
)
"""Words that hold the text together."""


class Choices:
    """A stream of choices that depends on its seed alone, on any machine and version."""

    def __init__(self, seed: str) -> None:
        self._seed = seed
        self._count = 0

    def below(self, limit: int) -> int:
        self._count += 1
        digest = sha256(f"{self._seed}:{self._count}".encode()).digest()
        return int.from_bytes(digest[:8], "big") % limit

    def of(self, items: Sequence[str]) -> str:
        return items[self.below(len(items))]


def mutations(text: str, seed: str, count: int) -> Iterator[str]:
    """`count` broken versions of a text, each with one to three changes."""
    for number in range(count):
        choices = Choices(f"{seed}:{number}")
        mutant = text
        for _ in range(1 + choices.below(3)):
            mutant = _line(mutant, choices) if choices.below(5) == 0 else _word(mutant, choices)
        yield mutant


def _line(text: str, choices: Choices) -> str:
    """Delete, double or move a line."""
    lines = text.split("\n")
    place, other = choices.below(len(lines)), choices.below(len(lines))
    match choices.below(3):
        case 0:
            del lines[place]
        case 1:
            lines.insert(other, lines[place])
        case _:
            lines[place], lines[other] = lines[other], lines[place]
    return "\n".join(lines)


def _word(text: str, choices: Choices) -> str:
    tokens: list[str] = _TOKEN.findall(text)
    words = [i for i, token in enumerate(tokens) if token not in _FRAME and _alike(token, tokens)]
    anything = [i for i, token in enumerate(tokens) if token.strip() and not token.startswith("//")]
    rough = choices.below(12) == 0
    places = anything if rough else words
    if not places:
        return text
    place = places[choices.below(len(places))]
    if rough:
        tokens[place] = choices.of(("", f" {tokens[place]} {choices.of(_SPICE)} ", choices.of(_SPICE)))
    else:
        tokens[place] = choices.of(_alike(tokens[place], tokens))
    return "".join(tokens)


def _alike(token: str, tokens: Sequence[str]) -> Sequence[str]:
    """What may stand in the place of a token: something of its kind, or another name of the text."""
    kind = next((kind for kind in _KINDS if token in kind), None)
    if kind is not None:
        return kind
    if token[0].isdigit() or token[0] == '"':
        return _KINDS[-1]
    if token[0].isalpha():
        return sorted({name for name in tokens if name[0].isalpha() and name not in _FRAME})
    return ()
