"""Arrays indexed by an enumeration or by Boolean take indices of that type only (Modelica 3.6, 10.5.1)."""

from __future__ import annotations

from acausal.lang import ast
from acausal.lang.arithmetic import as_value, type_error
from acausal.lang.class_table import ComponentEntry
from acausal.lang.instance import Array, Instance, Outer
from acausal.lang.iteration import enumerated_type
from acausal.lang.modifiers import Context
from acausal.lang.references import refuse_conditional
from acausal.lang.translation import Env, Translation
from acausal.lang.values import literal


def check_use(translation: Translation, node: ast.ComponentReference, env: Env) -> None:
    """What a reference in an expression may name, and how. Raises `lookup.conditional`, `type.index`."""
    refuse_conditional(node, env)
    for part in node.parts:
        if part.subscripts is not None:
            _check_index_types(translation, node, env)
            return


def _check_index_types(translation: Translation, node: ast.ComponentReference, env: Env) -> None:
    instance = env.context.instance
    if node.global_:
        return
    for part in node.parts:
        entry = None if instance is None else instance.scope.table.components.get(part.name)
        if instance is None or entry is None:
            return
        if part.subscripts is not None:
            _check(translation, entry, instance, part, env)
        member = instance.members.get(part.name)
        while isinstance(member, (Array, Outer)):
            member = member.target if isinstance(member, Outer) else next(iter(member.items), None)
        instance = member if isinstance(member, Instance) else None


def _check(
    translation: Translation, entry: ComponentEntry, instance: Instance, part: ast.NamePart, env: Env
) -> None:
    written = [entry.declaration.dimensions, entry.clause.dimensions]
    sizes = [item for subscripts in written if subscripts is not None for item in subscripts.items]
    indices = part.subscripts.items if part.subscripts is not None else ()
    place = Env(Context(entry.scope, instance))
    for size, index in zip(sizes, indices, strict=False):
        if isinstance(index, ast.Colon) or not isinstance(size, ast.ComponentReference) or _is_chosen(index):
            continue
        wanted = enumerated_type(translation, size, place)
        found = as_value(translation.value(index, env.with_size(literal(1))), index.span).type
        if wanted is not None and found != wanted:
            message = f"this dimension of `{part.name}` is indexed by {wanted}, not by {found}"
            raise type_error("type.index", message, index.span, "see Modelica 3.6, 10.5.1", (part.name,))


def _is_chosen(index: ast.Expression) -> bool:
    """A number in place of a subscript that varies at run time: it stands where that was written."""
    return isinstance(index, ast.IntegerLiteral) and index.span.text.strip() != str(index.value)
