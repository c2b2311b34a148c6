"""Parameters: an order of evaluation, values, cycles, missing values."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

import acausal
from acausal.errors import LookupProblem, TypeProblem
from acausal.symbolic.parameters import order_parameters, parameter_values
from tests.symbolic.build import model


def test_values_follow_the_order_of_use() -> None:
    known = parameter_values(model("x = c", parameters={"c": "a + b", "b": "2*a", "a": 3.0}))
    assert known.order == ("a", "b", "c")
    assert known.values == {"a": 3.0, "b": 6.0, "c": 9.0}


@given(st.permutations(range(12)))
def test_each_one_comes_after_what_it_uses(order: list[int]) -> None:
    parameters: dict[str, str | float | None] = {
        f"p{i}": f"p{i - 1} + p{i // 2}" if i > 1 else "1" for i in order
    }
    found = order_parameters(model("x = p11", parameters=parameters))
    assert sorted(found) == sorted(parameters)
    for i in range(2, 12):
        assert found.index(f"p{i - 1}") < found.index(f"p{i}")


def test_a_cycle_names_its_members_and_lines() -> None:
    parameters: dict[str, str | float | None] = {"a": "2*b", "b": "c + 1", "c": "a", "d": "a"}
    with pytest.raises(LookupProblem) as caught:
        parameter_values(model("x = d", parameters=parameters))
    assert set(caught.value.codes) == {"parameter.cyclic"}
    assert [d.names for d in caught.value.diagnostics] == [("a", "b", "c")] * 3
    assert "a -> b -> c -> a" in caught.value.diagnostics[0].message
    assert [d.span.line for d in caught.value.diagnostics if d.span] == [3, 4, 5]


def test_a_parameter_that_uses_itself() -> None:
    with pytest.raises(LookupProblem, match="a -> a"):
        order_parameters(model("x = a", parameters={"a": "a + 1"}))


def test_a_missing_value_is_an_error() -> None:
    with pytest.raises(TypeProblem) as caught:
        parameter_values(model("x = a + b", parameters={"a": None, "b": None}))
    assert caught.value.codes == ("parameter.no-value", "parameter.no-value")


def test_a_start_value_is_used_with_a_warning() -> None:
    flat = model("x = a", parameters={"a": 2.0}, free_parameters=["a"])
    assert parameter_values(flat).values == {}
    fixed = model("x = a", parameters={"a": 2.0})
    assert parameter_values(fixed).warnings == ()


def test_a_chain_of_ten_thousand() -> None:
    parameters: dict[str, str | float | None] = {f"p{i}": f"p{i + 1}" for i in range(10000)}
    known = parameter_values(model("x = p0", parameters={**parameters, "p10000": 7.0}))
    assert known.values["p0"] == 7.0


def test_what_cannot_be_computed_yet_has_no_value() -> None:
    known = parameter_values(model("x = b", parameters={"a": 0.0, "b": "1/a", "c": "b + 1"}))
    assert "b" not in known.values
    assert "c" not in known.values


@pytest.mark.parametrize(("value", "word"), [(-1.0, "below"), (11.0, "above")])
def test_a_value_outside_min_and_max_is_refused(value: float, word: str) -> None:
    text = f"model M parameter Real k(min = 0, max = 10) = {value}; Real x; equation x = k*time; end M;"
    with pytest.raises(TypeProblem, match=f"`k` = {value:g} is {word} its m") as caught:
        acausal.loads(text).compile()
    assert caught.value.codes == ("parameter.out-of-range",)
    assert caught.value.diagnostics[0].names == ("k",)


def test_the_start_of_a_free_parameter_may_use_a_later_one() -> None:
    text = """model M
      parameter Real p(fixed = false, start = 2*q);
      parameter Real q = r + 3;
      parameter Real r = 1 "Needed by q, and by p only through it";
    initial equation
      p^2 = 64;
    end M;"""
    found = acausal.loads(text).compile().simulate().parameters
    assert found["p"] == pytest.approx(8)
    with pytest.raises(LookupProblem) as caught:
        acausal.loads(text.replace("r = 1", "r = p")).compile()
    assert set(caught.value.diagnostics[0].names) == {"p", "q", "r"}
