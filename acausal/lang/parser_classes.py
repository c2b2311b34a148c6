"""Classes and their elements: appendices A.2.2 to A.2.4."""

from __future__ import annotations

from dataclasses import replace

from acausal.lang import ast
from acausal.lang.cursor import Cursor, accept, close, enter, expect, identifier, new_name
from acausal.lang.lexer import IDENT, STORED_CLASS, STRING, string_value
from acausal.lang.parser_equations import equations, statements
from acausal.lang.parser_expressions import (
    array_subscripts,
    component_reference,
    expression_list,
    type_specifier,
)
from acausal.lang.parser_imports import import_clause
from acausal.lang.parser_modifications import (
    CLASS_WORDS,
    NO_PREFIXES,
    annotation,
    class_prefixes,
    constraining_clause,
    declaration,
    description,
    description_string,
    optional_class_modification,
    short_class,
    type_prefix,
)
from acausal.lang.structure_errors import misordered_prefix, unclosed_class, wrong_end
from acausal.lang.syntax_errors import missing

_PROTECTED = ast.Prefixes(protected=True)
_ELEMENT_PREFIXES = frozenset(("redeclare", "final", "inner", "outer", "replaceable"))
_TYPE_PREFIXES = frozenset(("flow", "stream", "discrete", "parameter", "constant", "input", "output"))
_ELEMENT_STARTS = (
    CLASS_WORDS | _ELEMENT_PREFIXES | _TYPE_PREFIXES | {IDENT, ".", "import", "extends", STORED_CLASS}
)


# --------------------------------------------------------------------------- classes


def class_definition(c: Cursor, first: int, prefixes: ast.Prefixes) -> ast.ClassDefinition:
    """A class after its element prefixes, which begin at token `first`."""
    words, kind = class_prefixes(c)
    if c.kinds[c.position] == "extends":
        c.position += 1
        return _long_class(c, first, words, kind, prefixes, extends=True)
    if c.kinds[c.position + 1] != "=":
        return _long_class(c, first, words, kind, prefixes, extends=False)
    name = new_name(c, f"a name after `{kind}`")
    c.position += 1
    if c.kinds[c.position] == "der":
        return _der_class(c, first, name, kind, words, prefixes)
    return short_class(c, first, name, kind, words, prefixes)


def _long_class(
    c: Cursor,
    first: int,
    words: ast.ClassPrefixes,
    kind: ast.ClassKind,
    prefixes: ast.Prefixes,
    extends: bool,
) -> ast.LongClass:
    """`Name "description" ... end Name`."""
    enter(c)
    name = new_name(c, f"a name after `{'extends' if extends else kind}`")
    modification = optional_class_modification(c) if extends else None
    comment = description_string(c)
    body = _composition(c)
    if c.kinds[c.position] != "end":
        raise unclosed_class(c, name, first, body.annotation is not None)
    if c.texts[c.position + 1] != name or c.kinds[c.position + 1] != IDENT:
        raise wrong_end(c, name, first)
    c.position += 2
    c.depth -= 1
    span = c.span_from(first)
    return ast.LongClass(name, kind, words, prefixes, extends, modification, comment, body, None, span)


def _der_class(
    c: Cursor, first: int, name: str, kind: ast.ClassKind, words: ast.ClassPrefixes, prefixes: ast.Prefixes
) -> ast.DerClass:
    """`der(f, x, y)`, after `function name =`."""
    opened = c.position + 1
    c.position = opened
    expect(c, "(", "after `der`")
    base = type_specifier(c, "a function name")
    expect(c, ",", "after the function name: at least one variable to differentiate by is needed")
    variables = [identifier(c, "a variable")]
    while accept(c, ","):
        variables.append(identifier(c, "a variable"))
    close(c, ")", opened)
    comment = description(c)
    return ast.DerClass(
        name, kind, words, prefixes, base, tuple(variables), comment, None, c.span_from(first)
    )


def _composition(c: Cursor) -> ast.Composition:
    """The body of a class, up to its `end`."""
    kinds = c.kinds
    elements: list[ast.Element] = []
    sections: list[ast.EquationSection | ast.AlgorithmSection] = []
    _element_list(c, elements, protected=False)
    while True:
        kind = kinds[c.position]
        if kind in {"public", "protected"}:
            c.position += 1
            _element_list(c, elements, kind == "protected")
        elif kind in {"equation", "algorithm", "initial"}:
            sections.append(_section(c))
        else:
            break
    external = _external(c) if kinds[c.position] == "external" else None
    final_annotation = annotation(c)
    if final_annotation is not None:
        expect(c, ";", "after the annotation of the class")
    return ast.Composition(tuple(elements), tuple(sections), external, final_annotation)


def _section(c: Cursor) -> ast.EquationSection | ast.AlgorithmSection:
    first = c.position
    initial = accept(c, "initial")
    kind = c.kinds[c.position]
    if kind not in ("equation", "algorithm"):
        raise c.error("`equation` or `algorithm` after `initial`")
    c.position += 1
    if kind == "equation":
        return ast.EquationSection(equations(c), initial, c.span_from(first))
    return ast.AlgorithmSection(statements(c), initial, c.span_from(first))


