"""Which function a call means (Modelica 3.6, 5.3.2): by its name, or through components as `a[2].P.f(x)`."""

from __future__ import annotations

from acausal.errors import AcausalError, LookupProblem, fail
from acausal.lang import ast
from acausal.lang.access import is_protected
from acausal.lang.instance import Array, Instance
from acausal.lang.references import refuse_conditional, select
from acausal.lang.scope import Scope
from acausal.lang.translation import Env, Translation


def function_scope(translation: Translation, reference: ast.ComponentReference, env: Env) -> Scope:
    """The class that a call names. Raises `LookupProblem`."""
    return function_and_owner(translation, reference, env)[0]


def function_and_owner(
    translation: Translation, reference: ast.ComponentReference, env: Env
) -> tuple[Scope, Instance | None]:
    """The class that a call names, and the component it is reached through. Raises `LookupProblem`."""
    instance, scope = env.context.instance, env.context.scope
    first = reference.parts[0].name
    if instance is None or reference.global_ or len(reference.parts) == 1:
        return scope.find_class(reference, "function", complete=True), None
    if first not in scope.table.components:
        return scope.find_class(reference, "function", complete=True), None
    member = translation.instances.member(instance, first)
    count = 1
    while member is not None:
        found = select(translation, member, reference.parts[:count], env, constant=instance.constants)
        last = found.members[0] if found.members and not found.shape else None
        if not isinstance(last, Instance):
            raise _not_through(reference, count, last is None or isinstance(last, Array))
        if (
            reference.parts[count].name not in last.scope.table.components
            or count == len(reference.parts) - 1
        ):
            components = ast.ComponentReference(reference.parts[:count], False, reference.span)
            refuse_conditional(components, env)
            return _class_in(last.scope, reference, count), last
        count += 1
    return scope.find_class(reference, "function", complete=True), None


def _class_in(scope: Scope, reference: ast.ComponentReference, count: int) -> Scope:
    """The rest of the name, which consists of classes."""
    current = scope
    for part in reference.parts[count:]:
        found = current.find_nested(part.name, part.span)
        entry = current.find_class_entry(part.name)
        if entry is not None and is_protected(current, entry):
            raise fail(
                LookupProblem,
                "lookup.protected",
                f"`{part.name}` is protected in `{current.path}` and cannot be used from outside",
                part.span,
                names=[f"{current.path}.{part.name}"],
            )
        current = found
    around = current.enclosing
    in_operator = around is not None and around.kind == "operator"
    if current.kind != "function" or current.definition.class_prefixes.operator or in_operator:
        raise fail(
            LookupProblem,
            "lookup.not-a-function",
            f"`{reference.text}` is reached through a component, so it must be a plain function",
            reference.span,
            names=[reference.text],
            hint="other classes are reached through packages only (Modelica 3.6, 5.3.2)",
        )
    return current


def _not_through(reference: ast.ComponentReference, count: int, array: bool) -> AcausalError:
    name = ".".join([part.name for part in reference.parts[:count]])
    what = "is an array" if array else "has no functions"
    return fail(
        LookupProblem,
        "lookup.not-a-function",
        f"`{reference.text}` is no function: `{name}` {what}",
        reference.span,
        names=[reference.text],
        hint="a function is reached through scalar components or elements of arrays (Modelica 3.6, 5.3.2)",
    )
