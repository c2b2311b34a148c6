"""Built-in functions that make, reshape and join arrays (Modelica 3.6, 10.3)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import prod

from acausal.errors import Span
from acausal.lang.arithmetic import as_scalar, as_value, type_error
from acausal.lang.flat import INTEGER, REAL, ScalarType
from acausal.lang.values import AnyValue, Value, all_indices, describe, index_offset, scalar, unify
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr

Builtin = Callable[[Sequence[AnyValue], Span], Value]
MAX_ELEMENTS = 200_000


def numbers(args: Sequence[AnyValue], span: Span, name: str, count: int) -> list[Value]:
    """Numeric arguments, exactly `count` of them."""
    if len(args) != count:
        raise type_error("call.arguments", f"`{name}` takes {count} argument(s), not {len(args)}", span)
    values = [as_value(arg, span) for arg in args]
    for value in values:
        if not value.type.is_numeric:
            raise type_error("type.not-numeric", f"`{name}` needs numbers, not {describe(value)}", span)
    return values


def only(args: Sequence[AnyValue], span: Span, name: str) -> Value:
    """The one argument."""
    if len(args) != 1:
        raise type_error("call.arguments", f"`{name}` takes 1 argument, not {len(args)}", span)
    return as_value(args[0], span)


def common_type(a: Value, b: Value) -> ScalarType:
    """Integer if both are, else Real."""
    return unify(a.type, b.type) or REAL


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
    (a,) = numbers(args, span, "diagonal", 1)
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
    a = only(args, span, "transpose")
    if len(a.shape) < 2:
        raise type_error("type.array-size", f"`transpose` needs a matrix, not {describe(a)}", span)
    shape = (a.shape[1], a.shape[0], *a.shape[2:])
    items = [a.items[index_offset(a.shape, (i[1], i[0], *i[2:]))] for i in all_indices(shape)]
    return Value(a.type, shape, tuple(items))


def _cross(args: Sequence[AnyValue], span: Span) -> Value:
    a, b = numbers(args, span, "cross", 2)
    if a.shape != (3,) or b.shape != (3,):
        raise type_error("type.array-size", f"`cross` of {describe(a)} and {describe(b)}", span)
    x, y = a.items, b.items
    items = [ex.sub(ex.mul(x[i], y[j]), ex.mul(x[j], y[i])) for i, j in ((1, 2), (2, 0), (0, 1))]
    return Value(common_type(a, b), (3,), tuple(items))


def _skew(args: Sequence[AnyValue], span: Span) -> Value:
    (a,) = numbers(args, span, "skew", 1)
    if a.shape != (3,):
        raise type_error("type.array-size", f"`skew` of {describe(a)}", span)
    x, y, z = a.items
    zero = ex.ZERO
    return Value(a.type, (3, 3), (zero, ex.neg(z), y, z, zero, ex.neg(x), ex.neg(y), x, zero))


def _outer_product(args: Sequence[AnyValue], span: Span) -> Value:
    a, b = numbers(args, span, "outerProduct", 2)
    items = [ex.mul(x, y) for x in a.items for y in b.items]
    return Value(common_type(a, b), (len(a.items), len(b.items)), tuple(items))


def _symmetric(args: Sequence[AnyValue], span: Span) -> Value:
    a = only(args, span, "symmetric")
    if len(a.shape) != 2 or a.shape[0] != a.shape[1]:
        raise type_error("type.array-size", f"`symmetric` needs a square matrix, not {describe(a)}", span)
    items = [a.items[index_offset(a.shape, (min(i, j), max(i, j)))] for i, j in all_indices(a.shape)]
    return Value(a.type, a.shape, tuple(items))


def _scalar(args: Sequence[AnyValue], span: Span) -> Value:
    a = only(args, span, "scalar")
    if len(a.items) != 1:
        raise type_error("type.array-size", f"`scalar` of {describe(a)}", span)
    return scalar(a.type, a.items[0])


def _vector(args: Sequence[AnyValue], span: Span) -> Value:
    a = only(args, span, "vector")
    if sum(size > 1 for size in a.shape) > 1:
        raise type_error("type.array-size", f"`vector` of {describe(a)}", span)
    return Value(a.type, (len(a.items),), a.items)


def _matrix(args: Sequence[AnyValue], span: Span) -> Value:
    a = only(args, span, "matrix")
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


ARRAY_FUNCTIONS: dict[str, Builtin] = {
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
}
