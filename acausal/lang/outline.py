"""What is kept of a parsed file on disk: where its classes and long annotations stand, and what they are.

An outline says that a text is Modelica and how it is divided. The tree itself is not stored: a class is
parsed again from its own part of the text when somebody looks into it (`outline_reading`), with the parts
inside it left out until they are wanted. So a tree from an outline has the same nodes and spans as one from
the parser, and nothing but numbers and names is ever read back.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import cast, get_args

from acausal.lang import ast
from acausal.lang.parser_modifications import CLASS_KINDS

FORMAT = "acausal-outline-1"
"""Changes whenever the meaning of an outline does."""

_FORMS: tuple[type[ast.ClassDefinition], ...] = (ast.LongClass, ast.ShortClass, ast.EnumerationClass)
_PURITIES = get_args(ast.Purity)


@dataclass(frozen=True, slots=True)
class ClassMark:
    """What can be said of a class without looking into it."""

    form: int
    name: str
    kind: ast.ClassKind
    prefixes: ast.Prefixes
    class_prefixes: ast.ClassPrefixes
    extends: bool

    @property
    def node_type(self) -> type[ast.ClassDefinition]:
        return _FORMS[self.form]


@dataclass(frozen=True, slots=True)
class Outline:
    """Of one file: its `within`, whether each class at the top is `final`, and the marks in order.

    Mark `i` covers the characters `starts[i]` to `ends[i]`; `classes[i]` is None for an annotation. Marks
    lie one behind or inside the other.
    """

    within: tuple[str, ...] | None
    finals: tuple[bool, ...]
    starts: list[int]
    ends: list[int]
    classes: list[ClassMark | None]


def outline_of(
    stored: ast.StoredDefinition, marks: Sequence[ast.ClassDefinition | ast.Annotation]
) -> Outline:
    """The outline of a parsed file; `marks` are those of `parse_with_marks`."""
    kept = [node for node in marks if isinstance(node, (ast.Annotation, *_FORMS))]
    kept.sort(key=lambda node: (node.span.start, -node.span.end))
    return Outline(
        stored.within,
        tuple([final for final, _ in stored.classes]),
        [node.span.start for node in kept],
        [node.span.end for node in kept],
        [None if isinstance(node, ast.Annotation) else class_mark(node) for node in kept],
    )


def class_mark(node: ast.ClassDefinition) -> ClassMark:
    """The mark of a class. A partial derivative (`der(f, x)`) has none."""
    form = next(i for i, kind in enumerate(_FORMS) if isinstance(node, kind))
    extends = isinstance(node, ast.LongClass) and node.extends
    return ClassMark(form, node.name, node.kind, node.prefixes, node.class_prefixes, extends)


# --------------------------------------------------------------------------- to and from bytes


def encode(outline: Outline) -> bytes:
    """JSON: `[within, finals, [[distance, length, class], ...]]`, distances from mark to mark."""
    rows: list[object] = []
    last = 0
    for start, end, mark in zip(outline.starts, outline.ends, outline.classes, strict=True):
        rows.append([start - last, end - start, *([] if mark is None else _class_row(mark))])
        last = start
    data = [outline.within, [int(final) for final in outline.finals], rows]
    return json.dumps(data, separators=(",", ":")).encode()


def _class_row(mark: ClassMark) -> list[object]:
    p, c = mark.prefixes, mark.class_prefixes
    flags = (p.redeclare, p.final, p.inner, p.outer, p.replaceable, p.protected)
    flags += (c.encapsulated, c.partial, c.expandable, c.operator, mark.extends)
    bits = sum(1 << i for i, flag in enumerate(flags) if flag)
    return [mark.form, mark.name, mark.kind, bits, _PURITIES.index(c.purity)]


def decode(data: bytes, length: int) -> Outline | None:
    """The outline of a text with `length` characters, or None for bytes that hold no such outline."""
    try:
        value: object = json.loads(data)
    except (ValueError, RecursionError):
        return None
    reader = _Reader()
    try:
        outline = reader.outline(value)
    except (_WrongData, RecursionError):
        return None
    return outline if _nested(outline, length) else None


class _WrongData(Exception):
    """The JSON is not that of an outline."""


class _Reader:
    """Checks every part, and keeps equal class marks' prefixes once."""

    def __init__(self) -> None:
        self._prefixes: dict[tuple[int, int], tuple[ast.Prefixes, ast.ClassPrefixes]] = {}

    def outline(self, value: object) -> Outline:
        within, finals, rows = _items(value, 3)
        parts = None if within is None else tuple([_text(part) for part in _list(within)])
        outline = Outline(parts, tuple([bool(_number(f)) for f in _list(finals)]), [], [], [])
        start = 0
        for row in _list(rows):
            cells = _list(row)
            if len(cells) not in (2, 7):
                raise _WrongData
            start += _number(cells[0])
            outline.starts.append(start)
            outline.ends.append(start + _number(cells[1]))
            outline.classes.append(self._class(cells) if len(cells) == 7 else None)
        return outline

    def _class(self, cells: list[object]) -> ClassMark:
        form, name, kind = _number(cells[2]), _text(cells[3]), _text(cells[4])
        bits, purity = _number(cells[5]), _number(cells[6])
        if not (form < len(_FORMS) and kind in CLASS_KINDS and bits < 1 << 11 and purity < len(_PURITIES)):
            raise _WrongData
        key = bits, purity
        if key not in self._prefixes:
            on = [bool(bits >> i & 1) for i in range(10)]
            words = ast.ClassPrefixes(on[6], on[7], on[8], on[9], _PURITIES[purity])
            self._prefixes[key] = (ast.Prefixes(*on[:6]), words)
        prefixes, words = self._prefixes[key]
        return ClassMark(form, name, cast("ast.ClassKind", kind), prefixes, words, bool(bits >> 10))


def _list(value: object) -> list[object]:
    if not isinstance(value, list):
        raise _WrongData
    return cast("list[object]", value)


def _items(value: object, count: int) -> list[object]:
    items = _list(value)
    if len(items) != count:
        raise _WrongData
    return items


def _number(value: object) -> int:
    if type(value) is not int or not 0 <= value < 1 << 40:
        raise _WrongData
    return value


def _text(value: object) -> str:
    if not isinstance(value, str) or not value:
        raise _WrongData
    return value


def _nested(outline: Outline, length: int) -> bool:
    """Whether all marks lie in the text, one behind or inside the other, and the top ones are the classes."""
    open_ends: list[int] = []
    tops: list[bool] = []
    for start, end, mark in zip(outline.starts, outline.ends, outline.classes, strict=True):
        while open_ends and open_ends[-1] <= start:
            open_ends.pop()
        if not start < end <= (open_ends[-1] if open_ends else length):
            return False
        if not open_ends:
            tops.append(mark is not None)
        open_ends.append(end)
    return all(tops) and len(tops) == len(outline.finals) > 0
