"""Operators on values: types, sizes and what each does with arrays (Modelica 3.6, chapters 3 and 10.6)."""

from __future__ import annotations

from collections.abc import Callable
from math import isfinite, prod

from acausal.errors import Span, TypeProblem, fail
from acausal.lang.flat import BOOLEAN, INTEGER, REAL, STRING
from acausal.lang.values import (
    AnyValue,
    RecordArray,
    RecordValue,
    Value,
    describe,
    elementwise,
    same_fields,
    scalar,
    unify,
    zip_with,
)
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr

MAX_PRODUCTS = 1_000_000
MAX_CHARACTERS = 1_000_000

RELATIONS = {"<": "lt", "<=": "le", ">": "gt", ">=": "ge", "==": "eq", "<>": "ne"}


def type_error(
    code: str, message: str, span: Span, hint: str = "", names: tuple[str, ...] = ()
) -> TypeProblem:
    """A `TypeProblem` with one diagnostic."""
    return fail(TypeProblem, code, message, span, names=names, hint=hint)


def as_value(value: AnyValue, span: Span) -> Value:
    """A scalar or array of a predefined type. Raises for records."""
    if isinstance(value, Value):
        return value
    raise type_error("type.record", f"{describe(value)} cannot be used here", span, "use one of its fields")


def as_scalar(value: AnyValue, span: Span, what: str = "expression") -> Value:
    """A scalar. Raises `type.not-scalar`."""
    plain = as_value(value, span)
    if plain.shape:
        raise type_error(
            "type.not-scalar", f"this {what} must be a scalar, but it is {describe(plain)}", span
        )
    return plain


def as_boolean(value: AnyValue, span: Span, what: str = "condition") -> Expr:
    """A Boolean scalar's expression. Raises `type.not-boolean`."""
    plain = as_scalar(value, span, what)
    if plain.type != BOOLEAN:
        raise type_error(
            "type.not-boolean",
            f"this {what} must be Boolean, but it is {plain.type}",
            span,
            "compare it with something",
        )
    return plain.item


def binary(operator: str, left: AnyValue, right: AnyValue, span: Span) -> Value:
    """The value of `left operator right`. Raises `TypeProblem`."""
    a, b = as_value(left, span), as_value(right, span)
    if operator in RELATIONS:
        return _relation(operator, a, b, span)
    if operator in ("and", "or"):
        return _logical(operator, a, b, span)
    if operator == "+" and a.type == STRING and b.type == STRING:
        return _concatenate(a, b, span)
    _require_numeric(a, b, operator, span)
    if operator.startswith("."):
        return _elementwise(operator[1:], a, b, span)
    if operator in ("+", "-"):
        if a.shape != b.shape:
            raise _sizes(operator, a, b, span, "use `.+` or `.-` to add a scalar to every element")
        return _elementwise(operator, a, b, span)
    if operator == "*":
        return _times(a, b, span)
    if operator == "/":
        if b.shape:
            raise _sizes(operator, a, b, span, "the divisor must be a scalar; use `./` element by element")
        return _elementwise(operator, a, b, span)
    return _power(a, b, span)


def unary(operator: str, operand: AnyValue, span: Span) -> Value:
    """The value of `not`, `-` or `+`."""
    a = as_value(operand, span)
    if operator == "not":
        if a.type != BOOLEAN:
            raise type_error("type.not-boolean", f"`not` needs a Boolean, not {describe(a)}", span)
        return elementwise(ex.logical_not, a, BOOLEAN)
    if not a.type.is_numeric:
        raise type_error("type.not-numeric", f"`{operator}` needs a number, not {describe(a)}", span)
    return a if operator.endswith("+") else elementwise(ex.neg_term, a, a.type)


def _require_numeric(a: Value, b: Value, operator: str, span: Span) -> None:
    for value in (a, b):
        if not value.type.is_numeric:
            raise type_error(
                "type.not-numeric",
                f"`{operator}` needs numbers on both sides, not {describe(a)} and {describe(b)}",
                span,
                "use `if condition then 1 else 0` to count a Boolean" if value.type == BOOLEAN else "",
            )


def _sizes(operator: str, a: Value, b: Value, span: Span, hint: str = "") -> TypeProblem:
    return type_error(
        "type.array-size", f"the sizes do not fit: {describe(a)} {operator} {describe(b)}", span, hint
    )


_ELEMENT: dict[str, Callable[[Expr, Expr], Expr]] = {
    "+": ex.add,
    "-": ex.sub,
    "*": ex.mul,
    "/": ex.div,
    "^": ex.power,
}


def _elementwise(operator: str, a: Value, b: Value, span: Span) -> Value:
    type_ = REAL if operator in ("/", "^") else (unify(a.type, b.type) or REAL)
    result = zip_with(_ELEMENT[operator], a, b, type_)
    if result is None:
        raise _sizes(operator, a, b, span)
    return with_integers(result, span)


def with_integers(value: Value, span: Span) -> Value:
    """An Integer result with Integer literals: `n - n` and `0 * n` are 0, not 0.0."""
    if value.type != INTEGER or all(type(item.value) is not float for item in value.items):
        return value
    if not all(isfinite(item.number) for item in value.items if type(item.value) is float):
        raise type_error("parameter.arithmetic", "this Integer is larger than 64 bits", span)
    items = [ex.const(int(item.number)) if type(item.value) is float else item for item in value.items]
    return Value(INTEGER, value.shape, tuple(items))


