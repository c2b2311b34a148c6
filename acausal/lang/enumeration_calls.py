"""`E(i)`: the literal of the enumeration type E whose number is i (Modelica 3.6, 4.9.5.3)."""

from __future__ import annotations

from acausal.lang import ast
from acausal.lang.arithmetic import as_value, type_error
from acausal.lang.flat import INTEGER, ScalarType
from acausal.lang.index_choices import Choice
from acausal.lang.scope import Scope
from acausal.lang.translation import Env, Translation
from acausal.lang.values import Value, describe
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import EnumValue, Expr


def literal_of(translation: Translation, scope: Scope, node: ast.Call, env: Env) -> Value | None:
    """The value of `E(i)`, element by element; None where `scope` is no enumeration."""
    simple = translation.instances.simple_type(scope) if scope.kind == "type" else None
    if simple is None or not simple.scalar.is_enumeration:
        return None
    if len(node.arguments) != 1 or node.named:
        message = f"`{scope.path}` takes the number of a literal"
        raise type_error("call.arguments", message, node.span, "", (scope.path,))
    argument = node.arguments[0]
    numbers = as_value(translation.value(argument, env), argument.span)
    if numbers.type != INTEGER:
        message = f"`{scope.path}` takes an Integer, not {describe(numbers)}"
        raise type_error("type.mismatch", message, argument.span, "", (scope.path,))
    type_ = simple.scalar
    items = [_literal(translation, type_, item, argument) for item in numbers.items]
    return Value(type_, numbers.shape, tuple(items))


def _literal(translation: Translation, type_: ScalarType, number: Expr, node: ast.Expression) -> Expr:
    count = len(type_.literals)
    literals = [ex.const(EnumValue(type_.name, name, k)) for k, name in enumerate(type_.literals, start=1)]
    if isinstance(number.value, int) and number.is_const:
        if not 1 <= number.value <= count:
            message = f"`{type_.name}` has no literal number {number.value}, only 1 to {count}"
            raise type_error("type.index-out-of-range", message, node.span, "", (type_.name,))
        return literals[number.value - 1]
    choice = Choice(node, number, count, INTEGER, type_.name)
    choice.check(translation, ex.TRUE)
    result = literals[-1]
    for k in range(count - 1, 0, -1):
        result = ex.if_then_else(choice.test(k), literals[k - 1], result)
    return result
