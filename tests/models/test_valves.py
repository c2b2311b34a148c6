"""The valves of the ten-speed at every level: states, mass, characteristics, supplies."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray

import acausal
from acausal.simulate.result import Result
from tests.models import reference_main_regulator as fluid

STATES = {  # levels 1 to 5
    "LinearSolenoid": (5, 4, 3, 2, 0),
    "ShiftSolenoid": (4, 3, 2, 1, 0),
    "MainRegulatorFlow": (5, 5, 4, 4, 0),
    "MainRegulatorPressure": (4, 4, 3, 3, 0),
    "LubricationRegulator": (4, 4, 3, 2, 0),
    "ConverterRegulator": (5, 5, 4, 2, 0),
    "LineAccumulator": (3, 3, 2, 0),
    "LockupControl": (5, 5, 4, 2, 0),
    "SwitchValve": (3, 3, 2, 1, 0),
    "CutValve": (3, 3, 2, 1, 0),
    "TwoWayClutchValve": (8, 8, 1, 2, 0),
}
BENCHES = [(f"{name}L{level}", n) for name, row in STATES.items() for level, n in enumerate(row, 1)]
P_0 = 101325.0

Array = NDArray[np.float64]


@cache
def bench(name: str) -> acausal.CompiledModel:
    """A compiled bench."""
    return acausal.load(f"TenSpeed.Benches.{name}").compile()


@cache
def run(name: str) -> Result:
    """A run of a bench over its own experiment."""
    return bench(name).simulate(interval=0.005)


def at(result: Result, variable: str, times: list[float]) -> Array:
    """Values at stored instants."""
    return result.values(variable)[np.searchsorted(result.time, np.array(times) - 1e-9)]


@pytest.mark.parametrize(
    ("name", "states"), [*BENCHES, ("RegulationCircuitFlow", 17), ("RegulationCircuitPressure", 16)]
)
def test_states(name: str, states: int) -> None:
    assert len(bench(name).states) == states


@pytest.mark.parametrize(
    "name", [*(f"{name}L{level}" for name in STATES for level in (1, 4)), "RegulationCircuitFlow"]
)
def test_mass_is_conserved(name: str) -> None:
    """inflow - outflow = dm/dt, by the slope of the hand-written density, not the model's bulk modulus."""
    compiled = bench(name)
    result = compiled.simulate(interval=0.05)
    inflow, outflow = result.values("inflow"), result.values("outflow")
    throughput = float(np.max(np.abs(inflow) + np.abs(outflow)))
    assert np.max(np.abs(inflow - outflow - stored(compiled, result))) <= 1e-8 * throughput


def stored(compiled: acausal.CompiledModel, result: Result) -> Array:
    """Sum of d(rho V)/dt over all volumes."""
    total = np.zeros(len(result.time))
    for name in compiled.flat.by_name:
        volume, _, last = name.rpartition(".")
        if last == "K":
            slope, rho = np.array([density_slope(p) for p in result.values(f"{volume}.p")]).T
            total += slope * result.values(f"der({volume}.p)") * result.values(f"{volume}.V")
            total += rho * result.values(f"{volume}.V_flow")
    return total


def density_slope(pressure: float) -> tuple[float, float]:
    """Derivative of the density by the pressure, and the density."""
    volume, slope = fluid.specific_volume(pressure, fluid.DEFAULTS)
    rho = fluid.DEFAULTS["rho_ref"] / volume
    return -rho * slope / volume, rho


def test_the_integrated_balance_closes() -> None:
    text = """model Balance
      extends TenSpeed.Benches.RegulationCircuitFlow;
      Real net(unit = "kg", start = 0, fixed = true, nominal = 0.1);
      Real throughput(unit = "kg", start = 0, fixed = true, nominal = 0.1);
    equation
      der(net) = inflow - outflow;
      der(throughput) = inflow;
    end Balance;"""
    result = acausal.loads(text).compile().simulate(rtol=1e-6, stop_time=1.0, interval=0.01)
    error = result.values("m_oil") - result.values("m_oil")[0] - result.values("net")
    assert np.max(np.abs(error)) < 1e-5 * float(result.values("throughput")[-1])


