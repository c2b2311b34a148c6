"""Array constructors, matrices, ranges and reductions (Modelica 3.6, 10.4 and 10.3.4.1)."""

from __future__ import annotations

from collections.abc import Sequence

from acausal.errors import Span
from acausal.lang import ast
from acausal.lang.arithmetic import as_value, type_error
from acausal.lang.array_functions import cat
from acausal.lang.builtins import BUILTINS
from acausal.lang.flat import INTEGER, REAL
from acausal.lang.iteration import iterate, iterator_values
from acausal.lang.operator_records import sum_of_records
from acausal.lang.record_arrays import renumbered
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue, RecordArray, Value, describe, enumeration_literal, literal, stack
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Constant, EnumValue

MAX_RANGE = 200_000


def array_value(translation: Translation, node: ast.ArrayConstructor, env: Env) -> AnyValue:
    """`{a, b, c}` or `{e for i in r}`, where the last iterator becomes the first dimension."""
    if not node.iterators:
        values = [translation.value(item, env) for item in node.items]
        return _stacked(values, (len(values),), node)
    return _comprehension(translation, node.items[0], node.iterators, env, node)


def _comprehension(
    translation: Translation,
    item: ast.Expression,
    iterators: Sequence[ast.Iterator],
    env: Env,
    node: ast.ArrayConstructor | ast.Call,
) -> AnyValue:
    """`{e for i in I, j in J}` is `{{e for i in I} for j in J}`."""
    *inner, outer = iterators
    values: list[AnyValue] = []
    for value in translation.turns(iterator_values(translation, outer, env, item), outer.span):
        env_here = env.with_locals({outer.name: value})
        if inner:
            values.append(_comprehension(translation, item, inner, env_here, node))
        else:
            values.append(translation.value(item, env_here))
    if not values:
        return Value(REAL, (0,) * len(iterators), ())
    return _stacked(values, (len(values),), node)


def _stacked(
    values: Sequence[AnyValue], shape: tuple[int, ...], node: ast.ArrayConstructor | ast.Call
) -> AnyValue:
    result = stack(values, shape)
    if result is None:
        kinds = ", ".join(dict.fromkeys(describe(v) for v in values))
        message = f"the elements of this array do not fit together: {kinds}"
        raise type_error("type.array-elements", message, node.span)
    return result


def matrix_value(translation: Translation, node: ast.Matrix, env: Env) -> AnyValue:
    """`[a, b; c, d]`: rows joined along the second dimension, then along the first (10.4.2.1)."""
    cells = [[translation.value(cell, env) for cell in row] for row in node.rows]
    flat = [cell for row in cells for cell in row]
    if any(not isinstance(cell, Value) for cell in flat):
        return renumbered(flat, lambda numbers: _matrix(_like(cells, numbers), node.span), node.span)
    return _matrix([[as_value(cell, node.span) for cell in row] for row in cells], node.span)


def _like(rows: Sequence[Sequence[AnyValue]], values: Sequence[Value]) -> list[list[Value]]:
    """The values in rows as long as those of `rows`."""
    rest = iter(values)
    return [[next(rest) for _ in row] for row in rows]


def _matrix(written: Sequence[Sequence[Value]], span: Span) -> Value:
    rows: list[Value] = []
    for cells in written:
        dimensions = max([2, *[len(c.shape) for c in cells]])
        shaped = [Value(c.type, (*c.shape, *(1,) * dimensions)[:dimensions], c.items) for c in cells]
        rows.append(cat(2, shaped, span))
    return cat(1, rows, span)


# --------------------------------------------------------------------------- ranges


def range_value(translation: Translation, node: ast.Range, env: Env) -> Value:
    """`start : step : stop` of numbers, or `first : last` of an enumeration or of Booleans."""
    start = translation.evaluate_in(node.start, env, "the range")
    stop = translation.evaluate_in(node.stop, env, "the range")
    if node.step is None and isinstance(start, EnumValue) and isinstance(stop, EnumValue):
        return _enumeration_range(translation, node, env, start, stop)
    step: Constant = 1
    if node.step is not None:
        step = translation.evaluate_in(node.step, env, "the range")
    if isinstance(start, bool) and isinstance(stop, bool) and node.step is None:
        values = [literal(b) for b in (False, True) if start <= b <= stop]
        return Value(values[0].type if values else literal(True).type, (len(values),), _items(values))
    numbers = [v for v in (start, step, stop) if isinstance(v, (int, float)) and not isinstance(v, bool)]
    if len(numbers) != 3 or numbers[1] == 0:
        raise type_error("type.range", "a range needs numbers and a step that is not zero", node.span)
    return _numbers(numbers[0], numbers[1], numbers[2], node)


