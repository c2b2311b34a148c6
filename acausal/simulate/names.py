"""Close matches for names that do not exist."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """A hint with up to three close names; empty when nothing is close."""
    matches = get_close_matches(name, list(known), n=3, cutoff=0.5)
    return f"did you mean {' or '.join(matches)}?" if matches else ""


NAME_IT_TOO = "name it among the variables to compile for, or leave `only` out"


def left_out(name: str) -> str:
    """What is said about a variable that the chosen outputs do not need."""
    return f"`{name}` was left out: what was compiled for does not need it"
