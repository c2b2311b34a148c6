"""Operators of events with function syntax (Modelica 3.6, 3.7.3 to 3.7.5): `pre`, `sample`, `delay`, ..."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import prod

from acausal.errors import Span, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.arithmetic import as_scalar, as_value, type_error
from acausal.lang.flat import BOOLEAN, REAL, Variability
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue, Value, describe, elementwise, scalar
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr


def check_arguments(node: ast.Call, name: str, *counts: int) -> tuple[ast.Expression, ...]:
    """The positional arguments of an operator that has no named ones."""
    if len(node.arguments) not in counts or node.named:
        listed = " or ".join(map(str, counts))
        raise type_error("call.arguments", f"`{name}` takes {listed} argument(s)", node.span, "", (name,))
    return node.arguments


# --------------------------------------------------------------------------- left limits


def _pre(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    value, limits = _limits(translation, node, "pre", env)
    return Value(value.type, value.shape, limits)


def _edge(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    value, limits = _limits(translation, node, "edge", env)
    if value.type != BOOLEAN:
        message = f"`edge` needs a Boolean, not {describe(value)}"
        raise type_error("type.not-boolean", message, node.span, "use `change`", ex.symbols(value.items))
    return _paired(value, limits, lambda b, before: ex.logical_and(b, ex.logical_not(before)))


def _change(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    value, limits = _limits(translation, node, "change", env)
    return _paired(value, limits, lambda v, before: ex.relation("ne", v, before))


def _paired(value: Value, limits: Sequence[Expr], combine: Callable[[Expr, Expr], Expr]) -> Value:
    items = tuple([combine(item, limit) for item, limit in zip(value.items, limits, strict=True)])
    return Value(BOOLEAN, value.shape, items)


def _limits(translation: Translation, node: ast.Call, name: str, env: Env) -> tuple[Value, tuple[Expr, ...]]:
    """The value of the one argument, a variable, and its left limits."""
    (argument,) = check_arguments(node, name, 1)
    if not isinstance(argument, ast.ComponentReference):
        raise type_error("type.pre", f"`{name}` needs a variable, not an expression", argument.span)
    before = as_value(translation.value(argument, env.without_current()), argument.span)
    now = as_value(translation.value(argument, env), argument.span) if env.current else before
    return now, tuple([_limit(translation, item, env, argument.span) for item in before.items])


def _limit(translation: Translation, item: Expr, env: Env, span: Span) -> Expr:
    """`pre(item)`; what never changes is its own left limit."""
    if item.is_const:
        return item  # an iterator or a constant of a package
    if item.op != "sym":
        message = "a subscript under `pre` must be known at compile time"
        raise type_error("type.pre", message, span, "", ex.symbols([item]))
    leaf = translation.leaf(item.name)
    if leaf is None:  # time
        if not env.at_event:
            message = f"pre needs a discrete variable, but `{item.name}` is continuous"
            raise type_error("type.pre", message, span, "it can be used in when-clauses", (item.name,))
        return item
    variability = leaf.prefixes.variability
    if variability <= Variability.PARAMETER:
        return item
    if leaf.type == REAL and not env.at_event:
        translation.left_limits.setdefault(leaf.path, span)
    return ex.pre(item)


# --------------------------------------------------------------------------- events


def _initial(_translation: Translation, node: ast.Call, _env: Env) -> AnyValue:
    check_arguments(node, "initial", 0)
    return scalar(BOOLEAN, ex.initial())


def _terminal(_translation: Translation, node: ast.Call, _env: Env) -> AnyValue:
    check_arguments(node, "terminal", 0)
    return scalar(BOOLEAN, ex.terminal())


def _sample(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    """`sample(start, interval)`; with a clock, or without a second argument, it samples a signal (16.5.1)."""
    if len(node.arguments) != 2 or node.named:
        message = "`sample(...)` of synchronous clocks is not supported yet"
        raise fail(UnsupportedProblem, "unsupported.clock", message, node.span, names=["sample"])
    start, interval = (_time(translation, argument, "sample", env) for argument in node.arguments)
    for item, argument in ((start, node.arguments[0]), (interval, node.arguments[1])):
        _require_parameter(translation, item, "sample", argument.span)
    if interval.is_const and interval.number <= 0:
        message = "the interval of `sample` must be positive"
        raise type_error("call.sample", message, node.arguments[1].span)
    return scalar(BOOLEAN, ex.sample(start, interval))


def _delay(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    """`delay(expr, delayTime)`, `delay(expr, delayTime, delayMax)`."""
    arguments = check_arguments(node, "delay", 2, 3)
    value = as_value(translation.value(arguments[0], env), arguments[0].span)
    if not value.type.is_numeric:
        message = f"`delay` needs a Real, not {describe(value)}"
        raise type_error("type.not-numeric", message, arguments[0].span)
    times = [_time(translation, argument, "delay", env) for argument in arguments[1:]]
    _require_parameter(translation, times[-1], "delay", arguments[-1].span)
    if any(item.is_const and item.number < 0 for item in times):
        raise type_error("call.delay", "the time of `delay` cannot be negative", node.span)
    if all(item.is_const for item in times) and times[0].number > times[-1].number:
        raise type_error("call.delay", "the time of `delay` is larger than its maximum", node.span)
    return elementwise(lambda item: ex.delay(item, *times), value, REAL)


def _time(translation: Translation, node: ast.Expression, name: str, env: Env) -> Expr:
    value = as_scalar(translation.value(node, env), node.span)
    if not value.type.is_numeric:
        message = f"`{name}` needs a time in seconds, not {describe(value)}"
        raise type_error("type.not-numeric", message, node.span)
    return value.item


def _require_parameter(translation: Translation, item: Expr, name: str, span: Span) -> None:
    for path in ex.symbols([item]):
        leaf = translation.leaf(path)
        if leaf is None or leaf.prefixes.variability > Variability.PARAMETER:
            message = f"this argument of `{name}` may use parameters and constants only, but `{path}` varies"
            raise type_error("call.variability", message, span, "", (path,))


def _semi_linear(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    """`semiLinear(x, positiveSlope, negativeSlope)` (3.7.4.4), element by element for arrays (12.4.6)."""
    arguments = check_arguments(node, "semiLinear", 3)
    values = [as_value(translation.value(argument, env), argument.span) for argument in arguments]
    for value, argument in zip(values, arguments, strict=True):
        if not value.type.is_numeric:
            message = f"`semiLinear` needs numbers, not {describe(value)}"
            raise type_error("type.not-numeric", message, argument.span)
    shapes = list(dict.fromkeys([value.shape for value in values if value.shape]))
    if len(shapes) > 1:
        sizes = ", ".join([describe(value) for value in values])
        raise type_error("type.array-size", f"`semiLinear` of arrays of different sizes: {sizes}", node.span)
    shape = shapes[0] if shapes else ()
    count = prod(shape)
    parts = [value.items if value.shape else value.items * count for value in values]
    return Value(REAL, shape, tuple([_of_two_slopes(*three) for three in zip(*parts, strict=True)]))


def _of_two_slopes(x: Expr, positive: Expr, negative: Expr) -> Expr:
    chosen = ex.if_then_else(ex.relation("ge", x, ex.ZERO), ex.mul(positive, x), ex.mul(negative, x))
    return ex.smooth(0, chosen)


def _no_value(_translation: Translation, node: ast.Call, _env: Env) -> AnyValue:
    """`assert`, `terminate` and `reinit` as expressions."""
    name = node.function.text
    message = f"`{name}` has no value: it stands alone, as an equation or statement"
    raise type_error("call.no-value", message, node.span, "", (name,))


EVENT_CALLS: dict[str, Callable[[Translation, ast.Call, Env], AnyValue]] = {
    "pre": _pre,
    "edge": _edge,
    "change": _change,
    "initial": _initial,
    "terminal": _terminal,
    "sample": _sample,
    "delay": _delay,
    "semiLinear": _semi_linear,
    **dict.fromkeys(("assert", "terminate", "reinit"), _no_value),
}
