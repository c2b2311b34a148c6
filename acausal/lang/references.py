"""Component references: from `a.b[2].c` to members of the instance tree, constants of packages, literals.

`resolve` finds what the first identifiers mean, `select` walks the rest with its subscripts, and
`member_value` turns what was found into a value.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from itertools import product
from typing import TYPE_CHECKING

from acausal.errors import LookupProblem, Span, fail
from acausal.lang import ast
from acausal.lang.arithmetic import as_value, type_error
from acausal.lang.flat import BOOLEAN, INTEGER, ScalarType, Variability
from acausal.lang.instance import Absent, Array, Instance, Leaf, Member
from acausal.lang.instantiate import enumeration_of
from acausal.lang.scope import FoundComponent, Scope, did_you_mean, unknown_name
from acausal.lang.values import (
    AnyValue,
    RecordArray,
    RecordValue,
    Value,
    describe,
    enumeration_literal,
    index_offset,
    scalar,
    subscript,
)
from acausal.symbolic.expressions import expr as ex

if TYPE_CHECKING:
    from acausal.lang.translate import Env, Translator


@dataclass(frozen=True, slots=True, eq=False)
class Selection:
    """Members picked by a reference: one (`shape` empty) or an array of them, row by row.

    `constant` says that they are constants of a package or class, to be replaced by their values.
    """

    members: tuple[Member, ...]
    shape: tuple[int, ...]
    type: ScalarType | None
    constant: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class EnumerationLiteralFound:
    type: ScalarType
    index: int


Resolved = Selection | Scope | EnumerationLiteralFound


def resolve(translator: Translator, node: ast.ComponentReference, env: Env) -> Resolved:
    """What a reference means. Raises `LookupProblem` naming the first part that is not found."""
    instance = env.context.instance
    first = node.parts[0]
    if instance is not None and not node.global_:
        member = translator.instances.member(instance, first.name)
        if member is not None:
            return select(translator, member, node.parts, env, constant=False)
    found = env.context.scope.root.top(first.name) if node.global_ else env.context.scope.find(first.name)
    if found is None:
        raise unknown_name(first.name, env.context.scope, first.span)
    return _from_found(translator, found, node, env)


def _from_found(
    translator: Translator, found: FoundComponent | Scope, node: ast.ComponentReference, env: Env
) -> Resolved:
    """Walk classes until a constant, an enumeration literal or the end of the reference is met."""
    for i, part in enumerate(node.parts):
        if i > 0:
            assert isinstance(found, Scope)
            literal = _literal(found, part)
            if literal is not None:
                return literal
            entry = found.find_local(part.name)
            if entry is None:
                raise _no_such(part, found)
            nested = found.find_class_entry(part.name)
            component = found.table.components.get(part.name)
            if component is not None:
                found = FoundComponent(component, found)
            else:
                assert nested is not None
                found = found.nested(nested)
        if isinstance(found, FoundComponent):
            return _constant(translator, found, node.parts[i:], env)
    return found


def _literal(scope: Scope, part: ast.NamePart) -> EnumerationLiteralFound | None:
    definition = scope.definition
    while isinstance(definition, ast.ShortClass) and scope.table.bases and not scope.table.components:
        scope = scope.table.bases[0].scope
        definition = scope.definition
    if not isinstance(definition, ast.EnumerationClass):
        return None
    type_ = enumeration_of(scope)
    if part.name not in type_.literals:
        raise fail(
            LookupProblem,
            "lookup.unknown-literal",
            f"the enumeration `{scope.path}` has no literal `{part.name}`",
            part.span,
            names=[part.name],
            hint=did_you_mean(get_close_matches(part.name, type_.literals, 2)) or f"literals: {', '.join(type_.literals)}",
        )
    return EnumerationLiteralFound(type_, type_.literals.index(part.name) + 1)


def _constant(
    translator: Translator, found: FoundComponent, parts: Sequence[ast.NamePart], env: Env
) -> Selection:
    entry = found.entry
    if entry.clause.variability != "constant":
        prefix = entry.clause.variability or "variable"
        raise fail(
            LookupProblem,
            "lookup.not-constant",
            f"`{entry.name}` is a {prefix} of the enclosing class `{found.where.path}`; only its constants are visible here",
            parts[0].span,
            names=[entry.name],
            hint=f"declare it constant at {entry.declaration.span}, or pass it as a parameter",
        )
    holder = translator.instances.package(found.where)
    member = translator.instances.member(holder, entry.name)
    assert member is not None
    return select(translator, member, parts, env, constant=True)


def _no_such(part: ast.NamePart, scope: Scope) -> LookupProblem:
    known = [*scope.table.components, *scope.table.classes, *scope.node.child_names()]
    error = fail(
        LookupProblem,
        "lookup.unknown-name",
        f"`{part.name}` is not found in `{scope.path}`",
        part.span,
        names=[f"{scope.path}.{part.name}"],
        hint=did_you_mean(get_close_matches(part.name, known, 3)) or f"`{scope.path}` has no such element",
    )
    assert isinstance(error, LookupProblem)
    return error


# --------------------------------------------------------------------------- walking members


def select(
    translator: Translator, member: Member, parts: Sequence[ast.NamePart], env: Env, *, constant: bool
) -> Selection:
    """Follow the rest of a reference from the member its first part names."""
    selection = _subscript_members(translator, Selection((member,), (), None, constant), parts[0], env)
    for part in parts[1:]:
        members: list[Member] = []
        for current in selection.members:
            members.append(_part_of(translator, current, part))
        inner = Selection(tuple(members), selection.shape, None, constant)
        selection = _subscript_members(translator, inner, part, env)
    return selection


def _part_of(translator: Translator, current: Member, part: ast.NamePart) -> Member:
    if isinstance(current, Instance):
        found = translator.instances.member(current, part.name)
        if found is not None:
            if _is_protected(current, part.name):
                raise _protected(current, part)
            return found
        known = list(current.scope.table.components)
        near = did_you_mean(get_close_matches(part.name, known, 3))
        raise fail(
            LookupProblem,
            "lookup.unknown-name",
            f"`{current.path}` (a `{current.scope.path}`) has no component `{part.name}`",
            part.span,
            names=[f"{current.path}.{part.name}"],
            hint=near or (f"it has: {', '.join(known[:8])}" if known else "it has no components"),
        )
    if isinstance(current, Absent):
        return current  # `connect` drops it, anything else refuses it
    raise fail(
        LookupProblem,
        "lookup.unknown-name",
        f"`{current.path}` is a scalar and has no component `{part.name}`",
        part.span,
        names=[f"{current.path}.{part.name}"],
    )


def _is_protected(current: Instance, name: str) -> bool:
    return current.scope.table.components[name].protected


def _protected(current: Instance, part: ast.NamePart) -> TypeProblem:
    return type_error(
        "lookup.protected",
        f"`{part.name}` is protected in `{current.scope.path}` and cannot be used from outside",
        part.span,
        "make it public, or use one of the public variables",
        (f"{current.path}.{part.name}",),
    )


def _subscript_members(translator: Translator, selection: Selection, part: ast.NamePart, env: Env) -> Selection:
    """Apply a part's subscripts to what it names; an array without subscripts adds its dimensions."""
    if part.subscripts is None and not any(isinstance(m, Array) for m in selection.members):
        return selection
    members: list[Member] = []
    inner: tuple[int, ...] = ()
    type_: ScalarType | None = None
    for member in selection.members:
        if isinstance(member, Absent):
            return Selection((member,), (), None, selection.constant)
        if not isinstance(member, Array):
            raise type_error("type.not-array", f"`{member.path}` is not an array", part.span, "", (member.path,))
        picks = subscript_values(translator, part.subscripts, member.shape, env, member.path)
        inner = tuple([len(p) for p in picks if not isinstance(p, int)])
        type_ = member.type
        ranges = [(p,) if isinstance(p, int) else p for p in picks]
        members += [member.items[index_offset(member.shape, index)] for index in product(*ranges)]
    return Selection(tuple(members), selection.shape + inner, type_, selection.constant)


