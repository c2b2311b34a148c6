"""Lines that differ in indices only are told once: `body[1:8].phi = 0` for eight bodies."""

from __future__ import annotations

import re
from collections.abc import Sequence
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


def _told(group: Sequence[str]) -> str:
    """The text for lines that differ in indices only."""
    first = group[0]
    if len(group) == 1:
        return first
    numbers = [_INDEX.findall(line) for line in group]
    varying = [i for i, column in enumerate(zip(*numbers, strict=True)) if len(set(column)) > 1]
    columns = {tuple(row[i] for row in numbers) for i in varying}
    run = next(iter(columns)) if len(columns) == 1 else ()
    if run and all(text.isdecimal() for text in run) and _is_range([int(text) for text in run]):
        parts = iter(range(len(numbers[0])))
        return _INDEX.sub(lambda found: f"{run[0]}:{run[-1]}" if next(parts) in varying else found[0], first)
    return f"{first}  (and {len(group) - 1} more of other indices)"


def _is_range(values: Sequence[int]) -> bool:
    return all(after == before + 1 for before, after in pairwise(values))
