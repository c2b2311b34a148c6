"""Built-in functions and operators with function syntax, on values (Modelica 3.6, 3.7 and 10.3).

`BUILTINS` maps a name to a function of the translated arguments; those that need the unevaluated call
(`der`, `smooth`, `size`, reductions, ...) are handled by `translate`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import prod

from acausal.errors import Span
from acausal.lang.arithmetic import as_scalar, as_value, type_error
from acausal.lang.flat import BOOLEAN, INTEGER, REAL, ScalarType
from acausal.lang.values import (
    AnyValue,
    Value,
    all_indices,
    describe,
    elementwise,
    index_offset,
    scalar,
    unify,
    zip_with,
)
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr

Builtin = Callable[[Sequence[AnyValue], Span], Value]
LARGEST = 1.7976931348623157e308
MAX_ELEMENTS = 200_000
LARGEST_INTEGER = 2_147_483_647

_MATH = (
    "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "log10", "sqrt",
)  # fmt: skip


def _numeric(args: Sequence[AnyValue], span: Span, name: str, count: int) -> list[Value]:
    if len(args) != count:
        raise type_error("call.arguments", f"`{name}` takes {count} argument(s), not {len(args)}", span)
    values = [as_value(arg, span) for arg in args]
    for value in values:
        if not value.type.is_numeric:
            raise type_error("type.not-numeric", f"`{name}` needs numbers, not {describe(value)}", span)
    return values


def _one(args: Sequence[AnyValue], span: Span, name: str) -> Value:
    if len(args) != 1:
        raise type_error("call.arguments", f"`{name}` takes 1 argument, not {len(args)}", span)
    return as_value(args[0], span)


def _math(name: str) -> Builtin:
    def apply(args: Sequence[AnyValue], span: Span) -> Value:
        (a,) = _numeric(args, span, name, 1)
        return elementwise(lambda item: ex.function(name, item), a, REAL)

    return apply


def _abs(args: Sequence[AnyValue], span: Span) -> Value:
    (a,) = _numeric(args, span, "abs", 1)
    return elementwise(lambda item: ex.function("abs", item), a, a.type)


def _sign(args: Sequence[AnyValue], span: Span) -> Value:
    (a,) = _numeric(args, span, "sign", 1)
    return elementwise(lambda item: ex.function("sign", item), a, INTEGER)


def _two(name: str, op: str, result: Callable[[Value, Value], ScalarType]) -> Builtin:
    def apply(args: Sequence[AnyValue], span: Span) -> Value:
        a, b = _numeric(args, span, name, 2)
        value = zip_with(lambda x, y: ex.function(op, x, y), a, b, result(a, b))
        if value is None:
            raise type_error("type.array-size", f"`{name}` of {describe(a)} and {describe(b)}", span)
        return value

    return apply


def _common(a: Value, b: Value) -> ScalarType:
    return unify(a.type, b.type) or REAL


def _real(_a: Value, _b: Value) -> ScalarType:
    return REAL


def _rounding(name: str, type_: ScalarType) -> Builtin:
    def apply(args: Sequence[AnyValue], span: Span) -> Value:
        (a,) = _numeric(args, span, name, 1)
        return elementwise(lambda item: ex.function(name, item), a, type_)

    return apply


def _extreme(name: str) -> Builtin:
    """`min` and `max` of two values or of the elements of an array (10.3.4)."""
    two = _two(name, name, _common)

    def apply(args: Sequence[AnyValue], span: Span) -> Value:
        if len(args) == 2:
            return two(args, span)
        if len(args) != 1:
            raise type_error("call.arguments", f"`{name}` takes 1 or 2 argument(s), not {len(args)}", span)
        a = as_value(args[0], span)
        if a.type == BOOLEAN:
            combine = ex.logical_and if name == "min" else ex.logical_or
            return scalar(BOOLEAN, combine(*a.items))
        (a,) = _numeric(args, span, name, 1)
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
    (a,) = _numeric(args, span, "sum", 1)
    zero = ex.const(0) if a.type == INTEGER else ex.ZERO
    return scalar(a.type, ex.add(*a.items) if a.items else zero)


def _product(args: Sequence[AnyValue], span: Span) -> Value:
    (a,) = _numeric(args, span, "product", 1)
    one = ex.const(1) if a.type == INTEGER else ex.ONE
    return scalar(a.type, ex.mul(*a.items) if a.items else one)


def _integer_constant(arg: AnyValue, span: Span, name: str) -> int:
    item = as_scalar(arg, span).item
    if not isinstance(item.value, int) or isinstance(item.value, bool) or item.value < 0:
        raise type_error(
            "array.bad-size",
            f"`{name}` needs a size that is a constant Integer",
            span,
            "use a literal or a constant",
        )
    return item.value


def _filled(name: str, value: float | int) -> Builtin:
    def apply(args: Sequence[AnyValue], span: Span) -> Value:
        shape = _shape(args, span, name)
        return Value(INTEGER, shape, (ex.const(value),) * prod(shape))

    return apply


def _fill(args: Sequence[AnyValue], span: Span) -> Value:
    item = as_value(args[0], span)
    shape = _shape(args[1:], span, "fill", len(item.items))
    return Value(item.type, shape + item.shape, item.items * prod(shape))


def _shape(args: Sequence[AnyValue], span: Span, name: str, each: int = 1) -> tuple[int, ...]:
    shape = tuple([_integer_constant(arg, span, name) for arg in args])
    if prod(shape) * each > MAX_ELEMENTS:
        raise type_error("array.bad-size", f"`{name}` makes more than {MAX_ELEMENTS} elements", span)
    return shape


def _identity(args: Sequence[AnyValue], span: Span) -> Value:
    (size,) = _shape(args, span, "identity")
    return _diagonal([Value(INTEGER, (size,), (ex.const(1),) * size)], span)


def _diagonal(args: Sequence[AnyValue], span: Span) -> Value:
    (a,) = _numeric(args, span, "diagonal", 1)
    size = len(a.items)
    if len(a.shape) != 1 or size * size > MAX_ELEMENTS:
        raise type_error("type.array-size", f"`diagonal` of {describe(a)}", span)
    zero = ex.const(0) if a.type == INTEGER else ex.ZERO
    items = [a.items[i] if i == j else zero for i in range(size) for j in range(size)]
    return Value(a.type, (size, size), tuple(items))


def _linspace(args: Sequence[AnyValue], span: Span) -> Value:
    start, stop = as_scalar(args[0], span).item, as_scalar(args[1], span).item
    (count,) = _shape(args[2:], span, "linspace")
    if count < 2:
        raise type_error("array.bad-size", "`linspace` needs at least two points", span)
    step = ex.div(ex.sub(stop, start), ex.const(float(count - 1)))
    return Value(REAL, (count,), tuple([ex.add(start, ex.mul(ex.const(i), step)) for i in range(count)]))


def _transpose(args: Sequence[AnyValue], span: Span) -> Value:
    a = _one(args, span, "transpose")
    if len(a.shape) < 2:
        raise type_error("type.array-size", f"`transpose` needs a matrix, not {describe(a)}", span)
    shape = (a.shape[1], a.shape[0], *a.shape[2:])
    items = [a.items[index_offset(a.shape, (i[1], i[0], *i[2:]))] for i in all_indices(shape)]
    return Value(a.type, shape, tuple(items))


def _cross(args: Sequence[AnyValue], span: Span) -> Value:
    a, b = _numeric(args, span, "cross", 2)
    if a.shape != (3,) or b.shape != (3,):
        raise type_error("type.array-size", f"`cross` of {describe(a)} and {describe(b)}", span)
    x, y = a.items, b.items
    items = [ex.sub(ex.mul(x[i], y[j]), ex.mul(x[j], y[i])) for i, j in ((1, 2), (2, 0), (0, 1))]
    return Value(_common(a, b), (3,), tuple(items))


def _skew(args: Sequence[AnyValue], span: Span) -> Value:
    (a,) = _numeric(args, span, "skew", 1)
    if a.shape != (3,):
        raise type_error("type.array-size", f"`skew` of {describe(a)}", span)
    x, y, z = a.items
    zero = ex.ZERO
    return Value(a.type, (3, 3), (zero, ex.neg(z), y, z, zero, ex.neg(x), ex.neg(y), x, zero))


def _outer_product(args: Sequence[AnyValue], span: Span) -> Value:
    a, b = _numeric(args, span, "outerProduct", 2)
    items = [ex.mul(x, y) for x in a.items for y in b.items]
    return Value(_common(a, b), (len(a.items), len(b.items)), tuple(items))


def _symmetric(args: Sequence[AnyValue], span: Span) -> Value:
    a = _one(args, span, "symmetric")
    if len(a.shape) != 2 or a.shape[0] != a.shape[1]:
        raise type_error("type.array-size", f"`symmetric` needs a square matrix, not {describe(a)}", span)
    items = [a.items[index_offset(a.shape, (min(i, j), max(i, j)))] for i, j in all_indices(a.shape)]
    return Value(a.type, a.shape, tuple(items))


def _scalar(args: Sequence[AnyValue], span: Span) -> Value:
    a = _one(args, span, "scalar")
    if len(a.items) != 1:
        raise type_error("type.array-size", f"`scalar` of {describe(a)}", span)
    return scalar(a.type, a.items[0])


def _vector(args: Sequence[AnyValue], span: Span) -> Value:
    a = _one(args, span, "vector")
    if sum(size > 1 for size in a.shape) > 1:
        raise type_error("type.array-size", f"`vector` of {describe(a)}", span)
    return Value(a.type, (len(a.items),), a.items)


def _matrix(args: Sequence[AnyValue], span: Span) -> Value:
    a = _one(args, span, "matrix")
    shape = (*a.shape, 1, 1)[:2]
    if prod(shape) != len(a.items):
        raise type_error("type.array-size", f"`matrix` of {describe(a)}", span)
    return Value(a.type, shape, a.items)


def cat(dimension: int, values: Sequence[Value], span: Span) -> Value:
    """Concatenate along `dimension` (from 1)."""
    axis = dimension - 1
    if axis < 0:
        raise type_error("type.array-size", "`cat` joins along a dimension from 1", span)
    first = values[0]
    type_ = first.type
    for value in values:
        common = unify(type_, value.type)
        rest = [v for k, v in enumerate(value.shape) if k != axis]
        if (
            common is None
            or axis >= len(value.shape)
            or rest != [v for k, v in enumerate(first.shape) if k != axis]
        ):
            raise type_error("type.array-size", f"cannot join {describe(first)} and {describe(value)}", span)
        type_ = common
    blocks = [prod(value.shape[axis:]) for value in values]
    items: list[Expr] = []
    for outer in range(prod(first.shape[:axis])):
        for value, block in zip(values, blocks, strict=True):
            items.extend(value.items[outer * block : (outer + 1) * block])
    shape = (*first.shape[:axis], sum(v.shape[axis] for v in values), *first.shape[axis + 1 :])
    return Value(type_, shape, tuple(items))


def _cat(args: Sequence[AnyValue], span: Span) -> Value:
    return cat(_integer_constant(args[0], span, "cat"), [as_value(arg, span) for arg in args[1:]], span)


def _to_integer(args: Sequence[AnyValue], span: Span) -> Value:
    a = _one(args, span, "Integer")
    if not a.type.is_enumeration:
        raise type_error(
            "type.mismatch", f"`Integer` converts enumerations, not {describe(a)}", span, "use `integer`"
        )
    return elementwise(_enumeration_number, a, INTEGER)


def _enumeration_number(item: Expr) -> Expr:
    return ex.const(int(item.number)) if item.is_const else item


def _ndims(args: Sequence[AnyValue], span: Span) -> Value:
    return scalar(INTEGER, ex.const(len(_one(args, span, "ndims").shape)))


BUILTINS: dict[str, Builtin] = {
    **{name: _math(name) for name in _MATH},
    "abs": _abs,
    "sign": _sign,
    "atan2": _two("atan2", "atan2", _real),
    "div": _two("div", "idiv", _common),
    "mod": _two("mod", "mod", _common),
    "rem": _two("rem", "rem", _common),
    "floor": _rounding("floor", REAL),
    "ceil": _rounding("ceil", REAL),
    "integer": _rounding("integer", INTEGER),
    "min": _extreme("min"),
    "max": _extreme("max"),
    "sum": _sum,
    "product": _product,
    "zeros": _filled("zeros", 0),
    "ones": _filled("ones", 1),
    "fill": _fill,
    "identity": _identity,
    "diagonal": _diagonal,
    "linspace": _linspace,
    "transpose": _transpose,
    "cross": _cross,
    "skew": _skew,
    "outerProduct": _outer_product,
    "symmetric": _symmetric,
    "scalar": _scalar,
    "vector": _vector,
    "matrix": _matrix,
    "cat": _cat,
    "Integer": _to_integer,
    "ndims": _ndims,
}
NOT_YET = frozenset(
    {
        "pre", "edge", "change", "sample", "initial", "terminal", "reinit", "terminate", "delay",
        "semiLinear", "inStream", "actualStream", "cardinality", "spatialDistribution", "getInstanceName",
        "previous", "hold", "Clock", "subSample", "superSample", "shiftSample", "backSample", "noClock",
        "interval", "firstTick", "transition", "String",
    }
)  # fmt: skip
"""Operators of Modelica 3.6 that this version refuses by name."""
