"""Derivative rules against finite differences, and what may not be differentiated."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from acausal.symbolic.expressions.diff import JUMPS, RULES, NotDifferentiable, partial, time_derivative
from acausal.symbolic.expressions.evaluate import evaluate
from acausal.symbolic.expressions.expr import ONE, ZERO, Expr, const, der, function, make, sym
from acausal.symbolic.expressions.operators import OPERATORS
from acausal.symbolic.expressions.text import to_text
from tests.symbolic.build import read

X, Y, P = sym("x"), sym("y"), sym("p")


def value(expr: Expr, **values: float) -> float:
    result = evaluate(expr, values.get)
    assert isinstance(result, int | float)
    return float(result)


def difference(expr: Expr, name: str, **values: float) -> float:
    h = 1e-5
    up, down = {**values, name: values[name] + h}, {**values, name: values[name] - h}
    return (value(expr, **up) - value(expr, **down)) / (2 * h)


def wide(t: float) -> float:
    """Between -2 and 2, away from the switching point at 0."""
    return (0.1 + 1.9 * abs(t)) * (1 if t >= 0 else -1)


SMOOTH_UNARY: dict[str, Callable[[float], float]] = {
    "sin": wide,
    "cos": wide,
    "tan": lambda t: 1.2 * t,
    "asin": lambda t: 0.9 * t,
    "acos": lambda t: 0.9 * t,
    "atan": wide,
    "sinh": wide,
    "cosh": wide,
    "tanh": wide,
    "exp": wide,
    "log": lambda t: 0.2 + abs(t),
    "log10": lambda t: 0.2 + abs(t),
    "sqrt": lambda t: 0.2 + abs(t),
    "abs": wide,
    "sign": wide,
    "floor": lambda t: 3 + 0.4 * t + 0.5,
    "ceil": lambda t: 3 + 0.4 * t + 0.5,
    "integer": lambda t: 3 + 0.4 * t + 0.5,
}
BINARY = ("add", "mul", "div", "pow", "atan2", "min", "max", "mod", "rem", "idiv")


def test_every_operator_has_a_rule() -> None:
    assert RULES.keys() == OPERATORS.keys()


def test_every_function_of_the_table_is_compared_with_finite_differences() -> None:
    functions = {name for name, entry in OPERATORS.items() if entry.shape in ("function", "nary", "binary")}
    assert functions == SMOOTH_UNARY.keys() | set(BINARY)


@pytest.mark.parametrize("name", sorted(SMOOTH_UNARY))
@given(t=st.floats(-1, 1))
def test_unary_rules(name: str, t: float) -> None:
    at = SMOOTH_UNARY[name](t)
    expr = make(name, (X,))
    assert value(partial(expr, X), x=at) == pytest.approx(difference(expr, "x", x=at), rel=1e-5, abs=1e-6)


@pytest.mark.parametrize("name", BINARY)
@given(s=st.floats(-1, 1), t=st.floats(-1, 1))
def test_binary_rules(name: str, s: float, t: float) -> None:
    at = {"x": 2.3 + 0.2 * s, "y": 1.7 + 0.2 * t}
    if name in ("mod", "rem", "idiv"):
        at = {"x": 8.5 + 0.2 * s, "y": 3.1 + 0.1 * t}  # the quotient stays between 2 and 3
    expr = make(name, (X, Y))
    for leaf in (X, Y):
        slope = value(partial(expr, leaf), **at)
        assert slope == pytest.approx(difference(expr, leaf.name, **at), rel=1e-5, abs=1e-6)


@pytest.mark.parametrize(
    "text",
    ["-x", "noEvent(x^2)", "smooth(2, x^3)", "if x > 0 then x^2 else sin(x)", "x^2*exp(x)/(1+x)", "x^x"],
)
def test_structural_rules(text: str) -> None:
    expr = read(text)
    assert value(partial(expr, X), x=0.7) == pytest.approx(difference(expr, "x", x=0.7), rel=1e-5)


def test_relations_and_logic_have_zero_slope() -> None:
    assert partial(read("if x > y and not x < p then 1 else 2"), X) is ZERO
    assert partial(X, X) is ONE
    assert partial(der(X), X) is ZERO
    assert partial(der(X), der(X)) is ONE


@given(st.lists(st.sampled_from(["x", "y", "p", "time", "2"]), min_size=1, max_size=4), st.floats(0.2, 1.5))
def test_time_derivative_is_the_chain_rule(factors: list[str], at: float) -> None:
    """Along x = t^2, y = sin(t), p constant."""
    expr = read("*".join(factors) + " + sin(x*y) - p*exp(-y)/(1 + time)")
    along = {"x": at**2, "y": math.sin(at), "p": 1.3, "time": at}
    symbolic = time_derivative(expr, derivative_of)
    values = {**along, "der(x)": 2 * at, "der(y)": math.cos(at)}
    result = evaluate(symbolic, values.get, {der(X): 2 * at, der(Y): math.cos(at)})
    h = 1e-5

    def on_curve(t: float) -> float:
        return value(expr, x=t**2, y=math.sin(t), p=1.3, time=t)

    assert result == pytest.approx((on_curve(at + h) - on_curve(at - h)) / (2 * h), rel=1e-6, abs=1e-7)


def derivative_of(leaf: Expr) -> Expr | None:
    if leaf is sym("u"):
        return None
    return ZERO if leaf.op == "sym" and leaf.name in ("p", "t0", "t1", "h") else der(leaf)


def derived(text: str, **values: float) -> str:
    return to_text(time_derivative(read(text), derivative_of, values.get))


def test_derivatives_of_derivatives_and_parameters() -> None:
    assert derived("der(x)") == "der(der(x))"
    assert derived("p^2*t0") == "0.0"
    assert derived("time") == "1.0"
    assert derived("pre(x)") == "0.0"


def test_smooth_vouches_for_its_switches_and_counts_down() -> None:
    assert derived("smooth(2, if x > 0 then x^3 else 0)").startswith("smooth(1, if x > 0")
    second = time_derivative(read("smooth(1, if x > 0 then x^2 else 0)"), derivative_of)
    assert to_text(second) == "smooth(0, if x > 0.0 then 2.0 * x * der(x) else 0.0)"
    assert derived("smooth(1, abs(x)*x)").startswith("smooth(0")


def test_smooth_of_order_zero_needs_a_proof() -> None:
    assert derived("smooth(0, if x > 0 then x else 0)") == "if x > 0.0 then der(x) else 0.0"
    with pytest.raises(NotDifferentiable):
        derived("smooth(0, if x > 0 then 1 else x)")


@pytest.mark.parametrize(
    "text",
    [
        "if p > 1 then x else 2*x",  # the condition depends on parameters only
        "if time < t0 then 0 else h*(time - t0)",
        "if time < t0 then 0 else if time < t1 then h*(time - t0)/(t1 - t0) else h",
        "if x - p > 0 then x^2 - p^2 else 0",
        "if not x > 2*p then x*y else 2*p*y",
        "if 3*time < t0 then x else x + (3*time - t0)*y",
        "noEvent(if x >= p then x else p)",
        "if p > 1 then x else if time < 1 then 0 else 1",  # never in force with p = 1.5
        "if time < t1 then 0.1*h*(time - t0) - 0.45 else 0",  # zero to rounding
    ],
)
def test_switches_that_provably_meet(text: str) -> None:
    assert derived(text, p=1.5, t0=0.5, t1=2.0, h=3.0)


@pytest.mark.parametrize(
    "text",
    [
        "if time < 1 then 0 else 1",
        "if x > 0 then x else x + 1",
        "if x > y and x > 0 then x else x + y",
        "if x > 0 then y else x",
        "floor(x)",
        "sign(x)",
        "mod(x, p)",
        "u",
        "noEvent(if time < 1 then 0 else 1)",
        "if p > 2 then x else if time < 1 then 0 else 1",
        "if x > y then 1e-9 else 0",
    ],
)
def test_jumps_are_refused(text: str) -> None:
    with pytest.raises(NotDifferentiable):
        derived(text, p=1.5)


def test_the_second_derivative_of_a_ramp_is_refused() -> None:
    once = time_derivative(read("if time < 1 then 0 else time - 1"), derivative_of)
    with pytest.raises(NotDifferentiable) as caught:
        time_derivative(once, derivative_of)
    assert caught.value.expr is once


def test_kinks_may_be_differentiated_once() -> None:
    assert derived("abs(x)") == "noEvent(if x >= 0.0 then der(x) else -der(x))"
    assert derived("max(x, p)") == "noEvent(if x > p then der(x) else 0.0)"
    assert derived("min(x, y)") == "noEvent(if x < y then der(x) else der(y))"


def test_jumping_functions_of_constants_are_harmless() -> None:
    for name in sorted(JUMPS):
        args = (P,) if OPERATORS[name].arity == 1 else (P, const(2.0))
        assert time_derivative(function(name, *args), derivative_of) is ZERO