def subscript_values(
    translator: Translator, subscripts: ast.Subscripts | None, shape: tuple[int, ...], env: Env, path: str
) -> list[int | Sequence[int]]:
    """Each subscript as an index or a list of indices (from 0), checked against the sizes."""
    from dataclasses import replace

    items = () if subscripts is None else subscripts.items
    if subscripts is not None and len(items) > len(shape):
        raise type_error(
            "type.array-size", f"`{path}` has {len(shape)} dimension(s), not {len(items)}", subscripts.span, "", (path,)
        )
    picks: list[int | Sequence[int]] = []
    for item, size in zip(items, shape, strict=False):
        if isinstance(item, ast.Colon):
            picks.append(range(size))
            continue
        value = as_value(translator.value(item, replace(env, size=size)), item.span)
        indices = [_index(translator, value, k, size, item, path) for k in range(len(value.items))]
        if len(value.shape) > 1:
            raise type_error("type.subscript", "a subscript is a scalar or a vector", item.span)
        picks.append(indices if value.shape else indices[0])
    picks += [range(size) for size in shape[len(items) :]]
    return picks


def _index(translator: Translator, value: Value, k: int, size: int, item: ast.Expression, path: str) -> int:
    if value.type not in (INTEGER, BOOLEAN) and not value.type.is_enumeration:
        raise type_error("type.subscript", f"a subscript must be Integer, not {describe(value)}", item.span)
    constant = translator.evaluate_expr(value.items[k], item.span, f"the subscript of `{path}`")
    number = ex.const(constant).number
    index = int(number) if value.type == BOOLEAN else int(number) - 1
    if not 0 <= index < size:
        raise type_error(
            "type.index-out-of-range",
            f"index {int(number)} of `{path}` is outside 1 to {size}",
            item.span,
            "",
            (path,),
        )
    return index


