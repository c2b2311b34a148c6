"""Each explicit method, run just below and just above its limit, on a model with slow and fast modes."""

from __future__ import annotations

import pytest

import acausal
from acausal.api import CompiledModel
from acausal.errors import AcausalError
from acausal.simulate.stability import GROWTH

MIXED = """model Mixed "Two damped oscillators and a lag, coupled, and an angle that turns"
  Real x(start = 1, fixed = true), v(start = 0, fixed = true), y(start = -1, fixed = true);
  Real w(start = 0, fixed = true), T(start = 1, fixed = true), phi(start = 0, fixed = true);
equation
  der(x) = v; der(v) = -900*x - 12*v + 5*(y - x);
  der(y) = w; der(w) = -40*y - 3*w + 5*(x - y) + T;
  der(T) = -25*T; der(phi) = w;
end Mixed;"""

REAL = """model Lags "Fast and slow lags in a row, and one oscillator that is slower"
  Real x(start = 1, fixed = true), y(start = -1, fixed = true);
  Real z(start = 1, fixed = true), v(start = 0, fixed = true);
equation
  der(x) = -80*x + 3*y; der(y) = -11*y + x; der(z) = v; der(v) = -25*z - 4*v + x;
end Lags;"""

SWINGING = """model Swinging "Two weakly damped oscillators"
  Real x(start = 1, fixed = true), v(start = 0, fixed = true);
  Real y(start = -1, fixed = true), w(start = 0, fixed = true);
equation
  der(x) = v; der(v) = -900*x - 2*v + 5*(y - x);
  der(y) = w; der(w) = -40*y - 3*w + 5*(x - y);
end Swinging;"""


@pytest.fixture(scope="module", params=[MIXED, REAL, SWINGING], ids=["mixed", "real", "swinging"])
def mixed(request: pytest.FixtureRequest) -> CompiledModel:
    return acausal.loads(request.param).compile()


@pytest.mark.parametrize("method", sorted(GROWTH))
def test_just_below_and_just_above(mixed: CompiledModel, method: str) -> None:
    limit = mixed.linearize().step_limit(method)
    steps = 120_000 if mixed.name == "Swinging" else 4000  # what is hardly damped takes its time

    def end(share: float) -> float:
        step = share * limit
        try:
            run = mixed.simulate(
                stop_time=steps * step, solver=method, step=step, interval=steps // 10 * step
            )
        except AcausalError:
            return float("inf")
        return abs(float(run.values("x")[-1])) + abs(float(run.values("y")[-1]))

    assert end(0.97) < 1e-3
    assert end(1.03) > 10
