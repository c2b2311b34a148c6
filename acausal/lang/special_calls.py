"""Operators with function syntax that need the call as written, not only the values of its arguments."""

from __future__ import annotations

from collections.abc import Callable

from acausal.errors import AcausalError
from acausal.lang import ast
from acausal.lang.arithmetic import as_value, type_error
from acausal.lang.builtins import BUILTINS
from acausal.lang.event_calls import EVENT_CALLS
from acausal.lang.flat import INTEGER, REAL
from acausal.lang.record_arrays import rearranged
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue, Value, describe, literal, shape_of, zip_with
from acausal.symbolic.expressions import expr as ex

SpecialCall = Callable[[Translation, ast.Call, Env], AnyValue]


def _arguments(node: ast.Call, name: str, count: int) -> tuple[ast.Expression, ...]:
    if len(node.arguments) != count or node.named:
        raise type_error("call.arguments", f"`{name}` takes {count} argument(s)", node.span, "", (name,))
    return node.arguments


def _der(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    (argument,) = _arguments(node, "der", 1)
    value = as_value(translation.value(argument, env.without_current()), node.span)
    if value.type != REAL:
        message = f"`der` needs a Real, not {describe(value)}"
        raise type_error("type.der", message, node.span, "", ex.symbols(value.items))
    return Value(REAL, value.shape, tuple([ex.der(item) for item in value.items]))


def _no_event(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    (argument,) = _arguments(node, "noEvent", 1)
    value = as_value(translation.value(argument, env), node.span)
    return Value(value.type, value.shape, tuple([ex.no_event(item) for item in value.items]))


def _smooth(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    order_node, argument = _arguments(node, "smooth", 2)
    order = translation.evaluate_in(order_node, env, "the order of smooth")
    if not isinstance(order, int) or isinstance(order, bool) or order < 0:
        raise type_error("call.smooth", "the order of `smooth` is an Integer from 0", order_node.span)
    value = as_value(translation.value(argument, env), node.span)
    return Value(value.type, value.shape, tuple([ex.smooth(order, item) for item in value.items]))


def _homotopy(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    """`homotopy(actual, simplified)`, element by element for arrays (3.7.4.4)."""
    named = {argument.name: argument.value for argument in node.named}
    given = dict(zip(("actual", "simplified"), node.arguments, strict=False)) | named
    if set(given) != {"actual", "simplified"} or len(node.arguments) > 2:
        message = "`homotopy` takes `actual` and `simplified`"
        raise type_error("call.arguments", message, node.span, "", ("homotopy",))
    actual, simplified = (
        as_value(translation.value(given[n], env), node.span) for n in ("actual", "simplified")
    )
    if not (actual.type.is_numeric and simplified.type.is_numeric):
        message = f"`homotopy` needs Reals, not {describe(actual)} and {describe(simplified)}"
        raise type_error("type.homotopy", message, node.span, "", ex.symbols(actual.items))
    joined = zip_with(ex.homotopy, actual, simplified, REAL) if actual.shape == simplified.shape else None
    if joined is None:
        message = (
            f"`homotopy` needs two values of one size, not {describe(actual)} and {describe(simplified)}"
        )
        raise type_error("type.array-size", message, node.span, "", ex.symbols(actual.items))
    return joined


def _size(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    if not 1 <= len(node.arguments) <= 2 or node.named:
        message = "`size` takes an array and, optionally, a dimension"
        raise type_error("call.arguments", message, node.span, "", ("size",))
    dimension: object = None
    if len(node.arguments) == 2:
        dimension = translation.evaluate_in(node.arguments[1], env, "a dimension")
        so_far = _size_so_far(translation, node.arguments[0], dimension, env)
        if so_far is not None:
            return literal(so_far)
    shape = list(shape_of(translation.value(node.arguments[0], env)))
    if dimension is None:
        return Value(INTEGER, (len(shape),), tuple([ex.const(n) for n in shape]))
    if not isinstance(dimension, int) or not 1 <= dimension <= len(shape):
        message = f"there is no dimension {dimension} in an array of {len(shape)} dimensions"
        raise type_error("type.array-size", message, node.span)
    return literal(shape[dimension - 1])


def _size_so_far(
    translation: Translation, argument: ast.Expression, dimension: object, env: Env
) -> int | None:
    """The size of an array that is being declared: `Real A[:, size(A, 1)]`."""
    instance = env.context.instance
    if instance is None or not isinstance(argument, ast.ComponentReference) or not isinstance(dimension, int):
        return None
    if len(argument.parts) != 1 or argument.parts[0].subscripts is not None or argument.global_:
        return None
    return translation.instances.size_so_far(instance, argument.parts[0].name, dimension)


def _pure(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    (argument,) = _arguments(node, "pure", 1)
    return translation.value(argument, env)


def _sized(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    """`zeros`, `ones`, `fill`, `identity`, `linspace`: sizes may be parameters, which become structural."""
    name = node.function.text.removeprefix(".")
    first = {"fill": 1, "linspace": 2}.get(name, 0)
    exactly = {"identity": 1, "linspace": 3}.get(name)
    if node.named or len(node.arguments) <= first or exactly not in (None, len(node.arguments)):
        raise _wrong_count(node, name)
    values: list[AnyValue] = [translation.value(arg, env) for arg in node.arguments[:first]]
    for arg in node.arguments[first:]:
        size = translation.evaluate_in(arg, env, f"a size in `{name}`")
        values.append(literal(size) if isinstance(size, (int, float)) else literal(-1))
    if any(not isinstance(value, Value) for value in values):
        return rearranged(name, values, node.span)
    return BUILTINS[name](values, node.span)


def _wrong_count(node: ast.Call, name: str) -> AcausalError:
    message = f"`{name}` cannot take {len(node.arguments)} argument(s)"
    return type_error("call.arguments", message, node.span, "", (name,))


def _cat(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    """`cat(k, A, B, ...)`."""
    if node.named or len(node.arguments) < 2:
        raise _wrong_count(node, "cat")
    along = translation.evaluate_in(node.arguments[0], env, "the dimension of `cat`")
    values = [translation.value(arg, env) for arg in node.arguments[1:]]
    number = literal(along) if isinstance(along, int) else literal(-1)
    if any(not isinstance(value, Value) for value in values):
        return rearranged("cat", [number, *values], node.span)
    return BUILTINS["cat"]([number, *values], node.span)


def _instance_name(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    """The simple name of the model, then the path of the component whose text has the call (3.7.4.4)."""
    _arguments(node, "getInstanceName", 0)
    instance = env.context.instance
    if instance is None:
        message = "`getInstanceName` names a component, so it cannot stand in a function or a constant"
        raise type_error("call.instance-name", message, node.span, "", ("getInstanceName",))
    root = instance
    while root.parent is not None:
        root = root.parent
    name = root.scope.path.rpartition(".")[2]
    return literal(f"{name}.{instance.path}" if instance.path else name)


SPECIAL: dict[str, SpecialCall] = {
    **EVENT_CALLS,
    "der": _der,
    "noEvent": _no_event,
    "smooth": _smooth,
    "homotopy": _homotopy,
    "size": _size,
    "pure": _pure,
    "zeros": _sized,
    "ones": _sized,
    "fill": _sized,
    "identity": _sized,
    "linspace": _sized,
    "cat": _cat,
    "getInstanceName": _instance_name,
}
