"""What algorithm sections and when-equations assign: variables of the component itself (11.2.1.2)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from acausal.errors import AcausalError, Span
from acausal.lang import ast
from acausal.lang.arithmetic import type_error
from acausal.lang.flat import REAL, Causality, Variability
from acausal.lang.function_frame import Frame
from acausal.lang.index_choices import VariableIndex, check_size, with_colon, with_index
from acausal.lang.instance import Array, Instance, Leaf, Member
from acausal.lang.light import light_object
from acausal.lang.matching_values import match_values
from acausal.lang.references import Selection, refuse_conditional, resolve, selection_value
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue, RecordArray, RecordValue, Value, assignable, describe
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import TRUE, Expr


def store_component(frame: Frame, target: ast.ComponentReference, value: AnyValue) -> None:
    """Give variables of the component their new values at this point of an algorithm section."""
    for guard, symbol, item in list(_choices(frame, target, value, TRUE)):
        frame.current[symbol] = ex.if_then_else(guard, item, frame.current[symbol])


def _choices(
    frame: Frame, target: ast.ComponentReference, value: AnyValue, guard: Expr
) -> Iterator[tuple[Expr, Expr, Expr]]:
    """Which variable gets which value under which condition: of `x[i]` each element may be the one."""
    translation, env = frame.translation, frame.env()
    try:
        left = target_value(translation, target, env, initial=frame.initial)
    except VariableIndex as varying:
        if varying.choice is None:
            raise
        choice = varying.choice
    else:
        check_assignable(left, value, target)
        yield from [(guard, symbol, item) for symbol, item in match_values(left, value, target.span)]
        return
    check_size(choice)
    choice.check(translation, ex.logical_and(frame.guard, guard))
    elements = _elements(frame, with_colon(target, choice), choice.size)
    if elements is not None and isinstance(value, Value) and not value.shape:
        one = Value(elements.type, (), elements.items[:1])
        check_assignable(one, value, target)
        ((_, item),) = match_values(one, value, target.span)
        for k, symbol in enumerate(elements.items, start=1):
            yield ex.logical_and(guard, choice.test(k)), symbol, item
        return
    for k in range(1, choice.size + 1):
        inside = ex.logical_and(guard, choice.test(k))
        yield from _choices(frame, with_index(target, choice, k), value, inside)


def _elements(frame: Frame, target: ast.ComponentReference, size: int) -> Value | None:
    """All variables that one varying subscript chooses from, if that is the only one."""
    try:
        found = target_value(frame.translation, target, frame.env(), initial=frame.initial)
    except VariableIndex:
        return None
    return found if size and isinstance(found, Value) and found.shape == (size,) else None


def target_value(
    translation: Translation, target: ast.ComponentReference, env: Env, *, initial: bool
) -> AnyValue:
    """The variables that a reference on the left names, as symbols. Raises `assignment.*`."""
    found = resolve(translation, target, env)
    refuse_conditional(target, env)
    if not isinstance(found, Selection) or found.constant:
        message = f"`{target.text}` is not a variable and cannot be assigned"
        raise type_error("assignment.target", message, target.span, "", (target.text,))
    _check_owner(translation, target, env)
    for leaf in scalars(found.members):
        _check_leaf(leaf, target, initial=initial)
    return selection_value(translation, found, target.span)


def _check_leaf(leaf: Leaf, target: ast.ComponentReference, *, initial: bool) -> None:
    prefixes = leaf.prefixes
    if prefixes.variability is Variability.CONSTANT:
        raise _refused(leaf, "a constant", target.span)
    if prefixes.variability is Variability.PARAMETER and not initial:
        raise _refused(leaf, "a parameter", target.span)
    if prefixes.causality is Causality.INPUT and len(target.parts) == 1:
        raise _refused(leaf, "an input", target.span)


def _refused(leaf: Leaf, what: str, span: Span) -> AcausalError:
    message = f"`{leaf.path}` is {what} and cannot be assigned"
    return type_error("assignment.target", message, span, "", (leaf.path,))


def _check_owner(translation: Translation, target: ast.ComponentReference, env: Env) -> None:
    """Only variables of the component itself, its connectors and records, not of its models and blocks."""
    current: Member | None = env.context.instance
    for part in target.parts[:-1]:
        if not isinstance(current, Instance):
            return
        current = translation.instances.member(current, part.name)
        while isinstance(current, Array) and current.items:
            current = current.items[0]
        if isinstance(current, Instance) and not current.is_record and not current.is_connector:
            message = f"`{target.text}` belongs to the component `{current.path}`, which determines it itself"
            hint = "assign a variable of this model, and connect it or use it in an equation"
            raise type_error("assignment.component", message, target.span, hint, (target.text,))


def scalars(members: Sequence[Member]) -> Iterator[Leaf]:
    """The scalars below members, in order."""
    for member in members:
        if isinstance(member, Leaf):
            yield member
        elif isinstance(member, Array):
            yield from scalars(member.items)
        elif isinstance(member, Instance):
            yield from scalars([m for m in member.members.values() if isinstance(m, (Leaf, Array, Instance))])


def check_assignable(left: AnyValue, value: AnyValue, target: ast.ComponentReference) -> None:
    """An Integer variable takes no Real, and so on (6.6); sizes and fields are checked by `match_values`."""
    if isinstance(left, Value) and isinstance(value, Value) and not assignable(value.type, left.type):
        message = f"`{target.text}` is {describe(left)}, but it is assigned {describe(value)}"
        raise type_error("type.mismatch", message, target.span, "", (target.text,))
    if isinstance(left, RecordValue) and isinstance(value, RecordValue):
        for name, field in left.fields.items():
            if name in value.fields:
                check_assignable(field, value.fields[name], target)
    if isinstance(left, RecordArray) and isinstance(value, RecordArray):
        for a, b in zip(left.items, value.items, strict=False):
            check_assignable(a, b, target)


# --------------------------------------------------------------------------- what a section assigns


def whole_variables(translation: Translation, written: Target, env: Env) -> list[Leaf]:
    """The variables of a target without its subscripts: the whole array counts as assigned (11.1.2)."""
    target = written.reference
    name = target.parts[0].name
    if name in written.iterators:
        message = f"`{name}` runs over the range of a loop and cannot be assigned"
        raise type_error("statement.iterator", message, target.span, "", (name,))
    bare = replace(target, parts=tuple([replace(part, subscripts=None) for part in target.parts]))
    found = resolve(translation, bare, env)
    if not isinstance(found, Selection) or found.constant:
        message = f"`{target.text}` is not a variable and cannot be assigned"
        raise type_error("assignment.target", message, target.span, "", (target.text,))
    return list(scalars(found.members))


@light_object
class Target:
    """The target of an assignment: whether in a when-statement, and the iterators of the loops around it."""

    reference: ast.ComponentReference
    in_when: bool
    iterators: tuple[str, ...]


def targets_in(
    statements: Sequence[ast.Statement], in_when: bool = False, iterators: tuple[str, ...] = ()
) -> Iterator[Target]:
    """The targets of all assignments below statements, in order."""
    for statement in statements:
        if isinstance(statement, ast.Assignment):
            items = statement.target.items if isinstance(statement.target, ast.Tuple) else [statement.target]
            for item in items:
                if isinstance(item, ast.ComponentReference):
                    yield Target(item, in_when, iterators)
        elif isinstance(statement, ast.ForStatement):
            names = (*iterators, *[iterator.name for iterator in statement.iterators])
            yield from targets_in(statement.body, in_when, names)
        elif isinstance(statement, ast.WhileStatement):
            yield from targets_in(statement.body, in_when, iterators)
        elif isinstance(statement, (ast.IfStatement, ast.WhenStatement)):
            inside = in_when or isinstance(statement, ast.WhenStatement)
            for _, body in statement.branches:
                yield from targets_in(body, inside, iterators)
            if isinstance(statement, ast.IfStatement):
                yield from targets_in(statement.otherwise, inside, iterators)


def is_discrete(leaf: Leaf) -> bool:
    """Whether a variable is discrete by its type or prefix."""
    return leaf.type != REAL or leaf.prefixes.variability is Variability.DISCRETE
