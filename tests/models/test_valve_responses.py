"""Step responses of valves against the independent implementation of their equations."""

from __future__ import annotations

import numpy as np

import acausal
from tests.models import reference_main_regulator as regulator
from tests.models import reference_valves as reference


def test_linear_solenoid_follows_the_hand_written_equations() -> None:
    """Step to 0.6 A: the spool meets its upper stop, then regulates."""
    model = acausal.load("TenSpeed.Benches.LinearSolenoidL1")
    compiled = model.compile({"command.times": "{0.01, 1}", "command.values": "{0, 0.6, 0.6}"})
    _, expected = reference.solve_solenoid(reference.SOLENOID, (0.01, 0.02, 0.6), stop_time=0.1, points=201)
    result = compiled.simulate(rtol=1e-8, stop_time=0.1, interval=0.0005)
    names = ("i", "s", "valve.stage.valve.spool.v", "valve.stage.feedback.chamber.p", "p_out")
    for variable, values in zip(names, expected, strict=True):
        found = result.values(variable)
        assert np.allclose(found, values, rtol=0, atol=2e-5 * float(np.max(np.abs(values)))), variable


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
    for variable, values in zip(names, expected.states, strict=True):
        scale = float(np.max(np.abs(values)))
        assert np.allclose(result.values(variable), values, rtol=0, atol=2e-5 * scale), variable
