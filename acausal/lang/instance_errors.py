"""Messages about components that cannot be built."""

from __future__ import annotations

from acausal.errors import AcausalError, LookupProblem, Span, TypeProblem, UnsupportedProblem, fail
from acausal.lang.access import is_partial
from acausal.lang.class_table import ComponentEntry
from acausal.lang.instance import Instance
from acausal.lang.modifiers import Modifier
from acausal.lang.predefined import EXTERNAL_OBJECT
from acausal.lang.scope import Scope


def check_instantiable(scope: Scope, path: str, span: Span) -> None:
    """Raise unless components of the class can be built."""
    if scope.kind in ("package", "function"):
        raise fail(
            TypeProblem,
            "type.not-a-component-type",
            f"`{path}` is declared with the {scope.kind} `{scope.path}` as its type",
            span,
            names=[path],
            hint="use a model, block, connector, record or type",
        )
    if is_partial(scope):
        raise fail(
            TypeProblem,
            "type.partial",
            f"`{path}` is of the partial class `{scope.path}`, which cannot be instantiated",
            span,
            names=[path],
            hint="redeclare it with a class that extends the partial one",
        )
    if scope.path == EXTERNAL_OBJECT or any(base.scope.path == EXTERNAL_OBJECT for base in scope.table.bases):
        message = f"`{path}` is the external object `{scope.path}`, which is not supported yet"
        raise fail(UnsupportedProblem, "unsupported.external-object", message, span, names=[path])


def outer_modified(path: str, span: Span | None) -> AcausalError:
    """The error for a modification of an `outer` component (5.4)."""
    return fail(
        TypeProblem,
        "inner.outer-modified",
        f"`{path}` is `outer` and cannot be modified",
        span,
        names=[path],
        hint="modify the `inner` component",
    )


def modifies_protected(path: str, scope: Scope, modifier: Modifier) -> AcausalError:
    """The error for a modification of a protected element from outside (4.1)."""
    return fail(
        TypeProblem,
        "lookup.protected",
        f"`{path}` is protected in `{scope.path}` and cannot be modified from outside",
        modifier.span,
        names=[path],
        hint="make it public, or modify it in an `extends` clause",
    )


def not_a_component(path: str, span: Span) -> AcausalError:
    """The error for a component redeclared as a class."""
    message = f"`{path}` is a component, but it is redeclared as a class"
    return fail(TypeProblem, "redeclare.kind", message, span, names=[path])


def too_deep(instance: Instance, most: int) -> AcausalError:
    """The error for components nested without end."""
    return fail(
        TypeProblem,
        "instance.recursive",
        f"`{instance.scope.path}` contains itself: components are nested more than {most} deep",
        instance.span,
        names=[instance.scope.path],
        hint="a model cannot have a component of its own class",
    )


def too_large(path: str, span: Span, most: int) -> AcausalError:
    """The error for a model that has too many components."""
    return fail(
        TypeProblem,
        "instance.too-large",
        f"the model has more than {most} components and scalars; `{path}` is one too many",
        span,
        names=[path],
        hint="check the sizes of the arrays",
    )


def cyclic_structure(entry: ComponentEntry, instance: Instance) -> AcausalError:
    """The error for a size or condition that needs the component itself."""
    path = f"{instance.path}.{entry.name}" if instance.path else entry.name
    return fail(
        LookupProblem,
        "parameter.cyclic",
        f"the size, condition or type of `{path}` depends on itself",
        entry.declaration.span,
        names=[path],
        hint="break the circle of parameters",
    )
