"""Metrics of constructed traces with known answers, also where a feature is absent or the torque swings."""

from __future__ import annotations

import numpy as np
import pytest

from acausal.study.metrics.engagement import engagement
from acausal.study.metrics.shift import Shift, shift
from acausal.study.metrics.traces import Trace

TIME = np.arange(0, 2.0005, 1e-3)


def line(*points: tuple[float, float]) -> Trace:
    """Straight lines between the points, stored every millisecond."""
    time, values = zip(*points, strict=True)
    return Trace(TIME, np.interp(TIME, time, values))


COMMAND = line((0, 0), (0.1, 0), (0.6, 1), (2, 1))


def test_engagement() -> None:
    pressure = line((0, 1e5), (0.3, 1e5), (0.8, 11e5), (0.9, 12e5), (1.0, 11e5), (2, 11e5))
    piston = line((0, 0), (0.4, 0), (0.5, 5e-3), (2, 5e-3))
    found = engagement(COMMAND, pressure, piston, stop=5e-3)
    assert found.delay == pytest.approx(0.31 - 0.11, abs=1e-6)
    assert found.rise == pytest.approx(0.8 - 0.31, abs=1e-6)
    assert found.corner_time == pytest.approx(0.5 - 0.31, abs=1e-6)
    assert found.corner_pressure == pytest.approx(4e5, rel=1e-6)
    assert found.overshoot == pytest.approx(10, rel=1e-6)


def test_engagement_without_features() -> None:
    creeping = line((0, 1e5), (0.3, 1e5), (0.8, 10.9e5), (2, 10.9e5))
    found = engagement(COMMAND, creeping)
    assert (found.corner_time, found.corner_pressure, found.overshoot) == (
        None,
        None,
        pytest.approx(0, abs=1e-6),
    )
    nothing = engagement(COMMAND, line((0, 1e5), (2, 1e5)))
    assert (nothing.delay, nothing.rise, nothing.overshoot) == (None, None, None)


def test_a_falling_pressure_is_measured_alike() -> None:
    falling = line((0, 11e5), (0.3, 11e5), (0.8, 1e5), (2, 1e5))
    found = engagement(line((0, 1), (0.1, 1), (0.6, 0), (2, 0)), falling)
    assert (found.delay, found.rise) == (pytest.approx(0.2, abs=1e-6), pytest.approx(0.49, abs=1e-6))


SLIPS = {
    "C1": line((0, 100), (0.5, 100), (0.9, 0), (2, 0)),
    "B2": line((0, 0), (0.4, 0), (0.9, 80), (2, 80)),
    "C3": line((0, 0), (2, 0)),
}
TORQUES = {
    "C1": line((0, 0), (0.2, 0), (0.5, 200), (2, 200)),
    "B2": line((0, 150), (0.2, 150), (0.4, 0), (2, 0)),
    "C3": line((0, 90), (2, 90)),
}
HOLE = (
    (0, 400),
    (0.2, 400),
    (0.4, 100),
    (0.5, 100),
    (0.9, 340),
    (1.0, 300),
    (1.1, 250),
    (1.2, 300),
    (2, 300),
)


def upshift(*points: tuple[float, float]) -> Shift:
    return shift(line(*points), SLIPS, TORQUES, 0.1, 2.0)


def test_upshift() -> None:
    found = upshift(*HOLE)
    assert (found.oncoming, found.offgoing) == ("C1", "B2")
    assert found.initial_torque == pytest.approx(400)
    assert found.final_torque == pytest.approx(300)
    assert found.torque_hole == pytest.approx(-200)
    assert found.recovery_overshoot == pytest.approx(20)
    reached = 0.5 + 0.4 * 200 / 240
    assert found.settling_time == pytest.approx(1.2 - 0.1 * 6 / 50 - reached, abs=1e-6)
    assert found.torque_phase == pytest.approx(0.2, abs=1e-6)
    assert found.inertia_phase == pytest.approx(0.4, abs=1e-6)
    assert found.peak_to_peak_derivative == pytest.approx(600 + 1500, rel=1e-9)


def test_no_hole_and_no_overshoot() -> None:
    found = upshift((0, 200), (0.3, 200), (0.8, 300), (2, 300))
    assert (found.torque_hole, found.recovery_overshoot) == (0, None)
    assert found.settling_time == pytest.approx(0.8 - 0.5 * 6 / 100 - 0.1, abs=1e-6)
    below = upshift((0, 400), (0.2, 400), (0.4, 100), (0.9, 300), (2, 300))
    assert below.recovery_overshoot == pytest.approx(0, abs=1e-6)


def test_nothing_shifts() -> None:
    steady = {"C1": line((0, 0), (2, 0))}
    found = shift(line((0, 100), (2, 100)), steady, steady, 0.1, 2.0)
    assert (found.oncoming, found.offgoing, found.torque_phase, found.inertia_phase) == (
        None,
        None,
        None,
        None,
    )
    assert (found.torque_hole, found.settling_time) == (0, 0)


def test_an_open_brake_that_comes_to_rest_is_not_the_oncoming_element() -> None:
    slips = SLIPS | {"B3": line((0, 400), (0.5, 400), (0.9, 0), (2, 0))}
    torques = TORQUES | {"B3": line((0, 0), (2, 0))}
    assert shift(line(*HOLE), slips, torques, 0.1, 2.0).oncoming == "C1"


def test_the_torque_phase_ends_when_the_offgoing_element_lets_go_for_good() -> None:
    tied = TORQUES | {"B2": line((0, 150), (0.2, 150), (0.3, -60), (0.45, 0), (2, 0))}
    plain = shift(line(*HOLE), SLIPS, TORQUES, 0.1, 2.0).torque_phase
    longer = shift(line(*HOLE), SLIPS, tied, 0.1, 2.0).torque_phase
    assert plain is not None
    assert longer == pytest.approx(plain + 0.05, abs=2e-3)  # 0.45 s instead of 0.4 s


def test_an_oscillating_torque_hides_nothing() -> None:
    calm = line(*HOLE)
    swinging = Trace(TIME, calm.values + 12 * np.sin(2 * np.pi * 40 * TIME))
    plain, rough = shift(calm, SLIPS, TORQUES, 0.1, 2.0), shift(swinging, SLIPS, TORQUES, 0.1, 2.0)
    assert rough.torque_phase == pytest.approx(plain.torque_phase, abs=0.02)
    assert rough.torque_hole == pytest.approx(plain.torque_hole, abs=15)
    assert rough.final_torque == pytest.approx(plain.final_torque, abs=1)
    assert rough.inertia_phase == plain.inertia_phase
    assert rough.peak_to_peak_derivative > plain.peak_to_peak_derivative


def test_a_torque_that_never_settles_has_no_settling_time() -> None:
    swinging = Trace(TIME, 300 + 50 * np.sin(2 * np.pi * 5 * TIME))
    assert shift(swinging, SLIPS, TORQUES, 0.1, 2.0).settling_time is None


def test_an_empty_window_is_refused() -> None:
    with pytest.raises(ValueError, match="window"):
        shift(line((0, 1), (2, 1)), {}, {}, 1.0, 1.0)