def _numbers(start: float, step: float, stop: float, node: ast.Range) -> Value:
    integers = isinstance(start, int) and isinstance(step, int) and isinstance(stop, int)
    if integers:
        count = max(0, int((stop - start) // step) + 1)
    else:
        steps = (stop - start) / step
        if not abs(steps) < MAX_RANGE:
            count = MAX_RANGE + 1 if steps > 0 else 0
        else:
            count = int(steps + 1e-10) + 1 if steps >= 0 else 0
    if count > MAX_RANGE:
        message = f"this range has more than {MAX_RANGE} elements"
        raise type_error("for.too-long", message, node.span)
    items = tuple([ex.const(start + i * step) for i in range(count)])
    return Value(INTEGER if integers else REAL, (count,), items)


def _enumeration_range(
    translation: Translation, node: ast.Range, env: Env, start: EnumValue, stop: EnumValue
) -> Value:
    type_ = as_value(translation.value(node.start, env), node.span).type
    if start.type_name != stop.type_name:
        message = f"this range goes from `{start.type_name}` to `{stop.type_name}`"
        raise type_error("type.range", message, node.span)
    values = [enumeration_literal(type_, i) for i in range(start.index, stop.index + 1)]
    return Value(type_, (len(values),), _items(values))


def _items(values: Sequence[Value]) -> tuple[ex.Expr, ...]:
    return tuple([value.item for value in values])


# --------------------------------------------------------------------------- reductions


def array_call(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    """`array(a, b, c)`, which is `{a, b, c}`."""
    if node.named or not node.arguments:
        message = "`array` takes the elements of an array"
        raise type_error("call.arguments", message, node.span, "", ("array",))
    values = [translation.value(item, env) for item in node.arguments]
    return _stacked(values, (len(values),), node)


def reduction(translation: Translation, node: ast.Call, name: str, env: Env) -> AnyValue:
    """`sum(e for i in r)`, also `product`, `min`, `max` and `array`."""
    if name == "array":
        return _comprehension(translation, node.arguments[0], node.iterators, env, node)
    if name not in ("sum", "product", "min", "max"):
        message = f"`{name}` cannot be used with `for`"
        raise type_error("call.reduction", message, node.span, "", (name,))
    values = [
        translation.value(node.arguments[0], inner)
        for inner in iterate(translation, node.iterators, env, node.arguments)
    ]
    if not values:
        empty = {"sum": 0, "product": 1}.get(name)
        if empty is None:
            raise type_error("call.reduction", f"`{name}` over an empty range", node.span, "", (name,))
        return literal(empty)
    stacked = stack(values, (len(values),))
    if isinstance(stacked, RecordArray) and name == "sum" and len(stacked.shape) == 1:
        return sum_of_records(translation, stacked, node.span, env)
    if not isinstance(stacked, Value):
        message = f"the terms of this `{name}` do not fit together"
        raise type_error("type.array-elements", message, node.span)
    if stacked.is_scalar or len(stacked.shape) == 1:
        return BUILTINS[name]([stacked], node.span)
    return _sum_of_arrays(name, stacked, node)


def _sum_of_arrays(name: str, stacked: Value, node: ast.Call) -> Value:
    """`sum` of arrays adds them element by element."""
    if name != "sum":
        message = f"the terms of `{name}` must be scalars"
        raise type_error("type.array-elements", message, node.span, "", (name,))
    shape = stacked.shape[1:]
    size = len(stacked.items) // stacked.shape[0]
    items = tuple([ex.add(*stacked.items[k::size]) for k in range(size)])
    return Value(stacked.type, shape, items)
