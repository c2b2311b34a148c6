"""Messages about names and classes that lookup cannot find or must not use."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import get_close_matches
from typing import TYPE_CHECKING

from acausal.errors import AcausalError, LookupProblem, Span, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.predefined import SIMPLE_TYPES

if TYPE_CHECKING:
    from acausal.lang.scope import Scope


def did_you_mean(name: str, known: Sequence[str], most: int = 3) -> str:
    """`did you mean `a` or `b`?` with the nearest of the known names, or nothing."""
    near = list(dict.fromkeys(get_close_matches(name, known, most)))
    return f"did you mean {' or '.join(f'`{n}`' for n in near)}?" if near else ""


def unknown_name(name: str, scope: Scope, span: Span, what: str = "name") -> AcausalError:
    """The error for a simple name that no lookup rule finds, with near misses from around."""
    if name == "Clock":
        return fail(
            UnsupportedProblem,
            "unsupported.clock",
            f"`{scope.path}` uses the type `Clock`: synchronous clocks (Modelica 3.6, chapter 16)",
            span,
            names=[name],
            hint="use `when sample(start, interval)` where a sampled system is enough",
        )
    known: list[str] = []
    current: Scope | None = scope
    while current is not None:
        known += [*current.element_names(), *current.node.child_names()]
        current = current.enclosing
    known += [*scope.root.library.top_level_names(), *SIMPLE_TYPES]
    return fail(
        LookupProblem,
        f"lookup.unknown-{what}",
        f"{what} `{name}` is not found in `{scope.path}`, around it, or on the library path",
        span,
        names=[name],
        hint=did_you_mean(name, known) or f"declare `{name}` or import it",
    )


def unknown_target(name: str, target: Scope, span: Span) -> AcausalError:
    """The error for a modification of an element that the class does not have."""
    known = [*target.table.components, *target.table.classes]
    return fail(
        LookupProblem,
        "lookup.unknown-modified-element",
        f"`{target.path}` has no element `{name}` to modify",
        span,
        names=[name],
        hint=did_you_mean(name, known) or f"see the declaration of `{target.path}` at {target.span}",
    )


def unknown_nested(name: str, scope: Scope, span: Span) -> AcausalError:
    """The error for a class that a class does not contain."""
    known = [*scope.element_names(), *scope.node.child_names()]
    return fail(
        LookupProblem,
        "lookup.unknown-class",
        f"class `{name}` is not found in `{scope.path}`",
        span,
        names=[f"{scope.path}.{name}"],
        hint=did_you_mean(name, known) or f"`{scope.path}` has no such class",
    )


def unknown_import(target: str, known: Sequence[str], span: Span) -> AcausalError:
    """The error for an import that starts at a class nobody has."""
    first = target.split(".", maxsplit=1)[0]
    return fail(
        LookupProblem,
        "lookup.unknown-import",
        f"imported `{target}` is not found: there is no `{first}` on the library path",
        span,
        names=[target],
        hint=did_you_mean(first, known) or "imports start at the top level; check --path and MODELICAPATH",
    )


def ambiguous_import(name: str, span: Span) -> AcausalError:
    """The error for a name that two imports `A.*` make visible (5.3.1)."""
    return fail(
        LookupProblem,
        "import.ambiguous",
        f"`{name}` is found in more than one package imported with `.*`",
        span,
        names=[name],
        hint=f"import it by name: `import Package.{name}`",
    )


def component_as_class(name: str, declared: Span, span: Span) -> AcausalError:
    """The error for a component where a class is needed."""
    return fail(
        LookupProblem,
        "lookup.not-a-class",
        f"`{name}` is a component, but a class is needed here",
        span,
        names=[name],
        hint=f"`{name}` is declared at {declared}",
    )


def cyclic_extends(scope: Scope) -> AcausalError:
    """The error for a class among its own base classes."""
    return fail(
        LookupProblem,
        "extends.cyclic",
        f"the class `{scope.path}` extends itself, directly or through another class",
        scope.span,
        names=[scope.path],
        hint="break the circle of `extends`",
    )


def class_extends(definition: ast.LongClass) -> AcausalError:
    """The error for `model extends M` where no `M` is inherited or `redeclare` is missing (7.3.1)."""
    return fail(
        LookupProblem,
        "redeclare.nothing",
        f"`{definition.kind} extends {definition.name}` needs an inherited class of this name",
        definition.span,
        names=[definition.name],
        hint=f"write `redeclare {definition.kind} extends {definition.name}` in a class that inherits it",
    )


def outer_class(name: str, span: Span) -> AcausalError:
    """The refusal of an `outer` class, which depends on where in the model it is used (5.4)."""
    return fail(
        UnsupportedProblem,
        "unsupported.outer-class",
        f"the class `{name}` is `outer`, which is supported for components only",
        span,
        names=[name],
        hint="make the class replaceable and redeclare it",
    )


def duplicate(name: str, scope: Scope, span: Span, first: Span | None) -> AcausalError:
    """The error for two elements with one name."""
    return fail(
        LookupProblem,
        "lookup.duplicate-element",
        f"`{name}` is declared twice in `{scope.path}`",
        span,
        names=[name],
        hint=f"the first declaration is at {first}" if first else "rename one of them",
    )
