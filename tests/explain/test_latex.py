"""Expressions as LaTeX."""

from __future__ import annotations

import pytest

from acausal.explain.latex import MOST_NODES, equation_latex, expression_latex, name_latex
from acausal.symbolic.expressions.expr import (
    EnumValue,
    Expr,
    add,
    call,
    const,
    der,
    div,
    function,
    if_then_else,
    logical_and,
    logical_not,
    make,
    mul,
    neg,
    no_event,
    power,
    pre,
    relation,
    smooth,
    sym,
)
from acausal.symbolic.expressions.kernel import Named
from acausal.symbolic.expressions.operators import OPERATORS

X, Y = sym("x"), sym("y")
CASES = (
    r"\begin{cases} x & \text{if } \left(\left(x < y\right) \wedge \neg b\right) \\ "
    r"0 & \text{else} \end{cases}"
)


@pytest.mark.parametrize(
    ("name", "latex"),
    [
        ("x", "x"),
        ("tau", r"\tau"),
        ("tau_start", r"\tau_{\mathrm{start}}"),
        ("valve.spool.s", r"s_{\mathrm{valve.spool}}"),
        ("cell[3].v", r"v_{\mathrm{cell[3]}}"),
        ("v[3]", "v_{3}"),
        ("m.tau_in[2,1]", r"\tau_{\mathrm{m},\mathrm{in},\mathrm{2,1}}"),
        ("p1", r"\mathrm{p1}"),
        ("a.b[Mode.on]", r"b_{\mathrm{a},\mathrm{Mode.on}}"),
        ("line.p_0", r"p_{\mathrm{line},0}"),
        ("mass", r"\mathrm{mass}"),
        ("_x", r"\mathrm{\_x}"),
        ("'a_b.{$}'", r"\mathrm{'a\_b.\{\$\}'}"),
    ],
)
def test_names(name: str, latex: str) -> None:
    assert name_latex(name) == latex


@pytest.mark.parametrize(
    ("expression", "latex"),
    [
        (add(X, neg(Y)), "x - y"),
        (add(Y, X), "y + x"),
        (mul(add(X, const(1)), Y), r"\left(x + 1\right) \cdot y"),
        (div(X, add(X, Y)), r"\frac{x}{x + y}"),
        (power(X, const(2)), "x^{2}"),
        (mul(const(0.001), X), r"0.001 \cdot x"),
        (function("sqrt", X), r"\sqrt{x}"),
        (function("sin", X), r"\sin\left(x\right)"),
        (function("atan2", X, Y), r"\operatorname{atan2}\left(x, y\right)"),
        (function("abs", X), r"\left|x\right|"),
        (der(sym("phi")), r"\dot{\phi}"),
        (der(der(sym("a.s"))), r"\ddot{s}_{\mathrm{a}}"),
        (pre(X), r"\operatorname{pre}\left(x\right)"),
        (sym("time"), "t"),
        (no_event(add(X, Y)), "x + y"),
        (
            if_then_else(logical_and(relation("lt", X, Y), logical_not(sym("b"))), X, const(0)),
            CASES,
        ),
        (const(EnumValue("Mode", "open_", 1)), r"\mathrm{open\_}"),
    ],
)
def test_expressions(expression: Expr, latex: str) -> None:
    assert expression_latex(expression) == latex


@pytest.mark.parametrize("op", sorted(OPERATORS))
def test_every_operator_has_latex(op: str) -> None:
    operator = OPERATORS[op]
    count = 2 if operator.arity is None else operator.arity
    value = {"sym": "x", "const": 2.5, "call": "f", "smooth": 1}.get(op)
    args = (X, Y, X)[:count]
    latex = expression_latex(call(Named("f", 2), *args) if op == "call" else make(op, args, value))
    assert latex
    assert latex.count("{") == latex.count("}")


@pytest.mark.parametrize("value", [float("inf"), -float("inf"), True, "text {", 1e300, -3, 10**15])
def test_every_constant_has_latex(value: float | bool | str) -> None:
    assert expression_latex(add(const(value), X) if isinstance(value, float) else const(value))


def test_a_long_expression_has_none() -> None:
    terms = add(*[sym(f"x{i}") for i in range(MOST_NODES)])
    assert expression_latex(terms) is None
    assert equation_latex(X, terms) is None
    shared = X
    for _ in range(200):
        shared = call(Named("f", 2), shared, shared)
    assert expression_latex(smooth(1, shared)) is None
    fraction = X
    for depth in range(300):
        assert depth > 19 or expression_latex(fraction)
        fraction = div(X, add(Y, fraction))
    assert expression_latex(fraction) is None