PLATEAUS = [0.2 * k + 0.19 for k in range(1, 10)]
"""Instants at which the benches of the solenoids rest at 0.1 to 0.9 A."""


@pytest.mark.parametrize("level", [1, 2, 3, 4, 5])
def test_linear_solenoid_is_proportional(level: int) -> None:
    result = run(f"LinearSolenoidL{level}")
    current, pressure = at(result, "i_cmd", PLATEAUS), at(result, "p_out", PLATEAUS) - P_0
    slope = (current @ pressure) / (current @ current)
    assert np.max(np.abs(pressure / (slope * current) - 1)) < 0.02
    finest = at(run("LinearSolenoidL1"), "p_out", PLATEAUS) - P_0
    assert np.max(np.abs(pressure / finest - 1)) < 0.005


@pytest.mark.parametrize("level", [1, 2, 3, 4, 5])
def test_shift_solenoid_fills_and_drains(level: int) -> None:
    result = run(f"ShiftSolenoidL{level}")
    pressure = at(result, "p_out", PLATEAUS)
    assert np.allclose(pressure[:3], P_0, atol=100)
    assert np.allclose(pressure[4:], pressure[-1], rtol=1e-4)
    assert pressure[-1] > 0.98 * result.values("p_supply")[-1]
    finest = at(run("ShiftSolenoidL1"), "p_out", PLATEAUS)
    assert np.allclose(
        np.delete(pressure, 3), np.delete(finest, 3), rtol=0.001
    )  # at 0.4 A it has just opened
    assert pressure[3] == pytest.approx(finest[3], rel=0.025)


@pytest.mark.parametrize("level", [1, 2, 3, 4, 5])
@pytest.mark.parametrize(
    ("name", "pressure", "drained"),
    [
        ("MainRegulatorFlow", "p_line", "q_supply"),
        ("LubricationRegulator", "p_out", "q_drain"),
        ("ConverterRegulator", "p_out", "q_drain"),
    ],
)
def test_regulators_hold_their_pressure(name: str, pressure: str, drained: str, level: int) -> None:
    """The main regulator from 5 to 30 l/min of the supply, the others from 2 to 17 l/min through them."""
    result = run(f"{name}L{level}")
    regulating = result.time > 0.45
    held, flow = result.values(pressure)[regulating] - P_0, 6e4 * result.values(drained)[regulating]
    assert flow[0] < 5.01
    assert flow[-1] > (29.9 if name == "MainRegulatorFlow" else 17.0)
    assert np.ptp(held) < 0.03 * np.mean(held)
    finest = run(f"{name}L1").values(pressure)[regulating] - P_0
    tolerance = {4: 0.015, 5: 0.003}.get(level, 0.001)  # level 4 of the main regulator has no flow forces
    assert np.allclose(held[[0, -1]], finest[[0, -1]], rtol=tolerance)


@pytest.mark.parametrize("name", ["SwitchValve", "CutValve"])
@pytest.mark.parametrize("level", [1, 2, 3, 4, 5])
def test_switch_valves_switch_at_their_threshold(name: str, level: int) -> None:
    result = run(f"{name}L{level}")
    open_ = np.flatnonzero(result.values("p_out") > 6e5)
    up, down = (float(result.values("p_pilot")[i]) for i in (open_[0], open_[-1]))
    if level == 5:  # no memory, hence no hysteresis
        assert up == pytest.approx(3.61e5, rel=0.03)
        assert down == pytest.approx(up, rel=0.02)
    else:  # the latch's land holds the spool; a flow force of the cut valve's jets delays it
        supply_edge = P_0 + (20 + 2e3 * 2.2e-3) / 78.5e-6
        latched = P_0 + (20 + 2e3 * 2.2e-3 - 10e-6 * 9.4e5) / 78.5e-6
        assert up == pytest.approx(supply_edge, rel=0.06)
        assert down == pytest.approx(latched, rel=0.08 if name == "SwitchValve" else 0.16)
    if name == "CutValve":
        drained = result.values("drained")
        assert drained[open_[0] - 40] < 1e-2 * drained.max()
        assert drained[open_[0] + 100] > 0.5 * drained.max()


