"""Messages about references to things that are not there or cannot be used so."""

from __future__ import annotations

from collections.abc import Sequence

from acausal.errors import AcausalError, LookupProblem, Span, TypeProblem, fail
from acausal.lang import ast
from acausal.lang.class_table import ComponentEntry
from acausal.lang.instance import Absent, Instance
from acausal.lang.lookup_errors import did_you_mean
from acausal.lang.scope import Scope


def no_such_element(part: ast.NamePart, scope: Scope) -> AcausalError:
    """The error for `Package.name` that is not in the package."""
    known = [*scope.element_names(), *scope.node.child_names()]
    return fail(
        LookupProblem,
        "lookup.unknown-name",
        f"`{part.name}` is not found in `{scope.path}`",
        part.span,
        names=[f"{scope.path}.{part.name}"],
        hint=did_you_mean(part.name, known) or f"`{scope.path}` has no such element",
    )


def no_component(current: Instance, part: ast.NamePart) -> AcausalError:
    """The error for `component.name` that the component's class does not have."""
    known = list(current.scope.table.components)
    return fail(
        LookupProblem,
        "lookup.unknown-name",
        f"`{current.path}` (a `{current.scope.path}`) has no component `{part.name}`",
        part.span,
        names=[f"{current.path}.{part.name}"],
        hint=did_you_mean(part.name, known)
        or (f"it has: {', '.join(known[:8])}" if known else "it has no components"),
    )


def scalar_has_no_parts(path: str, part: ast.NamePart) -> AcausalError:
    """The error for `x.name` of a scalar `x`."""
    message = f"`{path}` is a scalar and has no component `{part.name}`"
    return fail(LookupProblem, "lookup.unknown-name", message, part.span, names=[f"{path}.{part.name}"])


def unknown_literal(part: ast.NamePart, scope: Scope, literals: Sequence[str]) -> AcausalError:
    """The error for `Enumeration.name` that is not one of its literals."""
    return fail(
        LookupProblem,
        "lookup.unknown-literal",
        f"the enumeration `{scope.path}` has no literal `{part.name}`",
        part.span,
        names=[part.name],
        hint=did_you_mean(part.name, literals, 2) or f"literals: {', '.join(literals)}",
    )


def not_a_constant(entry: ComponentEntry, where: Scope, part: ast.NamePart) -> AcausalError:
    """The error for a variable of a class (not of a component) that is no constant."""
    prefix = entry.clause.variability or "variable"
    return fail(
        LookupProblem,
        "lookup.not-constant",
        f"`{entry.name}` is a {prefix} of the enclosing class `{where.path}`; "
        "only its constants are visible here",
        part.span,
        names=[entry.name],
        hint=f"declare it constant at {entry.declaration.span}, or pass it as a parameter",
    )


def protected(scope: Scope, part: ast.NamePart, path: str) -> AcausalError:
    """The error for a protected element used by dot notation (4.1)."""
    return fail(
        TypeProblem,
        "lookup.protected",
        f"`{part.name}` is protected in `{scope.path}` and cannot be used from outside",
        part.span,
        names=[f"{path}.{part.name}"],
        hint="make it public, or use one of the public variables",
    )


def absent(member: Absent, span: Span) -> AcausalError:
    """The error for a conditional component that is not there, used outside `connect` (4.4.5)."""
    if member.potential:
        return fail(
            TypeProblem,
            "expandable.not-present",
            f"`{member.path}` is declared in an expandable connector, but no connection makes it present",
            span,
            names=[member.path],
            hint="connect it to something that gives it a value",
        )
    return fail(
        TypeProblem,
        "lookup.absent",
        f"`{member.path}` is not there: its condition is false",
        span,
        names=[member.path],
        hint="a conditional component may only be used in connect",
    )


def conditional(entry: ComponentEntry, part: ast.NamePart) -> AcausalError:
    """The error for a component with a condition in an expression (4.4.5)."""
    return fail(
        TypeProblem,
        "lookup.conditional",
        f"`{part.name}` has a condition (`if`), so it may only be connected and modified",
        part.span,
        names=[part.name],
        hint=f"it is declared at {entry.declaration.span}; see Modelica 3.6, 4.4.5",
    )


def component_as_value(member: Instance, span: Span) -> AcausalError:
    """The error for a component of a model used as a value."""
    return fail(
        TypeProblem,
        "type.component-as-value",
        f"`{member.path}` is a component of class `{member.scope.path}`, not a value",
        span,
        names=[member.path],
        hint="use one of its variables",
    )
