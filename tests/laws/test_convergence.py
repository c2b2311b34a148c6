"""Order of convergence, stability and energy drift of every integrator, on problems with known solutions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import acausal
from acausal.simulate.solvers import FIXED

ORDERS = {"euler": 1, "ab2": 2, "heun": 2, "rk3": 3, "dopri5": 5, "lieuler": 1, "rosenbrock": 2}

CURVED = acausal.loads("""
model Curved "exp(sin t), 1/(1 + t) and a rotation, one depending on the other"
  Real x(start = 1, fixed = true), y(start = 1, fixed = true), a(start = 1, fixed = true);
  Real b(start = 0, fixed = true);
equation
  der(x) = x*cos(time);
  der(y) = -y^2;
  der(a) = -b*(1 + time)*y;
  der(b) = a*(1 + time)*y;
end Curved;
""").compile()
DECAY = acausal.loads("""
model Decay
  parameter Real k = 1;
  Real x(start = 1, fixed = true);
equation
  der(x) = -k*x;
end Decay;
""").compile()
OSCILLATOR = acausal.loads("""
model Oscillator
  parameter Real w = 1;
  Real x(start = 1, fixed = true), v(start = 0, fixed = true);
equation
  der(x) = v;
  der(v) = -w^2*x;
end Oscillator;
""").compile()
IMPACT = acausal.loads("""
model Impact "A mass hits a spring, which it touches below 0"
  parameter Real w = 1, s_0 = 0.1;
  Real s, v(start = -1, fixed = true);
initial equation
  s = s_0;
equation
  der(s) = v;
  der(v) = w^2*noEvent(max(-s, 0));
end Impact;
""").compile()


def error(result: acausal.Result) -> float:
    """Largest error at the output points."""
    t = result.time
    exact = {"x": np.exp(np.sin(t)), "y": 1 / (1 + t), "a": np.cos(t), "b": np.sin(t)}
    return max(float(np.abs(result.values(name) - value).max()) for name, value in exact.items())


def slope(steps: list[float], errors: list[float]) -> float:
    return float(np.polyfit(np.log(steps), np.log(errors), 1)[0])


def test_every_fixed_step_solver_has_an_order() -> None:
    assert sorted(ORDERS) == sorted(FIXED)


@pytest.mark.parametrize("solver", FIXED)
def test_order_of_convergence(solver: str) -> None:
    steps = [0.1, 0.05, 0.025, 0.0125]
    runs = [CURVED.simulate(stop_time=2.0, interval=0.5, solver=solver, step=step) for step in steps]
    errors = [error(run) for run in runs]
    assert -0.3 < slope(steps, errors) - ORDERS[solver] < 0.8, errors


def test_order_of_the_method_with_variable_steps() -> None:
    """Steps that `max_step` limits are made by RODAS5P where RODAS3 is not good enough: order 5."""
    errors, evaluations = limited(5)
    assert 4.5 < slope(STEPS, errors) < 6.0, errors
    assert min(evaluations) > 7.0


def test_order_where_the_tolerance_asks_for_little() -> None:
    """RODAS3 with steps that only `max_step` limits: order 3, three evaluations."""
    errors, evaluations = limited(3)
    assert 2.7 < slope(STEPS, errors) < 3.7, errors
    assert max(evaluations[1:]) < 4.0


STEPS = [0.2, 0.1, 0.05, 0.025]


def limited(order: int) -> tuple[list[float], list[float]]:
    """Errors, and evaluations in a step, at a tolerance that only order 5 meets, or that anything does."""
    errors: list[float] = []
    evaluations: list[float] = []
    for step in STEPS:
        rtol = 0.5 if order == 3 else 0.02 * step**3
        run = CURVED.simulate(stop_time=2.0, interval=0.5, solver="rodas", rtol=rtol, max_step=step)
        errors.append(error(run))
        evaluations.append(run.statistics.rhs_evaluations / run.statistics.steps)
    return errors, evaluations


@pytest.mark.parametrize("solver", FIXED)
def test_output_between_steps_is_interpolated(solver: str) -> None:
    fine = CURVED.simulate(stop_time=2.0, interval=0.013, solver=solver, step=0.01)
    coarse = CURVED.simulate(stop_time=2.0, interval=0.01, solver=solver, step=0.01)
    assert error(fine) < 1.5 * error(coarse) + 1e-7


def test_variable_steps_follow_the_tolerance() -> None:
    """An error estimate of order 4 means steps of rtol^(1/5), and so an error of about rtol."""
    errors: list[float] = []
    steps: list[int] = []
    for rtol in (1e-4, 1e-6, 1e-8, 1e-10):
        result = CURVED.simulate(stop_time=2.0, rtol=rtol, solver="rodas")
        steps.append(result.statistics.steps)
        errors.append(abs(result.final(["a"])["a"] - math.cos(2.0)) / rtol)
    assert max(errors) < 20.0
    assert steps[-1] / steps[0] < 2.0 * 1e6 ** (1 / 5)


def test_dense_output_is_as_good_as_the_steps() -> None:
    result = CURVED.simulate(stop_time=2.0, interval=0.001, rtol=1e-8, solver="rodas")
    assert result.statistics.steps < 200
    off = np.abs(result.values("x") - np.exp(np.sin(result.time)))
    assert off.max() < 1e-6


@pytest.mark.parametrize(
    ("solver", "limit"), [("euler", 2.0), ("ab2", 1.0), ("heun", 2.0), ("rk3", 2.5127), ("dopri5", 3.3066)]
)
def test_stability_limit_on_the_real_axis(solver: str, limit: float) -> None:
    """x' = -k x stays bounded up to h k = limit, and grows beyond."""
    for factor, bounded in ((0.97, True), (1.03, False)):
        result = DECAY.simulate(
            stop_time=400.0, interval=400.0, solver=solver, step=1.0, parameters={"k": factor * limit}
        )
        assert (abs(result.final(["x"])["x"]) < 1.0) is bounded