@pytest.mark.parametrize("name", ["SwitchValveL4", "LinearSolenoidL4"])
def test_no_solver_steps_over_a_pulse_of_the_command(name: str) -> None:
    """At rest steps grow without bound; the start of each ramp ends them."""
    runs = [bench(name).simulate(solver=solver, interval=0.02) for solver in ("cvode", "rodas")]
    assert np.allclose(runs[0].values("p_out"), runs[1].values("p_out"), rtol=0.01)


def test_lockup_control_follows_its_command() -> None:
    finest = at(run("LockupControlL1"), "p_out", PLATEAUS) - P_0
    assert np.all(finest[:2] < 100)
    assert np.allclose(np.diff(finest[2:]), 0.9e5, rtol=0.03)  # 1.5 bar for each bar, less the spring
    for level in (2, 3, 4, 5):
        assert np.allclose(
            at(run(f"LockupControlL{level}"), "p_out", PLATEAUS) - P_0, finest, rtol=0.01, atol=3e3
        )


@pytest.mark.parametrize("level", [1, 2, 3, 5])
def test_detents_hold_on_both_sides_and_pass_at_the_designed_pressure(level: int) -> None:
    """Both pressures of a side rise slowly: 2 (F + c h) dh/ds of the cam, at its largest, on two lands."""
    result = run(f"TwoWayClutchValveL{level}")
    s, drive, reverse = (result.values(name) for name in ("s", "p_drive", "p_reverse"))
    phase = np.linspace(0, np.pi, 10001)
    h = 0.5e-3 * (1 - np.cos(phase))
    designed = P_0 + np.max(2 * (15 + 10e3 / 1.01 * h) * 0.5e-3 * np.sin(phase) * 2 * np.pi / 8e-3) / 80e-6
    there = int(np.argmax(s > 4e-3))
    back = there + int(np.argmax(s[there:] < 4e-3))
    assert drive[there] == pytest.approx(designed, rel=0.03)
    assert reverse[back] == pytest.approx(designed, rel=0.03)
    resting = (result.time > 6.0) & (result.time < 6.1)
    assert np.allclose(s[resting], 8e-3, atol=2e-5)
    assert s[-1] == pytest.approx(0, abs=2e-5)


PUMP = "Hydraulics.Sources.SlippingPump supply(q_start = 10/60000, p_shutOff = 11e5)"
PRESSURE = "Hydraulics.Sources.PressureSource supply(p_start = 101325, p_end = 9e5, duration = 0.3)"


@pytest.mark.parametrize(
    ("name", "states", "supply", "time", "pressure"),
    [
        ("LinearSolenoidL1", 5, PUMP, 1.19, 5.52e5),
        ("LockupControlL4", 2, PUMP, 1.19, 3.32e5),
        ("SwitchValveL2", 3, PUMP, 2.4, 9.5e5),
        ("ConverterRegulatorL1", 5, PRESSURE, 1.0, 6.13e5),
        ("LubricationRegulatorL5", 0, PRESSURE, 1.0, 3.07e5),
    ],
)
def test_benches_run_with_the_other_supply(
    name: str, states: int, supply: str, time: float, pressure: float
) -> None:
    text = f"model Other extends TenSpeed.Benches.{name}(redeclare {supply}); end Other;"
    compiled = acausal.loads(text).compile()
    assert len(compiled.states) == states
    found = at(compiled.simulate(stop_time=time + 0.1, interval=0.01), "p_out", [time])
    assert found[0] == pytest.approx(pressure, rel=0.02)


