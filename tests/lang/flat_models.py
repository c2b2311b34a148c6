"""Flat models for tests, written as Python-like text: `equation("tau = J * der(w)")`."""

from __future__ import annotations

import ast
from collections.abc import Callable, Sequence

from acausal.errors import Source, Span
from acausal.lang.flat import (
    REAL,
    Assertion,
    Equation,
    Experiment,
    FlatModel,
    Origin,
    ScalarType,
    Variability,
    Variable,
)
from acausal.symbolic.expressions import expr
from acausal.symbolic.expressions.expr import Expr, make
from acausal.symbolic.expressions.kernel import Named

_BINARY: dict[type[ast.operator], Callable[[Expr, Expr], Expr]] = {
    ast.Add: expr.add,
    ast.Sub: expr.sub,
    ast.Mult: expr.mul,
    ast.Div: expr.div,
    ast.Pow: expr.power,
}
_COMPARE: dict[type[ast.cmpop], str] = {
    ast.Lt: "lt",
    ast.LtE: "le",
    ast.Gt: "gt",
    ast.GtE: "ge",
    ast.Eq: "eq",
    ast.NotEq: "ne",
}


def span(text: str = "x") -> Span:
    """The whole of a text that is its own source."""
    return Span(Source("Test.mo", text), 0, len(text))


def real(name: str, unit: str = "", **attributes: object) -> Variable:
    return variable(name, REAL, Variability.CONTINUOUS, unit=unit, **attributes)


def parameter(name: str, unit: str = "", value: str | None = None, **attributes: object) -> Variable:
    return variable(name, REAL, Variability.PARAMETER, unit=unit, binding=value, **attributes)


def variable(name: str, type_: ScalarType, variability: Variability, **attributes: object) -> Variable:
    """Attributes given as text are expressions, except the texts that really are texts."""
    texts = ("unit", "display_unit", "quantity", "description")
    values = {
        key: expression(value) if isinstance(value, str) and key not in texts else value
        for key, value in attributes.items()
    }
    return Variable(name, type_, variability, span(name), **values)  # type: ignore[arg-type]


def equation(text: str, origin: Origin = Origin.EQUATION) -> Equation:
    left, right = text.split(" = ")
    return Equation(expression(left), expression(right), span(text), origin=origin)


def assertion(text: str, message: str = "no", level: str = "error") -> Assertion:
    return Assertion(expression(text), expr.const(message), level, span(text))


def model(
    variables: Sequence[Variable],
    equations: Sequence[Equation | str] = (),
    initial: Sequence[str] = (),
    assertions: Sequence[Assertion] = (),
    experiment: Experiment | None = None,
    name: str = "Test",
) -> FlatModel:
    return FlatModel(
        name,
        "",
        tuple(variables),
        tuple(equation(e) if isinstance(e, str) else e for e in equations),
        tuple(equation(e) for e in initial),
        tuple(assertions),
        experiment or Experiment(),
        span(),
    )


def expression(text: str) -> Expr:
    return _expression(ast.parse(text, mode="eval").body)


def _expression(node: ast.expr) -> Expr:
    match node:
        case ast.Constant(value=bool() | int() | float() | str() as value):
            return expr.const(value)
        case ast.Name() | ast.Attribute() | ast.Subscript():
            return expr.sym(ast.unparse(node))
        case ast.BinOp(left=left, op=operator, right=right):
            return _BINARY[type(operator)](_expression(left), _expression(right))
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return expr.neg(_expression(operand))
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            return expr.logical_not(_expression(operand))
        case ast.BoolOp(op=operator, values=values):
            return make("and" if isinstance(operator, ast.And) else "or", tuple(map(_expression, values)))
        case ast.Compare(left=left, ops=[operator], comparators=[right]):
            return make(_COMPARE[type(operator)], (_expression(left), _expression(right)))
        case ast.IfExp(test=test, body=body, orelse=orelse):
            return make("if", (_expression(test), _expression(body), _expression(orelse)))
        case ast.Call(func=ast.Name(id="smooth"), args=[ast.Constant(value=int() as order), inner]):
            return expr.smooth(order, _expression(inner))
        case ast.Call(func=ast.Name(id=name), args=arguments):
            args = tuple(map(_expression, arguments))
            return make(name, args) if name in expr.OPERATORS else expr.call(Named(name, len(args)), *args)
        case _:
            raise ValueError(ast.unparse(node))
