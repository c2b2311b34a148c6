"""AST of equations, statements and their sections (Modelica 3.6, A.2.6)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from acausal.errors import Span
from acausal.lang.ast_expressions import Call, ComponentReference, Expression, Iterator, Tuple
from acausal.lang.ast_node import node, span_field

if TYPE_CHECKING:  # annotations and descriptions hold modifications, and those again equations
    from acausal.lang.ast_classes import Annotation, Comment


@node
class EqualEquation:
    """`left = right`."""

    left: Expression
    right: Expression
    comment: Comment
    span: Span = span_field()


@node
class ConnectEquation:
    left: ComponentReference
    right: ComponentReference
    comment: Comment
    span: Span = span_field()


@node
class CallEquation:
    """`assert(...)`, `reinit(...)`, `Connections.root(...)`, or any function call as an equation."""

    call: Call
    comment: Comment
    span: Span = span_field()


@node
class IfEquation:
    branches: tuple[tuple[Expression, tuple[Equation, ...]], ...]
    otherwise: tuple[Equation, ...]
    comment: Comment
    span: Span = span_field()


@node
class ForEquation:
    iterators: tuple[Iterator, ...]
    body: tuple[Equation, ...]
    comment: Comment
    span: Span = span_field()


@node
class WhenEquation:
    """`when c then … elsewhen d then … end when`: (condition, body) pairs."""

    branches: tuple[tuple[Expression, tuple[Equation, ...]], ...]
    comment: Comment
    span: Span = span_field()


Equation = EqualEquation | ConnectEquation | CallEquation | IfEquation | ForEquation | WhenEquation


@node
class Assignment:
    """`target := value`; `target` is a `Tuple` for a call with several results."""

    target: ComponentReference | Tuple
    value: Expression
    comment: Comment
    span: Span = span_field()


@node
class CallStatement:
    call: Call
    comment: Comment
    span: Span = span_field()


@node
class IfStatement:
    branches: tuple[tuple[Expression, tuple[Statement, ...]], ...]
    otherwise: tuple[Statement, ...]
    comment: Comment
    span: Span = span_field()


@node
class ForStatement:
    iterators: tuple[Iterator, ...]
    body: tuple[Statement, ...]
    comment: Comment
    span: Span = span_field()


@node
class WhileStatement:
    condition: Expression
    body: tuple[Statement, ...]
    comment: Comment
    span: Span = span_field()


@node
class WhenStatement:
    branches: tuple[tuple[Expression, tuple[Statement, ...]], ...]
    comment: Comment
    span: Span = span_field()


@node
class BreakStatement:
    comment: Comment
    span: Span = span_field()


@node
class ReturnStatement:
    comment: Comment
    span: Span = span_field()


Statement = (
    Assignment
    | CallStatement
    | IfStatement
    | ForStatement
    | WhileStatement
    | WhenStatement
    | BreakStatement
    | ReturnStatement
)


@node
class EquationSection:
    """`equation` or `initial equation`."""

    equations: tuple[Equation, ...]
    initial: bool
    span: Span = span_field()


@node
class AlgorithmSection:
    """`algorithm` or `initial algorithm`."""

    statements: tuple[Statement, ...]
    initial: bool
    span: Span = span_field()


@node
class External:
    """`external "C" result = name(arguments) annotation(...)`."""

    language: str | None
    result: ComponentReference | None
    name: str | None
    arguments: tuple[Expression, ...]
    annotation: Annotation | None
    span: Span = span_field()
