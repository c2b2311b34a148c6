"""User functions: inlined by running their algorithm on symbolic values (Modelica 3.6, chapter 12).

Every call is replaced by the expressions its outputs come to. Loops run over ranges known at compile time,
an `if` whose condition is known takes one branch, any other merges the values that its branches assign.
What cannot be inlined is refused by name.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import prod

from acausal.errors import AcausalError, UnsupportedProblem
from acausal.lang import ast
from acausal.lang.access import is_partial
from acausal.lang.arithmetic import type_error
from acausal.lang.builtins import BUILTINS
from acausal.lang.class_table import ComponentEntry
from acausal.lang.external_calls import call_external
from acausal.lang.flat import REAL
from acausal.lang.function_derivatives import is_constant, with_derivative
from acausal.lang.function_frame import (
    Frame,
    declaration_order,
    declare,
    declared_rank,
    default_of,
    has_value,
    new_frame,
)
from acausal.lang.function_kernels import at_events
from acausal.lang.function_units import note_unit
from acausal.lang.function_values import function_value, is_function_type
from acausal.lang.instance import Instance
from acausal.lang.partial_derivatives import differentiated
from acausal.lang.scope import Scope
from acausal.lang.statements import run_algorithm
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue, RecordArray, RecordValue, Value, stack
from acausal.lang.whole_calls import called_as_whole

_Arguments = dict[str, AnyValue]


def call_function(
    translation: Translation, scope: Scope, node: ast.Call, env: Env, owner: Instance | None = None
) -> list[AnyValue]:
    """The outputs of a call, in order; `owner` is the component that the function was reached through.

    Raises `TypeProblem`, `UnsupportedProblem`.
    """
    if scope.kind != "function" and not any(base.scope.kind == "function" for base in scope.table.bases):
        message = f"`{scope.path}` is a {scope.kind}, not a function"
        raise type_error("call.not-a-function", message, node.span, "", (scope.path,))
    if is_partial(scope):
        message = f"`{scope.path}` is a partial function and cannot be called"
        raise type_error("type.partial", message, node.span, "call one that extends it", (scope.path,))
    translation.instances.check_redeclared(scope)
    inputs = [e for e in scope.table.components.values() if e.clause.causality == "input" and not e.protected]
    given = _bind_arguments(translation, scope, inputs, node, env)
    external = scope.table.external
    if external is not None and external.language == "builtin" and external.name in BUILTINS:
        missing = [e for e in inputs if e.name not in given]
        if missing:
            raise _no_argument(scope, missing[0], node)
        return [BUILTINS[external.name]([given[e.name] for e in inputs], node.span)]
    if owner is not None:
        env = env.owned_by(owner)
    results = _broadcast(translation, scope, inputs, given, node, env)
    if results is None:
        results = _inlined(translation, scope, given, node, env)
    return with_derivative(translation, scope, given, results, node, env)


def _bind_arguments(
    translation: Translation, scope: Scope, inputs: Sequence[ComponentEntry], node: ast.Call, env: Env
) -> _Arguments:
    given: _Arguments = {}
    listed = f"its inputs: {', '.join(e.name for e in inputs)}"
    if len(node.arguments) > len(inputs):
        message = f"`{scope.path}` takes {len(inputs)} argument(s), not {len(node.arguments)}"
        raise type_error("call.arguments", message, node.span, listed, (scope.path,))
    for entry, argument in zip(inputs, node.arguments, strict=False):
        given[entry.name] = _argument(translation, entry, argument, env)
    by_name = {e.name: e for e in inputs}
    for named in node.named:
        if named.name not in by_name or named.name in given:
            what = "is given twice in the call" if named.name in given else "is not an input"
            message = f"`{named.name}` {what} of `{scope.path}`"
            raise type_error("call.arguments", message, named.span, listed, (named.name,))
        given[named.name] = _argument(translation, by_name[named.name], named.value, env)
    return given


def _argument(translation: Translation, entry: ComponentEntry, node: ast.Expression, env: Env) -> AnyValue:
    if isinstance(node, (ast.ComponentReference, ast.PartialFunction)) and is_function_type(entry):
        return function_value(translation, entry, node, env)
    return translation.value(node, env)


def _no_argument(scope: Scope, entry: ComponentEntry, node: ast.Call) -> AcausalError:
    message = f"`{scope.path}` needs a value for `{entry.name}`"
    return type_error("call.arguments", message, node.span, "give it as an argument", (entry.name,))


def construct_record(translation: Translation, scope: Scope, node: ast.Call, env: Env) -> RecordValue:
    """`Record(a, b, c = 1)`: positional and named fields, defaults for the rest (12.6)."""
    if scope.definition.class_prefixes.partial:
        message = f"`{scope.path}` is a partial record and cannot be constructed"
        raise type_error("type.partial", message, node.span, "", (scope.path,))
    entries = [e for e in scope.table.components.values() if not e.protected]
    open_entries = [e for e in entries if not _is_settled(e)]
    given = _bind_arguments(translation, scope, open_entries, node, env)
    frame = new_frame(translation, scope, env)
    for entry in declaration_order(entries):
        value = given.get(entry.name)
        if value is None and default_of(entry) is None and entry in open_entries:
            raise _no_argument(scope, entry, node)
        frame.variables[entry.name] = declare(frame, entry, value, node.span)
    return RecordValue(scope.path, {entry.name: frame.variables[entry.name] for entry in entries}, scope)


def _is_settled(entry: ComponentEntry) -> bool:
    """A constant or final field with a value is no argument of the record's constructor (12.6)."""
    fixed = entry.clause.variability == "constant" or entry.clause.prefixes.final
    return fixed and default_of(entry) is not None


# --------------------------------------------------------------------------- one call


