"""Linearity: what is taken apart is exactly linear, and what is not is refused."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from acausal.symbolic.expressions.evaluate import evaluate
from acausal.symbolic.expressions.expr import ZERO, add, der, mul, sym
from acausal.symbolic.expressions.linear import linear_coefficient, linear_parts, slopes
from acausal.symbolic.expressions.simplify import collect_terms
from acausal.symbolic.expressions.text import to_text
from tests.symbolic.build import read

X, Y = sym("x"), sym("y")


def parts(text: str, *, frozen: bool = False) -> tuple[str, str] | None:
    found = linear_coefficient(read(text), X, frozen=frozen)
    return None if found is None else (to_text(found[0]), to_text(found[1]))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("x", ("1.0", "0.0")),
        ("y", ("0.0", "y")),
        ("2*x + y", ("2.0", "y")),
        ("-(x - y)*k/m", ("-k / m", "-k * (-y) / m")),
        ("(x + 1)*(y + 2)", ("y + 2.0", "y + 2.0")),
        ("if y > 0 then 2*x else y", ("if y > 0.0 then 2.0 else 0.0", "if y > 0.0 then 0.0 else y")),
        ("noEvent(3*x + y)", ("3.0", "y")),
        ("der(x)", ("0.0", "der(x)")),
    ],
)
def test_linear_expressions(text: str, expected: tuple[str, str]) -> None:
    found = linear_coefficient(read(text), X)
    assert found is not None
    values = {"x": 0.7, "y": 1.3, "k": 2.1, "m": 3.2}
    memo = {der(X): 4.0}
    whole = evaluate(read(text), values.get, dict(memo))
    a, b = (evaluate(part, values.get, dict(memo)) for part in found)
    assert isinstance(a, int | float)
    assert isinstance(b, int | float)
    assert whole == pytest.approx(a * 0.7 + b)
    if "k" not in text:
        assert parts(text) == expected


@pytest.mark.parametrize(
    "text", ["x*x", "x^2", "sin(x)", "1/x", "y/(1 + x)", "if x > 0 then x else 0", "max(x, y)", "x*(x + y)"]
)
def test_nonlinear_expressions(text: str) -> None:
    assert linear_coefficient(read(text), X) is None
    assert slopes(read(text), frozen=False)[X] is None


def test_a_condition_is_known_where_its_relation_is_a_mode() -> None:
    text = "if x > 0 then 2*x else x + y"
    assert parts(text) is None
    assert parts(text, frozen=True) == ("if x > 0.0 then 2.0 else 1.0", "if x > 0.0 then 0.0 else y")
    assert parts(f"noEvent({text})", frozen=True) is None


def test_a_condition_without_event_is_no_mode() -> None:
    text = "if noEvent(x > 0) then 2*x else x + y"
    assert parts(text, frozen=True) is None
    assert slopes(read(text))[X] is None


def test_several_leaves() -> None:
    found = linear_parts(read("2*x + k*y + c"), [X, Y])
    assert found is not None
    assert [to_text(a) for a in found[0]] == ["2.0", "k"]
    assert to_text(found[1]) == "c"
    assert linear_parts(read("x*y"), [X, Y]) is None


def test_slopes_of_every_leaf_by_itself() -> None:
    found = slopes(read("a*x + y*der(x) - sin(z) + (if w > 0 then y else 0)"))
    texts = {to_text(leaf): None if a is None else to_text(a) for leaf, a in found.items()}
    assert texts == {
        "a": "x",
        "x": "a",
        "y": "der(x) + (if w > 0.0 then 1.0 else 0.0)",
        "der(x)": "y",
        "z": None,
    }


@given(st.lists(st.tuples(st.integers(-3, 3), st.sampled_from("xyz")), min_size=1, max_size=8))
def test_slopes_agree_with_the_coefficient(terms: list[tuple[int, str]]) -> None:
    expr = add(*[mul(read(float(a)), sym(name)) for a, name in terms])
    for name in "xyz":
        total = sum(a for a, other in terms if other == name)
        found = linear_coefficient(expr, sym(name))
        assert found is not None
        assert evaluate(found[0], dict.fromkeys("xyz", 1.0).get) == total
        slope = slopes(expr).get(sym(name), ZERO)
        assert slope is not None
        assert evaluate(slope, dict.fromkeys("xyz", 1.0).get) == total


@given(st.lists(st.tuples(st.integers(-3, 3), st.sampled_from("xyz")), min_size=1, max_size=8))
def test_collecting_terms_keeps_the_value(terms: list[tuple[int, str]]) -> None:
    expr = add(*[mul(read(float(a)), sym(name)) for a, name in terms])
    values = {"x": 1.7, "y": 0.3, "z": -2.2}
    collected = collect_terms(expr)
    assert evaluate(collected, values.get) == pytest.approx(evaluate(expr, values.get))
    sums = {name: sum(a for a, other in terms if other == name) for name in "xyz"}
    assert (collected is ZERO) == (not any(sums.values()))


def test_a_long_sum_and_a_deep_nest_are_no_problem() -> None:
    long = add(*[mul(read(2.0), sym(f"v{i}")) for i in range(20000)], X)
    assert len(slopes(long)) == 20001
    deep = X
    for _ in range(20000):
        deep = mul(read("k"), add(deep, Y))
    assert linear_coefficient(deep, sym("q")) == (ZERO, deep)
