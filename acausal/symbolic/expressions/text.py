"""Expressions as Modelica text. Iterative, so that long sums and deep nests print too."""

from __future__ import annotations

import re
from collections.abc import Callable
from weakref import WeakKeyDictionary

from acausal.symbolic.expressions.expr import EnumValue, Expr, fold
from acausal.symbolic.expressions.kernel import Named
from acausal.symbolic.expressions.kernels.texts import TextOf
from acausal.symbolic.expressions.node import Wide
from acausal.symbolic.expressions.operators import OPERATORS

_Piece = tuple[str, int]
"""Text and its precedence."""

MOST_CHARACTERS = 10_000_000
"""Parts beyond this are left out as `...`: an expression with shared parts is small, its text may be huge."""
_MOST_WRITTEN = 10 * MOST_CHARACTERS
"""The same of the texts of all parts of one expression together, which bounds the time."""

_ATOM = 100
_POWER, _PRODUCT, _SUM = 7, 6, 5
_FUNCTION_TEXT = {"idiv": "div"}


def plain_name(name: str) -> str:
    """The name as it is."""
    return name


def quoted_name(name: str) -> str:
    """The Base Modelica identifier of a flat name (MCP-0031): `'cell[3].v'`; `time` stays."""
    if name == "time":
        return name
    return "'" + name.replace("\\", "\\\\").replace("'", "\\'") + "'"


def quote_string(text: str) -> str:
    """A Modelica string literal."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def constant_text(value: object, name: Callable[[str], str] = plain_name) -> str:
    """A literal as Modelica text."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, EnumValue):
        return f"{name(value.type_name)}.{value.literal}"
    if isinstance(value, str):
        return quote_string(value)
    if value in (float("inf"), float("-inf")):
        return "1e999" if value == float("inf") else "-1e999"
    return repr(value)


def to_text(root: Expr, name: Callable[[str], str] = plain_name) -> str:
    """The expression as Modelica text; `name` maps flat names to identifiers, as `quoted_name` does."""
    written = 0

    def visit(node: Expr, args: list[_Piece]) -> _Piece:
        nonlocal written
        length = sum([len(text) for text, _ in args])
        written += length
        if length > MOST_CHARACTERS or written > _MOST_WRITTEN:
            return "...", _ATOM
        if node.op == "call" and node.wide is not None and name is plain_name:
            return _call_text(node, _shared_text(node.wide, args), name), _ATOM
        return _piece(node, args, name)

    return fold([root], visit)[root][0]


def beginning(root: Expr, most: int) -> str:
    """The first characters of `to_text`: all of them if they are at most `most`, else more than that.

    A text begins with the beginnings of its parts' texts, so that none of these is needed whole.
    """

    def visit(node: Expr, args: list[_Piece]) -> _Piece:
        if node.op != "call" or node.wide is None:
            args = args[: most + 1]  # each is a character or more
        text, precedence = _piece(node, args, plain_name)
        return text[: most + 1], precedence

    return fold([root], visit)[root][0]


def _wrap(piece: _Piece, least: int) -> str:
    text, precedence = piece
    return text if precedence >= least else f"({text})"


def _piece(node: Expr, args: list[_Piece], name: Callable[[str], str]) -> _Piece:
    op = node.op
    if op == "sym":
        return name(node.name), _ATOM
    if op == "const":
        text = constant_text(node.value, name)
        return text, _SUM if text.startswith("-") else _ATOM
    if op == "add":
        return _sum_text(args), _SUM
    if op == "neg":
        return "-" + _wrap(args[0], _PRODUCT), _SUM
    if op == "mul":
        factors = [_wrap(arg, _PRODUCT if i == 0 else _POWER) for i, arg in enumerate(args)]
        return " * ".join(factors), _PRODUCT
    if op == "div":
        return f"{_wrap(args[0], _PRODUCT)} / {_wrap(args[1], _POWER)}", _PRODUCT
    if op == "pow":
        return f"{_wrap(args[0], _ATOM)} ^ {_wrap(args[1], _ATOM)}", _POWER
    return _other(node, args, name)


def _other(node: Expr, args: list[_Piece], name: Callable[[str], str]) -> _Piece:
    operator = OPERATORS[node.op]
    if operator.shape == "relation":
        return f"{_wrap(args[0], _SUM)} {operator.text} {_wrap(args[1], _SUM)}", operator.precedence
    if node.op == "not":
        return "not " + _wrap(args[0], 4), 3
    if operator.shape == "logical":
        least = operator.precedence + 1
        return f" {operator.text} ".join([_wrap(arg, least) for arg in args]), operator.precedence
    if node.op == "if":
        condition, then, otherwise = (arg[0] for arg in args)
        return f"if {condition} then {then} else {otherwise}", 0
    wide = node.wide if node.op == "call" and name is plain_name else None
    inner = _arguments(wide, args)
    if node.op == "smooth":
        return f"smooth({node.value}, {inner})", _ATOM
    if node.op == "call":
        return _call_text(node, inner, name), _ATOM
    if node.op == "derived":
        return args[0]
    return f"{_FUNCTION_TEXT.get(node.op, operator.text)}({inner})", _ATOM


def _call_text(node: Expr, inner: str, name: Callable[[str], str]) -> str:
    kernel = node.kernel
    if isinstance(kernel, TextOf):
        return f"String({inner}{kernel.options})"
    return f"{kernel.name if isinstance(kernel, Named) else name(kernel.name)}({inner})"


_in_ranges: WeakKeyDictionary[Wide, str] = WeakKeyDictionary()


def _shared_text(wide: Wide, args: list[_Piece]) -> str:
    """The text of arguments that calls share, made once."""
    known = _in_ranges.get(wide)
    if known is None:
        known = _arguments(wide, args)
        if ("...", _ATOM) not in args:
            _in_ranges[wide] = known
    return known


def _arguments(wide: Wide | None, args: list[_Piece]) -> str:
    texts = [arg[0] for arg in args]
    return ", ".join(texts if wide is None else _with_ranges(texts))


_ELEMENT = re.compile(r"([^()]*\[(?:\d+,)*)(\d+)\]")


def _with_ranges(texts: list[str]) -> list[str]:
    """Elements of an array that follow each other as one: `a[1:400]`."""
    found: list[str] = []
    last: tuple[str, int, int] | None = None
    for text in [*texts, ""]:
        element = _ELEMENT.fullmatch(text)
        if (
            element is not None
            and last is not None
            and (element[1], int(element[2])) == (last[0], last[2] + 1)
        ):
            last = last[0], last[1], last[2] + 1
            continue
        if last is not None:
            base, first, end = last
            found.append(f"{base}{first}]" if first == end else f"{base}{first}:{end}]")
        last = None if element is None else (element[1], int(element[2]), int(element[2]))
        if element is None and text:
            found.append(text)
    return found


def _sum_text(args: list[_Piece]) -> str:
    parts = [_wrap(args[0], _SUM)]
    for piece in args[1:]:
        text, precedence = piece
        if precedence == _SUM and text.startswith("-"):
            parts.append(f" - {text[1:]}")
        else:
            parts.append(f" + {_wrap(piece, _PRODUCT)}")
    return "".join(parts)
