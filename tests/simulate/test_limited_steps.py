"""Steps that only `max_step` keeps short: of order 3, on the output grid, as accurate as asked for."""

from __future__ import annotations

import numpy as np
import pytest

import acausal
from acausal.runtime.build import compiler

pytestmark = pytest.mark.skipif(compiler() is None, reason="no C compiler")

OSCILLATOR = """
model Oscillator "With a force that a nonlinear equation gives, and a contact at x = -0.5"
  Real x(start = 1, fixed = true);
  Real v(start = 0, fixed = true);
  Real f(start = -1);
  Real n(start = 0, fixed = true);
equation
  der(x) = v;
  der(v) = f;
  f + 1e-3*f^3 = -x;
  der(n) = if x < -0.5 then 1 else 0;
end Oscillator;
"""
STOP, LONGEST = 6.0, 0.002


@pytest.fixture(scope="module")
def oscillator() -> acausal.CompiledModel:
    return acausal.loads(OSCILLATOR).compile()


@pytest.fixture(scope="module")
def exact(oscillator: acausal.CompiledModel) -> acausal.Result:
    return oscillator.simulate(stop_time=STOP, interval=0.02, rtol=1e-11)


@pytest.mark.parametrize("compiled", [False, True])
def test_three_evaluations_make_a_step(
    oscillator: acausal.CompiledModel, exact: acausal.Result, compiled: bool
) -> None:
    run = oscillator.simulate(stop_time=STOP, interval=0.02, max_step=LONGEST, compiled=compiled)
    assert run.statistics.events == exact.statistics.events == 2
    for name in "xvfn":
        assert run.values(name) == pytest.approx(exact.values(name), abs=2e-6)
    steps, evaluations = run.statistics.steps, run.statistics.rhs_evaluations
    assert STOP / LONGEST <= steps < 1.03 * STOP / LONGEST  # on the grid but for the events
    assert evaluations < 3.3 * steps


def test_what_order_3_cannot_do_is_done_with_order_5(
    oscillator: acausal.CompiledModel, exact: acausal.Result
) -> None:
    run = oscillator.simulate(stop_time=STOP, interval=0.06, rtol=1e-9, max_step=0.03)
    assert run.statistics.rhs_evaluations > 7 * run.statistics.steps
    assert run.values("x")[-1] == pytest.approx(exact.values("x")[-1], abs=1e-8)


def test_compiled_or_not_gives_the_same_bits(oscillator: acausal.CompiledModel) -> None:
    first, second = (
        oscillator.simulate(stop_time=STOP, interval=0.01, max_step=LONGEST, compiled=compiled)
        for compiled in (False, True)
    )
    assert np.array_equal(first.data, second.data)


def test_any_output_interval_will_do(oscillator: acausal.CompiledModel, exact: acausal.Result) -> None:
    run = oscillator.simulate(stop_time=STOP, interval=0.02 / np.pi, max_step=LONGEST)
    assert np.interp(2.0, run.time, run.values("x")) == pytest.approx(
        np.interp(2.0, exact.time, exact.values("x")), abs=1e-4
    )
    assert run.values("x")[-1] == pytest.approx(exact.values("x")[-1], abs=2e-6)
