"""Modifications, annotations, descriptions and what may stand inside them: appendix A.2.5.

A redeclaration holds a short class or one component, and both hold modifications again, so declarations
and short classes are here too.
"""

from __future__ import annotations

from typing import cast

from acausal.lang import ast
from acausal.lang.cursor import Cursor, accept, close, enter, expect, identifier, new_name
from acausal.lang.lexer import IDENT, STORED_NOTE, STRING, string_value
from acausal.lang.parser_expressions import array_subscripts, component_reference, expression, type_specifier
from acausal.lang.syntax_errors import problem, token_span

NO_COMMENT = ast.Comment(None, None)
NO_PREFIXES = ast.Prefixes()
NO_CLASS_PREFIXES = ast.ClassPrefixes()

LONG_ANNOTATION = 100
"""Characters from which on an annotation is worth being read on its own."""

CLASS_KINDS = frozenset("class model record block connector type package function operator".split())
CLASS_WORDS = CLASS_KINDS | {"encapsulated", "partial", "expandable", "pure", "impure"}
"""The words a class definition may begin with."""


# --------------------------------------------------------------------------- descriptions


def description_string(c: Cursor) -> str | None:
    """`"a" + "b"`, or None."""
    if c.kinds[c.position] != STRING:
        return None
    parts = [string_value(c.texts[c.position])]
    c.position += 1
    while c.kinds[c.position] == "+":
        c.position += 1
        if c.kinds[c.position] != STRING:
            raise c.error("another string after the `+` of the description")
        parts.append(string_value(c.texts[c.position]))
        c.position += 1
    return "".join(parts)


def description(c: Cursor) -> ast.Comment:
    """A description string and an annotation, both optional."""
    kind = c.kinds[c.position]
    if kind not in {STRING, "annotation", STORED_NOTE}:
        return NO_COMMENT
    return ast.Comment(description_string(c), annotation(c))


def annotation(c: Cursor) -> ast.Annotation | None:
    """`annotation(...)`, or None."""
    first = c.position
    kind = c.kinds[first]
    if kind != "annotation":
        return stored_annotation(c) if kind == STORED_NOTE else None
    c.position = first + 1
    if c.kinds[c.position] != "(":
        raise c.error("`(` after `annotation`")
    notes = ast.Annotation(class_modification(c), c.span_from(first))
    if notes.span.end - notes.span.start >= LONG_ANNOTATION:
        c.marks.append(notes)
    return notes


def stored_annotation(c: Cursor) -> ast.Annotation:
    """The annotation that stands for the next token."""
    stored = c.stored[c.starts[c.position]]
    assert isinstance(stored, ast.Annotation)
    c.position += 1
    return stored


# --------------------------------------------------------------------------- modifications


def optional_modification(c: Cursor) -> ast.Modification | None:
    """`(arguments)`, `= value`, `(arguments) = value` or `:= value`."""
    first = c.position
    kind = c.kinds[first]
    if kind == "(":
        arguments = class_modification(c)
        value = None
        if c.kinds[c.position] == "=":
            c.position += 1
            value = _modification_expression(c)
    elif kind in {"=", ":="}:
        c.position = first + 1
        arguments = ()
        value = _modification_expression(c)
    else:
        return None
    return ast.Modification(arguments, value, c.span_from(first))


def _modification_expression(c: Cursor) -> ast.Expression | ast.Break:
    if c.kinds[c.position] == "break":
        c.position += 1
        return ast.Break(c.span_from(c.position - 1))
    return expression(c)


def optional_class_modification(c: Cursor, inheritance: bool = False) -> ast.Modification | None:
    """`(arguments)` alone; `inheritance` also allows `break` (in an `extends` clause)."""
    first = c.position
    if c.kinds[first] != "(":
        return None
    arguments = class_modification(c, inheritance)
    return ast.Modification(arguments, None, c.span_from(first))


def class_modification(c: Cursor, inheritance: bool = False) -> tuple[ast.Argument, ...]:
    """`(argument, argument)`; the next token is the parenthesis."""
    opened = c.position
    kinds = c.kinds
    c.position = opened + 1
    if kinds[c.position] == ")":
        c.position += 1
        return ()
    enter(c)
    arguments: list[ast.Argument] = []
    while True:
        kind = kinds[c.position]
        if kind == IDENT:
            arguments.append(_element_modification(c, c.position, False, False))
        elif kind == "break" and inheritance:
            arguments.append(_inheritance_modification(c))
        else:
            arguments.append(_prefixed_argument(c))
        if kinds[c.position] != ",":
            break
        c.position += 1
    close(c, ")", opened)
    c.depth -= 1
    return tuple(arguments)


