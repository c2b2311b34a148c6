"""The predefined types (Modelica 3.6, 4.9), as definitions without a text of their own."""

from __future__ import annotations

from acausal.errors import Source, Span
from acausal.lang import ast

PREDEFINED_FILE = "<predefined>"
SIMPLE_TYPES = ("Real", "Integer", "Boolean", "String")
ENUMERATIONS: dict[str, tuple[str, ...]] = {
    "StateSelect": ("never", "avoid", "default", "prefer", "always"),
    "AssertionLevel": ("warning", "error"),
}
EXTERNAL_OBJECT = "ExternalObject"
PREDEFINED = (*SIMPLE_TYPES, *ENUMERATIONS, EXTERNAL_OBJECT)


def predefined(name: str) -> ast.ClassDefinition:
    """The definition of a predefined type."""
    span = Span(Source(PREDEFINED_FILE, name), 0, len(name))
    no_comment = ast.Comment(None, None)
    plain = (ast.ClassPrefixes(), ast.Prefixes())
    literals = ENUMERATIONS.get(name)
    if literals is not None:
        entries = tuple([ast.EnumerationLiteral(literal, no_comment, span) for literal in literals])
        return ast.EnumerationClass(name, "type", *plain, entries, no_comment, None, span)
    body = ast.Composition((), (), None, None)
    kind: ast.ClassKind = "class" if name == EXTERNAL_OBJECT else "type"
    return ast.LongClass(name, kind, *plain, False, None, None, body, None, span)
