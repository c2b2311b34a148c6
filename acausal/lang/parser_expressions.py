"""Expressions, component references and calls: the grammar of Modelica 3.6, appendix A.2.7.

Operators are read by precedence climbing: `_operators(c, minimum)` reads an operand and then every
operator that binds at least as tightly as `minimum`, so `a + b + ... + z` is a loop, not a recursion.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import cast

from acausal.errors import Span
from acausal.lang import ast
from acausal.lang.cursor import Cursor, close, enter, expect, identifier
from acausal.lang.lexer import IDENT, INTEGER, REAL, STRING, string_value
from acausal.lang.operators import BINARY_LEVELS, NOT_ASSOCIATIVE, OR, POWER, PREFIX_LEVELS
from acausal.lang.syntax_errors import (
    chained,
    misplaced_operator,
    misplaced_subscript,
    positional_after_named,
    stray_expression,
)


def expression(c: Cursor) -> ast.Expression:
    """`if` expression, range or anything simpler."""
    if c.kinds[c.position] == "if":
        return _if_expression(c)
    return simple_expression(c)


def simple_expression(c: Cursor) -> ast.Expression:
    """`a`, `a : b` or `a : b : c`, each a logical expression."""
    first = c.position
    left = _operators(c, OR)
    if c.kinds[c.position] != ":":
        return left
    c.position += 1
    second = _operators(c, OR)
    if c.kinds[c.position] != ":":
        return ast.Range(left, None, second, c.span_from(first))
    c.position += 1
    third = _operators(c, OR)
    if c.kinds[c.position] == ":":
        raise chained(c)
    return ast.Range(left, second, third, c.span_from(first))


def _if_expression(c: Cursor) -> ast.Expression:
    first = c.position
    enter(c)
    branches: list[tuple[ast.Expression, ast.Expression]] = []
    while True:
        c.position += 1  # `if` or `elseif`
        condition = expression(c)
        expect(c, "then", "after the condition of the `if` expression")
        branches.append((condition, expression(c)))
        if c.kinds[c.position] != "elseif":
            break
    expect(c, "else", "in the `if` expression, which needs a value for every case")
    otherwise = expression(c)
    c.depth -= 1
    return ast.If(tuple(branches), otherwise, c.span_from(first))


def _operators(c: Cursor, minimum: int) -> ast.Expression:
    """An operand and all following operators of level `minimum` or tighter."""
    first = c.position
    kinds = c.kinds
    left = _prefixed(c, minimum) if kinds[first] in PREFIX_LEVELS else primary(c)
    operator = kinds[c.position]
    if operator not in BINARY_LEVELS:
        return left
    level = BINARY_LEVELS[operator]
    while level >= minimum:
        c.position += 1
        right = primary(c) if level == POWER else _operators(c, level + 1)
        start, end = c.starts[first], c.ends[c.position - 1]
        left = ast.Binary(cast(ast.BinaryOperator, operator), left, right, Span(c.source, start, end))
        operator = kinds[c.position]
        before, level = level, BINARY_LEVELS.get(operator, 0)
        if level == before and level in NOT_ASSOCIATIVE:
            raise chained(c)
    return left


def _prefixed(c: Cursor, minimum: int) -> ast.Expression:
    """`not a` or `-a`, where the grammar has them: at the beginning of a relation or of a sum."""
    first = c.position
    operator = c.kinds[first]
    level = PREFIX_LEVELS[operator]
    if level < minimum:
        raise misplaced_operator(c)
    c.position = first + 1
    operand = _operators(c, level + 1)
    return ast.Unary(cast(ast.UnaryOperator, operator), operand, c.span_from(first))


# --------------------------------------------------------------------------- references and calls


def component_reference(c: Cursor) -> ast.ComponentReference:
    """`[.] a[i].b[j]`."""
    first = c.position
    kinds = c.kinds
    if kinds[first] == IDENT:
        following = kinds[first + 1]
        if following not in {".", "["}:
            c.position = first + 1
            return _one_part(c, first)
    global_ = kinds[first] == "."
    if global_:
        c.position += 1
    parts: list[ast.NamePart] = []
    while True:
        start = c.position
        name = identifier(c, "a name")
        subscripts = array_subscripts(c) if kinds[c.position] == "[" else None
        parts.append(ast.NamePart(name, subscripts, c.span_from(start)))
        if kinds[c.position] != ".":
            return ast.ComponentReference(tuple(parts), global_, c.span_from(first))
        c.position += 1


def _one_part(c: Cursor, position: int) -> ast.ComponentReference:
    """Token `position` alone as a reference."""
    span = Span(c.source, c.starts[position], c.ends[position])
    return ast.ComponentReference((ast.NamePart(c.texts[position], None, span),), False, span)


def type_specifier(c: Cursor, what: str) -> ast.ComponentReference:
    """`[.] A.B.C`; `what` completes "expected ..."."""
    first = c.position
    kinds = c.kinds
    global_ = kinds[first] == "."
    if global_:
        c.position += 1
    parts: list[ast.NamePart] = []
    while True:
        start = c.position
        parts.append(ast.NamePart(identifier(c, what), None, c.span_from(start)))
        if kinds[c.position] != ".":
            return ast.ComponentReference(tuple(parts), global_, c.span_from(first))
        c.position += 1


def array_subscripts(c: Cursor) -> ast.Subscripts:
    """`[i, :, end]`."""
    first = c.position
    kinds = c.kinds
    enter(c)
    c.subscripts += 1
    items: list[ast.Expression] = []
    while True:
        c.position += 1  # `[` or `,`
        if kinds[c.position] == ":":
            c.position += 1
            items.append(ast.Colon(c.span_from(c.position - 1)))
        else:
            items.append(expression(c))
        if kinds[c.position] != ",":
            break
    close(c, "]", first)
    c.subscripts -= 1
    c.depth -= 1
    return ast.Subscripts(tuple(items), c.span_from(first))


def call_arguments(c: Cursor, first: int, function: ast.ComponentReference) -> ast.Call:
    """`(a, b, name = c)` or `(a for i in r)`, after the function's name, which began at token `first`."""
    opened = c.position
    kinds = c.kinds
    c.position = opened + 1
    enter(c)
    arguments: list[ast.Expression] = []
    named: list[ast.NamedArgument] = []
    iterators: tuple[ast.Iterator, ...] = ()
    if kinds[c.position] != ")":
        while True:
            if kinds[c.position] == IDENT and kinds[c.position + 1] == "=":
                named.append(_named_argument(c))
            elif named:
                raise positional_after_named(c)
            else:
                arguments.append(_argument(c))
            if kinds[c.position] != ",":
                break
            c.position += 1
        if kinds[c.position] == "for" and len(arguments) == 1 and not named:
            if isinstance(arguments[0], ast.PartialFunction):
                raise c.error("`)` after the function argument")
            c.position += 1
            iterators = for_indices(c)
    close(c, ")", opened)
    c.depth -= 1
    return ast.Call(function, tuple(arguments), tuple(named), iterators, c.span_from(first))


