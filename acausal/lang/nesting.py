"""How deep a Modelica text may nest, and the room on Python's stack for trees of that depth."""

from __future__ import annotations

import sys
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass, field
from threading import Lock

NESTING_LIMIT = 256
"""Most levels of parentheses, braces, calls, modifications, `if`s, loops and classes inside each other."""

_STACK_FRAMES = 6000
"""Enough for a recursive walk of a tree `NESTING_LIMIT` deep: the parser takes at most 12 frames a level."""


@dataclass
class _Raised:
    """How many walks are under way, and the recursion limit to go back to after the last one."""

    lock: Lock = field(default_factory=Lock)
    walks: int = 0
    before: int = 0


_raised = _Raised()


@contextmanager
def stack_room() -> Generator[None]:
    """Raise Python's recursion limit meanwhile to what a tree at the nesting limit needs.

    Python counts its own calls only (they use no C stack), so the higher limit costs nothing. Threads may
    overlap: the limit goes back when the last of them is done.
    """
    with _raised.lock:
        if _raised.walks == 0:
            _raised.before = sys.getrecursionlimit()
            sys.setrecursionlimit(max(_raised.before, _STACK_FRAMES))
        _raised.walks += 1
    try:
        yield
    finally:
        with _raised.lock:
            _raised.walks -= 1
            if _raised.walks == 0:
                sys.setrecursionlimit(_raised.before)
