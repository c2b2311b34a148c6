"""The two flagship systems against independent references: hand-written equations and linear algebra."""

from __future__ import annotations

import numpy as np
import pytest

import acausal
from tests.models import reference_kinematics as kinematics
from tests.models import reference_main_regulator as regulator

RATIO_BAND = 0.003
"""Acceptance of ten-speed.md, section 1."""
STATES = {
    "s": "valve.spool.s",
    "v": "valve.spool.v",
    "p_feedback": "valve.feedbackChamber.p",
    "p_pilot": "valve.pilotChamber.p",
    "p_line": "line.p",
}
RAMP = {"p_start": 6e5, "p_end": 10.5e5, "p_ramp_start": 0.2, "p_ramp_duration": 0.3}


@pytest.mark.parametrize("gear", kinematics.GEARS)
def test_fixed_gear_has_one_degree_of_freedom_and_the_published_ratio(gear: int) -> None:
    compiled = acausal.load("TenSpeed.Examples.FixedGear").compile(gear=gear)
    assert len(compiled.states) == 2
    assert compiled.index == 3
    run = compiled.simulate()
    ratio = float(run["ratio"][-1])
    assert abs(ratio - kinematics.GEARS[gear][1]) <= RATIO_BAND
    assert ratio == pytest.approx(kinematics.ratio(gear), rel=1e-9)


@pytest.mark.parametrize("gear", kinematics.GEARS)
def test_fixed_gear_accelerates_as_lagranges_equations_say(gear: int) -> None:
    run = acausal.load("TenSpeed.Examples.FixedGear").compile(gear=gear).simulate(stop_time=0.3)
    expected = kinematics.accelerations(gear)
    found = [float(run[f"gearbox.body[{k}].a"][-1]) for k in range(1, 9)]
    assert np.allclose(found, expected, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("gear", kinematics.GEARS)
def test_gearsets_lose_no_power(gear: int) -> None:
    run = acausal.load("TenSpeed.Examples.FixedGear").compile(gear=gear).simulate(stop_time=0.3)
    kinetic = sum(
        inertia * run.values(f"gearbox.body[{k}].w") ** 2 / 2
        for k, inertia in enumerate(kinematics.INERTIAS, start=1)
    )
    kinetic = kinetic + kinematics.VEHICLE_INERTIA * run.values("vehicle.w") ** 2 / 2
    work = 150.0 * run.values("gearbox.body[1].phi")
    assert np.allclose(kinetic, work, rtol=1e-5, atol=1e-5 * float(np.max(work)))


def test_a_gear_that_does_not_exist_is_refused_by_the_models_own_words() -> None:
    with pytest.raises(acausal.AcausalError, match="gear must be 1 to 10, or -1 for reverse"):
        acausal.load("TenSpeed.Examples.FixedGear").compile(gear=0).simulate()


@pytest.mark.parametrize(
    ("name", "supply", "changes"),
    [
        ("MainRegulatorFlow", "flow", {}),
        ("MainRegulatorPressure", "pressure", {}),
        ("MainRegulatorPressureRamp", "pressure", RAMP),
    ],
)
def test_regulator_follows_the_hand_written_equations(
    name: str, supply: str, changes: dict[str, float]
) -> None:
    reference = regulator.solve(regulator.DEFAULTS | changes, supply, points=201, rtol=1e-10)
    compiled = acausal.load(f"TenSpeed.Examples.{name}").compile()
    run = compiled.simulate(rtol=1e-10, interval=0.005)
    wanted = [STATES[state] for state in reference.names]
    assert sorted(compiled.states) == sorted(wanted)
    for state, values in zip(wanted, reference.states, strict=True):
        span = float(np.max(np.abs(values)))
        assert np.allclose(run.values(state), values, rtol=0, atol=5e-6 * span), state


def test_the_supply_alone_decides_whether_the_line_pressure_is_a_state() -> None:
    flow = acausal.load("TenSpeed.Examples.MainRegulatorFlow").compile()
    pressure = acausal.load("TenSpeed.Examples.MainRegulatorPressure").compile()
    assert set(flow.states) - set(pressure.states) == {"line.p"}
    assert len(flow.states) == 5
    assert len(pressure.states) == 4
    for model in (flow, pressure):
        assert "line.p" in model.flat.by_name


def test_the_regulator_holds_its_pressure_against_the_flow() -> None:
    compiled = acausal.load("TenSpeed.Examples.MainRegulatorFlow").compile()
    pressures = [
        float(compiled.simulate(parameters={"supply.q_end": litres / 60000})["line.p"][-1])
        for litres in (10.0, 20.0, 40.0)
    ]
    assert pressures == sorted(pressures)
    assert pressures[-1] < 1.25 * pressures[0]


@pytest.mark.parametrize("name", ["MainRegulatorFlow", "MainRegulatorPressureRamp"])
def test_oil_is_neither_lost_nor_made(name: str) -> None:
    """Mass that enters through the sources is stored in the volumes: the integral of the flows closes."""
    run = (
        acausal.load(f"TenSpeed.Examples.{name}").compile().simulate(rtol=1e-8, interval=2e-5, stop_time=0.4)
    )
    volumes = ("line", "valve.feedbackChamber", "valve.pilotChamber")
    none = np.zeros(len(run.time))
    stored = sum((run.values(f"{volume}.m") for volume in volumes), none)
    net = sum((run.values(f"{volume}.m_flow") for volume in volumes), none)
    entered = np.concatenate([[0.0], np.cumsum((net[1:] + net[:-1]) / 2 * np.diff(run.time))])
    assert np.allclose(stored - stored[0], entered, atol=2e-6 * float(stored[0]))


def test_references_differ_when_the_model_differs() -> None:
    """The comparison above would notice a wrong orifice: a tenth of its diameter is far outside the band."""
    par = regulator.DEFAULTS
    changed = regulator.solve(par | {"d_feedback": 1.1 * par["d_feedback"]}, "flow", points=201)
    plain = regulator.solve(par, "flow", points=201)
    worst = np.max(np.abs(changed.states - plain.states) / np.max(np.abs(plain.states), axis=1)[:, None])
    assert float(worst) > 1e-3
