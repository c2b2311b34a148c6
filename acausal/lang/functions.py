"""User functions: inlined by running their algorithm on symbolic values (Modelica 3.6, chapter 12).

Every call is replaced by the expressions its outputs come to. Loops run over ranges known at compile time,
an `if` whose condition is known takes one branch, any other merges the values that its branches assign.
What cannot be inlined is refused by name.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import prod
from typing import TYPE_CHECKING

from acausal.errors import AcausalError, Span, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.arithmetic import as_boolean, as_value, choose, type_error
from acausal.lang.builtins import BUILTINS
from acausal.lang.flat import REAL
from acausal.lang.modifiers import Context
from acausal.lang.scope import ComponentEntry, Scope
from acausal.lang.values import (
    AnyValue,
    RecordArray,
    RecordValue,
    Value,
    assignable,
    describe,
    index_offset,
)
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr

if TYPE_CHECKING:
    from acausal.lang.translate import Env, Translator

MAX_ITERATIONS = 100_000


class _Signal(Exception):
    """`break` or `return` on the way to its loop or function."""


class _Break(_Signal):
    pass


class _Return(_Signal):
    pass


@dataclass(slots=True)
class _Frame:
    """A running function: its variables and what they were declared as."""

    translator: Translator
    env: Env
    variables: dict[str, AnyValue]
    entries: dict[str, ComponentEntry]
    scope: Scope
    iterations: int = 0

    def current(self) -> Env:
        return replace(self.env, locals=self.variables)


def call_function(translator: Translator, scope: Scope, node: ast.Call, env: Env) -> list[AnyValue]:
    """The outputs of a call, in order. Raises `TypeProblem`, `UnsupportedProblem`."""
    if scope.kind != "function" and not _is_function(scope):
        raise type_error(
            "call.not-a-function", f"`{scope.path}` is a {scope.kind}, not a function", node.span, "", (scope.path,)
        )
    builtin = _external_builtin(scope)
    inputs = [e for e in scope.table.components.values() if e.clause.causality == "input"]
    given = _bind_arguments(translator, scope, inputs, node, env)
    if builtin is not None:
        return [BUILTINS[builtin]([given[e.name] for e in inputs], node.span)]
    if scope.table.external is not None:
        raise fail(
            UnsupportedProblem,
            "unsupported.external-function",
            f"`{scope.path}` is an external function, which is not supported yet",
            node.span,
            names=[scope.path],
        )
    vector = _broadcast(translator, scope, inputs, given, node, env)
    return vector if vector is not None else _run(translator, scope, given, node, env)


def _is_function(scope: Scope) -> bool:
    return any(base.scope.kind == "function" for base in scope.table.bases)


def _external_builtin(scope: Scope) -> str | None:
    """`external "builtin" y = sin(u)` of the Modelica Standard Library's elementary functions."""
    external = scope.table.external
    if external is not None and external.language == "builtin" and external.name in BUILTINS:
        return external.name
    return None


def _bind_arguments(
    translator: Translator, scope: Scope, inputs: Sequence[ComponentEntry], node: ast.Call, env: Env
) -> dict[str, AnyValue]:
    given: dict[str, AnyValue] = {}
    if len(node.arguments) > len(inputs):
        raise type_error(
            "call.arguments",
            f"`{scope.path}` takes {len(inputs)} argument(s), not {len(node.arguments)}",
            node.span,
            f"its inputs: {', '.join(e.name for e in inputs)}",
            (scope.path,),
        )
    for entry, argument in zip(inputs, node.arguments, strict=False):
        given[entry.name] = translator.value(argument, env)
    names = {e.name for e in inputs}
    for named in node.named:
        if named.name not in names or named.name in given:
            what = "is given twice" if named.name in given else "is not an input"
            raise type_error(
                "call.arguments",
                f"`{named.name}` {what} of `{scope.path}`",
                named.span,
                f"its inputs: {', '.join(e.name for e in inputs)}",
                (named.name,),
            )
        given[named.name] = translator.value(named.value, env)
    return given


def construct_record(translator: Translator, scope: Scope, node: ast.Call, env: Env) -> RecordValue:
    """`Record(a, b, c = 1)`: positional and named fields, defaults for the rest (12.6)."""
    entries = list(scope.table.components.values())
    given = _bind_arguments(translator, scope, entries, node, env)
    frame = _Frame(translator, _inner_env(env, scope), {}, scope.table.components, scope)
    for entry in entries:
        frame.variables[entry.name] = _declared(frame, entry, given.get(entry.name), node.span)
    return RecordValue(scope.path, dict(frame.variables))


