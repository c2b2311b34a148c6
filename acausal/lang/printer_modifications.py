"""Modifications, annotations, descriptions, components and one-line classes -> text."""

from __future__ import annotations

from collections.abc import Iterable

from acausal.lang import ast
from acausal.lang.printer_expressions import (
    WIDTH,
    expression_text,
    laid_out,
    reference_text,
    string_text,
    subscripts_text,
    value_text,
)

Indent = str | None
"""The indentation of the line a text begins on; None asks for a text without line breaks."""


def deeper(indent: Indent) -> Indent:
    """One level further to the right."""
    return None if indent is None else indent + "  "


def words(*parts: str) -> str:
    """The non-empty parts, with one space behind each."""
    return "".join([part + " " for part in parts if part])


def comment_text(comment: ast.Comment, indent: Indent, column: int = 0) -> str:
    """The description and annotation, each with a space (or a new line, if it is long) before it."""
    text = "" if comment.text is None else " " + string_text(comment.text)
    if comment.annotation is None:
        return text
    notes = annotation_text(comment.annotation, deeper(indent))
    short = indent is None or ("\n" not in notes and column + len(text) + len(notes) < WIDTH)
    return f"{text} {notes}" if short else f"{text}\n{indent}  {notes}"


def annotation_text(annotation: ast.Annotation, indent: Indent) -> str:
    """`annotation(...)`."""
    return "annotation" + arguments_text(annotation.arguments, indent)


def modification_text(modification: ast.Modification | None, indent: Indent) -> str:
    """`(arguments) = value`, or nothing."""
    if modification is None:
        return ""
    text = ""
    if modification.arguments or modification.value is None:
        text = arguments_text(modification.arguments, indent)
    if modification.value is None:
        return text
    if isinstance(modification.value, ast.Break):
        return f"{text} = break"
    value = expression_text(modification.value) if indent is None else value_text(modification.value, indent)
    return f"{text} = {value}"


def arguments_text(arguments: Iterable[ast.Argument], indent: Indent) -> str:
    """`(a = 1, final b(...))`."""
    flat = f"({', '.join([_argument_text(argument, None) for argument in arguments])})"
    if indent is None or len(flat) + len(indent) <= WIDTH:
        return flat
    return laid_out("(", [_argument_text(argument, deeper(indent)) for argument in arguments], ")", indent)


def _argument_text(argument: ast.Argument, indent: Indent) -> str:
    match argument:
        case ast.ElementModification():
            prefix = words("each" if argument.each else "", "final" if argument.final else "")
            value = modification_text(argument.modification, indent)
            return f"{prefix}{'.'.join(argument.name)}{value}{comment_text(argument.comment, indent)}"
        case ast.ElementRedeclaration():
            return _redeclaration_text(argument, indent)
        case ast.BreakConnect():
            if argument.equation is None:
                return f"break {argument.name}"
            return f"break {connect_text(argument.equation)}"


def _redeclaration_text(argument: ast.ElementRedeclaration, indent: Indent) -> str:
    prefix = words(
        "redeclare" if argument.redeclare else "",
        "each" if argument.each else "",
        "final" if argument.final else "",
        "replaceable" if argument.replaceable else "",
    )
    element = argument.element
    if isinstance(element, ast.ComponentClause):
        text = component_text(element, indent)
    else:
        text = short_class_text(element, indent)
    return prefix + text + constraint_text(argument.constraint, indent)


def connect_text(equation: ast.ConnectEquation) -> str:
    """`connect(a, b)`."""
    return f"connect({reference_text(equation.left)}, {reference_text(equation.right)})"


def constraint_text(constraint: ast.Constraint | None, indent: Indent) -> str:
    """` constrainedby Type(...) "description"`, or nothing."""
    if constraint is None:
        return ""
    modification = modification_text(constraint.modification, indent)
    comment = comment_text(constraint.comment, indent)
    return f" constrainedby {reference_text(constraint.type)}{modification}{comment}"


# --------------------------------------------------------------------------- components


def component_text(clause: ast.ComponentClause, indent: Indent) -> str:
    """`flow Real[3] a, b = 1 "description"`, without element prefixes and constraint."""
    prefix = words(clause.flow, clause.variability, clause.causality)
    head = f"{prefix}{reference_text(clause.type)}{subscripts_text(clause.dimensions)} "
    column = len(indent or "") + len(head)
    return head + ", ".join([_declaration_text(d, indent, column) for d in clause.declarations])


def _declaration_text(d: ast.Declaration, indent: Indent, column: int) -> str:
    text = d.name + subscripts_text(d.dimensions) + modification_text(d.modification, indent)
    if d.condition is not None:
        text += f" if {expression_text(d.condition)}"
    return text + comment_text(d.comment, indent, column + len(text))


# --------------------------------------------------------------------------- classes


def class_head(definition: ast.ClassDefinition) -> str:
    """`encapsulated partial model `, with a space at the end."""
    prefixes = definition.class_prefixes
    return words(
        "encapsulated" if prefixes.encapsulated else "",
        "partial" if prefixes.partial else "",
        "expandable" if prefixes.expandable else "",
        prefixes.purity,
        "operator" if prefixes.operator else "",
        definition.kind,
    )


def short_class_text(definition: ast.ShortClass | ast.EnumerationClass | ast.DerClass, indent: Indent) -> str:
    """`type Name = ...`, without element prefixes and constraint."""
    head = f"{class_head(definition)}{definition.name} = "
    match definition:
        case ast.ShortClass():
            base = words(definition.causality) + reference_text(definition.base)
            body = base + subscripts_text(definition.dimensions)
            body += modification_text(definition.modification, indent)
        case ast.EnumerationClass():
            body = f"enumeration{_literals_text(definition.literals, indent)}"
        case ast.DerClass():
            body = f"der({', '.join((reference_text(definition.base), *definition.variables))})"
    column = len(indent or "") + len(head) + len(body)
    return head + body + comment_text(definition.comment, indent, column)


def _literals_text(literals: tuple[ast.EnumerationLiteral, ...] | None, indent: Indent) -> str:
    if literals is None:
        return "(:)"
    flat = f"({', '.join([literal.name + comment_text(literal.comment, None) for literal in literals])})"
    if indent is None or len(flat) + len(indent) <= WIDTH:
        return flat
    items = [literal.name + comment_text(literal.comment, deeper(indent)) for literal in literals]
    return laid_out("(", items, ")", indent)
