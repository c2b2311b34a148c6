"""Comparing syntax trees with their spans, which the equality of nodes leaves out."""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from typing import cast

from acausal.errors import Span


def differences(a: object, b: object, where: str = "") -> list[str]:
    """Paths at which two trees differ, spans included; none for identical ones."""
    if isinstance(a, Span) and isinstance(b, Span):
        same = (a.source.text, a.start, a.end) == (b.source.text, b.start, b.end)
        return [] if same else [f"{where}: {a.start}-{a.end} and {b.start}-{b.end}"]
    first, second = _parts(a), _parts(b)
    if not first and not second:
        return [] if a == b and type(a) is type(b) else [f"{where}: {a!r} and {b!r}"]
    if list(first) != list(second):
        return [f"{where}: different parts"]
    found = [d for name in first for d in differences(first[name], second[name], f"{where}.{name}")]
    return found if type(a) is type(b) else [f"{where}: {type(a)} and {type(b)}"]


def _parts(value: object) -> dict[str, object]:
    if isinstance(value, tuple):
        return {str(i): item for i, item in enumerate(cast("tuple[object, ...]", value))}
    if is_dataclass(value):
        return {field.name: getattr(value, field.name) for field in fields(value)}
    return {}