def _inner_env(env: Env, scope: Scope) -> Env:
    from acausal.lang.translate import Env as EnvClass

    return EnvClass(Context(scope, None), {}, None, env.depth + 1)


def _run(
    translator: Translator, scope: Scope, given: dict[str, AnyValue], node: ast.Call, env: Env
) -> list[AnyValue]:
    table = scope.table
    frame = _Frame(translator, _inner_env(env, scope), {}, table.components, scope)
    for entry in table.components.values():
        value = given.get(entry.name)
        if value is None and entry.clause.causality == "input" and _default(entry) is None:
            raise type_error(
                "call.arguments",
                f"`{scope.path}` needs a value for its input `{entry.name}`",
                node.span,
                "give it as an argument",
                (entry.name,),
            )
        if value is not None or _default(entry) is not None or entry.clause.causality != "output":
            declared = _declared(frame, entry, value, node.span)
            if declared is not None:
                frame.variables[entry.name] = declared
    _algorithm(frame, node)
    outputs = [e for e in table.components.values() if e.clause.causality == "output"]
    for entry in outputs:
        if entry.name not in frame.variables:
            raise type_error(
                "function.unassigned",
                f"the output `{entry.name}` of `{scope.path}` is never assigned",
                entry.declaration.span,
                "",
                (entry.name,),
            )
    return [frame.variables[entry.name] for entry in outputs]


def _algorithm(frame: _Frame, node: ast.Call) -> None:
    sections = [s for s, _ in frame.scope.table.sections if isinstance(s, ast.AlgorithmSection)]
    if not sections:
        raise type_error("function.no-body", f"`{frame.scope.path}` has no algorithm", node.span)
    try:
        for section in sections:
            _statements(frame, section.statements)
    except _Return:
        return


def _default(entry: ComponentEntry) -> ast.Expression | None:
    modification = entry.declaration.modification
    value = None if modification is None else modification.value
    return None if isinstance(value, ast.Break) else value


def _declared(frame: _Frame, entry: ComponentEntry, value: AnyValue | None, span: Span) -> AnyValue:
    """The initial value of a function variable or record field, checked against its declaration.

    Unassigned variables start as zeros of their declared size, so that element-wise assignment works.
    """
    translator, env = frame.translator, frame.current()
    type_scope = entry.scope.find_class(entry.clause.type)
    simple = translator.instances.simple_type(type_scope)
    shape = _declared_shape(frame, entry)
    if value is None:
        default = _default(entry)
        if default is not None:
            value = translator.value(default, env)
    if value is None:
        return _empty(frame, entry, type_scope, shape)
    if simple is None:
        return value
    plain = as_value(value, span)
    if not assignable(plain.type, simple.scalar):
        raise type_error(
            "type.mismatch",
            f"`{entry.name}` of `{frame.scope.path}` is {simple.scalar}, but it is given {describe(plain)}",
            span,
            "",
            (entry.name,),
        )
    if shape is not None and len(shape) == len(plain.shape):
        for want, size in zip(shape, plain.shape, strict=True):
            if want is not None and want != size:
                raise type_error(
                    "type.array-size",
                    f"`{entry.name}` of `{frame.scope.path}` has size {want}, but it is given {describe(plain)}",
                    span,
                )
    return Value(simple.scalar, plain.shape, plain.items)


def _empty(frame: _Frame, entry: ComponentEntry, type_scope: Scope, shape: list[int | None] | None) -> AnyValue:
    simple = frame.translator.instances.simple_type(type_scope)
    if simple is None:
        fields: dict[str, AnyValue] = {}
        inner = _Frame(frame.translator, _inner_env(frame.env, type_scope), {}, type_scope.table.components, type_scope)
        for part in type_scope.table.components.values():
            inner.variables[part.name] = fields[part.name] = _declared(inner, part, None, entry.declaration.span)
        return RecordValue(type_scope.path, fields)
    sizes = tuple([n or 0 for n in shape or ()])
    zero = {"Boolean": ex.FALSE, "Integer": ex.const(0), "String": ex.const("")}.get(simple.scalar.name, ex.ZERO)
    return Value(simple.scalar, sizes, (zero,) * prod(sizes))


def _declared_shape(frame: _Frame, entry: ComponentEntry) -> list[int | None] | None:
    shape: list[int | None] = []
    for dimensions in (entry.declaration.dimensions, entry.clause.dimensions):
        for item in () if dimensions is None else dimensions.items:
            if isinstance(item, ast.Colon):
                shape.append(None)
                continue
            size = frame.translator.evaluate_in(item, frame.current(), f"the size of `{entry.name}`")
            shape.append(size if isinstance(size, int) else None)
    return shape


