"""Statements of functions, run at compile time on symbolic values (Modelica 3.6, chapter 11)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import product

from acausal.errors import AcausalError, Span, TypeProblem, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.arithmetic import as_boolean, as_value, choose, type_error
from acausal.lang.function_frame import Frame
from acausal.lang.iteration import iterator_values
from acausal.lang.subscripts import subscript_values
from acausal.lang.values import (
    AnyValue,
    RecordArray,
    RecordValue,
    Value,
    assignable,
    describe,
    index_offset,
    stack,
)
from acausal.symbolic.expressions.expr import Expr

_BranchNode = tuple[ast.Expression, tuple[ast.Statement, ...]]


class _Signal(Exception):
    """`break` or `return` on the way to its loop or function."""


class _Break(_Signal):
    """On the way to the end of the loop."""


class _Return(_Signal):
    """On the way to the end of the function."""


def run_algorithm(frame: Frame, sections: Iterable[ast.AlgorithmSection]) -> None:
    """Run the algorithm sections of a function; its variables change in `frame`."""
    try:
        for section in sections:
            _statements(frame, section.statements)
    except _Return:
        return
    except _Break:
        message = f"`break` stands outside a loop in `{frame.scope.path}`"
        raise type_error("function.break", message, frame.scope.span, "", (frame.scope.path,)) from None


def _statements(frame: Frame, statements: Sequence[ast.Statement]) -> None:
    for statement in statements:
        frame.translation.count_step(frame.scope.path, statement.span)
        _statement(frame, statement)


def _statement(frame: Frame, statement: ast.Statement) -> None:
    if isinstance(statement, ast.Assignment):
        _assign(frame, statement)
    elif isinstance(statement, ast.IfStatement):
        _if(frame, statement.branches, statement.otherwise)
    elif isinstance(statement, ast.ForStatement):
        _for(frame, statement.iterators, statement.body)
    elif isinstance(statement, ast.WhileStatement):
        _while(frame, statement)
    elif isinstance(statement, ast.ReturnStatement):
        raise _Return
    elif isinstance(statement, ast.BreakStatement):
        raise _Break
    elif not (isinstance(statement, ast.CallStatement) and statement.call.function.text == "assert"):
        raise fail(
            UnsupportedProblem,
            "unsupported.statement",
            f"this statement in `{frame.scope.path}` is not supported yet",
            statement.span,
            names=[frame.scope.path],
        )


# --------------------------------------------------------------------------- assignments


def _assign(frame: Frame, statement: ast.Assignment) -> None:
    env = frame.env()
    if not isinstance(statement.target, ast.Tuple):
        _store(frame, statement.target, frame.translation.value(statement.value, env))
        return
    if not isinstance(statement.value, ast.Call):
        raise type_error("type.tuple", "only a function call has several results", statement.span)
    results = frame.translation.results(statement.value, env)
    targets = statement.target.items
    if len(targets) > len(results):
        name = statement.value.function.text
        message = f"`{name}` has only {len(results)} result(s)"
        raise type_error("call.results", message, statement.span, "", (name,))
    for target, value in zip(targets, results, strict=False):
        if isinstance(target, ast.ComponentReference):
            _store(frame, target, value)


def _store(frame: Frame, target: ast.ComponentReference, value: AnyValue) -> None:
    name = target.parts[0].name
    entry = frame.entries.get(name)
    if entry is None or entry.clause.causality == "input" or entry.clause.variability == "constant":
        what = "is not a variable" if entry is None else f"is {_kind(entry.clause)}"
        message = f"`{name}` {what} of `{frame.scope.path}` and cannot be assigned"
        raise type_error("function.assignment", message, target.span, "", (name,))
    frame.variables[name] = _updated(frame, frame.variables[name], list(target.parts), value)
    frame.assigned.add(name)


def _kind(clause: ast.ComponentClause) -> str:
    return "an input" if clause.causality == "input" else "a constant"


def _updated(frame: Frame, old: AnyValue, parts: list[ast.NamePart], value: AnyValue) -> AnyValue:
    """`old` with the part that the reference names replaced by `value`."""
    part = parts[0]
    if part.subscripts is not None:
        return _store_elements(frame, old, parts, value)
    if len(parts) > 1:
        if not isinstance(old, RecordValue) or parts[1].name not in old.fields:
            message = f"{describe(old)} has no field `{parts[1].name}`"
            raise type_error("lookup.unknown-field", message, parts[1].span, "", (parts[1].name,))
        inner = _updated(frame, old.fields[parts[1].name], parts[1:], value)
        return old.with_fields({**old.fields, parts[1].name: inner})
    if isinstance(old, Value) != isinstance(value, Value):
        message = f"`{part.name}` is {describe(old)}, but it is assigned {describe(value)}"
        raise type_error("type.mismatch", message, part.span, "", (part.name,))
    if isinstance(old, Value) and isinstance(value, Value):
        if not assignable(value.type, old.type):
            message = f"`{part.name}` is {old.type}, but it is assigned {describe(value)}"
            raise type_error("type.mismatch", message, part.span, "", (part.name,))
        if len(value.shape) != len(old.shape) or (old.items and value.shape != old.shape):
            message = f"`{part.name}` is {describe(old)}, but it is assigned {describe(value)}"
            raise type_error("type.array-size", message, part.span, "", (part.name,))
        return Value(old.type, value.shape, value.items)
    return value


def _store_elements(frame: Frame, old: AnyValue, parts: list[ast.NamePart], value: AnyValue) -> AnyValue:
    part = parts[0]
    if isinstance(old, RecordValue):
        message = f"`{part.name}` is {describe(old)}, not an array"
        raise type_error("type.not-array", message, part.span, "", (part.name,))
    picks = subscript_values(frame.translation, part.subscripts, old.shape, frame.env(), part.name)
    ranges = [(p,) if isinstance(p, int) else p for p in picks]
    targets = [index_offset(old.shape, index) for index in product(*ranges)]
    if isinstance(old, RecordArray):
        return _store_records(frame, old, targets, parts, value)
    new = as_value(value, part.span)
    if len(targets) != len(new.items) or len(parts) > 1:
        message = f"{describe(new)} does not fit this part of `{part.name}`"
        raise type_error("type.array-size", message, part.span, "", (part.name,))
    if not assignable(new.type, old.type):
        message = f"`{part.name}` holds {old.type}, but it is assigned {describe(new)}"
        raise type_error("type.mismatch", message, part.span, "", (part.name,))
    items = list(old.items)
    for offset, item in zip(targets, new.items, strict=True):
        items[offset] = item
    return Value(old.type, old.shape, tuple(items))


def _store_records(
    frame: Frame, old: RecordArray, targets: list[int], parts: list[ast.NamePart], value: AnyValue
) -> RecordArray:
    """One record of an array, or one field of it."""
    if len(targets) != 1:
        message = f"only one element of the array of records `{parts[0].name}` can be assigned at a time"
        raise type_error("type.record", message, parts[0].span, "", (parts[0].name,))
    (offset,) = targets
    items = list(old.items)
    bare = ast.NamePart(parts[0].name, None, parts[0].span)
    new = _updated(frame, items[offset], [bare, *parts[1:]], value)
    if not isinstance(new, RecordValue):
        message = f"{describe(new)} is assigned to a record of `{parts[0].name}`"
        raise type_error("type.mismatch", message, parts[0].span, "", (parts[0].name,))
    items[offset] = new
    result = stack(items, old.shape)
    assert isinstance(result, RecordArray)
    return result


# --------------------------------------------------------------------------- branches


def _if(
    frame: Frame,
    branches: Sequence[_BranchNode],
    otherwise: tuple[ast.Statement, ...],
) -> None:
    if not branches:
        _statements(frame, otherwise)
        return
    (condition, body), rest = branches[0], branches[1:]
    test = as_boolean(frame.translation.value(condition, frame.env()), condition.span)
    known = frame.translation.decide_discrete(test)
    if known is None and (_jumps(body) or any(_jumps(b) for _, b in rest) or _jumps(otherwise)):
        known = frame.translation.decide(test)
    if known is not None:
        if known:
            _statements(frame, body)
        else:
            _if(frame, rest, otherwise)
        return
    before, assigned = dict(frame.variables), set(frame.assigned)
    try:
        _both(frame, test, branches, otherwise)
    except _Signal:
        raise _not_inlinable(frame, condition.span) from None
    except TypeProblem:  # sizes or indices make sense in one of the branches only
        known = frame.translation.decide(test)
        if known is None:
            raise
        frame.variables, frame.assigned = before, assigned
        if known:
            _statements(frame, body)
        else:
            _if(frame, rest, otherwise)


def _both(
    frame: Frame,
    test: Expr,
    branches: Sequence[_BranchNode],
    otherwise: tuple[ast.Statement, ...],
) -> None:
    """Run the first branch and the others, each from the same start, and merge what they assign."""
    (condition, body), rest = branches[0], branches[1:]
    before, assigned = dict(frame.variables), set(frame.assigned)
    _statements(frame, body)
    taken, frame.variables = frame.variables, before
    first, frame.assigned = frame.assigned, assigned
    _if(frame, rest, otherwise)
    frame.assigned |= first
    frame.variables = _merged(test, taken, frame.variables, condition.span)


def _jumps(body: Iterable[ast.Statement]) -> bool:
    """Whether statements may break or return."""
    for statement in body:
        if isinstance(statement, (ast.ReturnStatement, ast.BreakStatement)):
            return True
        if isinstance(statement, (ast.ForStatement, ast.WhileStatement)) and _jumps(statement.body):
            return True
        if isinstance(statement, ast.IfStatement) and (
            any(_jumps(b) for _, b in statement.branches) or _jumps(statement.otherwise)
        ):
            return True
    return False


def _not_inlinable(frame: Frame, span: Span) -> AcausalError:
    return fail(
        UnsupportedProblem,
        "unsupported.conditional-jump",
        f"`{frame.scope.path}` cannot be inlined: it loops, returns or breaks under a condition "
        "that is not known at compile time",
        span,
        names=[frame.scope.path],
        hint="assign in both branches instead of returning from one",
    )


def _merged(
    test: Expr, taken: dict[str, AnyValue], other: dict[str, AnyValue], span: Span
) -> dict[str, AnyValue]:
    return {
        name: a if a is other[name] else choose(test, a, other[name], span)
        for name, a in taken.items()
        if name in other
    }


# --------------------------------------------------------------------------- loops


def _for(frame: Frame, iterators: Sequence[ast.Iterator], body: Sequence[ast.Statement]) -> None:
    """`for i in r, j in s loop`: `break` leaves them all."""
    try:
        _for_nested(frame, iterators, body)
    except _Break:
        return


def _for_nested(frame: Frame, iterators: Sequence[ast.Iterator], body: Sequence[ast.Statement]) -> None:
    if not iterators:
        _statements(frame, body)
        return
    first, rest = iterators[0], iterators[1:]
    hidden = frame.variables.get(first.name)
    try:
        for value in iterator_values(frame.translation, first, frame.env()):
            frame.translation.count_step(frame.scope.path, first.span)
            frame.variables[first.name] = value
            _for_nested(frame, rest, body)
    finally:
        if hidden is None:
            frame.variables.pop(first.name, None)
        else:
            frame.variables[first.name] = hidden


def _while(frame: Frame, statement: ast.WhileStatement) -> None:
    try:
        while True:
            frame.translation.count_step(frame.scope.path, statement.span)
            condition = frame.translation.value(statement.condition, frame.env())
            test = frame.translation.decide(as_boolean(condition, statement.condition.span))
            if test is None:
                raise _not_inlinable(frame, statement.condition.span)
            if not test:
                return
            _statements(frame, statement.body)
    except _Break:
        return
