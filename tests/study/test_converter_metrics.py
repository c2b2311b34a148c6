"""Metrics of converter sweeps and of stored clutch pressures, on constructed results with known answers."""

from __future__ import annotations

from dataclasses import replace
from math import exp

import numpy as np
import pytest

from acausal.errors import UsageProblem
from acausal.study.metrics.converter import Curves, converter_figures, curves
from acausal.study.metrics.engagements import engagements
from acausal.study.metrics.table import Table

RATIO = np.linspace(0, 1.1, 1101)
SWEEP = Curves(RATIO, np.maximum(2 - 1.25 * RATIO, 1.0), 150 + 100 * RATIO)
"""Couples at 0.8; efficiency 2 x - 1.25 x^2 is 0.8 at 0.8, its largest value."""


def test_figures_of_straight_lines() -> None:
    found = converter_figures(SWEEP)
    assert found.stall_torque_ratio == pytest.approx(2)
    assert found.stall_capacity_factor == pytest.approx(150)
    assert found.coupling_speed_ratio == pytest.approx(0.8)
    assert (found.peak_efficiency, found.peak_efficiency_speed_ratio) == pytest.approx((0.8, 0.8))
    assert (found.capacity_rms_error, found.torque_ratio_rms_error) == (None, None)


def test_a_peak_before_coupling() -> None:
    found = converter_figures(Curves(RATIO, 2.5 - 2 * RATIO, 150 + RATIO))
    assert found.coupling_speed_ratio == pytest.approx(0.75)
    assert found.peak_efficiency == pytest.approx(0.78125, rel=1e-6)
    assert found.peak_efficiency_speed_ratio == pytest.approx(0.625, abs=1e-3)


def test_distance_to_a_reference() -> None:
    reference = replace(SWEEP, capacity=SWEEP.capacity / 1.02, torque_ratio=SWEEP.torque_ratio / 0.99)
    found = converter_figures(SWEEP, reference)
    assert found.capacity_rms_error == pytest.approx(0.02)
    assert found.torque_ratio_rms_error == pytest.approx(0.01)
    far = Curves(np.array([0.97, 1.0]), np.ones(2), np.ones(2))
    assert converter_figures(SWEEP, far).capacity_rms_error is None


def test_features_that_are_not_there() -> None:
    part = Curves(RATIO[200:700], SWEEP.torque_ratio[200:700], SWEEP.capacity[200:700])
    found = converter_figures(part)
    assert (found.stall_torque_ratio, found.stall_capacity_factor, found.coupling_speed_ratio) == (None,) * 3
    assert found.peak_efficiency_speed_ratio == pytest.approx(0.699)


def test_the_sweep_is_read_on_its_way_up() -> None:
    """The turbine stands still at first while the torque settles, and slows down again at the end."""
    up = np.concatenate([np.zeros(5), [-1e-5], RATIO[1:], RATIO[::-1]])
    torque = np.concatenate([np.linspace(3, 2, 6), SWEEP.torque_ratio[1:], np.full(len(RATIO), 9.0)])
    time = np.arange(len(up), dtype=np.float64)
    found = curves(Table({"time": time, "speedRatio": up, "torqueRatio": torque, "capacityFactor": torque}))
    assert converter_figures(found).stall_torque_ratio == pytest.approx(2, rel=1e-4)
    assert float(found.torque_ratio.max()) <= 2
    still = Table({name: np.zeros(3) for name in ("time", "speedRatio", "torqueRatio", "capacityFactor")})
    with pytest.raises(UsageProblem, match="never rises"):
        curves(still)


def pressures() -> Table:
    """A ramp of the current from 0.1 s on; pressure of C1 from 0.3 s on, the piston travels 0.4 to 0.5 s."""
    time = np.arange(0, 2.0005, 1e-3)
    return Table(
        {
            "time": time,
            "current_C1": np.interp(time, [0.1, 0.6], [0, 1]),
            "pressure_C1": np.interp(time, [0.3, 0.8, 0.9, 1.0], [1e5, 11e5, 12e5, 11e5]),
            "position_C1": np.interp(time, [0.4, 0.5], [0, 5e-3]),
            "current_B1": np.ones(len(time)),
            "pressure_B1": np.full(len(time), 2e5),
        }
    )


