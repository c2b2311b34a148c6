"""External functions: those of the table by name, and nothing else (Modelica 3.6, 12.9).

With arguments known at compile time a function is evaluated at once; strings, files and matrices are of that
kind, and the parameters they depend on become structural. With others it becomes a kernel that is evaluated
at events. Tables are kernels of their own. A function that is not in the table is refused, never called.
"""

from __future__ import annotations

from collections.abc import Sequence

from acausal.errors import AcausalError, Diagnostic, Span, UnsupportedProblem, fail
from acausal.externals.arguments import Argument, Routine, RoutineFailed, Tensor
from acausal.externals.files import file_routines
from acausal.externals.routines import IMPURE_RANDOM, find_routine, routine_call
from acausal.lang import ast
from acausal.lang.arithmetic import as_scalar, as_value, type_error
from acausal.lang.external_objects import APPLICATIONS, CONSTRUCTORS, Application, object_of
from acausal.lang.flat import BOOLEAN, INTEGER, REAL, Assertion, ScalarType
from acausal.lang.function_frame import Frame
from acausal.lang.function_kernels import parts_of
from acausal.lang.scope import Scope
from acausal.lang.translation import Translation
from acausal.lang.values import AnyValue, Value, describe, literal, real, scalar
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Constant, EnumValue, Expr

_TABLES = "ModelicaStandardTables_"
_MESSAGES = {"ModelicaError": "error", "ModelicaWarning": "warning"}
_WRITE = "ModelicaIO_writeRealMatrix"
_LANGUAGES = (None, "C", "FORTRAN 77")
_WHAT = "an argument of an external function"


def call_external(frame: Frame, external: ast.External, node: ast.Call) -> None:
    """Run the external function whose inputs `frame` holds; its outputs are there afterwards."""
    name = external.name or frame.scope.definition.name
    arguments = _arguments(frame, external)
    written = _written(frame, arguments)
    values = [frame.translation.value(argument, frame.env()) for argument in arguments]
    try:
        results = _results(frame, name, values, written, external, node)
    except RoutineFailed as problem:
        message = f"`{frame.scope.path}` fails: {problem}"
        raise type_error("external.failed", message, node.span, "", (frame.scope.path,)) from None
    for position, target in written.items():
        if position in results:
            _store(frame, target, results[position], node)


def _arguments(frame: Frame, external: ast.External) -> Sequence[ast.Expression]:
    """As written; without a written call the inputs, in order (12.9.3)."""
    if external.name is not None:
        return external.arguments
    return [
        ast.ComponentReference((ast.NamePart(entry.name, None, external.span),), False, external.span)
        for entry in frame.entries.values()
        if not entry.protected and entry.clause.causality == "input"
    ]


def _written(frame: Frame, arguments: Sequence[ast.Expression]) -> dict[int, str]:
    """The variables that the function may write, by their position among its arguments; its result at -1."""
    external = frame.scope.table.external
    outputs = [n for n, e in frame.entries.items() if e.clause.causality == "output" and not e.protected]
    found: dict[int, str] = {}
    if external is not None and external.result is not None:
        found[-1] = _result_name(frame, external.result, outputs)
    elif external is not None and external.name is None and outputs:
        found[-1] = outputs[0]
    for position, argument in enumerate(arguments):
        if isinstance(argument, ast.ComponentReference) and len(argument.parts) == 1:
            entry = frame.entries.get(argument.text)
            if entry is not None and entry.clause.causality != "input":
                found[position] = argument.text
    return found


def _result_name(frame: Frame, result: ast.ComponentReference, outputs: Sequence[str]) -> str:
    """What stands left of `=` in an external call: an output (12.9.3)."""
    if result.text in outputs:
        return result.text
    message = f"`{result.text}` is no output of `{frame.scope.path}`: the external call cannot set it"
    raise type_error("external.result", message, result.span, "", (frame.scope.path, result.text))


def _results(
    frame: Frame,
    name: str,
    values: list[AnyValue],
    written: dict[int, str],
    external: ast.External,
    node: ast.Call,
) -> dict[int, AnyValue]:
    translation = frame.translation
    if name in _MESSAGES:
        _say(frame, _MESSAGES[name], values, node)
        return {}
    if name == _WRITE:
        _note_unwritten(frame, node)
        return {-1: literal(False)}
    if name.startswith(_TABLES) and values:
        applied = APPLICATIONS.get(name.removeprefix(_TABLES))
        if applied is not None:
            found = object_of(translation, values[0], node.span)
            return dict.fromkeys(written, applied(Application(translation, found, values[1:], node.span)))
        constructor = CONSTRUCTORS.get(name)
        if constructor is not None:
            made = constructor(_constants(translation, values, node.span), translation.externals.files)
            return {-1: scalar(REAL, ex.call(made))}
    files = file_routines(translation.externals.files).get(name)
    routine = files or find_routine(name)
    if routine is None or external.language not in _LANGUAGES:
        raise _unknown(frame.scope, name, node.span)
    if name == IMPURE_RANDOM:
        site = literal(translation.externals.next_site())
        values = [values[0], site, real(ex.TIME)]
    elif files is not None:
        return _evaluated(routine, _constants(translation, values, node.span))
    known = None if name == IMPURE_RANDOM else _known(translation, values)
    return _deferred(frame, name, values, written) if known is None else _evaluated(routine, known)


