"""The operator table: per-operator knowledge that several modules need, beside tiny functions.

`OPERATORS` lists every operator a scalar expression can have. Derivative rules live in `diff`, CasADi
constructors in `acausal.codegen.casadi_expressions`; both are tables keyed by the same names, and a test
checks that they are complete.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal

LARGEST_INTEGER = 2**63
Shape = Literal[
    "leaf", "nary", "binary", "unary", "relation", "logical", "if", "wrap", "function", "call", "event"
]  # fmt: skip


@dataclass(frozen=True)
class Operator:
    """`name`; `arity` (None: any); `text` as printed; `precedence` as in Modelica (higher binds tighter)."""

    name: str
    shape: Shape
    arity: int | None
    text: str
    precedence: int
    evaluate: Callable[..., Any] | None = None
    """Numeric value from the arguments' numeric values; None where it needs more than values."""


def _divide(a: float, b: float) -> float:
    if b == 0:
        raise ZeroDivisionError("division by zero")
    return a / b


def _power(a: float, b: float) -> float:
    result = float(a) ** float(b)
    if isinstance(result, complex):
        raise ValueError(f"{a} to the power {b} is not a real number")
    return float(result)


def _sum(*args: float) -> float:
    total = args[0]
    for arg in args[1:]:
        total = total + arg
    return _bounded(total)


def _product(*args: float) -> float:
    total = args[0]
    for arg in args[1:]:
        total = _bounded(total * arg)
    return total


def _bounded(value: float) -> float:
    """Integers beyond 64 bits are an error: they would grow without end."""
    if isinstance(value, int) and abs(value) > LARGEST_INTEGER:
        raise OverflowError("an Integer is larger than 64 bits")
    return value


def _same(a: float) -> float:
    return a


def _actual(actual: object, _simplified: object) -> object:
    return actual


def _if(condition: bool, a: object, b: object) -> object:
    return a if condition else b


def _any(*args: bool) -> bool:
    return any(args)


def _all(*args: bool) -> bool:
    return all(args)


def _floor(a: float) -> float:
    return float(math.floor(a))


def _ceil(a: float) -> float:
    return float(math.ceil(a))


def _sign(a: float) -> int:
    return (a > 0) - (a < 0)


def _div(a: float, b: float) -> float:
    if isinstance(a, int) and isinstance(b, int):
        quotient = abs(a) // abs(b)
        return quotient if (a >= 0) == (b >= 0) else -quotient
    return float(math.trunc(a / b))


def _mod(a: float, b: float) -> float:
    return a - math.floor(a / b) * b


def _rem(a: float, b: float) -> float:
    return a - _div(a, b) * b


def _function(name: str, arity: int | None, evaluate: Callable[..., Any]) -> Operator:
    return Operator(name, "function", arity, name, 100, evaluate)


_TABLE = (
    Operator("const", "leaf", 0, "", 100),
    Operator("sym", "leaf", 0, "", 100),
    Operator("der", "wrap", 1, "der", 100),
    Operator("pre", "wrap", 1, "pre", 100),
    Operator("noEvent", "wrap", 1, "noEvent", 100, _same),
    Operator("smooth", "wrap", 1, "smooth", 100, _same),
    Operator("ordinal", "wrap", 1, "Integer", 100, _same),
    Operator("homotopy", "wrap", 2, "homotopy", 100, _actual),
    Operator("initial", "event", 0, "initial", 100),
    Operator("terminal", "event", 0, "terminal", 100),
    Operator("sample", "event", 2, "sample", 100),
    Operator("trigger", "event", 1, "trigger", 100),
    Operator("delay", "event", None, "delay", 100),
    Operator("call", "call", None, "", 100),
    Operator("derived", "wrap", 2, "", 100),
    Operator("rate", "wrap", 1, "der", 100),
    Operator("if", "if", 3, "if", 0, _if),
    Operator("or", "logical", None, "or", 1, _any),
    Operator("and", "logical", None, "and", 2, _all),
    Operator("not", "logical", 1, "not", 3, operator.not_),
    Operator("lt", "relation", 2, "<", 4, operator.lt),
    Operator("le", "relation", 2, "<=", 4, operator.le),
    Operator("gt", "relation", 2, ">", 4, operator.gt),
    Operator("ge", "relation", 2, ">=", 4, operator.ge),
    Operator("eq", "relation", 2, "==", 4, operator.eq),
    Operator("ne", "relation", 2, "<>", 4, operator.ne),
    Operator("add", "nary", None, "+", 5, _sum),
    Operator("neg", "unary", 1, "-", 5, operator.neg),
    Operator("mul", "nary", None, "*", 6, _product),
    Operator("div", "binary", 2, "/", 6, _divide),
    Operator("pow", "binary", 2, "^", 7, _power),
    _function("sin", 1, math.sin),
    _function("cos", 1, math.cos),
    _function("tan", 1, math.tan),
    _function("asin", 1, math.asin),
    _function("acos", 1, math.acos),
    _function("atan", 1, math.atan),
    _function("atan2", 2, math.atan2),
    _function("sinh", 1, math.sinh),
    _function("cosh", 1, math.cosh),
    _function("tanh", 1, math.tanh),
    _function("exp", 1, math.exp),
    _function("log", 1, math.log),
    _function("log10", 1, math.log10),
    _function("sqrt", 1, math.sqrt),
    _function("abs", 1, abs),
    _function("sign", 1, _sign),
    _function("min", 2, min),
    _function("max", 2, max),
    _function("floor", 1, _floor),
    _function("ceil", 1, _ceil),
    _function("integer", 1, math.floor),
    _function("idiv", 2, _div),
    _function("mod", 2, _mod),
    _function("rem", 2, _rem),
)

OPERATORS: dict[str, Operator] = {entry.name: entry for entry in _TABLE}
RELATIONS = frozenset({"lt", "le", "gt", "ge", "eq", "ne"})
SWITCHING = RELATIONS | {"integer"}
"""Operators whose value outside `noEvent` and `smooth` is a mode, constant between events."""
NEGATED_RELATION = {"lt": "ge", "le": "gt", "gt": "le", "ge": "lt", "eq": "ne", "ne": "eq"}
KNOWN_AT_EVENTS = frozenset({"initial", "terminal", "sample", "trigger", "delay"})
"""Operators whose value comes from the course of the simulation: nothing is solved for what they hold."""
EVENT_FUNCTIONS = frozenset({"floor", "ceil", "integer", "idiv", "mod", "rem"})
"""Functions that generate events outside `noEvent` (Modelica 3.6, 3.7.2)."""
