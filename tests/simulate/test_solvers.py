"""Every solver on one model with loops and events; fixed steps, located events or not; no compiler."""

from __future__ import annotations

import math
from importlib.util import find_spec

import numpy as np
import pytest

import acausal
from acausal.errors import SimulationProblem, UnsupportedProblem, UsageProblem
from acausal.runtime.build import compiler
from acausal.simulate.solvers import FIXED, SOLVERS

SWING = acausal.loads("""
model Swing "A pendulum caught by a spring, beside nonlinear and linear loops"
  Real phi(start = 1, fixed = true), w(start = 0, fixed = true);
  Real y, z(start = 1), a, b, c, d;
equation
  der(phi) = w;
  der(w) = -9.81*sin(phi) - (if phi < 0 then 400*phi else 0) - 0.01*y;
  y^3 + y = phi + sin(time);
  z + exp(0.1*z*y) = 3 + 0.01*w;
  a*(2 + phi) + b = 1;
  3*b + c*phi = a;
  2*c + d = b + phi;
  4*d + a*phi = c;
end Swing;
""").compile()
SWITCH = acausal.loads("""
model Switch "x rises at 1, and at 3 above 0.5"
  Real x(start = 0, fixed = true);
equation
  der(x) = if x > 0.5 then 3 else 1;
end Switch;
""").compile()
ACCURATE = {
    **dict.fromkeys(["auto", "rodas", "cvode", "cvode-adams", "ida", "scikits-odes"], 5e-4),
    "euler": 0.5,
    "ab2": 1e-3,
    "heun": 1e-3,
    "rk3": 1e-4,
    "dopri5": 1e-6,
    "lieuler": 0.5,
    "rosenbrock": 1e-3,
}
EXACT = SWING.simulate(stop_time=2.0, rtol=1e-10, solver="cvode")
NAMES = ("phi", "w", "y", "z", "a", "d")


def test_every_solver_is_tested() -> None:
    assert sorted(ACCURATE) == sorted(SOLVERS)


@pytest.mark.parametrize("solver", SOLVERS)
def test_every_solver_solves_loops_and_events(solver: str) -> None:
    if solver == "scikits-odes" and find_spec("scikits_odes_sundials") is None:
        pytest.skip("scikits-odes is not installed")
    if solver == "rodas" and compiler() is None:
        pytest.skip("no C compiler")
    result = SWING.simulate(stop_time=2.0, solver=solver, step=1e-3)
    assert result.statistics.events == EXACT.statistics.events == 4
    assert result.statistics.solver == (solver if solver != "auto" else result.statistics.solver)
    for name in NAMES:
        off = abs(result.final([name])[name] - EXACT.final([name])[name])
        assert off < ACCURATE[solver] * (1 + abs(EXACT.final([name])[name])), name


@pytest.mark.parametrize("solver", FIXED)
def test_numpy_and_c_take_the_same_steps(solver: str, monkeypatch: pytest.MonkeyPatch) -> None:
    if compiler() is None:
        pytest.skip("no C compiler")
    native = SWING.simulate(stop_time=1.0, interval=0.1, solver=solver, step=2e-3)
    monkeypatch.setenv("ACAUSAL_CC", "none")
    numpy = SWING.simulate(stop_time=1.0, interval=0.1, solver=solver, step=2e-3)
    assert numpy.statistics.steps == native.statistics.steps
    for name in NAMES:
        assert numpy.values(name) == pytest.approx(native.values(name), rel=1e-5, abs=1e-5)


