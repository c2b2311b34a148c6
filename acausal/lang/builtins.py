"""Built-in functions and operators with function syntax, on values (Modelica 3.6, 3.7 and 10.3).

`BUILTINS` maps a name to a function of the translated arguments; those that need the unevaluated call
(`der`, `smooth`, `size`, reductions, ...) are handled by `translate`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from acausal.errors import Span
from acausal.lang.arithmetic import as_value, type_error
from acausal.lang.array_functions import ARRAY_FUNCTIONS, Builtin, common_type, numbers, only
from acausal.lang.flat import BOOLEAN, INTEGER, REAL, ScalarType
from acausal.lang.values import (
    AnyValue,
    Value,
    describe,
    elementwise,
    scalar,
    zip_with,
)
from acausal.symbolic.expressions import expr as ex

LARGEST = 1.7976931348623157e308
LARGEST_INTEGER = 2_147_483_647

_MATH = (
    "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "log10", "sqrt",
)  # fmt: skip


def _math(name: str) -> Builtin:
    def apply(args: Sequence[AnyValue], span: Span) -> Value:
        (a,) = numbers(args, span, name, 1)
        check_domain(name, a, span)
        return elementwise(lambda item: ex.function(name, item), a, REAL)

    return apply


_DOMAINS: dict[str, tuple[Callable[[float], bool], str]] = {
    "asin": (lambda x: -1 <= x <= 1, "from -1 to 1"),
    "acos": (lambda x: -1 <= x <= 1, "from -1 to 1"),
    "log": (lambda x: x > 0, "above 0"),
    "log10": (lambda x: x > 0, "above 0"),
    "sqrt": (lambda x: x >= 0, "from 0 on"),
}


def check_domain(name: str, argument: Value, span: Span) -> None:
    """A number that is no argument of the function (3.7.3). Raises `call.domain`."""
    inside, range_ = _DOMAINS.get(name, (None, ""))
    for item in argument.items if inside is not None else ():
        if item.is_const and inside is not None and not inside(item.number):
            message = f"`{name}` takes numbers {range_}, not {item.number:g}"
            raise type_error("call.domain", message, span, "see Modelica 3.6, 3.7.3", (name,))


def _abs(args: Sequence[AnyValue], span: Span) -> Value:
    (a,) = numbers(args, span, "abs", 1)
    return elementwise(lambda item: ex.function("abs", item), a, a.type)


def _sign(args: Sequence[AnyValue], span: Span) -> Value:
    (a,) = numbers(args, span, "sign", 1)
    return elementwise(lambda item: ex.function("sign", item), a, INTEGER)


def _two(name: str, op: str, result: Callable[[Value, Value], ScalarType]) -> Builtin:
    def apply(args: Sequence[AnyValue], span: Span) -> Value:
        a, b = numbers(args, span, name, 2)
        value = zip_with(lambda x, y: ex.function(op, x, y), a, b, result(a, b))
        if value is None:
            raise type_error("type.array-size", f"`{name}` of {describe(a)} and {describe(b)}", span)
        return value

    return apply


def _real(_a: Value, _b: Value) -> ScalarType:
    return REAL


def _rounding(name: str, type_: ScalarType) -> Builtin:
    def apply(args: Sequence[AnyValue], span: Span) -> Value:
        (a,) = numbers(args, span, name, 1)
        return elementwise(lambda item: ex.function(name, item), a, type_)

    return apply


def _extreme(name: str) -> Builtin:
    """`min` and `max` of two values or of the elements of an array (10.3.4)."""
    two = _two(name, name, common_type)

    def apply(args: Sequence[AnyValue], span: Span) -> Value:
        if len(args) == 2:
            return two(args, span)
        if len(args) != 1:
            raise type_error("call.arguments", f"`{name}` takes 1 or 2 argument(s), not {len(args)}", span)
        a = as_value(args[0], span)
        if a.type == BOOLEAN:
            combine = ex.logical_and if name == "min" else ex.logical_or
            return scalar(BOOLEAN, combine(*a.items))
        (a,) = numbers(args, span, name, 1)
        if not a.items:
            limit = LARGEST if name == "min" else -LARGEST
            return scalar(
                a.type, ex.const(limit if a.type == REAL else int(LARGEST_INTEGER * limit / LARGEST))
            )
        result = a.items[0]
        for item in a.items[1:]:
            result = ex.function(name, result, item)
        return scalar(a.type, result)

    return apply


def _sum(args: Sequence[AnyValue], span: Span) -> Value:
    (a,) = numbers(args, span, "sum", 1)
    zero = ex.const(0) if a.type == INTEGER else ex.ZERO
    return scalar(a.type, ex.add(*a.items) if a.items else zero)


def _product(args: Sequence[AnyValue], span: Span) -> Value:
    (a,) = numbers(args, span, "product", 1)
    one = ex.const(1) if a.type == INTEGER else ex.ONE
    return scalar(a.type, ex.mul(*a.items) if a.items else one)


def _to_integer(args: Sequence[AnyValue], span: Span) -> Value:
    a = only(args, span, "Integer")
    if not a.type.is_enumeration:
        raise type_error(
            "type.mismatch", f"`Integer` converts enumerations, not {describe(a)}", span, "use `integer`"
        )
    return elementwise(ex.ordinal, a, INTEGER)


def _ndims(args: Sequence[AnyValue], span: Span) -> Value:
    return scalar(INTEGER, ex.const(len(only(args, span, "ndims").shape)))


BUILTINS: dict[str, Builtin] = {
    **ARRAY_FUNCTIONS,
    **{name: _math(name) for name in _MATH},
    "abs": _abs,
    "sign": _sign,
    "atan2": _two("atan2", "atan2", _real),
    "div": _two("div", "idiv", common_type),
    "mod": _two("mod", "mod", common_type),
    "rem": _two("rem", "rem", common_type),
    "floor": _rounding("floor", REAL),
    "ceil": _rounding("ceil", REAL),
    "integer": _rounding("integer", INTEGER),
    "min": _extreme("min"),
    "max": _extreme("max"),
    "sum": _sum,
    "product": _product,
    "Integer": _to_integer,
    "ndims": _ndims,
}
NOT_YET = frozenset(
    {
        "spatialDistribution",
        "previous", "hold", "Clock", "subSample", "superSample", "shiftSample", "backSample", "noClock",
        "interval", "firstTick", "transition",
    }
)  # fmt: skip
"""Operators of Modelica 3.6 that this version refuses by name."""
