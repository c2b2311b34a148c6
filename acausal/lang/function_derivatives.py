"""Derivatives that a function's author gives: the annotation `derivative` (Modelica 3.6, 12.7.1).

The results of a call carry the call of the derivative with them (`expr.derived`), for index reduction to take
instead of differentiating the inlined body. Without it, `smoothOrder` vouches for the body.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from acausal.errors import Diagnostic, UnsupportedProblem
from acausal.lang import ast
from acausal.lang.class_table import ComponentEntry
from acausal.lang.experiment import annotation_of
from acausal.lang.flat import REAL, Variability
from acausal.lang.function_values import inputs_of
from acausal.lang.scope import Scope
from acausal.lang.translation import Env, Translation
from acausal.lang.value_calls import reference
from acausal.lang.values import AnyValue, RecordArray, RecordValue, Value
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.expressions.operators import EVENT_FUNCTIONS, RELATIONS

_MOST_ORDERS = 3


@dataclass(frozen=True)
class Given:
    """One `derivative(order = n, zeroDerivative = a, noDerivative = b) = function`."""

    function: ast.ComponentReference
    order: int
    zero: tuple[str, ...]
    none: tuple[str, ...]


def with_derivative(
    translation: Translation,
    scope: Scope,
    given: Mapping[str, AnyValue],
    results: list[AnyValue],
    node: ast.Call,
    env: Env,
) -> list[AnyValue]:
    """The results of a call with what the author says about their derivatives."""
    annotation = annotation_of(scope)
    if annotation is None or scope.table.external is not None or is_constant(translation, given):
        return results
    for found in _derivatives(annotation):
        slopes = _slopes(translation, scope, found, given, node, env)
        if slopes is not None:
            return _joined(results, slopes)
    order = _smooth_order(annotation)
    if order >= 1 and not any(_raises_events(v) for v in given.values()):
        return [_smoothed(order, result) for result in results]
    return results


# ------------------------------------------------------------------------------ annotations


def _derivatives(annotation: ast.Annotation) -> list[Given]:
    found: list[Given] = []
    for argument in annotation.arguments:
        if not isinstance(argument, ast.ElementModification) or argument.name != ("derivative",):
            continue
        modification = argument.modification
        if modification is None or not isinstance(modification.value, ast.ComponentReference):
            continue
        options = [a for a in modification.arguments if isinstance(a, ast.ElementModification)]
        found.append(
            Given(
                modification.value,
                max([_integer(o) for o in options if o.name == ("order",)], default=1),
                tuple([_name(o) for o in options if o.name == ("zeroDerivative",)]),
                tuple([_name(o) for o in options if o.name == ("noDerivative",)]),
            )
        )
    return found


def _smooth_order(annotation: ast.Annotation) -> int:
    for argument in annotation.arguments:
        if isinstance(argument, ast.ElementModification) and argument.name == ("smoothOrder",):
            return _integer(argument)
    return 0


def _integer(argument: ast.ElementModification) -> int:
    value = None if argument.modification is None else argument.modification.value
    return value.value if isinstance(value, ast.IntegerLiteral) else 0


def _name(argument: ast.ElementModification) -> str:
    value = None if argument.modification is None else argument.modification.value
    return value.text if isinstance(value, ast.ComponentReference) else ""


# ------------------------------------------------------------------------------ the derivative's call


def _slopes(
    translation: Translation,
    scope: Scope,
    found: Given,
    given: Mapping[str, AnyValue],
    node: ast.Call,
    env: Env,
) -> list[AnyValue] | None:
    """The results of the derivative function; None where this annotation does not apply."""
    if any(name in given and _moves(translation, given[name]) for name in found.zero):
        return None
    if translation.externals.orders >= _MOST_ORDERS:
        return None
    function = scope.find_class(found.function, "function")
    inputs = inputs_of(scope)
    rates = [
        e for e in inputs if e.name not in (*found.zero, *found.none) and _is_real(translation, e, given)
    ]
    wanted = len(inputs_of(function)) - len(inputs)
    if found.order > 1:
        rates = rates[len(rates) - wanted :] if 0 < wanted <= len(rates) else rates
    if wanted != len(rates) or any(e.name not in given for e in inputs):
        if wanted != len(rates) and all(isinstance(value, Value) for value in given.values()):
            translation.warnings.append(_misfit(scope, function, len(rates), wanted, node))
        return None
    values = [given[e.name] for e in inputs] + [_rate(given[e.name]) for e in rates]
    translation.externals.orders += 1
    checks = len(translation.assertions)
    try:
        return _call(translation, function, values, node, env)
    except UnsupportedProblem:
        return None
    finally:
        translation.externals.orders -= 1
        del translation.assertions[checks:]


def _call(
    translation: Translation, function: Scope, values: Sequence[AnyValue], node: ast.Call, env: Env
) -> list[AnyValue]:
    """All results of a function of values, which get names that no Modelica text can have."""
    local = {f"#{i}": value for i, value in enumerate(values)}
    arguments = tuple([reference(name, node.span) for name in local])
    call = ast.Call(reference(function.path, node.span), arguments, (), (), node.span)
    return translation.call(function, call, Env(env.context, local, None, env.depth))


def _is_real(translation: Translation, entry: ComponentEntry, given: Mapping[str, AnyValue]) -> bool:
    value = given.get(entry.name)
    if isinstance(value, Value):
        simple = translation.instances.simple_type(entry.scope.find_class(entry.clause.type))
        return simple is not None and simple.scalar == REAL
    return False


def _rate(value: AnyValue) -> AnyValue:
    assert isinstance(value, Value)  # only Real inputs have rates
    return Value(REAL, value.shape, tuple([ex.ZERO if i.is_const else ex.rate(i) for i in value.items]))


def _misfit(scope: Scope, function: Scope, found: int, wanted: int, node: ast.Call) -> Diagnostic:
    message = (
        f"`{function.path}` is annotated as the derivative of `{scope.path}`, but takes {wanted} more "
        f"inputs instead of {found}; the body is differentiated instead"
    )
    return Diagnostic("function.derivative", message, node.span, (scope.path,), severity="warning")


def _joined(results: list[AnyValue], slopes: list[AnyValue]) -> list[AnyValue]:
    """The Real results with their derivatives, which are the results of the derivative function in order."""
    rest = iter(slopes)
    joined: list[AnyValue] = []
    for result in results:
        if not isinstance(result, Value) or result.type != REAL:
            joined.append(result)
            continue
        slope = next(rest, None)
        if isinstance(slope, Value) and slope.shape == result.shape:
            pairs = zip(result.items, slope.items, strict=True)
            result = Value(REAL, result.shape, tuple([ex.derived(a, b) for a, b in pairs]))  # noqa: PLW2901
        joined.append(result)
    return joined


def _smoothed(order: int, value: AnyValue) -> AnyValue:
    if not isinstance(value, Value) or value.type != REAL:
        return value
    items = tuple([ex.smooth(order, item) if _switches([item]) else item for item in value.items])
    return Value(REAL, value.shape, items)


# ------------------------------------------------------------------------------ what moves


def is_constant(translation: Translation, given: Mapping[str, AnyValue]) -> bool:
    """Whether no argument changes between events."""
    return not any(_moves(translation, value) for value in given.values())


def _moves(translation: Translation, value: AnyValue) -> bool:
    """Whether a value changes with time continuously."""
    if isinstance(value, RecordArray):
        return any(_moves(translation, item) for item in value.items)
    if isinstance(value, RecordValue):
        return any(_moves(translation, item) for item in value.fields.values())
    return any(_leaf_moves(translation, leaf) for item in value.items for leaf in ex.unknown_leaves(item))


def _leaf_moves(translation: Translation, leaf: Expr) -> bool:
    if leaf.op != "sym" or leaf is ex.TIME:
        return leaf.op != "pre"
    found = translation.leaf(leaf.name)
    return found is None or found.prefixes.variability is Variability.CONTINUOUS


def _items(value: AnyValue) -> Sequence[Expr]:
    return value.items if isinstance(value, Value) else ()


def _raises_events(value: AnyValue) -> bool:
    """Whether an argument holds what raises events, which `smooth` around the result would silence."""
    return any(n.op in RELATIONS or n.op in EVENT_FUNCTIONS for n in ex.postorder(_items(value)))


def _switches(roots: Sequence[Expr]) -> bool:
    return any(node.op == "if" for node in ex.postorder(roots))
