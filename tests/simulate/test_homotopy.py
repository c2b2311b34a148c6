"""`homotopy(actual, simplified)`: a run takes the actual value, its start may use the simplified one."""

from __future__ import annotations

import math

import pytest

import acausal
from acausal.errors import InitializationProblem

ROOT = 50 + 5 * math.sqrt(math.log(2))
TRAP = """model Trap "At x = 0 the residual is 0.5 and its slope 1e-43: no local search gets anywhere"
  parameter Real to = 50;
  Real x(start = 0);
  Real y(start = 0, fixed = true);
equation
  homotopy(actual = 0.5 - exp(-((x - 50) / 5)^2), simplified = x - to) = 0;
  der(y) = x - y;
end Trap;"""


def test_the_start_is_found_from_the_simplified_equation() -> None:
    result = acausal.loads(TRAP).compile().simulate()
    assert result["x"].values[0] == pytest.approx(ROOT, abs=1e-9)
    (warning,) = [w for w in result.warnings if w.code == "initialize.homotopy-operator"]
    assert "x" in warning.names
    assert warning.span is not None
    assert warning.span.line == 6


def test_without_the_operator_the_same_start_fails() -> None:
    text = TRAP.replace("homotopy(actual = ", "(").replace(", simplified = x - to)", ")")
    with pytest.raises(InitializationProblem) as caught:
        acausal.loads(text).compile().simulate()
    assert caught.value.codes == ("simulate.no-solution",)


def test_it_is_not_used_where_the_actual_equation_can_be_solved() -> None:
    result = acausal.loads(TRAP).compile().simulate(start={"x": 54.0})
    assert not result.warnings
    assert result["x"].values[-1] == pytest.approx(ROOT)


def test_a_path_that_ends_is_reported_with_both_reasons() -> None:
    """From x = -30 the path of solutions runs to infinity as lambda approaches 1."""
    with pytest.raises(InitializationProblem) as caught:
        acausal.loads(TRAP).compile({"to": -30}).simulate()
    first, *_, last = caught.value.diagnostics
    assert first.code == "simulate.no-solution"
    assert last.code == "initialize.homotopy-failed"
    assert "of 1" in last.message
    assert last.span is not None
    assert last.span.line == 6


def test_simplified_equations_without_solution_are_reported() -> None:
    text = TRAP.replace("simplified = x - to", "simplified = x^2 + 1")
    with pytest.raises(InitializationProblem, match="no solution either") as caught:
        acausal.loads(text).compile().simulate()
    assert caught.value.diagnostics[-1].code == "initialize.homotopy-failed"


ALIAS = """model Alias "Actually y = x is an alias; simplified, y is a constant"
  Real x(start = 0);
  Real y;
  Real z(start = 2, fixed = true);
equation
  y = homotopy(x, 50);
  homotopy(0.5 - exp(-((x - 50) / 5)^2), x - y) = 0;
  der(z) = -y * z;
end Alias;"""


def test_an_alias_of_the_run_may_be_none_on_the_path() -> None:
    compiled = acausal.loads(ALIAS).compile()
    assert [alias.name for alias in compiled.causal.aliases] == ["y"]
    result = compiled.simulate(stop_time=0.1)
    assert result["y"].values[0] == pytest.approx(ROOT, abs=1e-9)


def test_overrides_reach_the_path() -> None:
    """Another start value of the run counts on the path too, and so does a parameter of it."""
    compiled = acausal.loads(TRAP).compile()
    result = compiled.simulate(start={"x": 1.5}, parameters={"to": 51})
    assert result["x"].values[0] == pytest.approx(ROOT, abs=1e-9)


def test_arrays_and_types() -> None:
    ok = "model M Real x[2] = homotopy({time, 2}, simplified = {1, 1}); end M;"
    result = acausal.loads(ok).compile().simulate()
    assert result["x[1]"].values[-1] == 1
    for wrong, code in (("homotopy({1, 2}, 1)", "type.array-size"), ("homotopy(true, 1)", "type.homotopy")):
        with pytest.raises(acausal.AcausalError) as caught:
            acausal.loads(f"model M Real x[2] = {wrong}; end M;").check()
        assert caught.value.codes == (code,)