def _element_modification(c: Cursor, first: int, each: bool, final: bool) -> ast.ElementModification:
    """`a.b(...) = value "description"`, after `each` and `final`."""
    kinds = c.kinds
    name = [identifier(c, "a name to modify")]
    while kinds[c.position] == ".":
        c.position += 1
        name.append(identifier(c, "a name after `.`"))
    if kinds[c.position] == "[":
        hint = "modify the whole array instead, with an array as value or with `each`"
        raise problem("modification", "a modified name has no subscripts", token_span(c), hint)
    modification = optional_modification(c)
    comment = NO_COMMENT
    if kinds[c.position] == STRING:
        comment = ast.Comment(description_string(c), None)
    return ast.ElementModification(tuple(name), modification, each, final, comment, c.span_from(first))


def _prefixed_argument(c: Cursor) -> ast.Argument:
    """An argument that begins with `redeclare`, `each`, `final` or `replaceable`."""
    first = c.position
    redeclare = accept(c, "redeclare")
    each = accept(c, "each")
    final = accept(c, "final")
    if not redeclare and c.kinds[c.position] == IDENT:
        return _element_modification(c, first, each, final)
    replaceable = accept(c, "replaceable")
    if not redeclare and not replaceable:
        hint = "the order is `redeclare each final replaceable`" if c.position > first else ""
        raise c.error("a modification `name = value`, `each`, `final`, `redeclare` or `replaceable`", hint)
    read = _short_class_definition if c.kinds[c.position] in CLASS_WORDS else _single_component
    element = read(c)
    constraint = constraining_clause(c, False) if replaceable else None
    span = c.span_from(first)
    return ast.ElementRedeclaration(element, redeclare, each, final, replaceable, constraint, span)


def _inheritance_modification(c: Cursor) -> ast.BreakConnect:
    """`break connect(a, b)` or `break name`."""
    first = c.position
    c.position = first + 1
    if c.kinds[c.position] != "connect":
        name = identifier(c, "a component name or `connect(...)` after `break`")
        return ast.BreakConnect(None, name, c.span_from(first))
    start = c.position
    left, right = connect_clause(c)
    equation = ast.ConnectEquation(left, right, NO_COMMENT, c.span_from(start))
    return ast.BreakConnect(equation, None, c.span_from(first))


def connect_clause(c: Cursor) -> tuple[ast.ComponentReference, ast.ComponentReference]:
    """`connect(a, b)`."""
    opened = c.position + 1
    c.position = opened
    expect(c, "(", "after `connect`")
    left = component_reference(c)
    expect(c, ",", "between the two connectors of `connect`")
    right = component_reference(c)
    close(c, ")", opened)
    return left, right


def constraining_clause(c: Cursor, described: bool) -> ast.Constraint | None:
    """`constrainedby Type(...)`, with a description where `described`; None when absent."""
    first = c.position
    if c.kinds[first] != "constrainedby":
        return None
    c.position = first + 1
    base = type_specifier(c, "a type after `constrainedby`")
    modification = optional_class_modification(c)
    comment = description(c) if described else NO_COMMENT
    return ast.Constraint(base, modification, comment, c.span_from(first))


# --------------------------------------------------------------------------- components


def type_prefix(c: Cursor) -> tuple[ast.Flow, ast.Variability, ast.Causality]:
    """`[flow | stream] [discrete | parameter | constant] [input | output]`."""
    kinds = c.kinds
    flow = variability = causality = ""
    if kinds[c.position] in ("flow", "stream"):
        flow = kinds[c.position]
        c.position += 1
    if kinds[c.position] in ("discrete", "parameter", "constant"):
        variability = kinds[c.position]
        c.position += 1
    if kinds[c.position] in ("input", "output"):
        causality = kinds[c.position]
        c.position += 1
    return cast(ast.Flow, flow), cast(ast.Variability, variability), cast(ast.Causality, causality)


def declaration(c: Cursor, conditional: bool) -> ast.Declaration:
    """`name[dimensions](...) = value if condition "description"`."""
    first = c.position
    kinds = c.kinds
    name = new_name(c, "a component name")
    dimensions = array_subscripts(c) if kinds[c.position] == "[" else None
    modification = optional_modification(c)
    condition = None
    if conditional and kinds[c.position] == "if":
        c.position += 1
        condition = expression(c)
    comment = description(c)
    return ast.Declaration(name, dimensions, modification, condition, comment, c.span_from(first))


