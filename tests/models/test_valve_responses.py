"""Step responses of every valve at level 1 against the independent implementation of their equations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

import acausal
from tests.models import reference_main_regulator as regulator
from tests.models import reference_valves as reference
from tests.models.reference_valves import P_0

STAGE = "valve.stage."
SPOOL = STAGE + "valve.spool."


@dataclass(frozen=True)
class Case:
    """A step on a bench: the reference's states at the start, by name, and the variables they are."""

    bench: str
    changes: dict[str, str | float]
    model: reference.Model
    start: dict[str, float]
    variables: tuple[str, ...]
    stop: float


def spool(par: regulator.Parameters, *pressures: str) -> dict[str, float]:
    """Spool and pressures at rest."""
    return {"s": reference.rest(par), "v": 0.0, **dict.fromkeys(pressures, P_0)}


def step(first: float, last: float) -> dict[str, str | float]:
    """Command from `first` to `last` within 20 ms, from 10 ms on."""
    values = f"{{{first}, {last}}}"
    return {"command.times": "{0.01}", "command.values": values, "command.duration": 0.02}


CASES = (
    Case(
        "LinearSolenoidL1",
        step(0, 0.6),
        reference.linear_solenoid(reference.LINEAR_SOLENOID, (0.01, 0.02, 0.0, 0.6)),
        {"i": 0.0, **spool(reference.LINEAR_SOLENOID, "p_fb", "p")},
        ("i", "s", SPOOL + "v", STAGE + "feedback.chamber.p", "p_out"),
        0.1,
    ),
    Case(
        "ShiftSolenoidL1",
        step(0, 1),
        reference.shift_solenoid(reference.SHIFT_SOLENOID, (0.01, 0.02, 0.0, 1.0)),
        {"i": 0.0, **spool(reference.SHIFT_SOLENOID, "p")},
        ("i", "s", SPOOL + "v", "p_out"),
        0.06,
    ),
    Case(
        "LockupControlL1",
        step(P_0, 4e5),
        reference.lockup_control(reference.LOCKUP_CONTROL, (0.01, 0.02, P_0, 4e5)),
        spool(reference.LOCKUP_CONTROL, "p", "p_fb", "p_cmd"),
        ("s", SPOOL + "v", "p_out", STAGE + "feedback1.chamber.p", STAGE + "feedback2.chamber.p"),
        0.1,
    ),
    Case(
        "SwitchValveL1",
        step(P_0, 8e5),
        reference.switch_valve(reference.SWITCH_VALVE, (0.01, 0.02, P_0, 8e5)),
        spool(reference.SWITCH_VALVE, "p"),
        ("s", SPOOL + "v", "p_out"),
        0.06,
    ),
    Case(
        "CutValveL1",
        step(P_0, 8e5),
        reference.cut_valve(reference.CUT_VALVE, (0.01, 0.02, P_0, 8e5)),
        spool(reference.CUT_VALVE, "p"),
        ("s", SPOOL + "v", "p_out"),
        0.06,
    ),
    Case(
        "LubricationRegulatorL1",
        {"supply.startTime": 0.1, "supply.duration": 0.01},
        reference.lubrication_regulator(reference.LUBRICATION_REGULATOR, (0.1, 0.01, 5 / 6e4, 20 / 6e4)),
        spool(reference.LUBRICATION_REGULATOR, "p", "p_1"),
        ("s", SPOOL + "v", "p_out", STAGE + "feedback.chamber.p"),
        0.14,
    ),
    Case(
        "ConverterRegulatorL1",
        {"supply.startTime": 0.1, "supply.duration": 0.01},
        reference.converter_regulator(reference.CONVERTER_REGULATOR, (0.1, 0.01, 5 / 6e4, 20 / 6e4)),
        spool(reference.CONVERTER_REGULATOR, "p", "p_1", "p_2"),
        ("s", SPOOL + "v", "p_out", STAGE + "feedback1.chamber.p", STAGE + "feedback2.chamber.p"),
        0.14,
    ),
    Case(
        "LineAccumulatorL1",
        {"supply.startTime": 0.01, "supply.duration": 0.05},
        reference.accumulator(reference.ACCUMULATOR, (0.01, 0.05, P_0, 12e5)),
        spool(reference.ACCUMULATOR, "p"),
        ("s", STAGE + "piston.v", STAGE + "chamber.chamber.p"),
        0.2,
    ),
    Case(
        "TwoWayClutchValveL1",
        {"drive.times": "{0.01}", "drive.values": f"{{{P_0}, 9e5}}", "drive.duration": 0.01},
        reference.two_way_clutch(reference.TWO_WAY_CLUTCH, (0.01, 0.01, P_0, 9e5)),
        {**spool(reference.TWO_WAY_CLUTCH, "p_d", "p_r"), "z": -15 / 1e6},
        (
            "s",
            STAGE + "spool.v",
            STAGE + "driveChamber[1].chamber.p",
            STAGE + "reverseChamber[2].chamber.p",
            STAGE + "detent[1].y",
        ),
        0.05,
    ),
)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.bench)
def test_step_response(case: Case) -> None:
    expected = reference.solve(case.model, case.start, case.stop, 201)
    compiled = acausal.load(f"TenSpeed.Benches.{case.bench}").compile(case.changes)
    result = compiled.simulate(rtol=1e-8, stop_time=case.stop, interval=case.stop / 200)
    times = np.linspace(0, case.stop, 201)
    for variable, values in zip(case.variables, expected.values(), strict=True):
        found = np.interp(times, result.time, result.values(variable))  # events are stored twice
        error = float(np.max(np.abs(found - values)))
        assert error <= 1e-4 * float(np.max(np.abs(values))), (variable, error)


