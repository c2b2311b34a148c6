"""Numeric value of an expression in Python: for parameters, sizes and conditions, not for simulation."""

from __future__ import annotations

from collections.abc import Callable

from acausal.symbolic.expressions.expr import Constant, EnumValue, Expr, parts
from acausal.symbolic.expressions.operators import OPERATORS

Lookup = Callable[[str], Constant | None]
"""The value of a symbol, or None when it has none."""


class NotConstant(Exception):
    """The expression needs a symbol that has no value; `name` is the first one met (or an operator)."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.name = name


class EvaluationFailed(Exception):
    """Arithmetic failed (division by zero, logarithm of a negative number, ...): a text for the message."""


def evaluate(root: Expr, lookup: Lookup, memo: dict[Expr, Constant] | None = None) -> Constant:
    """Value of `root`. Only the taken branch of an `if` is evaluated; iterative.

    Raises `NotConstant` and `EvaluationFailed`.
    """
    values: dict[Expr, Constant] = {} if memo is None else memo
    stack = [root]
    while stack:
        node = stack[-1]
        if node in values:
            stack.pop()
            continue
        missing = _missing(node, values)
        if missing:
            stack.extend(missing)
        else:
            stack.pop()
            values[node] = _value(node, values, lookup)
    return values[root]


def number_of(expr: Expr, lookup: Lookup) -> float | None:
    """The value as a float; None where it is not known, or no number."""
    try:
        value = evaluate(expr, lookup)
    except (NotConstant, EvaluationFailed):
        return None
    return float(value) if isinstance(value, int | float) else None


def _missing(node: Expr, values: dict[Expr, Constant]) -> list[Expr]:
    if node.op != "if":
        return [arg for arg in reversed(parts(node)) if arg not in values]
    condition, then, otherwise = node.args
    if condition not in values:
        return [condition]
    taken = then if values[condition] else otherwise
    return [] if taken in values else [taken]


def _value(node: Expr, values: dict[Expr, Constant], lookup: Lookup) -> Constant:
    if node.op == "const":
        assert node.value is not None
        return node.value
    if node.op == "sym":
        value = lookup(node.name)
        if value is None:
            raise NotConstant(node.name)
        return value
    if node.op == "if":
        condition, then, otherwise = node.args
        return values[then if values[condition] else otherwise]
    if node.op == "derived":
        return values[node.args[0]]
    compute = node.kernel.evaluate if node.op == "call" else OPERATORS[node.op].evaluate
    if compute is None:
        raise NotConstant(node.op)
    return _apply(compute, [values[arg] for arg in node.args])


def _apply(compute: Callable[..., Constant], args: list[Constant]) -> Constant:
    plain = [arg.index if isinstance(arg, EnumValue) else arg for arg in args]
    try:
        return compute(*plain)
    except (ArithmeticError, ValueError, TypeError) as problem:
        raise EvaluationFailed(str(problem)) from None
