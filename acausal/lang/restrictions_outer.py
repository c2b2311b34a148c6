"""`outer` components against the `inner` ones they stand for (Modelica 3.6, 5.4 and 5.5)."""

from __future__ import annotations

from acausal.errors import AcausalError, TypeProblem, fail
from acausal.lang import ast
from acausal.lang.class_table import ComponentEntry
from acausal.lang.instance import Array, Instance, Leaf, Outer
from acausal.lang.instance_errors import outer_modified
from acausal.lang.modifiers import Context
from acausal.lang.translation import Translation


def check_outer(parent: Instance, name: str, member: Outer, translation: Translation) -> None:
    """One `outer` component of `parent`. Raises `inner.incompatible`, `modification.outer`."""
    entry = parent.scope.table.components[name]
    modifier = parent.modifier.children.get(name)
    if modifier is not None and not modifier.is_empty and not entry.clause.prefixes.inner:
        raise outer_modified(member.path, modifier.span)
    type_ = entry.scope.find_class(entry.clause.type)
    simple = translation.instances.simple_type(type_)
    target = member.target
    if simple is None:
        if isinstance(target, Leaf):
            raise _incompatible(member, entry, f"a component of `{type_.path}`", str(target.type))
        return
    found = target.type if isinstance(target, (Leaf, Array)) else None
    if isinstance(target, Instance) or (found is not None and found != simple.scalar):
        is_found = f"a component of `{target.scope.path}`" if isinstance(target, Instance) else str(found)
        raise _incompatible(member, entry, str(simple.scalar), is_found)
    written = [entry.declaration.dimensions, entry.clause.dimensions]
    sizes = [(d, Context(entry.scope, parent)) for d in written if d is not None]
    sizes += [(d, Context(scope, None)) for d, scope in simple.dimensions]
    wanted = [_size(item, place, translation) for subscripts, place in sizes for item in subscripts.items]
    shape = target.shape if isinstance(target, Array) else ()
    if len(wanted) != len(shape) or any(
        want not in (None, size) for want, size in zip(wanted, shape, strict=True)
    ):
        raise _incompatible(member, entry, _shaped(wanted), _shaped(list(shape)))


def _size(item: ast.Expression, place: Context, translation: Translation) -> object | None:
    """A declared size; None where any will do, or where a type is the index."""
    if isinstance(item, (ast.Colon, ast.ComponentReference)):
        return None
    return translation.evaluate(item, place, "the size of an outer component")


def _shaped(sizes: list[object | None] | list[int]) -> str:
    return f"an array [{', '.join(':' if n is None else str(n) for n in sizes)}]" if sizes else "a scalar"


def _incompatible(member: Outer, entry: ComponentEntry, wanted: str, found: str) -> AcausalError:
    return fail(
        TypeProblem,
        "inner.incompatible",
        f"the `outer` `{member.path}` is {wanted}, but the `inner` `{member.target.path}` is {found}",
        entry.declaration.span,
        names=[member.path, member.target.path],
        hint="the type of the inner component must be a subtype (Modelica 3.6, 5.4)",
    )