def _external(c: Cursor) -> ast.External:
    """`external "C" y = f(x) annotation(...);`."""
    first = c.position
    c.position = first + 1
    language = result = name = None
    arguments: tuple[ast.Expression, ...] = ()
    if c.kinds[c.position] == STRING:
        language = string_value(c.texts[c.position])
        c.position += 1
    if c.kinds[c.position] in (IDENT, "."):
        if c.kinds[c.position + 1] != "(":
            result = component_reference(c)
            expect(c, "=", "after the result of the external function")
        name = identifier(c, "the name of the external function")
        opened = c.position
        expect(c, "(", "after the name of the external function")
        if c.kinds[c.position] != ")":
            arguments = expression_list(c)
        close(c, ")", opened)
    notes = annotation(c)
    span = c.span_from(first)
    expect(c, ";", "after the `external` clause")
    return ast.External(language, result, name, arguments, notes, span)


# --------------------------------------------------------------------------- elements


def _element_list(c: Cursor, elements: list[ast.Element], protected: bool) -> None:
    """Append elements, each with its semicolon, as long as there are any."""
    kinds = c.kinds
    while kinds[c.position] in _ELEMENT_STARTS:
        element = one_element(c, protected)
        elements.append(element)
        if kinds[c.position] != ";":
            raise missing(c, ";", f"after {_what(element)}")
        c.position += 1


def _what(element: ast.Element) -> str:
    """The element in words, for a message."""
    if isinstance(element, ast.ComponentClause):
        return f"the declaration of `{element.declarations[-1].name}`"
    if isinstance(element, ast.Import):
        return f"the import of `{'.'.join(element.name)}`"
    if isinstance(element, ast.Extends):
        return f"`extends {element.type.text}`"
    return f"the class `{element.name}`"


def one_element(c: Cursor, protected: bool) -> ast.Element:
    """A class, component, import or `extends` clause, without its semicolon."""
    kind = c.kinds[c.position]
    first = c.position
    if kind == "import":
        return import_clause(c)
    if kind == "extends":
        return _extends(c, protected)
    if kind == STORED_CLASS:
        return stored_class(c)
    if kind not in _ELEMENT_PREFIXES:
        prefixes = _PROTECTED if protected else NO_PREFIXES
        return _class_or_component(c, first, prefixes)
    redeclare = accept(c, "redeclare")
    final = accept(c, "final")
    inner = accept(c, "inner")
    outer = accept(c, "outer")
    replaceable = accept(c, "replaceable")
    if c.kinds[c.position] in _ELEMENT_PREFIXES:
        raise misordered_prefix(c, "redeclare final inner outer replaceable")
    prefixes = ast.Prefixes(redeclare, final, inner, outer, replaceable, protected)
    return _class_or_component(c, first, prefixes)


def stored_class(c: Cursor) -> ast.ClassDefinition:
    """The class that stands for the next token."""
    stored = c.stored[c.starts[c.position]]
    assert not isinstance(stored, ast.Annotation)
    c.position += 1
    return stored


def _class_or_component(c: Cursor, first: int, prefixes: ast.Prefixes) -> ast.Element:
    if c.kinds[c.position] in CLASS_WORDS:
        element = class_definition(c, first, prefixes)
    else:
        element = _component_clause(c, first, prefixes)
    if prefixes.replaceable and c.kinds[c.position] == "constrainedby":
        element = _with_constraint(c, first, element)
    if not isinstance(element, ast.ComponentClause):
        c.marks.append(element)
    return element


def _with_constraint(
    c: Cursor, first: int, element: ast.ClassDefinition | ast.ComponentClause
) -> ast.ClassDefinition | ast.ComponentClause:
    """Read `constrainedby ...` and put it into the element."""
    constraint = constraining_clause(c, described=True)
    return replace(element, constraint=constraint, span=c.span_from(first))


def _component_clause(c: Cursor, first: int, prefixes: ast.Prefixes) -> ast.ComponentClause:
    flow, variability, causality = type_prefix(c)
    kinds = c.kinds
    if kinds[c.position] in _TYPE_PREFIXES or kinds[c.position] in _ELEMENT_PREFIXES:
        order = "redeclare final inner outer replaceable flow parameter input"
        raise misordered_prefix(c, order)
    kind = type_specifier(c, "a type")
    dimensions = array_subscripts(c) if kinds[c.position] == "[" else None
    declarations = [declaration(c, conditional=True)]
    while kinds[c.position] == ",":
        c.position += 1
        declarations.append(declaration(c, conditional=True))
    span = c.span_from(first)
    return ast.ComponentClause(
        prefixes, flow, variability, causality, kind, dimensions, tuple(declarations), None, span
    )


def _extends(c: Cursor, protected: bool) -> ast.Extends:
    first = c.position
    c.position = first + 1
    base = type_specifier(c, "a class name after `extends`")
    modification = optional_class_modification(c, inheritance=True)
    notes = annotation(c)
    return ast.Extends(base, modification, notes, protected, c.span_from(first))