def _say(frame: Frame, level: str, values: Sequence[AnyValue], node: ast.Call) -> None:
    """A call that must not be reached, or that warns, is an assertion that fails where it is reached."""
    text = as_scalar(values[0], node.span).item if values else ex.const(frame.scope.path)
    frame.translation.assertions.append(Assertion(ex.FALSE, text, level, node.span))


def _note_unwritten(frame: Frame, node: ast.Call) -> None:
    """A model may write no files: the function says that it failed, and a warning says so too."""
    message = f"`{frame.scope.path}` writes no file here: it returns false"
    warning = Diagnostic("external.not-written", message, node.span, (frame.scope.path,), severity="warning")
    if warning not in frame.translation.warnings:
        frame.translation.warnings.append(warning)


def _unknown(scope: Scope, name: str, span: Span) -> AcausalError:
    return fail(
        UnsupportedProblem,
        "unsupported.external-function",
        f"`{scope.path}` is the external function `{name}`, which is not built in",
        span,
        names=[scope.path],
        hint="external code is never called; what models need of the standard library's is built in",
    )


# ------------------------------------------------------------------------------ known when compiled


def _known(translation: Translation, values: Sequence[AnyValue]) -> list[Argument] | None:
    """The arguments as constants; None when one varies while the simulation runs."""
    found: list[Argument] = []
    for value in values:
        if not isinstance(value, Value):
            return None
        items: list[Constant] = []
        for item in value.items:
            constant = translation.known(item)
            if constant is None:
                return None
            items.append(constant)
        found.append(Tensor(value.shape, tuple(items)) if value.shape else items[0])
    return found


def _constants(translation: Translation, values: Sequence[AnyValue], span: Span) -> list[Argument]:
    """The arguments as constants. Raises `TypeProblem` `structural.not-constant`."""
    found: list[Argument] = []
    for value in values:
        plain = as_value(value, span)
        items = [translation.evaluate_expr(item, span, _WHAT) for item in plain.items]
        found.append(Tensor(plain.shape, tuple(items)) if plain.shape else items[0])
    return found


def _evaluated(routine: Routine, args: list[Argument]) -> dict[int, AnyValue]:
    try:
        changed = routine(args)
    except (ValueError, ArithmeticError) as problem:
        raise RoutineFailed(str(problem)) from None
    return {position: _value(result) for position, result in changed.items()}


def _value(result: Argument) -> Value:
    if not isinstance(result, Tensor):
        return scalar(REAL, ex.const(result))
    return Value(REAL, result.shape, tuple([ex.const(item) for item in result.items]))


# ------------------------------------------------------------------------------ evaluated at events


def _deferred(
    frame: Frame, name: str, values: Sequence[AnyValue], written: dict[int, str]
) -> dict[int, AnyValue]:
    """Kernels for the elements of everything that the function writes."""
    plain = [as_value(value, frame.scope.span) for value in values]
    shapes = [value.shape or None for value in plain]
    items_in = [item for value in plain for item in value.items]
    template = tuple([item.value if item.is_const else None for item in items_in])
    args = tuple([item for item in items_in if not item.is_const])
    # work arrays are left out: nothing comes after the call that could read them
    outputs = {k: t for k, t in written.items() if frame.entries[t].clause.causality == "output"}
    old = {k: as_value(frame.variables[t], frame.scope.span) for k, t in outputs.items()}
    whole = routine_call(name, shapes, template, [(k, len(value.items)) for k, value in old.items()])
    results = parts_of(whole, args, frame.scope, {target: old[k] for k, target in outputs.items()})
    return dict(zip(outputs, results, strict=True))


# ------------------------------------------------------------------------------ results


def _store(frame: Frame, target: str, new: AnyValue, node: ast.Call) -> None:
    """Give an output its value, of the type and size that it is declared with."""
    old = as_value(frame.variables[target], node.span)
    value = as_value(new, node.span)
    if value.shape != old.shape:
        message = f"`{target}` of `{frame.scope.path}` is {describe(old)}, but it gets {describe(value)}"
        raise type_error("type.array-size", message, node.span, "", (target,))
    items = tuple([_of_type(item, old.type) for item in value.items])
    frame.variables[target] = Value(old.type, old.shape, items)
    frame.assigned.add(target)


def _of_type(item: Expr, type_: ScalarType) -> Expr:
    """A constant as a literal of the declared type: C knows numbers only."""
    value = item.value
    if not item.is_const or not isinstance(value, (int, float)):
        return item
    if type_.is_enumeration and 1 <= value <= len(type_.literals):
        return ex.const(EnumValue(type_.name, type_.literals[int(value) - 1], int(value)))
    convert = {INTEGER: int, BOOLEAN: bool, REAL: float}.get(type_)
    return item if convert is None else ex.const(convert(value))