@given(st.floats(2.0, 9.0))
@pytest.mark.parametrize("solver", ["lieuler", "rosenbrock"])
def test_implicit_methods_damp_what_is_stiff(solver: str, exponent: float) -> None:
    """L-stable: one step takes x' = -k x to nearly nothing, however large h k is."""
    k = 10.0**exponent
    result = DECAY.simulate(stop_time=4.0, interval=4.0, solver=solver, step=1.0, parameters={"k": k})
    assert abs(result.final(["x"])["x"]) < 1e-4


@pytest.mark.parametrize("solver", ["lieuler", "rosenbrock"])
@pytest.mark.parametrize("pulsation", [30.0, 100.0, 300.0, 1e4])
def test_implicit_methods_add_no_energy_to_impacts(solver: str, pulsation: float) -> None:
    """A contact that closes within a step, however deep and stiff, throws back no faster than it was hit."""
    for start in np.linspace(0.01, 0.2, 8):
        result = IMPACT.simulate(
            stop_time=1.0, interval=0.01, solver=solver, step=0.01, parameters={"w": pulsation, "s_0": start}
        )
        assert np.abs(result.values("v")).max() < 1.02


@pytest.mark.parametrize(("solver", "drift"), [("rodas", 2e-3), ("dopri5", 1e-4), ("cvode", 5e-2)])
def test_energy_drift(solver: str, drift: float) -> None:
    """100 periods of an oscillation."""
    result = OSCILLATOR.simulate(stop_time=200 * math.pi, interval=math.pi, solver=solver, step=math.pi / 50)
    energy = result.values("x") ** 2 + result.values("v") ** 2
    assert np.abs(energy - 1.0).max() < drift


@pytest.mark.parametrize("solver", ["rodas", *FIXED])
@pytest.mark.parametrize("compiled", [False, True])
def test_same_run_twice_gives_the_same_bytes(solver: str, compiled: bool) -> None:
    runs = [CURVED.simulate(stop_time=1.0, solver=solver, step=0.01, compiled=compiled) for _ in range(2)]
    assert runs[0].data.tobytes() == runs[1].data.tobytes()


@pytest.mark.parametrize("solver", ["rodas", *FIXED])
def test_compiled_functions_and_virtual_machine_agree(solver: str) -> None:
    machine, compiled = (
        CURVED.simulate(stop_time=1.0, solver=solver, step=0.01, compiled=way) for way in (False, True)
    )
    assert machine.data.tobytes() == compiled.data.tobytes()
    assert machine.statistics.steps == compiled.statistics.steps