def apply_subscripts(translator: Translator, value: Value, subscripts: ast.Subscripts, env: Env) -> Value:
    """`value[subscripts]` of an array value."""
    return subscript(value, subscript_values(translator, subscripts, value.shape, env, "this array"))


# --------------------------------------------------------------------------- values


def member_value(translator: Translator, found: Resolved, node: ast.ComponentReference, env: Env) -> AnyValue:
    """The value of what a reference resolved to."""
    if isinstance(found, EnumerationLiteralFound):
        return enumeration_literal(found.type, found.index)
    if isinstance(found, Scope):
        raise type_error(
            "type.class-as-value", f"`{node.text}` is a {found.kind}, not a value", node.span, "", (node.text,)
        )
    return selection_value(translator, found, node.span)


def selection_value(translator: Translator, found: Selection, span: Span) -> AnyValue:
    """Scalars as symbols (constants of packages as their values), records field by field."""
    if not found.shape:
        return _one(translator, found.members[0], found.constant, span)
    values = [_one(translator, member, found.constant, span) for member in found.members]
    if all(isinstance(v, RecordValue) for v in values) and values:
        return RecordArray(found.shape, tuple([v for v in values if isinstance(v, RecordValue)]))
    plain = [as_value(v, span) for v in values]
    type_ = plain[0].type if plain else found.type
    assert type_ is not None
    return Value(type_, found.shape, tuple([v.item for v in plain]))


def _one(translator: Translator, member: Member, constant: bool, span: Span) -> AnyValue:
    if isinstance(member, Leaf):
        return _leaf_value(translator, member, constant, span)
    if isinstance(member, Array):
        return selection_value(translator, Selection(member.items, member.shape, member.type, constant), span)
    if isinstance(member, Absent):
        raise type_error(
            "lookup.absent",
            f"`{member.path}` is not there: its condition is false",
            span,
            "a conditional component may only be used in connect",
            (member.path,),
        )
    if not member.is_record and not member.is_connector:
        raise type_error(
            "type.component-as-value",
            f"`{member.path}` is a component of class `{member.scope.path}`, not a value",
            span,
            "use one of its variables",
            (member.path,),
        )
    fields: dict[str, AnyValue] = {}
    for name in member.scope.table.components:
        part = translator.instances.member(member, name)
        if part is not None and not isinstance(part, Absent):
            fields[name] = _one(translator, part, constant, span)
    return RecordValue(member.scope.path, fields)


def _leaf_value(translator: Translator, leaf: Leaf, constant: bool, span: Span) -> Value:
    translator.leaves.setdefault(leaf.path, leaf)
    if not constant:
        return scalar(leaf.type, ex.sym(leaf.path))
    if leaf.prefixes.variability > Variability.PARAMETER:
        raise type_error("lookup.not-constant", f"`{leaf.path}` is not a constant", span, "", (leaf.path,))
    value = translator.parameter_value(leaf.path)
    assert value is not None
    return scalar(leaf.type, ex.const(value))