def _times(a: Value, b: Value, span: Span) -> Value:
    type_ = unify(a.type, b.type) or REAL
    if not a.shape or not b.shape:
        return _elementwise("*", a, b, span)
    left, right = list(a.shape), list(b.shape)
    if left[-1] != right[0] or len(left) > 2 or len(right) > 2:
        raise _sizes("*", a, b, span, "use `.*` for the product element by element")
    inner, rows, columns = right[0], prod(left[:-1]), prod(right[1:])
    if inner * rows * columns > MAX_PRODUCTS:
        message = f"a product of matrices takes more than {MAX_PRODUCTS} multiplications"
        raise type_error("array.bad-size", message, span)
    items = [
        dot([a.items[i * inner + k] for k in range(inner)], [b.items[k * columns + j] for k in range(inner)])
        for i in range(rows)
        for j in range(columns)
    ]
    return with_integers(Value(type_, a.shape[:-1] + b.shape[1:], tuple(items)), span)


def dot(a: list[Expr], b: list[Expr]) -> Expr:
    """Sum of products."""
    return ex.add(*[ex.mul(x, y) for x, y in zip(a, b, strict=True)]) if a else ex.ZERO


def _power(a: Value, b: Value, span: Span) -> Value:
    if not a.shape and not b.shape:
        return _elementwise("^", a, b, span)
    square = len(a.shape) == 2 and a.shape[0] == a.shape[1]
    exponent = b.items[0].value if not b.shape and b.items[0].is_const else None
    if not square or not isinstance(exponent, int) or not 0 <= exponent <= 100:
        raise _sizes("^", a, b, span, "use `.^` element by element")
    size = a.shape[0]
    one, zero = ex.const(1), ex.const(0)
    result = Value(a.type, a.shape, tuple(one if i % (size + 1) == 0 else zero for i in range(size * size)))
    for _ in range(exponent):
        result = _times(result, a, span)
    return result


def _relation(operator: str, a: Value, b: Value, span: Span) -> Value:
    if a.shape or b.shape:
        raise type_error(
            "type.not-scalar", f"`{operator}` compares scalars, not {describe(a)} and {describe(b)}", span
        )
    if unify(a.type, b.type) is None:
        raise type_error(
            "type.mismatch", f"`{operator}` cannot compare {describe(a)} with {describe(b)}", span
        )
    return scalar(BOOLEAN, ex.relation(RELATIONS[operator], a.item, b.item))


def _logical(operator: str, a: Value, b: Value, span: Span) -> Value:
    if a.type != BOOLEAN or b.type != BOOLEAN:
        raise type_error(
            "type.not-boolean", f"`{operator}` needs Booleans, not {describe(a)} and {describe(b)}", span
        )
    combine = ex.logical_and if operator == "and" else ex.logical_or
    result = zip_with(combine, a, b, BOOLEAN) if a.shape == b.shape else None
    if result is None:
        raise _sizes(operator, a, b, span)
    return result


def _concatenate(a: Value, b: Value, span: Span) -> Value:
    result = zip_with(_joined, a, b, STRING) if a.shape == b.shape else None
    if result is None:
        raise _sizes("+", a, b, span)
    if any(isinstance(i.value, str) and len(i.value) > MAX_CHARACTERS for i in result.items):
        raise type_error("string.too-long", f"a string has more than {MAX_CHARACTERS} characters", span)
    return result


def _joined(a: Expr, b: Expr) -> Expr:
    """The text of `a`, then that of `b`; a sum of Strings joins its terms in order."""
    x, y = a.value, b.value
    if isinstance(x, str) and isinstance(y, str) and a.is_const and b.is_const:
        return ex.const(x + y)
    return ex.add(a, b)


def choose(condition: Expr, then: AnyValue, otherwise: AnyValue, span: Span) -> AnyValue:
    """`if condition then then else otherwise`, element by element and field by field."""
    if then is otherwise:
        return then
    if isinstance(then, RecordValue) and isinstance(otherwise, RecordValue) and same_fields(then, otherwise):
        names = list(then.fields)
        chosen = [choose(condition, then.fields[name], otherwise.fields[name], span) for name in names]
        return then.with_fields(dict(zip(names, chosen, strict=True)))
    if isinstance(then, RecordArray) and isinstance(otherwise, RecordArray) and then.shape == otherwise.shape:
        items = [choose(condition, x, y, span) for x, y in zip(then.items, otherwise.items, strict=True)]
        return RecordArray(then.shape, tuple([x for x in items if isinstance(x, RecordValue)]), then.scope)
    return _choose_values(condition, then, otherwise, span)


def _choose_values(condition: Expr, then: AnyValue, otherwise: AnyValue, span: Span) -> Value:
    a, b = as_value(then, span), as_value(otherwise, span)
    type_ = unify(a.type, b.type)
    if type_ is None:
        raise type_error(
            "type.mismatch", f"the branches of this `if` are {describe(a)} and {describe(b)}", span
        )
    if a.shape != b.shape:
        raise type_error(
            "type.array-size",
            f"the branches of this `if` have different sizes: {describe(a)} and {describe(b)}",
            span,
        )
    pairs = zip(a.items, b.items, strict=True)
    items = [x if x is y else ex.if_then_else(condition, x, y) for x, y in pairs]
    return Value(type_, a.shape, tuple(items))
