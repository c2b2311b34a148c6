"""Too many and too few conditions at the start: which compete, which are assumed, what to change."""

from __future__ import annotations

from typing import cast

import pytest

import acausal
from acausal.errors import InitializationProblem

OVER = """model Over
  Real x(start = 2, fixed = true), y(start = {y}, fixed = true), v(start = 0);
  Real w(start = 1), free(start = 7);
equation
  der(x) = v;
  der(v) = -x;
  y = 2 * x;
  w = x + y;
  der(free) = -free;
end Over;"""

STEADY = """model Steady
  Real x(start = 2, fixed = true), v(start = 0, fixed = true);
initial equation
  der(x) = 0;
  x + v = {sum};
equation
  der(x) = v;
  der(v) = -x;
end Steady;"""


def test_conditions_that_agree_are_accepted() -> None:
    assert acausal.loads(OVER.format(y=4)).compile().simulate()["y"].values[0] == 4
    assert acausal.loads(STEADY.format(sum=2)).compile().simulate()["x"].values[0] == 2


def test_conditions_that_compete_are_named_with_their_lines() -> None:
    with pytest.raises(InitializationProblem) as caught:
        acausal.loads(OVER.format(y=5)).compile().simulate()
    first, other = caught.value.diagnostics
    assert "contradict the start value `y` = 5" in first.message
    assert "one condition too many beside the start value `x` = 2 (<string>:2)" in first.message
    assert first.hint == "remove `fixed = true` from one of `y`, `x`, or make the values agree"
    assert "the start value `x` = 2" in other.message
    assert [d.span.line for d in caught.value.diagnostics if d.span] == [2, 2]


def test_initial_equations_compete_with_start_values() -> None:
    with pytest.raises(InitializationProblem) as caught:
        acausal.loads(STEADY.format(sum=3)).compile().simulate()
    assert caught.value.codes == ("initialize.inconsistent",) * 3
    assert [d.span.line for d in caught.value.diagnostics if d.span] == [2, 4, 5]
    hint = caught.value.diagnostics[0].hint
    assert "remove `fixed = true` from `x`, remove one of the initial equations" in hint


def test_a_start_value_against_the_equations_alone() -> None:
    text = "model M Real c(start = 4, fixed = true); equation c = 3 * time + {at}; end M;"
    with pytest.raises(InitializationProblem, match="the equations alone determine this") as caught:
        acausal.loads(text.format(at=1)).compile().simulate()
    assert caught.value.diagnostics[0].hint == "remove `fixed = true` from `c`, or make the values agree"
    acausal.loads(text.format(at=4)).compile().simulate()


def test_the_report_counts_conditions() -> None:
    explanation = acausal.loads(OVER.format(y=4)).compile().explain()
    data = cast("dict[str, object]", explanation.to_json()["initial_problem"])
    assert data["needed"] == 3
    assert data["assumed"] == ["v", "free"]
    assert data["unused"] == ["w"]
    (surplus,) = cast("list[dict[str, dict[str, object]]]", data["surplus"])
    assert surplus["condition"]["start"] == "y"
    assert "1 fixed start value, 2 start values assumed though not fixed" in explanation.text
    assert (
        "one too many: the start value `y` = 4 (<string>:2) must agree with the start value"
        in explanation.text
    )
    assert "start values not used, because the rest determines these: w" in explanation.text


def test_a_loop_without_solution_names_the_starts_it_uses() -> None:
    text = """model M
      Real x(start = {x}, fixed = {fixed}), y(start = 0.5), v(start = 0);
    equation
      der(x) = v;
      der(v) = -x + y;
      x^2 + y^2 + exp(y) * 0 + abs(y) = 1;
    end M;"""
    with pytest.raises(InitializationProblem) as caught:
        acausal.loads(text.format(x=3, fixed="true")).compile().simulate()
    assert "the block uses the start values x = 3 (fixed)" in caught.value.diagnostics[0].hint
    with pytest.raises(InitializationProblem) as caught:
        acausal.loads(text.format(x=3, fixed="false")).compile().simulate()
    assert "x = 3 (not fixed, but assumed)" in caught.value.diagnostics[0].hint


def test_many_solutions_are_no_secret() -> None:
    text = """model M Real x(start = 3), y;
    initial equation der(x) = 0; der(y) = 0;
    equation der(x) = y - x; der(y) = x - y; end M;"""
    (warning,) = acausal.loads(text).compile().simulate().warnings
    assert warning.code == "initialize.not-unique"
    assert "do not say what `y` is" in warning.message
    assert "`y` = ..." in warning.hint
    single = text.replace("der(y) = 0", "y = 2")
    assert not acausal.loads(single).compile().simulate().warnings


def test_values_outside_their_range_are_told() -> None:
    text = "model M Real x(min = low, max = 4, start = {}, fixed = true); parameter Real low = 1; "
    model = text + "equation der(x) = 0; end M;"
    for start, says in (("0", "`x` = 0 is below 1"), ("5", "`x` = 5 is above 4")):
        (warning,) = acausal.loads(model.format(start)).compile().simulate().warnings
        assert warning.code == "initialize.out-of-range"
        assert says in warning.message
    assert not acausal.loads(model.format("4 + 1e-9")).compile().simulate().warnings
