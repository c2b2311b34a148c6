"""Component references: from `a.b[2].c` to members of the instance tree, constants of packages, literals.

`resolve` finds what the first identifiers mean, `select` walks the rest with its subscripts, and
`member_value` turns what was found into a value.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import product

from acausal.errors import Span
from acausal.lang import ast
from acausal.lang.access import check_complete, check_inside
from acausal.lang.arithmetic import as_value, type_error
from acausal.lang.class_table import ClassEntry, ComponentEntry
from acausal.lang.flat import ScalarType, Variability
from acausal.lang.instance import Absent, Array, Instance, Leaf, Member, Outer
from acausal.lang.light import light_object
from acausal.lang.lookup_errors import unknown_name
from acausal.lang.reference_errors import (
    absent,
    component_as_value,
    conditional,
    no_component,
    no_such_element,
    not_a_constant,
    protected,
    scalar_has_no_parts,
    unknown_literal,
)
from acausal.lang.scope import FoundComponent, Scope
from acausal.lang.subscripts import subscript_values
from acausal.lang.translation import Env, Translation
from acausal.lang.values import (
    AnyValue,
    RecordArray,
    RecordValue,
    Value,
    enumeration_literal,
    index_offset,
    scalar,
)
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr


@light_object
class Selection:
    """Members picked by a reference: one (`shape` empty) or an array of them, row by row.

    `constant` says that they are constants of a package or class, to be replaced by their values.
    """

    members: tuple[Member, ...]
    shape: tuple[int, ...]
    type: ScalarType | None
    constant: bool = False
    element: Scope | None = None
    """The class of the members, for an empty array."""


@light_object
class EnumerationLiteralFound:
    """A literal of an enumeration, by its index from 1."""

    type: ScalarType
    index: int


Resolved = Selection | Scope | EnumerationLiteralFound


def resolve(translation: Translation, node: ast.ComponentReference, env: Env) -> Resolved:
    """What a reference means. Raises `LookupProblem` naming the first part that is not found."""
    instance, scope = env.context.instance, env.context.scope
    first = node.parts[0]
    if instance is not None and not node.global_ and first.name in scope.table.components:
        member = translation.instances.member(instance, first.name)
        if member is not None:
            found = select(translation, member, node.parts, env, constant=instance.constants)
            return found if found.members else _typed(translation, found, instance.scope, node.parts)
    found = scope.root.top(first.name) if node.global_ else scope.find(first.name)
    if found is None:
        raise unknown_name(first.name, scope, first.span)
    return _from_found(translation, found, node, env)


def _typed(
    translation: Translation, nothing: Selection, scope: Scope, parts: Sequence[ast.NamePart]
) -> Selection:
    """A selection without members with the type that they would have: `ports.v` of no ports at all."""
    if nothing.type is not None:
        return nothing
    for part in parts:
        entry = scope.table.components.get(part.name)
        if entry is None:
            return nothing
        scope = entry.scope.find_class(entry.clause.type)
    simple = translation.instances.simple_type(scope)
    return nothing if simple is None else Selection((), nothing.shape, simple.scalar, nothing.constant)


def _from_found(
    translation: Translation, found: FoundComponent | Scope, node: ast.ComponentReference, env: Env
) -> Resolved:
    """Walk classes until a constant, an enumeration literal or the end of the reference is met."""
    if isinstance(found, FoundComponent):
        return _constant(translation, found, node.parts, env)
    for i, part in enumerate(node.parts[1:], start=1):
        literal = _literal(translation, found, part)
        if literal is not None:
            return literal
        element = _element(found, part)
        if isinstance(element, FoundComponent):
            return _constant(translation, element, node.parts[i:], env)
        found = element
    return found


def _element(scope: Scope, part: ast.NamePart) -> FoundComponent | Scope:
    entry = scope.find_local(part.name)
    if entry is None:
        raise no_such_element(part, scope)
    check_complete(scope, part.name, part.span)
    check_inside(scope, entry, part.span)
    return scope.nested(entry) if isinstance(entry, ClassEntry) else FoundComponent(entry, scope)


def _literal(translation: Translation, scope: Scope, part: ast.NamePart) -> EnumerationLiteralFound | None:
    if scope.kind != "type":
        return None
    simple = translation.instances.simple_type(scope)
    if simple is None or not simple.scalar.is_enumeration:
        return None
    literals = simple.scalar.literals
    if part.name not in literals:
        raise unknown_literal(part, scope, literals)
    return EnumerationLiteralFound(simple.scalar, literals.index(part.name) + 1)


def _constant(
    translation: Translation, found: FoundComponent, parts: Sequence[ast.NamePart], env: Env
) -> Selection:
    entry = found.entry
    if entry.clause.variability != "constant":
        raise not_a_constant(entry, found.where, parts[0])
    around = None if env.context.instance is None else env.context.instance.nearest(found.where)
    holder = around or translation.instances.package(found.where)
    member = translation.instances.member(holder, entry.name)
    assert member is not None
    return select(translation, member, parts, env, constant=holder.constants)


def refuse_conditional(node: ast.ComponentReference, env: Env) -> None:
    """A component with a condition is only modified and connected (4.4.5). Raises `lookup.conditional`."""
    instance = env.context.instance
    if node.global_:
        return
    last = len(node.parts) - 1
    for i, part in enumerate(node.parts):
        entry = None if instance is None else instance.scope.table.components.get(part.name)
        if instance is None or entry is None:
            return
        if entry.declaration.condition is not None:
            raise conditional(entry, part)
        if i == last:
            return
        if entry.clause.prefixes.outer:
            _check_declared(entry, node.parts[i + 1])
        member = instance.members.get(part.name)
        while isinstance(member, (Array, Outer)):
            member = member.target if isinstance(member, Outer) else next(iter(member.items), None)
        instance = member if isinstance(member, Instance) else None


def _check_declared(entry: ComponentEntry, part: ast.NamePart) -> None:
    """Of an `outer` component only what its own type has may be used (5.4)."""
    scope = entry.scope.find_class(entry.clause.type)
    if part.name not in scope.table.components:
        raise no_such_element(part, scope)


# --------------------------------------------------------------------------- walking members


def select(
    translation: Translation, member: Member, parts: Sequence[ast.NamePart], env: Env, *, constant: bool
) -> Selection:
    """Follow the rest of a reference from the member its first part names."""
    selection = _subscript_members(translation, Selection((member,), (), None, constant), parts[0], env)
    for part in parts[1:]:
        selection = select_part_of(translation, selection, part, env)
    return selection


def select_part_of(translation: Translation, selection: Selection, part: ast.NamePart, env: Env) -> Selection:
    """One step further: a part of every member, with its subscripts."""
    if not selection.members and selection.element is not None:
        return _part_of_nothing(translation, selection, selection.element, part)
    members = tuple([_part_of(translation, current, part, env) for current in selection.members])
    inner = Selection(members, selection.shape, None, selection.constant)
    return _subscript_members(translation, inner, part, env)


def _part_of_nothing(
    translation: Translation, selection: Selection, element: Scope, part: ast.NamePart
) -> Selection:
    """A part of an empty array of components: an empty array of the part's type."""
    entry = element.table.components.get(part.name)
    if entry is None:
        raise no_such_element(part, element)
    scope = entry.scope.find_class(entry.clause.type)
    simple = translation.instances.simple_type(scope)
    written = (entry.declaration.dimensions, entry.clause.dimensions)
    inner = sum(len(d.items) for d in written if d is not None)
    singled = 0 if part.subscripts is None else len(part.subscripts.items)
    shape = selection.shape + (0,) * max(0, inner - singled)
    type_ = None if simple is None else simple.scalar
    return Selection((), shape, type_, selection.constant, scope)


