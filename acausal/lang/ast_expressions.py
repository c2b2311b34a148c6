"""AST of names and expressions (Modelica 3.6, A.2.7)."""

from __future__ import annotations

from typing import Literal

from acausal.errors import Span
from acausal.lang.ast_node import node, span_field


@node
class Subscripts:
    """`[i, j, :]`; a lone colon is `Colon`."""

    items: tuple[Expression, ...]
    span: Span = span_field()


@node
class NamePart:
    """One identifier of a dotted reference with its subscripts: `cell[3]` in `line.cell[3].p`.

    A quoted identifier keeps its quotes: `'cell 3'` is not the same name as `cell`.
    """

    name: str
    subscripts: Subscripts | None
    span: Span = span_field()


@node
class ComponentReference:
    """`a.b[1].c`, or `.Modelica.Constants.pi` when `global_` is true. Also type names and function names."""

    parts: tuple[NamePart, ...]
    global_: bool
    span: Span = span_field()

    @property
    def text(self) -> str:
        """The dotted name without subscripts."""
        return ("." if self.global_ else "") + ".".join([part.name for part in self.parts])


@node
class RealLiteral:
    value: float
    span: Span = span_field()


@node
class IntegerLiteral:
    value: int
    span: Span = span_field()


@node
class BooleanLiteral:
    value: bool
    span: Span = span_field()


@node
class StringLiteral:
    """`value` is the string's content after escape sequences are applied."""

    value: str
    span: Span = span_field()


UnaryOperator = Literal["-", "+", ".-", ".+", "not"]
BinaryOperator = Literal[
    "+", "-", "*", "/", "^", ".+", ".-", ".*", "./", ".^", "<", "<=", ">", ">=", "==", "<>", "and", "or"
]


@node
class Unary:
    operator: UnaryOperator
    operand: Expression
    span: Span = span_field()


@node
class Binary:
    operator: BinaryOperator
    left: Expression
    right: Expression
    span: Span = span_field()


@node
class If:
    """`if c1 then e1 elseif c2 then e2 else e3`: `branches` are the (condition, value) pairs."""

    branches: tuple[tuple[Expression, Expression], ...]
    otherwise: Expression
    span: Span = span_field()


@node
class NamedArgument:
    """`name = value` in a call; `value` may be a `PartialFunction`."""

    name: str
    value: Expression
    span: Span = span_field()


@node
class Iterator:
    """`i in range`; `range` is None where it is deduced from the use of `i` as a subscript."""

    name: str
    range: Expression | None
    span: Span = span_field()


@node
class Call:
    """`f(a, b, c = d)`, a reduction `sum(e for i in r)` when `iterators` is not empty.

    `der(x)`, `initial()` and `pure(f(x))` are calls too: their function is a one-part reference.
    """

    function: ComponentReference
    arguments: tuple[Expression, ...]
    named: tuple[NamedArgument, ...]
    iterators: tuple[Iterator, ...]
    span: Span = span_field()


@node
class PartialFunction:
    """`function f(a = 1)`: a function with some arguments bound, passed as an argument."""

    function: ComponentReference
    named: tuple[NamedArgument, ...]
    span: Span = span_field()


@node
class ArrayConstructor:
    """`{a, b, c}`, or `{e for i in r}` when `iterators` is not empty (then `items` has one element)."""

    items: tuple[Expression, ...]
    iterators: tuple[Iterator, ...]
    span: Span = span_field()


@node
class Matrix:
    """`[a, b; c, d]`: rows of expressions."""

    rows: tuple[tuple[Expression, ...], ...]
    span: Span = span_field()


@node
class Range:
    """`start : stop` or `start : step : stop`."""

    start: Expression
    step: Expression | None
    stop: Expression
    span: Span = span_field()


@node
class Tuple:
    """`(a, , b)` as the left side of a call with several results; `()` too. Left-out positions are None.

    A single parenthesised expression is not a tuple, except on the left of `:=`.
    """

    items: tuple[Expression | None, ...]
    span: Span = span_field()


@node
class Colon:
    """`:` as a subscript or array dimension."""

    span: Span = span_field()


@node
class End:
    """`end` inside a subscript."""

    span: Span = span_field()


@node
class Subscripted:
    """`(expression)[i]`: Base Modelica and Modelica 3.7 have it, Modelica 3.6 (section 3.2) forbids it."""

    expression: Expression
    subscripts: Subscripts
    span: Span = span_field()


Expression = (
    RealLiteral
    | IntegerLiteral
    | BooleanLiteral
    | StringLiteral
    | ComponentReference
    | Unary
    | Binary
    | If
    | Call
    | PartialFunction
    | ArrayConstructor
    | Matrix
    | Range
    | Tuple
    | Colon
    | End
    | Subscripted
)
