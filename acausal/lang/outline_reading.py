"""A file's tree from its text and its outline: each part is parsed when somebody first looks into it."""

from __future__ import annotations

from bisect import bisect_left
from functools import partial

from acausal.errors import LookupProblem, Source, Span, SyntaxProblem, fail
from acausal.lang import ast
from acausal.lang.outline import ClassMark, Outline, class_mark
from acausal.lang.parser import Marks, parse_part, parse_with_marks
from acausal.lang.unread import unread_annotation, unread_class


def read_outlined(source: Source, outline: Outline) -> ast.StoredDefinition:
    """The classes of a file; nothing of the text is parsed yet."""
    classes = _Parts(source, outline).inside(0, len(source.text), 0)
    assert all(not isinstance(node, ast.Annotation) for node in classes)
    pairs = zip(outline.finals, classes, strict=True)
    found = tuple([(final, node) for final, node in pairs if not isinstance(node, ast.Annotation)])
    return ast.StoredDefinition(outline.within, found, source.path)


class _Parts:
    """The marked parts of one text."""

    def __init__(self, source: Source, outline: Outline) -> None:
        self._source = source
        self._outline = outline
        self._whole: dict[tuple[int, int], ast.ClassDefinition | ast.Annotation] | None = None

    def inside(self, start: int, end: int, first: int) -> Marks:
        """The marks from number `first` on that lie between two characters, as unread nodes."""
        outline = self._outline
        nodes: Marks = []
        index = first
        while index < len(outline.starts) and outline.starts[index] < end:
            mark = outline.classes[index]
            span = Span(self._source, outline.starts[index], outline.ends[index])
            if mark is None:
                nodes.append(unread_annotation(span, partial(self._annotation, index)))
            else:
                nodes.append(unread_class(mark, span, partial(self._class, index, mark)))
            index = bisect_left(outline.starts, outline.ends[index], index + 1)
        return nodes

    def _class(self, index: int, mark: ClassMark) -> ast.ClassDefinition:
        found = self._part(index, mark.prefixes.protected)
        if isinstance(found, mark.node_type) and class_mark(found) == mark:
            return found
        found = self._parsed(index)
        if isinstance(found, mark.node_type) and class_mark(found) == mark:
            return found
        raise self._mismatch(index)

    def _annotation(self, index: int) -> ast.Annotation:
        found = self._part(index, None)
        found = found if isinstance(found, ast.Annotation) else self._parsed(index)
        if not isinstance(found, ast.Annotation):
            raise self._mismatch(index)
        return found

    def _part(self, index: int, protected: bool | None) -> ast.Element | ast.Annotation | None:
        """The marked part, parsed on its own; None when it is not what the mark says."""
        start, end = self._outline.starts[index], self._outline.ends[index]
        try:
            return parse_part(self._source, start, end, self.inside(start, end, index + 1), protected)
        except SyntaxProblem:
            return None

    def _parsed(self, index: int) -> ast.ClassDefinition | ast.Annotation | None:
        """What the parser finds at a mark in the whole text. Raises `SyntaxProblem`."""
        if self._whole is None:
            _, marks = parse_with_marks(self._source)
            self._whole = {(node.span.start, node.span.end): node for node in marks}
        return self._whole.get((self._outline.starts[index], self._outline.ends[index]))

    def _mismatch(self, index: int) -> LookupProblem:
        """Only a forged outline comes here: its checksum was right and it does not fit the text."""
        start, end = self._outline.starts[index], self._outline.ends[index]
        return fail(
            LookupProblem,
            "library.cache",
            f"what is kept of {self._source.path} in the cache of parsed files does not fit the file",
            Span(self._source, start, min(end, start + 80)),
            hint="delete the cache, or switch it off with ACAUSAL_CACHE=off",
        )
