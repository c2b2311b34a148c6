"""AST -> Modelica text: `parse(print(tree)) == tree` for every tree the parser can build.

Two spaces of indentation, one element or equation a line, `public` and `protected` as needed. Comments
(`//`) are not part of the tree and are not printed.
"""

from __future__ import annotations

from collections.abc import Iterator

from acausal.lang import ast
from acausal.lang.nesting import stack_room
from acausal.lang.printer_equations import equation_lines, statement_lines
from acausal.lang.printer_expressions import expression_text, list_text, reference_text, string_text
from acausal.lang.printer_modifications import (
    annotation_text,
    class_head,
    comment_text,
    component_text,
    constraint_text,
    modification_text,
    short_class_text,
    words,
)


def print_definition(definition: ast.StoredDefinition) -> str:
    """A whole file, with a newline at its end."""
    lines: list[str] = []
    if definition.within is not None:
        lines.append("within " + ".".join(definition.within) + ";" if definition.within else "within;")
    with stack_room():
        for final, item in definition.classes:
            lines.append(_class_text(item, "", words("final" if final else "")) + ";")
    return "\n".join(lines) + "\n"


def print_class(definition: ast.ClassDefinition) -> str:
    """One class with its element prefixes, without the semicolon behind it."""
    with stack_room():
        return _element_text(definition, "")


def print_expression(expression: ast.Expression) -> str:
    """One expression on one line."""
    with stack_room():
        return expression_text(expression)


def _class_text(definition: ast.ClassDefinition, indent: str, prefix: str) -> str:
    """A class after `prefix`; `indent` is that of its first line, which the text does not include."""
    if not isinstance(definition, ast.LongClass):
        text = short_class_text(definition, indent)
    else:
        text = "\n".join(_long_class_lines(definition, indent))
    return prefix + text + constraint_text(definition.constraint, indent)


def _long_class_lines(definition: ast.LongClass, indent: str) -> Iterator[str]:
    comment = "" if definition.comment is None else " " + string_text(definition.comment)
    extends = "extends " if definition.extends else ""
    modification = modification_text(definition.modification, indent)
    yield f"{class_head(definition)}{extends}{definition.name}{modification}{comment}"
    yield from _body_lines(definition.body, indent)
    yield f"{indent}end {definition.name}"


def _body_lines(body: ast.Composition, indent: str) -> Iterator[str]:
    inner = indent + "  "
    protected = False
    for element in body.elements:
        now = _is_protected(element, protected)
        if now != protected:
            protected = now
            yield indent + ("protected" if protected else "public")
        yield f"{inner}{_element_text(element, inner)};"
    for section in body.sections:
        initial = "initial " if section.initial else ""
        if isinstance(section, ast.EquationSection):
            yield f"{indent}{initial}equation"
            for equation in section.equations:
                yield from equation_lines(equation, inner)
        else:
            yield f"{indent}{initial}algorithm"
            for statement in section.statements:
                yield from statement_lines(statement, inner)
    if body.external is not None:
        yield f"{indent}{_external_text(body.external, indent)};"
    if body.annotation is not None:
        yield f"{inner}{annotation_text(body.annotation, inner)};"


def _is_protected(element: ast.Element, current: bool) -> bool:
    """The section an element belongs to; an import belongs to any."""
    match element:
        case ast.Import():
            return current
        case ast.Extends():
            return element.protected
        case _:
            return element.prefixes.protected


def _element_text(element: ast.Element, indent: str) -> str:
    match element:
        case ast.Import():
            return _import_text(element, indent)
        case ast.Extends():
            text = f"extends {reference_text(element.type)}{modification_text(element.modification, indent)}"
            return text + comment_text(ast.Comment(None, element.annotation), indent, len(indent) + len(text))
        case ast.ComponentClause():
            text = component_text(element, indent) + constraint_text(element.constraint, indent)
            return _prefix_words(element.prefixes) + text
        case _:
            return _class_text(element, indent, _prefix_words(element.prefixes))


def _prefix_words(prefixes: ast.Prefixes) -> str:
    return words(
        "redeclare" if prefixes.redeclare else "",
        "final" if prefixes.final else "",
        "inner" if prefixes.inner else "",
        "outer" if prefixes.outer else "",
        "replaceable" if prefixes.replaceable else "",
    )


def _import_text(element: ast.Import, indent: str) -> str:
    name = ".".join(element.name)
    if element.alias is not None:
        name = f"{element.alias} = {name}"
    elif element.wildcard:
        name += ".*"
    elif element.group:
        name += ".{" + ", ".join(element.group) + "}"
    return f"import {name}{comment_text(element.comment, indent)}"


def _external_text(external: ast.External, indent: str) -> str:
    text = "external"
    if external.language is not None:
        text += " " + string_text(external.language)
    if external.name is not None:
        result = "" if external.result is None else reference_text(external.result) + " = "
        text += f" {result}{external.name}({list_text(external.arguments)})"
    return text + comment_text(ast.Comment(None, external.annotation), indent, len(indent) + len(text))
