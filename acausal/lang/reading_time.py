"""How long reading and parsing files has taken so far, wherever it happens.

Files of a library are read in the middle of flattening, when a name in them is first looked up; the clock
of the pipeline takes that time out of the step it falls into.
"""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass
from time import perf_counter


@dataclass
class _Spent:
    seconds: float = 0.0
    depth: int = 0


_spent = _Spent()


def seconds_reading() -> float:
    """Seconds spent inside `reading` since the start of the process."""
    return _spent.seconds


@contextmanager
def reading() -> Generator[None]:
    """Count the time of this block; blocks inside each other count once."""
    began = perf_counter()
    _spent.depth += 1
    try:
        yield
    finally:
        _spent.depth -= 1
        if _spent.depth == 0:
            _spent.seconds += perf_counter() - began
