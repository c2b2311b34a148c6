"""Flat models from a few lines of text: what the tests of the symbolic passes are written in.

`model("der(x) = -k*x", variables={"x": {"start": "1"}}, parameters={"k": 2.0})`; every name that is not a
parameter is a continuous Real unknown.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from typing import TypedDict

from acausal.errors import Source, Span
from acausal.lang.flat import (
    REAL,
    Assertion,
    Causality,
    Equation,
    Experiment,
    FlatModel,
    Origin,
    ScalarType,
    StateSelect,
    Variability,
    Variable,
)
from acausal.symbolic.expressions import expr as e
from acausal.symbolic.expressions.expr import Expr, symbols

_TOKEN = re.compile(r"\s*(\d+\.?\d*(?:[eE][+-]?\d+)?|[A-Za-z_][\w.\[\]]*|<=|>=|<>|==|[-+*/^()<>,])")
_RELATIONS = {"<": "lt", "<=": "le", ">": "gt", ">=": "ge", "==": "eq", "<>": "ne"}


class Attributes(TypedDict, total=False):
    """Attributes of a variable, as expressions or texts of expressions."""

    start: str | float
    top_level: bool
    fixed: bool
    nominal: str | float
    min: str | float
    max: str | float
    select: StateSelect
    type: ScalarType
    discrete: bool
    flow: bool
    input: bool


class _Reader:
    def __init__(self, text: str) -> None:
        self.tokens = _TOKEN.findall(text)
        self.at = 0

    def peek(self) -> str:
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self, *expected: str) -> str:
        token = self.peek()
        if expected and token not in expected:
            raise ValueError(f"expected {expected} in {self.tokens} at {self.at}")
        self.at += 1
        return token

    def expression(self) -> Expr:
        if self.peek() == "if":
            self.take()
            condition = self.expression()
            self.take("then")
            then = self.expression()
            self.take("else")
            return e.if_then_else(condition, then, self.expression())
        return self.chain(("or",), lambda: self.chain(("and",), self.negation, e.logical_and), e.logical_or)

    def chain(
        self, operators: Sequence[str], part: Callable[[], Expr], join: Callable[[Expr, Expr], Expr]
    ) -> Expr:
        left = part()
        while self.peek() in operators:
            self.take()
            left = join(left, part())
        return left

    def negation(self) -> Expr:
        if self.peek() == "not":
            self.take()
            return e.logical_not(self.negation())
        left = self.sum()
        if self.peek() in _RELATIONS:
            return e.relation(_RELATIONS[self.take()], left, self.sum())
        return left

    def sum(self) -> Expr:
        negative = self.peek() == "-"
        if negative:
            self.take()
        left = self.product()
        left = e.neg(left) if negative else left
        while self.peek() in ("+", "-"):
            left = e.add(left, self.product()) if self.take() == "+" else e.sub(left, self.product())
        return left

    def product(self) -> Expr:
        left = self.power()
        while self.peek() in ("*", "/"):
            left = e.mul(left, self.power()) if self.take() == "*" else e.div(left, self.power())
        return left

    def power(self) -> Expr:
        base = self.atom()
        if self.peek() == "^":
            self.take()
            return e.power(base, self.atom())
        return base

    def atom(self) -> Expr:
        token = self.take()
        if token == "(":
            inner = self.expression()
            self.take(")")
            return inner
        if token[0].isdigit():
            return e.const(float(token))
        if token in ("true", "false"):
            return e.const(token == "true")
        if self.peek() != "(":
            return e.sym(token)
        return self.call(token)

    def call(self, name: str) -> Expr:
        self.take("(")
        args = [self.expression()]
        while self.peek() == ",":
            self.take()
            args.append(self.expression())
        self.take(")")
        if name == "der":
            return e.der(args[0])
        if name == "pre":
            return e.pre(args[0])
        if name == "noEvent":
            return e.no_event(args[0])
        if name == "smooth":
            return e.smooth(int(args[0].number), args[1])
        return e.function(name, *args)


def read(text: str | float) -> Expr:
    """One expression."""
    if not isinstance(text, str):
        return e.const(float(text))
    reader = _Reader(text)
    result = reader.expression()
    if reader.peek():
        raise ValueError(f"unread: {reader.tokens[reader.at :]} in {text!r}")
    return result


def model(
    *equations: str,
    variables: Mapping[str, Attributes] | None = None,
    parameters: Mapping[str, str | float | None] | None = None,
    initial: Sequence[str] = (),
    assertions: Sequence[str] = (),
    origins: Mapping[int, Origin] | None = None,
    free_parameters: Sequence[str] = (),
) -> FlatModel:
    """A flat model; line n of its source is equation n, and variables are declared after the equations."""
    given, values = variables or {}, parameters or {}
    sides = [_sides(text) for text in equations]
    start_sides = [_sides(text) for text in initial]
    met = symbols([*[x for pair in sides for x in pair], *[x for pair in start_sides for x in pair]])
    names = [n for n in dict.fromkeys((*given, *met)) if n not in values and n != "time"]
    lines = [*equations, *names, *values, *initial, *assertions]
    source = Source("test.mo", "\n".join(lines))
    offsets = [0]
    for line in lines:
        offsets.append(offsets[-1] + len(line) + 1)
    spans = [Span(source, offsets[i], offsets[i] + len(line)) for i, line in enumerate(lines)]
    n, m, p = len(equations), len(names), len(values)
    return FlatModel(
        name="Test",
        description="",
        variables=(
            *[_variable(name, given.get(name, {}), spans[n + i]) for i, name in enumerate(names)],
            *[
                _parameter(name, value, spans[n + m + i], free=name in free_parameters)
                for i, (name, value) in enumerate(values.items())
            ],
        ),
        equations=tuple(
            Equation(a, b, spans[i], origin=(origins or {}).get(i, Origin.EQUATION))
            for i, (a, b) in enumerate(sides)
        ),
        initial_equations=tuple(Equation(a, b, spans[n + m + p + i]) for i, (a, b) in enumerate(start_sides)),
        assertions=tuple(
            Assertion(read(text), e.const("failed"), "error", spans[n + m + p + len(initial) + i])
            for i, text in enumerate(assertions)
        ),
        experiment=Experiment(),
        span=Span(source, 0, 1),
    )


def _sides(text: str) -> tuple[Expr, Expr]:
    left, right = re.split(r"(?<![<>=])=(?!=)", text)
    return read(left), read(right)


def _optional(value: str | float | None) -> Expr | None:
    return None if value is None else read(value)


def _variable(name: str, given: Attributes, span: Span) -> Variable:
    return Variable(
        name=name,
        type=given.get("type", REAL),
        variability=Variability.DISCRETE if given.get("discrete") else Variability.CONTINUOUS,
        span=span,
        causality=Causality.INPUT if given.get("input") else Causality.LOCAL,
        start=_optional(given.get("start")),
        fixed=given.get("fixed"),
        nominal=_optional(given.get("nominal")),
        min=_optional(given.get("min")),
        max=_optional(given.get("max")),
        state_select=given.get("select", StateSelect.DEFAULT),
        flow=given.get("flow", False),
        top_level=given.get("top_level", "." not in name),
    )


def _parameter(name: str, value: str | float | None, span: Span, *, free: bool) -> Variable:
    return Variable(
        name=name,
        type=REAL,
        variability=Variability.PARAMETER,
        span=span,
        binding=None if free else _optional(value),
        start=_optional(value) if free else None,
        fixed=False if free else None,
    )


PENDULUM = (
    "der(x) = vx",
    "der(y) = vy",
    "m * der(vx) = -lambda * x",
    "m * der(vy) = -lambda * y - m * g",
    "x ^ 2 + y ^ 2 = L ^ 2",
)
PENDULUM_PARAMETERS: dict[str, str | float | None] = {"m": 2.0, "g": 9.81, "L": 1.5}


def pendulum(**starts: float) -> FlatModel:
    """The pendulum of every paper: index 3, one degree of freedom."""
    variables: dict[str, Attributes] = {name: {"start": value} for name, value in starts.items()}
    return model(*PENDULUM, variables=variables, parameters=PENDULUM_PARAMETERS)


def chain(cells: int) -> FlatModel:
    """Spring-mass-damper chain, five scalar equations a cell, connections included."""
    equations: list[str] = []
    for i in range(cells):
        a, b = f"cell[{i}]", f"cell[{i + 1}]"
        equations += [
            f"{a}.v = der({a}.s)",
            f"m * der({a}.v) = {a}.left + {a}.right",
            f"{a}.right = " + (f"c*({b}.s - {a}.s) + d*({b}.v - {a}.v)" if i + 1 < cells else "0"),
            f"{a}.left + {f'cell[{i - 1}].right' if i else 'c*' + a + '.s'} = 0",
            f"{a}.flange.s = {a}.s",
        ]
    return model(*equations, parameters={"m": 1.0, "c": 100.0, "d": 1.0})
