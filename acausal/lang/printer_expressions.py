"""Expressions -> text, with the fewest parentheses that read back as the same tree.

Sums, comparisons and logical operators are spaced; products and powers are not. Elementwise operators
always are, because `2.*x` is the Real `2.` times `x`.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import assert_never

from acausal.lang import ast
from acausal.lang.operators import (
    BINARY_LEVELS,
    CONDITIONAL,
    NOT_ASSOCIATIVE,
    OR,
    PREFIX_LEVELS,
    PRIMARY,
    RANGE,
    SUM,
)

WIDTH = 100
"""Arrays, calls and modifications longer than this are laid out one item a line where that is possible."""

_ESCAPED = re.compile(r'[\\"\a\b\f\r\v]')
_ESCAPES = {
    "\\": "\\\\",
    '"': '\\"',
    "\a": "\\a",
    "\b": "\\b",
    "\f": "\\f",
    "\r": "\\r",
    "\v": "\\v",
}
_TIGHT = frozenset(("*", "/", "^"))


def string_text(value: str) -> str:
    """A string literal; newlines and tabs stay as they are, which keeps documentation readable."""
    return '"' + _ESCAPED.sub(lambda match: _ESCAPES[match[0]], value) + '"'


def level_of(e: ast.Expression) -> int:
    """How tightly the outermost operator of an expression binds."""
    match e:
        case ast.Binary():
            return BINARY_LEVELS[e.operator]
        case ast.Unary():
            return PREFIX_LEVELS[e.operator]
        case ast.If():
            return CONDITIONAL
        case ast.Range():
            return RANGE
        case ast.IntegerLiteral() | ast.RealLiteral():
            return SUM if e.value < 0 else PRIMARY
        case _:
            return PRIMARY


def expression_text(e: ast.Expression, minimum: int = CONDITIONAL) -> str:
    """The text of an expression, in parentheses if it binds less tightly than `minimum`."""
    text = _bare_text(e)
    return text if minimum == CONDITIONAL or level_of(e) >= minimum else f"({text})"


def _bare_text(e: ast.Expression) -> str:
    match e:
        case ast.ComponentReference():
            return reference_text(e)
        case ast.IntegerLiteral():
            return str(e.value)
        case ast.RealLiteral():
            return _real_text(e.value)
        case ast.StringLiteral():
            return string_text(e.value)
        case ast.BooleanLiteral():
            return "true" if e.value else "false"
        case ast.Binary():
            return _binary_text(e)
        case ast.Unary():
            return _unary_text(e)
        case ast.Range():
            ends = (e.start, e.stop) if e.step is None else (e.start, e.step, e.stop)
            return ":".join([expression_text(part, OR) for part in ends])
        case ast.Colon():
            return ":"
        case ast.End():
            return "end"
        case ast.Subscripted():
            return f"({_bare_text(e.expression)}){subscripts_text(e.subscripts)}"
        case _:
            return _compound_text(e)


def _compound_text(
    e: ast.If | ast.Call | ast.PartialFunction | ast.ArrayConstructor | ast.Matrix | ast.Tuple,
) -> str:
    match e:
        case ast.Call() | ast.PartialFunction():
            return f"{call_head(e)}({', '.join(call_items(e))})"
        case ast.ArrayConstructor():
            return "{" + list_text(e.items) + iterators_text(e.iterators, " for ") + "}"
        case ast.Matrix():
            return "[" + "; ".join([list_text(row) for row in e.rows]) + "]"
        case ast.Tuple():
            return tuple_text(e)
        case ast.If():
            return _if_text(e)
        case _:
            assert_never(e)


def _real_text(value: float) -> str:
    """The shortest decimal that reads back as the same double; never an Integer."""
    text = repr(value)
    if text in ("inf", "-inf", "nan"):
        raise ValueError(f"Modelica has no literal for {text}")
    return text


def _binary_text(e: ast.Binary) -> str:
    """The left spine of `a + b + c + ...` is walked, not recursed into: it may be very long."""
    tail: list[str] = []
    left: ast.Expression = e
    level = BINARY_LEVELS[e.operator]
    while isinstance(left, ast.Binary) and BINARY_LEVELS[left.operator] >= level:
        here = BINARY_LEVELS[left.operator]
        if left is not e and level == here and here in NOT_ASSOCIATIVE:
            break
        level = here
        operator = left.operator if left.operator in _TIGHT else f" {left.operator} "
        tail.append(operator + expression_text(left.right, level + 1))
        left = left.left
    head = expression_text(left, level + 1 if level in NOT_ASSOCIATIVE else level)
    return head + "".join(reversed(tail))


def _unary_text(e: ast.Unary) -> str:
    operator = "not " if e.operator == "not" else e.operator
    return operator + expression_text(e.operand, PREFIX_LEVELS[e.operator] + 1)


def _if_text(e: ast.If) -> str:
    branches = [f"if {expression_text(test)} then {expression_text(value)}" for test, value in e.branches]
    return f"{' else'.join(branches)} else {expression_text(e.otherwise)}"


def reference_text(e: ast.ComponentReference) -> str:
    """`.a[1].b`."""
    names = [
        part.name if part.subscripts is None else part.name + subscripts_text(part.subscripts)
        for part in e.parts
    ]
    return ("." if e.global_ else "") + ".".join(names)


def subscripts_text(subscripts: ast.Subscripts | None) -> str:
    """`[1, :]`, or nothing."""
    return "" if subscripts is None else f"[{list_text(subscripts.items)}]"


def list_text(items: Iterable[ast.Expression]) -> str:
    """Expressions between commas."""
    return ", ".join([expression_text(item) for item in items])


def tuple_text(e: ast.Tuple) -> str:
    """`(a, , b)`."""
    return "(" + ", ".join(["" if item is None else expression_text(item) for item in e.items]) + ")"


def iterators_text(iterators: Iterable[ast.Iterator], before: str = "") -> str:
    """`i in 1:n, j`, after the text `before`; nothing at all if there are none."""
    texts = [
        iterator.name if iterator.range is None else f"{iterator.name} in {expression_text(iterator.range)}"
        for iterator in iterators
    ]
    return before + ", ".join(texts) if texts else ""


def call_head(e: ast.Call | ast.PartialFunction) -> str:
    """What stands before the parenthesis of a call."""
    word = "function " if isinstance(e, ast.PartialFunction) else ""
    return word + reference_text(e.function)


def call_items(e: ast.Call | ast.PartialFunction) -> list[str]:
    """The arguments of a call."""
    items = [f"{argument.name} = {expression_text(argument.value)}" for argument in e.named]
    if isinstance(e, ast.PartialFunction):
        return items
    positional = [expression_text(argument) for argument in e.arguments]
    if e.iterators:
        positional[-1] += iterators_text(e.iterators, " for ")
    return positional + items


# --------------------------------------------------------------------------- layout


def laid_out(open_text: str, items: Iterable[str], close_text: str, indent: str) -> str:
    """The items one a line between brackets; `indent` is that of the line on which the bracket opens."""
    inner = indent + "  "
    return open_text + "\n" + ",\n".join([inner + item for item in items]) + close_text


def value_text(e: ast.Expression, indent: str, minimum: int = CONDITIONAL) -> str:
    """Like `expression_text`, but long arrays and calls spread over several lines."""
    text = expression_text(e, minimum)
    if len(text) + len(indent) <= WIDTH:
        return text
    inner = indent + "  "
    match e:
        case ast.ArrayConstructor() if not e.iterators and len(e.items) > 1:
            return laid_out("{", [value_text(item, inner) for item in e.items], "}", indent)
        case ast.Call() if not e.iterators and len(e.arguments) + len(e.named) > 1:
            items = [value_text(argument, inner) for argument in e.arguments]
            items += [f"{argument.name} = {value_text(argument.value, inner)}" for argument in e.named]
            return laid_out(call_head(e) + "(", items, ")", indent)
        case ast.Matrix() if len(e.rows) > 1:
            rows = [inner + list_text(row) for row in e.rows]
            return "[\n" + ";\n".join(rows) + "]"
        case _:
            return text
