"""Modes at the start: suggested by start values, found for networks of ideal diodes, or explained."""

from __future__ import annotations

import numpy as np
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


BRIDGE = """
model Bridge "ideal diodes without resistance between a source, which floats, and an inductive load"
  constant Integer n = 3;
  constant Real pi = 3.141592653589793;
  Real e[n], p, star, s[2 * n], u[2 * n], i[2 * n], load(start = {load}, fixed = true);
  Boolean off[2 * n];
equation
  for k in 1:n loop
    e[k] - star = 100 * sin(100 * pi * time + {phase} - 2 * pi * (k - 1) / n);
    u[k] = e[k] - p;
    u[n + k] = -e[k];
  end for;
  for k in 1:2 * n loop
    off[k] = s[k] < 0;
    u[k] = if off[k] then s[k] else 0;
    i[k] = if off[k] then 0 else s[k];
  end for;
  sum(i[1:n]) = load;
  sum(i[n + 1:2 * n]) = load;
  0.1 * der(load) = p - 10 * load;
end Bridge;
"""


@pytest.mark.parametrize(("load", "phase"), [(0.0, 0.0), (5.0, 0.3), (5.0, np.pi / 2)])
def test_currents_of_an_ideal_bridge_pass_from_diode_to_diode(load: float, phase: float) -> None:
    """All conducting, all blocking, and two conducting after their voltages cross have no solution."""
    compiled = acausal.loads(BRIDGE.format(load=load, phase=phase)).compile()
    result = compiled.simulate(stop_time=0.02, interval=1e-4)
    angles = 100 * np.pi * result.time + phase
    phases = 100 * np.sin(angles[:, None] - np.arange(3) * 2 * np.pi / 3)
    voltage = phases.max(axis=1) - phases.min(axis=1)
    assert result.values("p") == pytest.approx(voltage, abs=1e-2)
