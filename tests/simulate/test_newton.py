"""Robust solution of nonlinear blocks: far starts, steep and flat functions, homotopy, bounded work."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import acausal
from acausal.errors import InitializationProblem
from acausal.simulate import continuation
from acausal.simulate.initialize import initialize
from acausal.simulate.matrices import Vector
from acausal.simulate.newton import Solution, System, solve

Scalar = Callable[[float], tuple[float, float]]


def scalar(of: Scalar) -> Callable[[Vector], tuple[Vector, Vector]]:
    def system(z: Vector) -> tuple[Vector, Vector]:
        value, slope = of(float(z[0]))
        return np.array([value]), np.array([[slope]])

    return system


@pytest.mark.parametrize("start", [-50.0, -1.0, 1e-30, 0.0, 3.0, 1e6])
def test_square_root_with_an_infinite_slope_at_zero(start: float) -> None:
    """sign(z) sqrt|z| = 2 has its only solution at 4; at 0 the slope is infinite and residuals look small."""

    def root(z: float) -> tuple[float, float]:
        with np.errstate(divide="ignore"):
            return float(np.sign(z) * np.sqrt(abs(z)) - 2.0), float(np.divide(0.5, np.sqrt(abs(z))))

    found = solve(scalar(root), np.array([start]), np.ones(1))
    assert found.converged
    assert found.z == pytest.approx([4.0], rel=1e-6)


@pytest.mark.parametrize("start", [-20.0, -3.0, 0.0, 50.0, 300.0])
def test_exponential(start: float) -> None:
    found = solve(scalar(lambda z: (np.exp(z) - 5.0, np.exp(z))), np.array([start]), np.ones(1))
    assert found.converged
    assert found.z == pytest.approx([np.log(5.0)])


@given(x=st.floats(-30, 30), y=st.floats(-30, 30))
@settings(deadline=None, max_examples=60)
def test_rosenbrock_from_anywhere(x: float, y: float) -> None:
    def system(z: Vector) -> tuple[Vector, Vector]:
        residual = np.array([10 * (z[1] - z[0] ** 2), 1 - z[0]])
        return residual, np.array([[-20 * z[0], 10.0], [-1.0, 0.0]])

    found = solve(system, np.array([x, y]), np.ones(2))
    assert found.converged
    assert found.z == pytest.approx([1.0, 1.0])


def test_no_solution_ends_within_the_limit_and_reports_the_residual() -> None:
    calls: list[float] = []

    def parabola(z: float) -> tuple[float, float]:
        calls.append(z)
        return z * z + 1.0, 2 * z

    found = solve(scalar(parabola), np.array([3.0]), np.ones(1))
    assert not found.converged
    assert len(calls) < 5000
    assert continuation.follow(scalar(parabola), np.array([3.0]), np.ones(1)) is None
    assert len(calls) < 200_000


def wave(z: float) -> tuple[float, float]:
    """Rises to a crest and falls into a trough that is above zero; its only zero is left of -2."""
    return z**3 / 3 - z + 2.0, z * z - 1.0


def test_homotopy_follows_a_path_where_newton_is_trapped() -> None:
    """z exp(-z^2) + z/100 = 0.35 from far right: the residual has a valley at the crest's foot."""

    def trap(z: float) -> tuple[float, float]:
        return np.arctan(20 * (z - 1)) + 0.01 * z, 20 / (1 + (20 * (z - 1)) ** 2) + 0.01

    found = continuation.follow(scalar(trap), np.array([80.0]), np.ones(1))
    assert found is not None
    assert abs(trap(float(found.z[0]))[0]) < 1e-8


def test_path_that_turns_back_is_given_up() -> None:
    found = continuation.follow(scalar(wave), np.array([2.0]), np.ones(1))
    assert found is None or abs(wave(float(found.z[0]))[0]) < 1e-8