def _broadcast(
    translator: Translator,
    scope: Scope,
    inputs: Sequence[ComponentEntry],
    given: dict[str, AnyValue],
    node: ast.Call,
    env: Env,
) -> list[AnyValue] | None:
    """A scalar function called with arrays works element by element (12.4.6)."""
    extra: tuple[int, ...] | None = None
    for entry in inputs:
        value = given.get(entry.name)
        if isinstance(value, Value) and value.shape and not _is_array(translator, entry):
            if extra is not None and extra != value.shape:
                raise type_error("type.array-size", f"arguments of `{scope.path}` have different sizes", node.span)
            extra = value.shape
    if extra is None:
        return None
    columns: list[list[AnyValue]] = []
    for k in range(prod(extra)):
        picked: dict[str, AnyValue] = {}
        for entry in inputs:
            value = given.get(entry.name)
            if isinstance(value, Value) and value.shape and not _is_array(translator, entry):
                value = Value(value.type, (), (value.items[k],))
            if value is not None:
                picked[entry.name] = value
        columns.append(_run(translator, scope, picked, node, env))
    results: list[AnyValue] = []
    for position in range(len(columns[0]) if columns else 0):
        cells = [as_value(column[position], node.span) for column in columns]
        results.append(Value(cells[0].type, extra, tuple([c.item for c in cells])))
    return results or [Value(REAL, extra, ())]


def _is_array(translator: Translator, entry: ComponentEntry) -> bool:
    if entry.declaration.dimensions is not None or entry.clause.dimensions is not None:
        return True
    simple = translator.instances.simple_type(entry.scope.find_class(entry.clause.type))
    return simple is not None and bool(simple.dimensions)


# --------------------------------------------------------------------------- statements


def _statements(frame: _Frame, statements: Sequence[ast.Statement]) -> None:
    for statement in statements:
        frame.iterations += 1
        if frame.iterations > MAX_ITERATIONS:
            raise _too_long(frame, statement.span)
        _statement(frame, statement)


def _too_long(frame: _Frame, span: Span) -> AcausalError:
    return type_error(
        "function.too-long", f"`{frame.scope.path}` runs more than {MAX_ITERATIONS} statements", span
    )


def _statement(frame: _Frame, statement: ast.Statement) -> None:
    if isinstance(statement, ast.Assignment):
        _assign(frame, statement)
    elif isinstance(statement, ast.IfStatement):
        _if(frame, statement.branches, statement.otherwise)
    elif isinstance(statement, ast.ForStatement):
        _for(frame, statement)
    elif isinstance(statement, ast.WhileStatement):
        _while(frame, statement)
    elif isinstance(statement, ast.ReturnStatement):
        raise _Return
    elif isinstance(statement, ast.BreakStatement):
        raise _Break
    elif isinstance(statement, ast.CallStatement) and statement.call.function.text == "assert":
        return
    else:
        raise fail(
            UnsupportedProblem,
            "unsupported.statement",
            f"this statement in `{frame.scope.path}` is not supported yet",
            statement.span,
        )


def _assign(frame: _Frame, statement: ast.Assignment) -> None:
    translator, env = frame.translator, frame.current()
    if isinstance(statement.target, ast.Tuple):
        if not isinstance(statement.value, ast.Call):
            raise type_error("type.tuple", "only a function call has several results", statement.span)
        scope = frame.scope.find_class(statement.value.function)
        results = call_function(translator, scope, statement.value, env)
        for target, value in zip(statement.target.items, results, strict=False):
            if isinstance(target, ast.ComponentReference):
                _store(frame, target, value)
        return
    _store(frame, statement.target, translator.value(statement.value, env))


def _store(frame: _Frame, target: ast.ComponentReference, value: AnyValue) -> None:
    name = target.parts[0].name
    entry = frame.entries.get(name)
    if entry is None or entry.clause.causality == "input":
        what = "is an input" if entry is not None else "is not a variable"
        raise type_error(
            "function.assignment", f"`{name}` {what} of `{frame.scope.path}` and cannot be assigned", target.span, "", (name,)
        )
    old = frame.variables.get(name)
    if old is None:
        old = _declared(frame, entry, None, target.span)
    frame.variables[name] = _updated(frame, old, list(target.parts), value, entry)


def _updated(
    frame: _Frame, old: AnyValue, parts: list[ast.NamePart], value: AnyValue, entry: ComponentEntry
) -> AnyValue:
    part = parts[0]
    if part.subscripts is not None:
        return _store_elements(frame, as_value(old, part.span), part, value)
    if len(parts) > 1:
        if not isinstance(old, RecordValue) or parts[1].name not in old.fields:
            raise type_error("lookup.unknown-field", f"there is no field `{parts[1].name}`", parts[1].span)
        inner = _updated(frame, old.fields[parts[1].name], parts[1:], value, entry)
        return RecordValue(old.type_name, {**old.fields, parts[1].name: inner})
    if isinstance(old, Value) and isinstance(value, Value):
        if not assignable(value.type, old.type):
            raise type_error(
                "type.mismatch", f"`{part.name}` is {old.type}, but it is assigned {describe(value)}", part.span
            )
        return Value(old.type, value.shape, value.items)
    return value