def _part_of(translation: Translation, current: Member, part: ast.NamePart, env: Env) -> Member:
    if isinstance(current, Instance):
        entry = current.scope.table.components.get(part.name)
        found = None if entry is None else translation.instances.member(current, part.name)
        if entry is None and env.connecting:
            added = current.members.get(part.name)
            if added is not None and not isinstance(added, Outer):
                return added
        if found is None or entry is None:
            raise no_component(current, part)
        if entry.protected:
            raise protected(current.scope, part, current.path)
        return found
    if isinstance(current, Absent):
        return current  # `connect` drops it, anything else refuses it
    raise scalar_has_no_parts(current.path, part)


def _subscript_members(
    translation: Translation, selection: Selection, part: ast.NamePart, env: Env
) -> Selection:
    """Apply a part's subscripts to what it names; an array without subscripts adds its dimensions."""
    if part.subscripts is None and not any(isinstance(m, Array) for m in selection.members):
        return selection
    members: list[Member] = []
    inner: tuple[int, ...] | None = None
    type_: ScalarType | None = None
    element: Scope | None = None
    for member in selection.members:
        if isinstance(member, Absent):
            return Selection((member,), (), None, selection.constant)
        if not isinstance(member, Array):
            message = f"`{member.path}` is not an array"
            raise type_error("type.not-array", message, part.span, "", (member.path,))
        picks = subscript_values(translation, part.subscripts, member.shape, env, member.path)
        sizes = tuple([len(p) for p in picks if not isinstance(p, int)])
        if inner is not None and sizes != inner:
            message = f"`{member.path}` has another size than its neighbours: this is no array"
            raise type_error("type.array-size", message, part.span, "", (member.path,))
        inner, type_, element = sizes, member.type, member.element
        ranges = [(p,) if isinstance(p, int) else p for p in picks]
        members += [member.items[index_offset(member.shape, index)] for index in product(*ranges)]
    return Selection(tuple(members), selection.shape + (inner or ()), type_, selection.constant, element)


