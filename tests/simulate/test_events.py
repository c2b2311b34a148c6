"""Events: located in time, with both sides in the result, and bounded where they never end."""

from __future__ import annotations

import math

import numpy as np
import pytest

from acausal.codegen.functions import Code, generate
from acausal.errors import SimulationProblem
from acausal.simulate.simulate import simulate
from acausal.symbolic.expressions import expr as e
from acausal.symbolic.expressions.expr import TIME, Expr, const, sym
from tests.codegen.systems import explicit, hand_system, rate

X, V, Z = sym("x"), sym("v"), sym("z")


def switch(relation: Expr, then: float, otherwise: float) -> Expr:
    return e.if_then_else(relation, const(then), const(otherwise))


def event_times(code: Code, stop: float, interval: float = 0.3) -> list[float]:
    """Times that occur twice: both sides of an event."""
    time = simulate(code, stop_time=stop, interval=interval, rtol=1e-9).time
    return [float(t) for t in time[1:][np.diff(time) == 0]]


@pytest.mark.parametrize("op", ["lt", "le", "gt", "ge"])
def test_threshold_is_located(op: str) -> None:
    """dx/dt = -x from 1; at x = 0.4 it becomes a constant slope, at time ln 2.5."""
    relation = e.relation(op, X, const(0.4))
    below, above = (const(-0.1), e.neg(X)) if op in ("lt", "le") else (e.neg(X), const(-0.1))
    slope = e.if_then_else(relation, below, above)
    code = generate(hand_system({"x": 1.0}, [explicit(Z, slope), rate("x", Z)], relations=[relation]))
    assert event_times(code, 2.0) == pytest.approx([math.log(2.5)], abs=1e-6)
    result = simulate(code, stop_time=2.0, rtol=1e-9)
    assert result.final(["x"])["x"] == pytest.approx(0.4 - 0.1 * (2.0 - math.log(2.5)), abs=1e-6)
    both = np.flatnonzero(np.diff(result.time) == 0)[0]
    assert result.values("z")[both : both + 2] == pytest.approx([-0.4, -0.1], abs=1e-6)
    assert result.statistics.events == 1


@pytest.mark.parametrize("op", ["lt", "le", "gt", "ge"])
def test_time_event_without_states(op: str) -> None:
    relation = e.relation(op, TIME, const(0.35))
    code = generate(hand_system({}, [explicit(Z, switch(relation, 1.0, 2.0))], relations=[relation]))
    assert event_times(code, 1.0) == pytest.approx([0.35], abs=1e-12)
    assert simulate(code).final(["z"])["z"] == (1.0 if op in ("gt", "ge") else 2.0)


def test_event_on_a_grid_point_at_the_start_and_at_the_stop() -> None:
    for instant in (0.0, 0.5, 1.0):
        relation = e.relation("gt", TIME, const(instant))
        code = generate(
            hand_system({"x": 0.0}, [rate("x", switch(relation, 1.0, 0.0))], relations=[relation])
        )
        assert simulate(code, interval=0.5).final(["x"])["x"] == pytest.approx(1.0 - instant, abs=1e-9)


def test_start_exactly_at_the_switching_point_does_not_stick() -> None:
    """x = 0 at the start, rising: the mode of `x > 0` must become true although no sign changes."""
    relation = e.relation("gt", X, e.ZERO)
    code = generate(hand_system({"x": 0.0}, [rate("x", switch(relation, 2.0, 1.0))], relations=[relation]))
    assert simulate(code).final(["x"])["x"] == pytest.approx(2.0, abs=1e-6)


def test_hysteresis_switches_at_every_crossing_of_an_oscillation() -> None:
    """z = sign of a cosine: 2 events per period, 10 periods, none missed and none doubled."""
    relation = e.relation("ge", X, e.ZERO)
    code = generate(
        hand_system(
            {"x": 1.0, "v": 0.0},
            [rate("x", V), rate("v", e.neg(X)), explicit(Z, switch(relation, 1.0, -1.0))],
            relations=[relation],
        )
    )
    expected = [(k + 0.5) * math.pi for k in range(20)]
    assert event_times(code, 20 * math.pi, 0.5) == pytest.approx(expected, abs=1e-5)