MAIN = {
    **regulator.DEFAULTS,
    "V_line": 1e-3,
    "c": 5e3,
    "F_preload": 180.0,
    "damping_ratio": 25 / np.sqrt(5.0),  # 50 N s/m on 5 N/mm and 1 g
    "s_0": -180 / 1.005e6,
    "s_max": 3e-3,
    "d_spool": 20e-3,
    "coverage": 0.5,
    "chamfer": 0.2e-3,
    "overlap_converter": 0.3e-3,
    "overlap_lubrication": 0.45e-3,
    "overlap_suction": 0.6e-3,
    "jet_angle": 1.35,
    "A_feedback": 300e-6,
    "A_pilot": 450e-6,
    "V_feedback": 20e-6,
    "V_pilot": 30e-6,
    "d_feedback": 4e-3,
    "d_pilot": 4.5e-3,
    "p_converter": 5e5,
    "p_lubrication": 3e5,
    "q_start": 5 / 6e4,
    "q_end": 30 / 6e4,
    "q_ramp_start": 0.15,
    "q_ramp_duration": 0.01,
}


def test_main_regulator_follows_the_hand_written_equations() -> None:
    """The supply steps from 5 to 30 l/min within 10 ms while the pilot stands at 3 bar."""
    expected = regulator.solve(MAIN, "flow", stop_time=0.25, points=251, rtol=1e-8)
    compiled = acausal.load("TenSpeed.Benches.MainRegulatorFlowL1").compile(
        {"command.values": "{3e5, 3e5}", "supply.startTime": 0.15, "supply.duration": 0.01}
    )
    result = compiled.simulate(rtol=1e-8, stop_time=0.25, interval=0.001)
    names = ("s", "valve.stage.valve.spool.v", "valve.stage.valve.feedbackChamber.p")
    names += ("valve.stage.valve.pilotChamber.p", "p_line")
    times = np.linspace(0, 0.25, 251)
    for variable, values in zip(names, expected.states, strict=True):
        scale = float(np.max(np.abs(values)))
        found = np.interp(times, result.time, result.values(variable))
        assert np.allclose(found, values, rtol=0, atol=2e-5 * scale), variable