def _named_argument(c: Cursor) -> ast.NamedArgument:
    first = c.position
    c.position = first + 2
    return ast.NamedArgument(c.texts[first], _argument(c), c.span_from(first))


def _argument(c: Cursor) -> ast.Expression:
    return _partial_function(c) if c.kinds[c.position] == "function" else expression(c)


def _partial_function(c: Cursor) -> ast.PartialFunction:
    """`function f(a = 1)`."""
    first = c.position
    c.position = first + 1
    function = type_specifier(c, "a function name after `function`")
    opened = c.position
    expect(c, "(", "after the function name")
    enter(c)
    named: list[ast.NamedArgument] = []
    while c.kinds[c.position] != ")":
        if c.kinds[c.position] != IDENT or c.kinds[c.position + 1] != "=":
            raise c.error("an argument `name = value`", "`function f(...)` binds arguments by name only")
        named.append(_named_argument(c))
        if c.kinds[c.position] != "," or c.kinds[c.position + 1] == ")":
            break
        c.position += 1
    close(c, ")", opened)
    c.depth -= 1
    return ast.PartialFunction(function, tuple(named), c.span_from(first))


# --------------------------------------------------------------------------- primaries


def primary(c: Cursor) -> ast.Expression:
    """A literal, reference, call, bracket or `end`."""
    position = c.position
    kind = c.kinds[position]
    if kind == IDENT:
        reference = component_reference(c)
        return call_arguments(c, position, reference) if c.kinds[c.position] == "(" else reference
    if kind == INTEGER:
        c.position = position + 1
        span = Span(c.source, c.starts[position], c.ends[position])
        return ast.IntegerLiteral(int(c.texts[position]), span)
    if kind in _PRIMARIES:
        return _PRIMARIES[kind](c)
    if kind in PREFIX_LEVELS:
        raise misplaced_operator(c)
    raise stray_expression(c)


