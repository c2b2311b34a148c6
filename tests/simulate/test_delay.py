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


def test_what_changes_at_events_only_comes_back_as_an_event() -> None:
    model = acausal.loads(
        """model M
          parameter Real lag = 0.01;
          Boolean up(start = false, fixed = true), late;
          Integer n(start = 0, fixed = true);
          Real y = delay(if up then 1.0 else 0.0, lag);
        equation
          when {time >= 1, time >= 1.001, time >= 3, time >= 90} then up = not pre(up); end when;
          late = y > 0.5;
          when change(late) then n = pre(n) + 1; end when;
        end M;"""
    ).compile()
    result = model.simulate(stop_time=100.0)
    assert result.values("n")[-1] == 4
    assert result.statistics.events == 8
    assert result.statistics.steps < 1000
    time = result.time
    late = ((time >= 1.01) & (time < 1.011)) | ((time >= 3.01) & (time < 90.01))
    far = np.min(np.abs(time[:, None] - [1.01, 1.011, 3.01, 90.01]), axis=1) > 1e-9
    assert (result.values("late")[far] == late[far]).all()


@pytest.mark.parametrize(
    ("delayed", "steady"),
    [
        ("if up then 1.0 else 0.0, 0.1", True),
        ("if time < 0.3 then 1.0 else 0.0, 0.1", True),
        ("noEvent(if time < 0.3 then 1.0 else 0.0), 0.1", False),
        ("if up then x else 0.0, 0.1", False),
        ("if up then 1.0 else 0.0, if up then 0.1 else 0.2, 0.3", False),
    ],
)
def test_what_counts_as_steady(delayed: str, steady: bool) -> None:
    text = (
        "model M Real x(start = 0, fixed = true); Boolean up = x > 0.5; Real y;"
        f" equation der(x) = 1; y = delay({delayed}); end M;"
    )
    assert acausal.loads(text).compile().code.delays_are_steady == steady
