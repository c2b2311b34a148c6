"""Lines that differ in indices only are told once: `body[1:8].phi = 0` for eight bodies."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise

_INDEX = re.compile(r"(?<=\[)\d+(?:, ?\d+)*(?=\])")


def folded(lines: Sequence[str]) -> list[str]:
    """One line for all that are equal but for the numbers in brackets, where the first of them stands.

    Numbers without gaps become a range, others stay those of the first line, with how many follow. Linear.
    """
    groups: dict[str, list[str]] = {}
    for line in lines:
        groups.setdefault(_INDEX.sub("*", line), []).append(line)
    return [_told(group) for group in groups.values()]


def listing(lines: Sequence[str], most: int | None) -> Iterator[str]:
    """Indented: folded and, after `most` of them, how many are left out; all as they are where it is None."""
    rows = lines if most is None else folded(lines)
    yield from (f"  {row}" for row in rows[:most])
    if most is not None and len(rows) > most:
        yield f"  and {len(rows) - most} more; --all shows them"


def _told(group: Sequence[str]) -> str:
    """The text for lines that differ in indices only."""
    first = group[0]
    if len(group) == 1:
        return first
    columns = list(zip(*[_INDEX.findall(line) for line in group], strict=True))
    ranges = [_range(column) for column in columns]
    if None in ranges:
        return f"{first}  (and {len(group) - 1} more of other indices)"
    texts = iter(ranges)
    return _INDEX.sub(lambda _: next(texts) or "", first)


def _range(column: Sequence[str]) -> str | None:
    """`3` where all are 3, `1:8` for numbers without gaps; None for others."""
    if all(text == column[0] for text in column):
        return column[0]
    if not all(text.isdecimal() for text in column):
        return None
    values = [int(text) for text in column]
    steady = all(after == before + 1 for before, after in pairwise(values))
    return f"{column[0]}:{column[-1]}" if steady else None
