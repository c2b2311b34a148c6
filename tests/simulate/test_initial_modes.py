"""Modes at the start: suggested by start values, found for networks of ideal diodes, or explained."""

from __future__ import annotations

import pytest

import acausal
from acausal.errors import InitializationProblem
from acausal.simulate.initialize import initialize

TWO_STABLE = """
model TwoStable "both modes agree with themselves: the start value decides which one holds"
  Real z(start = {start}), x(start = 0, fixed = true);
equation
  z = if z > 1 then 2 + x else 0.5 + x;
  der(x) = z;
end TwoStable;
"""


@pytest.mark.parametrize(("start", "mode"), [("0", 0.0), ("3", 1.0)])
def test_start_values_choose_between_consistent_modes(start: str, mode: float) -> None:
    compiled = acausal.loads(TWO_STABLE.format(start=start)).compile()
    assert initialize(compiled.code, 0.0).evaluator.m.tolist() == [mode]


LADDER = """
model Ladder "ideal diodes between nodes of different voltage, each conducting or blocking"
  constant Integer n = {n};
  Real s[n], v[n + 1], i[n];
equation
  v[1] = 10;
  for k in 1:n loop
    v[k] - v[k + 1] = if s[k] > 0 then 1e-3 * s[k] else s[k];
    i[k] = if s[k] > 0 then s[k] else 1e-3 * s[k];
  end for;
  for k in 1:n - 1 loop
    i[k] = i[k + 1] + (v[k + 1] - 8 * mod(k, 2)) / 10;
  end for;
  i[n] = v[n + 1] / 5;
end Ladder;
"""


@pytest.mark.parametrize("n", [3, 6, 10])
def test_network_of_diodes(n: int) -> None:
    compiled = acausal.loads(LADDER.format(n=n)).compile()
    final = compiled.simulate(stop_time=0.0).final([f"s[{k}]" for k in range(1, n + 1)])
    modes = initialize(compiled.code, 0.0).evaluator.m
    assert [float(value > 0) for value in final.values()] == modes.tolist()


def test_conditions_that_contradict_themselves_are_named() -> None:
    text = """
    model Never
      Real z, x(start = 1, fixed = true);
      Real ok;
    equation
      z = if z > 0 then -1 else 1;
      ok = if x > 0.5 then 1 else 0;
      der(x) = z + ok;
    end Never;
    """
    with pytest.raises(InitializationProblem, match="`z > 0") as caught:
        initialize(acausal.loads(text).compile().code, 0.0)
    assert caught.value.codes == ("initialize.mode-cycle",)
    assert caught.value.diagnostics[0].names == ("z",)


def test_modes_without_a_solution_are_left_for_others() -> None:
    """In the mode that the start value suggests there is no solution; the other mode has one."""
    text = """
    model Other
      Real z(start = 2), x(start = 0, fixed = true);
    equation
      (if z > 1 then z * z + 4 else z * z + z) = 0.25 + x;
      der(x) = z;
    end Other;
    """
    point = initialize(acausal.loads(text).compile().code, 0.0)
    assert point.evaluator.m.tolist() == [0.0]
    z = point.evaluator.guess[0]
    assert z * z + z == pytest.approx(0.25)