def test_without_a_compiler(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ACAUSAL_CC", "none")
    assert SWITCH.simulate().statistics.solver == "cvode"
    with pytest.raises(UnsupportedProblem) as caught:
        SWITCH.simulate(solver="rodas")
    assert caught.value.codes == ("runtime.compiler",)


def test_missing_backend_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    import sys

    monkeypatch.setitem(sys.modules, "scikits_odes_sundials.cvode", None)
    with pytest.raises(UnsupportedProblem) as caught:
        SWITCH.simulate(solver="scikits-odes")
    assert caught.value.codes == ("simulate.solver-missing",)


@pytest.mark.parametrize("solver", FIXED)
def test_located_event_splits_the_step(solver: str) -> None:
    """The slope changes at x = 0.5, in the middle of a step; all methods are exact on straight lines."""
    located = SWITCH.simulate(solver=solver, step=0.2, events="locate")
    assert located.final(["x"])["x"] == pytest.approx(0.5 + 3 * 0.5, abs=1e-8)
    assert located.statistics.events == 1
    at_steps = SWITCH.simulate(solver=solver, step=0.2, events="step")
    assert at_steps.final(["x"])["x"] == pytest.approx(0.6 + 3 * 0.4, abs=1e-8)
    times = at_steps.time[1:][np.diff(at_steps.time) == 0]
    assert times == pytest.approx([0.6])


def test_fixed_steps_are_counted_and_timed() -> None:
    result = SWING.simulate(stop_time=0.1, solver="heun", step=1e-3)
    assert result.statistics.steps == 100
    assert result.statistics.max_step_seconds is not None
    assert 0 < result.statistics.max_step_seconds < 60
    assert SWING.simulate(stop_time=0.1, solver="cvode").statistics.max_step_seconds is None


def test_settings_that_cannot_be() -> None:
    for wrong in ({"step": -1.0}, {"step": math.inf}, {"events": "sometimes"}, {"solver": "rodax"}):
        with pytest.raises(UsageProblem):
            SWITCH.simulate(**wrong)  # type: ignore[arg-type]


def test_unstable_fixed_step_is_told() -> None:
    model = "model M Real x(start = 1, fixed = true); equation der(x) = -x^3; end M;"
    with pytest.raises(SimulationProblem):
        acausal.loads(model).compile().simulate(stop_time=100.0, interval=1.0, solver="euler", step=10.0)


def test_states_that_hold_the_solver_back() -> None:
    """One fast state among slow ones."""
    model = """
    model M
      Real slow(start = 1, fixed = true), fast(start = 1, fixed = true);
    equation
      der(slow) = -0.01*slow;
      der(fast) = -100*(fast - sin(50*time));
    end M;
    """
    result = acausal.loads(model).compile().simulate(stop_time=10.0, solver="rodas")
    costs = result.state_costs
    assert [cost.state for cost in costs] == ["fast", "slow"]
    assert costs[0].influence > 0.95
    assert sum(cost.influence for cost in costs) == pytest.approx(1.0)
    assert sum(cost.error_failures for cost in costs) == result.statistics.rejected


def test_two_crossings_between_two_looks_are_found() -> None:
    """A root that dips below zero for a short time between the points at which it is looked at."""
    model = """
    model M
      Real x(start = 0, fixed = true), hits(start = 0, fixed = true);
    equation
      der(x) = 1;
      der(hits) = if (x - 0.513)^2 < 1e-4 then 1 else 0;
    end M;
    """
    result = acausal.loads(model).compile().simulate(stop_time=1.0, interval=0.1)
    assert result.statistics.events == 2
    assert result.final(["hits"])["hits"] == pytest.approx(0.02, abs=1e-7)


@pytest.mark.parametrize("seconds", [1, pytest.param(10, marks=pytest.mark.slow)])
def test_a_thousand_events_a_second_none_missed_or_doubled(seconds: int) -> None:
    model = """
    model M "The sign of a sine changes every millisecond"
      Real x(start = 1, fixed = true), v(start = 0, fixed = true), z;
    equation
      der(x) = v;
      der(v) = -(1000*3.141592653589793)^2*x;
      z = if x > 0 then 1 else -1;
    end M;
    """
    result = acausal.loads(model).compile().simulate(stop_time=seconds, interval=1e-3, rtol=1e-8)
    assert result.statistics.events == 1000 * seconds
    times = result.time[1:][np.diff(result.time) == 0]
    assert times == pytest.approx((np.arange(1000 * seconds) + 0.5) * 1e-3, abs=1e-6 * seconds)


@pytest.mark.skipif(compiler() is None, reason="no C compiler")
def test_slopes_that_only_the_time_changes_keep_the_order() -> None:
    model = acausal.loads("""
model Driven "No state acts on another: the Jacobian has no entries"
  Real x(start = 0, fixed = true);
equation
  der(x) = cos(time);
end Driven;
""").compile()
    errors = [
        abs(model.simulate(stop_time=2.0, interval=h, solver="rosenbrock").values("x")[-1] - math.sin(2.0))
        for h in (0.02, 0.01)
    ]
    assert errors[0] == pytest.approx(4 * errors[1], rel=0.05)
    assert model.simulate(stop_time=20.0, interval=20.0, solver="rodas").statistics.steps < 100