def test_a_bench_at_a_pressure_takes_a_flow_by_redeclaration() -> None:
    source = "redeclare Hydraulics.Sources.FlowSource supply(q_start = 5e-4)"
    for name, states in (("MainRegulatorPressureL3", 4), ("RegulationCircuitPressure", 17)):
        compiled = acausal.loads(f"model F extends TenSpeed.Benches.{name}({source}); end F;").compile()
        assert len(compiled.states) == states


def test_accumulator_takes_oil() -> None:
    result = run("LineAccumulatorL1")
    rise = result.values("m_oil")[-1] - result.values("m_oil")[0]
    assert rise == pytest.approx(830 * 500e-6 * 12.76e-3, rel=0.03)
    flow = acausal.loads(
        f"model F extends TenSpeed.Benches.LineAccumulatorL4(redeclare {PUMP}); end F;"
    ).compile()
    assert list(flow.states) == ["valve.stage.volume.p"]  # its volume is the line


def test_regulation_circuit_at_a_fixed_step() -> None:
    """Linearly implicit steps of 50 us and more: pressures within 2 % of CVODE's, at every millisecond."""
    circuit = bench("RegulationCircuitFlow")
    wanted = circuit.simulate(solver="cvode", rtol=1e-7, stop_time=0.7, interval=1e-3)
    for solver, step, tolerance in (("lieuler", 5e-5, 0.02), ("rosenbrock", 2e-4, 1e-3)):
        found = circuit.simulate(solver=solver, step=step, stop_time=0.7, interval=1e-3)
        for name in circuit.states:
            if name.endswith(".p"):
                error = np.max(np.abs(found.values(name) / wanted.values(name) - 1))
                assert error < tolerance, (solver, name, error)
    assert 1e-6 < circuit.linearize(0.55).step_limit("heun") < 1e-5


def test_regulation_circuit_of_maps() -> None:
    """Every regulator at level 5: closed, and while its edges open, trial steps lead the blocks far away."""
    levels = ", ".join(
        f"redeclare model {part} = TenSpeed.Valves.Levels.{name}"
        for part, name in (
            ("Main", "MainRegulatorL5"),
            ("Lubrication", "LubricationRegulatorL5"),
            ("Converter", "ConverterRegulatorL5"),
            ("Accumulator", "LineAccumulatorL4"),
        )
    )
    text = f"model Maps extends TenSpeed.Benches.RegulationCircuitFlow({levels}); end Maps;"
    compiled = acausal.loads(text).compile()
    assert list(compiled.states) == ["accumulator.stage.volume.p"]
    finest = run("RegulationCircuitFlow")
    for solver, rtol in (
        ("rodas", 1e-6),
        ("cvode", 1e-4),
        ("cvode", 1e-7),
        ("cvode-adams", 1e-5),
        ("ida", 1e-6),
    ):
        result = compiled.simulate(stop_time=2.5, solver=solver, rtol=rtol)
        for name in ("p_line", "p_converter", "p_lubrication"):
            assert result.values(name)[-1] == pytest.approx(finest.values(name)[-1], rel=2e-3)


def test_circuits_agree_when_the_pressure_is_the_one_of_the_flow() -> None:
    """Fed by the pressure that the flow-fed circuit found, the circuit takes that flow."""
    flow = run("RegulationCircuitFlow")
    line = float(flow.values("p_line")[-1])
    result = bench("RegulationCircuitPressure").simulate(parameters={"supply.p_end": line}, interval=0.01)
    assert result.values("q_supply")[-1] == pytest.approx(0.5e-3, rel=1e-3)
    for name in ("p_converter", "p_lubrication"):
        assert result.values(name)[-1] == pytest.approx(flow.values(name)[-1], rel=1e-5)