ORIFICES = """
model Orifices "a net of turbulent resistances between two pressures, without volumes, guesses far away"
  constant Integer n = 12;
  Real p[n](each start = {start}, each nominal = 1e5), q[n + 1](each nominal = 1e-5), leak[n];
  Real dp[n + 1];
equation
  dp[1] = 2e7 - p[1];
  for i in 2:n loop dp[i] = p[i - 1] - p[i]; end for;
  dp[n + 1] = p[n] - 1e5;
  for i in 1:n + 1 loop
    q[i] = 1e-7 * noEvent(if dp[i] >= 0 then sqrt(dp[i]) else -sqrt(-dp[i]));
  end for;
  for i in 1:n loop
    leak[i] = 1e-8 * noEvent(if p[i] >= 1e5 then sqrt(p[i] - 1e5) else -sqrt(1e5 - p[i]));
    q[i] = q[i + 1] + leak[i];
  end for;
end Orifices;
"""


@pytest.mark.parametrize("start", ["1e7", "0", "1e5", "-4e6", "3e8"])
def test_net_of_square_roots_from_far_guesses(start: str) -> None:
    result = acausal.loads(ORIFICES.format(start=start)).compile().simulate(stop_time=0.0)
    p = [result.final([f"p[{i}]"])[f"p[{i}]"] for i in range(1, 13)]
    assert all(a > b for a, b in pairwise(p))
    assert 1e5 < p[-1] < p[0] < 2e7
    reference = acausal.loads(ORIFICES.format(start="1e7")).compile().simulate(stop_time=0.0)
    assert p[5] == pytest.approx(reference.final(["p[6]"])["p[6]"], rel=1e-6)


BRIDGE = """
model Bridge "four exponential diodes into a grounded load, fed by a floating sine"
  parameter Real Is = 1e-12, Vt = 0.026, R = 100;
  Real a(start = {start}), b, plus(start = {start}), i1, i2, i3, i4, source;
equation
  a - b = 10 * sin(6.28 * time + 1.2);
  i1 = Is * (exp((a - plus) / Vt) - 1);
  i2 = Is * (exp((b - plus) / Vt) - 1);
  i3 = Is * (exp(-a / Vt) - 1);
  i4 = Is * (exp(-b / Vt) - 1);
  i1 + i2 = plus / R;
  i3 + i4 = plus / R;
  source + i3 = i1;
end Bridge;
"""


@pytest.mark.parametrize("start", ["0", "5", "-3"])
def test_diode_bridge(start: str) -> None:
    result = acausal.loads(BRIDGE.format(start=start)).compile().simulate(stop_time=1.0, interval=0.01)
    feed = np.abs(10 * np.sin(6.28 * result.time + 1.2))
    load = result.values("plus")
    assert np.all(load > -1e-6)
    assert np.max(np.abs(load - np.maximum(feed - 1.3, 0.0))) < 0.6


def test_homotopy_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    """With Newton's method allowed to fail at the start value, the path leads on and a warning says so."""
    text = "model Cube Real z(start = 3); equation z ^ 3 + z = 2 + time; end Cube;"
    compiled = acausal.loads(text).compile()
    assert initialize(compiled.code, 0.0).warnings == ()

    def stuck(system: System, start: Vector, nominal: Vector, limit: int) -> Solution:
        del nominal, limit
        return Solution(start, False, system(start)[0], 0)

    monkeypatch.setattr("acausal.simulate.block_solvers.newton.solve", stuck)
    result = compiled.simulate(stop_time=0.0)
    assert result.final(["z"])["z"] == pytest.approx(1.0)
    assert [w.code for w in result.warnings] == ["initialize.homotopy"]
    assert result.warnings[0].names == ("z",)


def test_failure_names_values_and_worst_equations() -> None:
    text = """
    model NoRoot
      Real a(start = 1), b(start = 2);
    equation
      a * a + b * b = -1;
      a * b * b = 3 + time;
    end NoRoot;
    """
    with pytest.raises(
        InitializationProblem, match=r"off by .* at .*a = .*at time 0 s.*equations involved"
    ) as e:
        initialize(acausal.loads(text).compile().code, 0.0)
    assert e.value.codes[0] == "simulate.no-solution"
    assert set(e.value.diagnostics[0].names) == {"a", "b"}
    assert "began at" in e.value.diagnostics[0].hint