def test_short_pulse_is_not_stepped_over() -> None:
    """Two crossings closer together than the steps the solution would allow."""
    rises, falls = e.relation("gt", TIME, const(5.001)), e.relation("gt", TIME, const(5.011))
    height = e.if_then_else(rises, e.if_then_else(falls, e.ZERO, const(100.0)), e.ZERO)
    code = generate(hand_system({"x": 0.0}, [rate("x", height)], relations=[rises, falls]))
    assert simulate(code, stop_time=10.0).final(["x"])["x"] == pytest.approx(1.0, abs=1e-6)


def test_simultaneous_events() -> None:
    a, b = e.relation("gt", X, const(0.5)), e.relation("gt", V, const(0.5))
    code = generate(
        hand_system(
            {"x": 0.0, "v": 0.0},
            [
                rate("x", e.ONE),
                rate("v", e.ONE),
                explicit(Z, e.add(switch(a, 1.0, 0.0), switch(b, 1.0, 0.0))),
            ],
            relations=[a, b],
        )
    )
    result = simulate(code)
    assert result.final(["z"])["z"] == 2.0
    assert event_times(code, 1.0)[0] == pytest.approx(0.5, abs=1e-9)


def test_events_that_set_off_others() -> None:
    """The second condition depends on what the first one switches."""
    first = e.relation("gt", X, const(0.5))
    second = e.relation("gt", Z, const(1.5))
    code = generate(
        hand_system(
            {"x": 0.0},
            [explicit(Z, switch(first, 2.0, 1.0)), rate("x", switch(second, 3.0, 1.0))],
            relations=[first, second],
        )
    )
    assert simulate(code, rtol=1e-9).final(["x"])["x"] == pytest.approx(0.5 + 1.5, abs=1e-6)


def test_sliding_is_an_error_that_names_the_condition() -> None:
    relation = e.relation("gt", X, e.ZERO)
    code = generate(hand_system({"x": 0.3}, [rate("x", switch(relation, -1.0, 1.0))], relations=[relation]))
    with pytest.raises(SimulationProblem, match=r"`x > 0.0`.*time 0\.3") as caught:
        simulate(code)
    assert caught.value.codes == ("simulate.mode-cycle",)
    assert caught.value.diagnostics[0].names == ("x",)
    assert "slides" in (caught.value.diagnostics[0].hint or "")


def test_zeno_is_an_error_that_names_the_conditions() -> None:
    """The twisting algorithm reaches the origin in finite time through infinitely many switchings."""
    position, speed = e.relation("gt", X, e.ZERO), e.relation("gt", V, e.ZERO)
    force = e.add(switch(position, -2.0, 2.0), switch(speed, -1.0, 1.0))
    code = generate(
        hand_system({"x": 1.0, "v": 0.0}, [rate("x", V), rate("v", force)], relations=[position, speed])
    )
    with pytest.raises(SimulationProblem) as caught:
        simulate(code, stop_time=10.0)
    assert set(caught.value.codes) <= {"simulate.zeno", "simulate.mode-cycle"}
    names = set(caught.value.diagnostics[0].names)
    assert names
    assert names <= {"x", "v"}


def test_same_run_twice_gives_the_same_numbers() -> None:
    relation = e.relation("lt", X, const(0.4))
    code = generate(
        hand_system({"x": 1.0}, [rate("x", e.if_then_else(relation, e.ONE, e.neg(X)))], relations=[relation])
    )
    with pytest.raises(SimulationProblem):
        simulate(code, stop_time=3.0)
    relation = e.relation("lt", X, const(0.4))
    code = generate(
        hand_system(
            {"x": 1.0}, [rate("x", e.if_then_else(relation, const(-0.1), e.neg(X)))], relations=[relation]
        )
    )
    assert np.array_equal(simulate(code).data, simulate(code).data)
