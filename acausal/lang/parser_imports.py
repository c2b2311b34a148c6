"""Import clauses and plain dotted names: appendix A.2.2."""

from __future__ import annotations

from acausal.lang import ast
from acausal.lang.cursor import Cursor, accept, close, identifier
from acausal.lang.parser_modifications import description


def dotted_name(c: Cursor) -> tuple[str, ...]:
    """`A.B.C`."""
    name = [identifier(c, "a name")]
    while c.kinds[c.position] == ".":
        c.position += 1
        name.append(identifier(c, "a name after `.`"))
    return tuple(name)


def import_clause(c: Cursor) -> ast.Import:
    """`import A.B`, `import D = A.B`, `import A.*`, `import A.{B, C}`."""
    first = c.position
    kinds = c.kinds
    c.position = first + 1
    alias: str | None = None
    if kinds[c.position + 1] == "=":
        alias = identifier(c, "a name after `import`")
        c.position += 1
    name = [identifier(c, "a name after `import`")]
    group: list[str] = []
    wildcard = False
    while (kinds[c.position] == "." and alias is not None) or _dotted(c):
        c.position += 1
        name.append(identifier(c, "a name after `.`"))
    if alias is None and kinds[c.position] == ".*":
        wildcard = True
        c.position += 1
    elif alias is None and kinds[c.position] == ".":
        wildcard = _import_tail(c, group)
    comment = description(c)
    return ast.Import(tuple(name), alias, wildcard, tuple(group), comment, c.span_from(first))


def _dotted(c: Cursor) -> bool:
    """Whether the name goes on, rather than ending in `.*` or `.{`."""
    return c.kinds[c.position] == "." and c.kinds[c.position + 1] not in ("*", "{")


def _import_tail(c: Cursor, group: list[str]) -> bool:
    """`. *` (true) or `.{B, C}` (false, names appended to `group`)."""
    c.position += 1
    if accept(c, "*"):
        return True
    opened = c.position
    c.position += 1
    group.append(identifier(c, "a name to import"))
    while accept(c, ","):
        group.append(identifier(c, "a name to import"))
    close(c, "}", opened)
    return False