def _single_component(c: Cursor) -> ast.ComponentClause:
    """The component of a redeclaration: no array dimensions on its type, no condition."""
    first = c.position
    flow, variability, causality = type_prefix(c)
    kind = type_specifier(c, "a type")
    if c.kinds[c.position] == "[":
        hint = "write the dimensions behind the name: `redeclare Real x[3]`"
        raise problem(
            "modification", "a redeclared component has no dimensions on its type", token_span(c), hint
        )
    declarations = (declaration(c, conditional=False),)
    span = c.span_from(first)
    return ast.ComponentClause(
        NO_PREFIXES, flow, variability, causality, kind, None, declarations, None, span
    )


# --------------------------------------------------------------------------- classes in one line


def class_prefixes(c: Cursor) -> tuple[ast.ClassPrefixes, ast.ClassKind]:
    """`[partial]` and the kind of a class with its own prefixes."""
    kinds = c.kinds
    encapsulated = accept(c, "encapsulated")
    partial = accept(c, "partial")
    expandable = accept(c, "expandable")
    purity = ""
    if kinds[c.position] in ("pure", "impure"):
        purity = kinds[c.position]
        c.position += 1
    operator = kinds[c.position] == "operator" and kinds[c.position + 1] in CLASS_KINDS
    c.position += operator
    kind = kinds[c.position]
    if kind not in CLASS_KINDS:
        raise c.error("a kind of class (`model`, `block`, `connector`, `record`, `package`, `function`, ...)")
    wrong = (expandable and kind != "connector") or (purity and kind != "function")
    if wrong or (operator and kind not in {"record", "function"}):
        word = "expandable" if expandable else purity or "operator"
        hint = "expandable connector, pure function, impure function, operator record, operator function"
        raise problem("prefix", f"a {kind} cannot be `{word}`", token_span(c), hint)
    c.position += 1
    if not (encapsulated or partial or expandable or purity or operator):
        return NO_CLASS_PREFIXES, cast(ast.ClassKind, kind)
    prefixes = ast.ClassPrefixes(encapsulated, partial, expandable, operator, cast(ast.Purity, purity))
    return prefixes, cast(ast.ClassKind, kind)


def _short_class_definition(c: Cursor) -> ast.ShortClass | ast.EnumerationClass:
    """The class of a redeclaration."""
    first = c.position
    if c.kinds[first] == "encapsulated":
        raise c.error("a class", "a redeclared class cannot be `encapsulated`")
    prefixes, kind = class_prefixes(c)
    name = new_name(c, f"a name after `{kind}`")
    expect(
        c,
        "=",
        f"after `{name}`: only a short class `{kind} {name} = Type` can be redeclared in a modification",
    )
    return short_class(c, first, name, kind, prefixes, NO_PREFIXES)


def short_class(
    c: Cursor, first: int, name: str, kind: ast.ClassKind, words: ast.ClassPrefixes, prefixes: ast.Prefixes
) -> ast.ShortClass | ast.EnumerationClass:
    """`Base[3](...)` or `enumeration(...)`, after `kind name =`."""
    if c.kinds[c.position] == "enumeration":
        literals = _enumeration_literals(c)
        comment = description(c)
        return ast.EnumerationClass(name, kind, words, prefixes, literals, comment, None, c.span_from(first))
    causality: ast.Causality = ""
    if c.kinds[c.position] in ("input", "output"):
        causality = cast(ast.Causality, c.kinds[c.position])
        c.position += 1
    base = type_specifier(c, f"a type after `{name} =`")
    dimensions = array_subscripts(c) if c.kinds[c.position] == "[" else None
    modification = optional_class_modification(c)
    comment = description(c)
    span = c.span_from(first)
    return ast.ShortClass(
        name, kind, words, prefixes, causality, base, dimensions, modification, comment, None, span
    )


def _enumeration_literals(c: Cursor) -> tuple[ast.EnumerationLiteral, ...] | None:
    """`enumeration(a "first", b)`; None for `enumeration(:)`."""
    opened = c.position + 1
    c.position = opened
    expect(c, "(", "after `enumeration`")
    literals: list[ast.EnumerationLiteral] | None = []
    if c.kinds[c.position] == ":":
        literals = None
        c.position += 1
    elif c.kinds[c.position] != ")":
        while True:
            first = c.position
            name = new_name(c, "an enumeration literal")
            comment = description(c)
            literals.append(ast.EnumerationLiteral(name, comment, c.span_from(first)))
            if not accept(c, ","):
                break
    close(c, ")", opened)
    return None if literals is None else tuple(literals)