def _real(c: Cursor) -> ast.Expression:
    c.position += 1
    return ast.RealLiteral(float(c.texts[c.position - 1]), c.span_from(c.position - 1))


def _string(c: Cursor) -> ast.Expression:
    c.position += 1
    return ast.StringLiteral(string_value(c.texts[c.position - 1]), c.span_from(c.position - 1))


def _boolean(c: Cursor) -> ast.Expression:
    c.position += 1
    return ast.BooleanLiteral(c.kinds[c.position - 1] == "true", c.span_from(c.position - 1))


def _end(c: Cursor) -> ast.Expression:
    if not c.subscripts:
        raise stray_expression(c)
    c.position += 1
    return ast.End(c.span_from(c.position - 1))


def _keyword_call(c: Cursor) -> ast.Expression:
    """`der(x)`, `initial()` and `pure(f(x))`: functions whose name is a keyword."""
    first = c.position
    c.position += 1
    if c.kinds[c.position] != "(":
        raise c.error(f"`(` after `{c.kinds[first]}`")
    return call_arguments(c, first, _one_part(c, first))


def _global_reference(c: Cursor) -> ast.Expression:
    first = c.position
    reference = component_reference(c)
    return call_arguments(c, first, reference) if c.kinds[c.position] == "(" else reference


def _parenthesised(c: Cursor) -> ast.Expression:
    """`(a)`, which is `a`, or a tuple `(a, , b)`."""
    first = c.position
    items = tuple_items(c)
    if len(items) == 1 and items[0] is not None:
        if c.kinds[c.position] == "[":
            raise misplaced_subscript(c)
        return items[0]
    return ast.Tuple(items, c.span_from(first))


def tuple_items(c: Cursor) -> tuple[ast.Expression | None, ...]:
    """`( [expression] {, [expression]} )`; nothing at all between the parentheses is no item."""
    first = c.position
    c.position = first + 1
    enter(c)
    kinds = c.kinds
    items: list[ast.Expression | None] = []
    while True:
        kind = kinds[c.position]
        items.append(None if kind in (",", ")") else expression(c))
        if kinds[c.position] != ",":
            break
        c.position += 1
    close(c, ")", first)
    c.depth -= 1
    return () if items == [None] else tuple(items)


def _array(c: Cursor) -> ast.Expression:
    first = c.position
    c.position = first + 1
    enter(c)
    kinds = c.kinds
    if kinds[c.position] == "}":
        raise c.error("an expression", "an empty array is written zeros(0) or fill(value, 0)")
    items = [expression(c)]
    iterators: tuple[ast.Iterator, ...] = ()
    if kinds[c.position] == "for":
        c.position += 1
        iterators = for_indices(c)
    else:
        while kinds[c.position] == ",":
            c.position += 1
            items.append(expression(c))
    close(c, "}", first)
    c.depth -= 1
    return ast.ArrayConstructor(tuple(items), iterators, c.span_from(first))


def _matrix(c: Cursor) -> ast.Expression:
    first = c.position
    enter(c)
    rows: list[tuple[ast.Expression, ...]] = []
    while True:
        c.position += 1  # `[` or `;`
        rows.append(expression_list(c))
        if c.kinds[c.position] != ";":
            break
    close(c, "]", first)
    c.depth -= 1
    return ast.Matrix(tuple(rows), c.span_from(first))


def expression_list(c: Cursor) -> tuple[ast.Expression, ...]:
    """One or more expressions between commas."""
    items = [expression(c)]
    while c.kinds[c.position] == ",":
        c.position += 1
        items.append(expression(c))
    return tuple(items)


def for_indices(c: Cursor) -> tuple[ast.Iterator, ...]:
    """`i in a, j, k in b`, after the word `for`."""
    iterators: list[ast.Iterator] = []
    while True:
        first = c.position
        name = identifier(c, "an iterator after `for`")
        values: ast.Expression | None = None
        if c.kinds[c.position] == "in":
            c.position += 1
            values = expression(c)
        iterators.append(ast.Iterator(name, values, c.span_from(first)))
        if c.kinds[c.position] != ",":
            return tuple(iterators)
        c.position += 1


_PRIMARIES: dict[str, Callable[[Cursor], ast.Expression]] = {
    REAL: _real,
    STRING: _string,
    "true": _boolean,
    "false": _boolean,
    "end": _end,
    "der": _keyword_call,
    "initial": _keyword_call,
    "pure": _keyword_call,
    ".": _global_reference,
    "(": _parenthesised,
    "{": _array,
    "[": _matrix,
}
