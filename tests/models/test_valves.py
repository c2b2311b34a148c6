"""The valves of the ten-speed: states, characteristics, mass balance, and independent equations."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import acausal
from acausal.simulate.result import Result
from tests.models import reference_main_regulator as fluid
from tests.models import reference_valves as reference

STATES = {  # levels 1 to 5
    "LinearSolenoid": (5, 4, 3, 2, 0),
    "ShiftSolenoid": (4, 3, 2, 1, 0),
}
BENCHES = [(f"{name}L{level}", n) for name, row in STATES.items() for level, n in enumerate(row, 1)]
P_0 = 101325.0


@cache
def bench(name: str) -> acausal.CompiledModel:
    """A compiled bench."""
    return acausal.load(f"TenSpeed.Benches.{name}").compile()


@cache
def run(name: str, **parameters: float) -> Result:
    """A run of a bench over its own experiment."""
    return bench(name).simulate(parameters=dict(parameters))


def at(result: Result, variable: str, times: list[float]) -> np.ndarray:
    """Values at stored instants."""
    return result.values(variable)[np.searchsorted(result.time, np.array(times) - 1e-9)]


def stored(compiled: acausal.CompiledModel, result: Result) -> np.ndarray:
    """Sum of d(rho V)/dt over all volumes of the valve, by the slope of the hand-written density."""
    total = np.zeros(len(result.time))
    for name in compiled.flat.by_name:
        volume, _, last = name.rpartition(".")
        if last == "K" and volume.startswith("valve."):
            slope, rho = np.array([density_slope(p) for p in result.values(f"{volume}.p")]).T
            total += slope * result.values(f"der({volume}.p)") * result.values(f"{volume}.V")
            total += rho * result.values(f"{volume}.V_flow")
    return total


def density_slope(pressure: float) -> tuple[float, float]:
    """Derivative of the density by the pressure, and the density."""
    volume, slope = fluid.specific_volume(pressure, fluid.DEFAULTS)
    rho = fluid.DEFAULTS["rho_ref"] / volume
    return -rho * slope / volume, rho


@pytest.mark.parametrize(("name", "states"), BENCHES)
def test_states(name: str, states: int) -> None:
    assert len(bench(name).states) == states


@pytest.mark.parametrize("name", [name for name, _ in BENCHES])
def test_mass_is_conserved(name: str) -> None:
    """inflow - outflow = dm/dt, the derivative by that of the density, not by the balance itself."""
    compiled = bench(name)
    result = compiled.simulate(interval=0.02)
    throughput = np.abs(result.values("inflow")) + np.abs(result.values("outflow"))
    change = result.values("inflow") - result.values("outflow") - stored(compiled, result)
    assert float(np.max(np.abs(change))) <= 1e-8 * float(np.max(throughput))


PLATEAUS = [0.2 * k + 0.19 for k in range(1, 10)]
"""Instants at which the solenoids' benches rest at 0.1 to 0.9 A."""


@pytest.mark.parametrize("level", [1, 2, 3, 4, 5])
def test_linear_solenoid_is_proportional(level: int) -> None:
    result = run(f"LinearSolenoidL{level}")
    current, pressure = at(result, "i_cmd", PLATEAUS), at(result, "p_out", PLATEAUS) - P_0
    slope = (current @ pressure) / (current @ current)
    assert np.max(np.abs(pressure / (slope * current) - 1)) < 0.02
    finest = at(run("LinearSolenoidL1"), "p_out", PLATEAUS) - P_0
    assert np.max(np.abs(pressure / finest - 1)) < 0.005


def test_linear_solenoid_follows_the_hand_written_equations() -> None:
    """Step to 0.6 A: rise of the pressure with the spool against its upper stop, then regulation."""
    model = acausal.load("TenSpeed.Benches.LinearSolenoidL1")
    compiled = model.compile({"command.times": "{0.01, 1}", "command.values": "{0, 0.6, 0.6}"})
    _, expected = reference.solve_solenoid(reference.SOLENOID, (0.01, 0.02, 0.6), stop_time=0.1, points=201)
    result = compiled.simulate(rtol=1e-8, stop_time=0.1, interval=0.0005)
    names = ("i", "s", "valve.stage.valve.spool.v", "valve.stage.feedback.chamber.p", "p_out")
    for variable, values in zip(names, expected, strict=True):
        found = result.values(variable)
        assert np.allclose(found, values, rtol=0, atol=2e-5 * float(np.max(np.abs(values)))), variable