def test_every_pressure_of_a_result() -> None:
    first, second = engagements(pressures(), stop=5e-3)
    assert (first.name, second.name) == ("C1", "B1")
    assert first.figures.delay == pytest.approx(0.2, abs=1e-6)
    assert first.figures.rise == pytest.approx(0.49, abs=1e-6)
    assert first.figures.corner_time == pytest.approx(0.19, abs=1e-6)
    assert first.figures.corner_pressure == pytest.approx(4e5, rel=1e-6)
    assert first.figures.overshoot == pytest.approx(10, rel=1e-6)
    assert (second.figures.delay, second.figures.corner_time) == (None, None)


def test_the_stop_is_98_per_cent_of_the_travel_unless_given() -> None:
    assert engagements(pressures())[0].figures.corner_time == pytest.approx(0.188, abs=1e-6)


def test_a_single_pressure_and_a_window() -> None:
    table = pressures()
    alone = Table(
        {name.removesuffix("_C1"): table.columns[name] for name in table.columns if "B1" not in name}
    )
    (whole,) = engagements(alone)
    assert (whole.name, whole.to_json()["overshoot"]) == ("", pytest.approx(10))
    (late,) = engagements(alone, start=1.2, end=2.0)
    assert late.figures.delay is None
    for wrong in ((1.0, 1.0), (-1.0, 1.0), (0.0, 9.0)):
        with pytest.raises(UsageProblem, match="no window"):
            engagements(alone, start=wrong[0], end=wrong[1])
    with pytest.raises(UsageProblem, match="pressure"):
        engagements(Table({"time": np.arange(3.0)}))


def test_what_is_not_a_number_is_named() -> None:
    time = np.linspace(0, 1, 11)
    broken = np.where(time > 0.45, np.nan, time)
    sweep = Table({"time": time, "speedRatio": time, "torqueRatio": broken, "capacityFactor": time})
    with pytest.raises(UsageProblem, match=r"metrics\.not-a-number") as problem:
        curves(sweep)
    assert problem.value.diagnostics[0].names == ("torqueRatio",)
    clutch = Table({"time": time, "current": time, "pressure": time, "position": broken})
    with pytest.raises(UsageProblem, match=r"`position` is not a number at 0\.5 s"):
        engagements(clutch)


@pytest.mark.parametrize("value", [np.inf, -np.inf, 1e300])
def test_what_is_infinite_is_named(value: float) -> None:
    time = np.linspace(0, 1, 11)
    broken = np.where(time > 0.45, value, time)
    with pytest.raises(UsageProblem, match=r"`pressure` is infinite or far too large at 0\.5 s"):
        engagements(Table({"time": time, "current": time, "pressure": broken}))
    with pytest.raises(UsageProblem, match="`time` is infinite or far too large in row 6"):
        engagements(Table({"time": broken, "current": time, "pressure": time}))
    with pytest.raises(UsageProblem, match="stop"):
        engagements(
            Table({"time": time, "current": time, "pressure": time}), stop=value if value < 1e9 else np.nan
        )


@pytest.mark.parametrize("name", ["torqueRatio", "capacityFactor"])
def test_a_sweep_without_torque_is_refused(name: str) -> None:
    columns = {
        "time": RATIO,
        "speedRatio": RATIO,
        "torqueRatio": SWEEP.torque_ratio,
        "capacityFactor": SWEEP.capacity,
    }
    columns[name] = columns[name] * np.where(RATIO > 0.5, -1, 1)
    with pytest.raises(UsageProblem, match=f"`{name}` is not positive at the speed ratio 0.501"):
        curves(Table(columns))


def test_a_lag_of_first_order_creeps_to_its_end() -> None:
    """2 to 98 % take 3.89 time constants; a ramp has an end, and a falling pressure lets the piston fall."""
    time = np.arange(0, 2, 1e-4)
    late = np.maximum(time - 0.5, 0)
    pressure = np.array([1e5 + 5e5 * (1 - exp(-t / 0.05)) for t in late.tolist()])
    lag = Table({"time": time, "current": np.where(time > 0.4, 1.0, 0.0), "pressure": pressure})
    assert engagements(lag)[0].figures.rise == pytest.approx(0.05 * np.log(49), rel=1e-3)
    assert engagements(lag)[0].figures.delay == pytest.approx(0.1 - 0.05 * np.log(0.98), abs=2e-4)
    down = np.interp(time, [0.5, 1.0], [6e5, 1e5])
    released = Table(
        {"time": time, "current": down, "pressure": down, "position": np.interp(time, [0.6, 0.7], [5e-3, 0])}
    )
    found = engagements(released)[0].figures
    assert found.rise == pytest.approx(0.49, rel=1e-4)
    assert found.corner_time == pytest.approx(0.698 - 0.51, abs=1e-6)
    assert found.corner_pressure == pytest.approx(-5e5 * 0.396, rel=1e-4)