def _inlined(
    translation: Translation, scope: Scope, given: _Arguments, node: ast.Call, env: Env
) -> list[AnyValue]:
    """The results as expressions; where a loop depends on run-time values, as kernels evaluated at events."""
    checks = len(translation.assertions)

    def run(arguments: _Arguments) -> list[AnyValue]:
        return _run(translation, scope, arguments, node, env)

    try:
        whole = called_as_whole(translation, scope, given, env, run) if env.at_event else None
        return run(given) if whole is None else whole
    except UnsupportedProblem as problem:
        if "unsupported.run-time-loop" not in problem.codes or not (
            env.at_event or is_constant(translation, given)
        ):
            raise
        del translation.assertions[checks:]
        frame = new_frame(translation, scope, env)
        entries = list(scope.table.components.values())
        for entry in declaration_order(entries):
            frame.variables[entry.name] = declare(frame, entry, given.get(entry.name), node.span)
        outputs = [e.name for e in entries if e.clause.causality == "output" and not e.protected]
        sized = [(name, frame.variables[name]) for name in outputs]
        results = at_events(translation, scope, given, sized, node)
        if results is None:
            raise
        return results


def _run(
    translation: Translation, scope: Scope, given: _Arguments, node: ast.Call, env: Env
) -> list[AnyValue]:
    if isinstance(scope.definition, ast.DerClass):

        def run(base: Scope, inputs: _Arguments) -> list[AnyValue]:
            return _run(translation, base, inputs, node, env)

        return differentiated(scope, scope.definition, given, node.span, run)
    frame = new_frame(translation, scope, env)
    translation.count_step(scope.path, node.span, call=True)
    entries = list(scope.table.components.values())
    if scope.table.declaration_order is None:
        scope.table.declaration_order = declaration_order(entries)
    for entry in scope.table.declaration_order:
        value = given.get(entry.name)
        is_input = entry.clause.causality == "input"
        if value is None and is_input and default_of(entry) is None:
            raise _no_argument(scope, entry, node)
        frame.variables[entry.name] = declare(frame, entry, value, node.span)
        if value is not None or has_value(entry):
            frame.assigned.add(entry.name)
    written = [(s, where) for s, where in scope.table.sections if isinstance(s, ast.AlgorithmSection)]
    sections = [section for section, _ in written]
    if scope.table.external is not None:
        call_external(frame, scope.table.external, node)
    outputs = [e for e in entries if e.clause.causality == "output" and not e.protected]
    if not sections and any(e.name not in frame.assigned for e in outputs):
        message = f"`{scope.path}` has no algorithm"
        raise type_error("function.no-body", message, node.span, "", (scope.path,))
    frame.body = written[-1][1] if written else None
    run_algorithm(frame, sections)
    for entry in outputs:
        if entry.name not in frame.assigned and not _is_empty(frame, entry):
            message = f"the output `{entry.name}` of `{scope.path}` is never assigned"
            raise type_error("function.unassigned", message, entry.declaration.span, "", (entry.name,))
        note_unit(translation, entry, frame.variables[entry.name])
    return [frame.variables[entry.name] for entry in outputs]


def _is_empty(frame: Frame, entry: ComponentEntry) -> bool:
    value = frame.variables[entry.name]
    return not isinstance(value, RecordValue) and prod(value.shape) == 0


def _broadcast(
    translation: Translation,
    scope: Scope,
    inputs: Sequence[ComponentEntry],
    given: _Arguments,
    node: ast.Call,
    env: Env,
) -> list[AnyValue] | None:
    """A function called with arrays of what it takes works element by element (12.4.6)."""
    extra: tuple[int, ...] = ()
    spread: dict[str, Value | RecordArray] = {}
    for entry in inputs:
        value = given.get(entry.name)
        if value is None or isinstance(value, RecordValue):
            continue
        more = value.shape[: len(value.shape) - declared_rank(translation, entry)]
        if more and extra and more != extra:
            message = f"arguments of `{scope.path}` have different sizes"
            raise type_error("type.array-size", message, node.span, "", (entry.name,))
        if more and len(value.shape) > declared_rank(translation, entry):
            extra, spread[entry.name] = more, value
    if not extra:
        return None
    outputs = [e for e in scope.table.components.values() if e.clause.causality == "output"]
    if len(outputs) > 1 or declared_rank(translation, outputs[0]):
        message = f"`{scope.path}` is called with arrays of what it takes, but it has no single scalar result"
        hint = "only functions with one scalar result work element by element (Modelica 3.6, 12.4.6)"
        raise type_error("call.element-wise", message, node.span, hint, (scope.path,))
    columns: list[list[AnyValue]] = []
    for k in range(prod(extra)):
        picked = dict(given)
        for name, value in spread.items():
            picked[name] = _block(value, value.shape[len(extra) :], k)
        columns.append(_run(translation, scope, picked, node, env))
    return _joined(columns, extra, node)


def _joined(columns: list[list[AnyValue]], extra: tuple[int, ...], node: ast.Call) -> list[AnyValue]:
    results: list[AnyValue] = []
    for position in range(len(columns[0]) if columns else 0):
        joined = stack([column[position] for column in columns], extra)
        if joined is None:
            message = f"the results of `{node.function.text}` have different sizes"
            raise type_error("type.array-size", message, node.span, "", (node.function.text,))
        results.append(joined)
    return results or [Value(REAL, extra, ())]


def _block(value: Value | RecordArray, shape: tuple[int, ...], number: int) -> AnyValue:
    """Block `number` of the elements, as long as `shape` says."""
    size = prod(shape)
    start = number * size
    if isinstance(value, Value):
        return Value(value.type, shape, value.items[start : start + size])
    part = value.items[start : start + size]
    return RecordArray(shape, part, value.scope) if shape else part[0]