def _store_elements(frame: _Frame, old: Value, part: ast.NamePart, value: AnyValue) -> Value:
    from itertools import product

    from acausal.lang.references import subscript_values

    new = as_value(value, part.span)
    picks = subscript_values(frame.translator, part.subscripts, old.shape, frame.current(), part.name)
    ranges = [(p,) if isinstance(p, int) else p for p in picks]
    targets = [index_offset(old.shape, index) for index in product(*ranges)]
    if len(targets) != len(new.items):
        raise type_error("type.array-size", f"{describe(new)} does not fit the part of `{part.name}`", part.span)
    items = list(old.items)
    for offset, item in zip(targets, new.items, strict=True):
        items[offset] = item
    return Value(old.type, old.shape, tuple(items))


def _if(
    frame: _Frame,
    branches: Sequence[tuple[ast.Expression, tuple[ast.Statement, ...]]],
    otherwise: tuple[ast.Statement, ...],
) -> None:
    if not branches:
        _statements(frame, otherwise)
        return
    (condition, body), rest = branches[0], branches[1:]
    test = as_boolean(frame.translator.value(condition, frame.current()), condition.span)
    known = test.value if test.is_const else None
    if known is not None:
        if known:
            _statements(frame, body)
        else:
            _if(frame, rest, otherwise)
        return
    before = dict(frame.variables)
    _branch(frame, body, condition.span)
    taken = frame.variables
    frame.variables = dict(before)
    try:
        _if(frame, rest, otherwise)
    except _Signal:
        raise _not_inlinable(frame, condition.span) from None
    frame.variables = _merged(test, taken, frame.variables, condition.span)


def _branch(frame: _Frame, body: Sequence[ast.Statement], span: Span) -> None:
    try:
        _statements(frame, body)
    except _Signal:
        raise _not_inlinable(frame, span) from None


def _not_inlinable(frame: _Frame, span: Span) -> AcausalError:
    return fail(
        UnsupportedProblem,
        "unsupported.conditional-jump",
        f"`{frame.scope.path}` cannot be inlined: it returns or breaks under a condition that is not known at compile time",
        span,
        names=[frame.scope.path],
        hint="assign in both branches instead of returning from one",
    )


def _merged(
    test: Expr, taken: dict[str, AnyValue], other: dict[str, AnyValue], span: Span
) -> dict[str, AnyValue]:
    merged: dict[str, AnyValue] = {}
    for name in [*taken, *[n for n in other if n not in taken]]:
        a, b = taken.get(name), other.get(name)
        if a is None or b is None:
            continue
        merged[name] = a if a is b else _merge_value(test, a, b, span)
    return merged


def _merge_value(test: Expr, a: AnyValue, b: AnyValue, span: Span) -> AnyValue:
    if isinstance(a, RecordValue) and isinstance(b, RecordValue):
        fields = {name: _merge_value(test, a.fields[name], b.fields[name], span) for name in a.fields}
        return RecordValue(a.type_name, fields)
    if isinstance(a, RecordArray) or isinstance(b, RecordArray):
        raise type_error("type.record", "an array of records cannot be assigned under a condition", span)
    return choose(test, a, b, span)


def _for(frame: _Frame, statement: ast.ForStatement) -> None:
    first, rest = statement.iterators[0], statement.iterators[1:]
    inner: tuple[ast.Statement, ...] = statement.body
    if rest:
        inner = (ast.ForStatement(rest, statement.body, statement.comment, statement.span),)
    hidden = frame.variables.get(first.name)
    try:
        for value in frame.translator.iterator_values(first, frame.current()):
            frame.variables[first.name] = value
            _statements(frame, inner)
    except _Break:
        pass
    if hidden is None:
        frame.variables.pop(first.name, None)
    else:
        frame.variables[first.name] = hidden


def _while(frame: _Frame, statement: ast.WhileStatement) -> None:
    try:
        while True:
            frame.iterations += 1
            if frame.iterations > MAX_ITERATIONS:
                raise _too_long(frame, statement.span)
            test = as_boolean(frame.translator.value(statement.condition, frame.current()), statement.span)
            if not test.is_const:
                raise _not_inlinable(frame, statement.condition.span)
            if not test.value:
                return
            _statements(frame, statement.body)
    except _Break:
        return


