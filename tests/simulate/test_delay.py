"""Delayed expressions, against the method of steps and closed forms."""

from __future__ import annotations

import numpy as np
import pytest

import acausal
from acausal.errors import SimulationProblem
from acausal.simulate.history import History, Sample
from acausal.simulate.result import Result


def run(text: str, stop: float, rtol: float | None = None, interval: float | None = None) -> Result:
    return (
        acausal.loads(f"model M\n{text}\nend M;\n")
        .compile()
        .simulate(stop_time=stop, rtol=rtol, interval=interval)
    )


@pytest.mark.parametrize("solver", ["rodas", "cvode"])
def test_delay_equation_by_the_method_of_steps(solver: str) -> None:
    model = acausal.loads(
        "model M Real x(start = 1, fixed = true); equation der(x) = -delay(x, 1); end M;"
    ).compile()
    result = model.simulate(stop_time=3.0, rtol=1e-8, solver=solver)
    t = result.time
    expected = 1 - t
    expected = np.where(t > 1, expected + (t - 1) ** 2 / 2, expected)
    expected = np.where(t > 2, expected - (t - 2) ** 3 / 6, expected)
    assert result.values("x") == pytest.approx(expected, abs=1e-6)


def test_a_delay_that_varies() -> None:
    result = run("Real y; equation y = delay(sin(5*time), 0.3 + 0.2*sin(time), 1);", 10.0)
    then = result.time - (0.3 + 0.2 * np.sin(result.time))
    assert result.values("y") == pytest.approx(np.where(then > 0, np.sin(5 * then), 0.0), abs=1e-5)


def test_before_the_start_the_first_value_holds() -> None:
    result = run("Real x(start = 2, fixed = true), y; equation der(x) = 1; y = delay(3*x, 0.5);", 1.0)
    assert result.values("y")[result.time <= 0.5] == pytest.approx(6.0)
    assert result.values("y")[-1] == pytest.approx(7.5)


def test_a_jump_is_delayed_too() -> None:
    result = run("Real y; equation y = delay(if time < 0.25 then 1.0 else 2.0, 0.5);", 1.0)
    assert result.values("y")[result.time < 0.74] == pytest.approx(1.0)
    assert result.values("y")[result.time > 0.76] == pytest.approx(2.0)


def test_a_delay_beyond_its_longest_is_an_error() -> None:
    with pytest.raises(SimulationProblem) as caught:
        run("Real y; equation y = delay(time, 0.5 + time, 1);", 1.0)
    assert caught.value.codes == ("simulate.delay",)


def test_what_is_older_than_the_longest_delay_is_dropped() -> None:
    history = History(acausal.loads("model M Real y = delay(time, 1); end M;").compile().causal)
    for i in range(10_000):
        values = np.array([i * 0.01])
        one, zero = np.ones(1), np.zeros(1)
        history.add(Sample(i * 0.01, values, one, one, one, zero))
    assert history.size < 1000
    found = np.zeros(1)
    history.fill(99.995, found)
    assert found[0] == pytest.approx(98.995)
