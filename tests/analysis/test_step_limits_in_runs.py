"""Each explicit method, run just below and just above its limit, on a model with slow and fast modes."""

from __future__ import annotations

import pytest

import acausal
from acausal.analysis.stability import GROWTH
from acausal.api import CompiledModel
from acausal.errors import AcausalError

MIXED = """model Mixed "Two damped oscillators and a lag, coupled, and an angle that turns"
  Real x(start = 1, fixed = true), v(start = 0, fixed = true), y(start = -1, fixed = true);
  Real w(start = 0, fixed = true), T(start = 1, fixed = true), phi(start = 0, fixed = true);
equation
  der(x) = v; der(v) = -900*x - 12*v + 5*(y - x);
  der(y) = w; der(w) = -40*y - 3*w + 5*(x - y) + T;
  der(T) = -25*T; der(phi) = w;
end Mixed;"""


@pytest.fixture(scope="module")
def mixed() -> CompiledModel:
    return acausal.loads(MIXED).compile()


@pytest.mark.parametrize("method", sorted(GROWTH))
def test_just_below_and_just_above(mixed: CompiledModel, method: str) -> None:
    limit = mixed.linearize().step_limit(method)

    def end(share: float) -> float:
        step = share * limit
        try:
            run = mixed.simulate(stop_time=4000 * step, solver=method, step=step, interval=400 * step)
        except AcausalError:
            return float("inf")
        return abs(float(run.values("x")[-1])) + abs(float(run.values("y")[-1]))

    assert end(0.97) < 1e-3
    assert end(1.03) > 10