# --------------------------------------------------------------------------- values


def member_value(translation: Translation, found: Resolved, node: ast.ComponentReference) -> AnyValue:
    """The value of what a reference resolved to."""
    if isinstance(found, EnumerationLiteralFound):
        return enumeration_literal(found.type, found.index)
    if isinstance(found, Scope):
        message = f"`{node.text}` is a {found.kind}, not a value"
        raise type_error("type.class-as-value", message, node.span, "", (node.text,))
    if not found.shape and isinstance(found.members[0], Leaf):
        return _leaf_value(translation, found.members[0], found.constant, node.span)
    return selection_value(translation, found, node.span)


def current_value(value: AnyValue, current: Mapping[Expr, Expr]) -> AnyValue:
    """The value with variables replaced by what they are at this point of an algorithm section."""
    if isinstance(value, Value):
        items = tuple([current.get(item, item) for item in value.items])
        return value if items == value.items else Value(value.type, value.shape, items)
    if isinstance(value, RecordValue):
        fields = {name: current_value(field, current) for name, field in value.fields.items()}
        return value.with_fields(fields)
    records = [current_value(item, current) for item in value.items]
    return RecordArray(value.shape, tuple([r for r in records if isinstance(r, RecordValue)]), value.scope)


def selection_value(translation: Translation, found: Selection, span: Span) -> AnyValue:
    """Scalars as symbols (constants of packages as their values), records field by field."""
    if not found.shape:
        return _one(translation, found.members[0], found.constant, span)
    values = [_one(translation, member, found.constant, span) for member in found.members]
    if all(isinstance(v, RecordValue) for v in values) and values:
        records = tuple([v for v in values if isinstance(v, RecordValue)])
        return RecordArray(found.shape, records, records[0].scope)
    plain = [as_value(v, span) for v in values]
    type_ = plain[0].type if plain else found.type
    if type_ is None:
        return RecordArray(found.shape, (), found.element)
    return Value(type_, found.shape, tuple([v.item for v in plain]))


def _one(translation: Translation, member: Member, constant: bool, span: Span) -> AnyValue:
    if isinstance(member, Leaf):
        return _leaf_value(translation, member, constant, span)
    if isinstance(member, Array):
        picked = Selection(member.items, member.shape, member.type, constant, member.element)
        return selection_value(translation, picked, span)
    if isinstance(member, Absent):
        raise absent(member, span)
    if not member.is_record and not member.is_connector:
        raise component_as_value(member, span)
    fields: dict[str, AnyValue] = {}
    for name in member.scope.table.components:
        part = translation.instances.member(member, name)
        if part is not None and not isinstance(part, Absent):
            fields[name] = _one(translation, part, constant, span)
    return RecordValue(member.scope.path, fields, member.scope)


def _leaf_value(translation: Translation, leaf: Leaf, constant: bool, span: Span) -> Value:
    if not constant:
        translation.note(leaf)
        return scalar(leaf.type, ex.sym(leaf.path))
    if leaf.prefixes.variability > Variability.PARAMETER:
        raise type_error("lookup.not-constant", f"`{leaf.path}` is not a constant", span, "", (leaf.path,))
    return scalar(leaf.type, ex.const(translation.constant_of(leaf)))
