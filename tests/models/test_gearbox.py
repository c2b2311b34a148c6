"""The gearbox: state counts found by the compiler, lumped gearsets against the measured ones."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import acausal
from benchmarks.sweep import gears, overload

PARTS = {  # level: states in cylinders, bodies and vehicle, planets
    1: (21, 18, 64),
    2: (21, 18, 0),
    3: (21, 16, 0),
    4: (21, 8, 0),
}


@cache
def energy_bench(level: int) -> acausal.CompiledModel:
    return acausal.load(f"TenSpeed.Benches.GearboxL{level}Energy").compile()


@pytest.mark.parametrize("level", PARTS)
def test_states(level: int) -> None:
    """The energy account has four states of its own, and takes nothing from those of the bench."""
    compiled = energy_bench(level)
    assert len([name for name in compiled.states if name.startswith("account.")]) == 4
    cylinders = [name for name in compiled.states if ".cylinder" in name]
    planets = [name for name in compiled.states if "_planet" in name or "_orbit" in name]
    rest = len(compiled.states) - len(cylinders) - len(planets) - 4
    assert (len(cylinders), rest, len(planets)) == PARTS[level]


def measured(gearset: int) -> tuple[float, float]:
    """Stiffness and play of a gearset at its sun, from the angles at rest under two torques."""
    compiled = acausal.load("TenSpeed.Benches.GearsetTorque").compile(
        {"data": f"TenSpeed.Gearbox.Data.P{gearset}"}
    )
    runs = [compiled.simulate(parameters={"tau": tau}) for tau in (50.0, 100.0)]
    low, high = (float(run.values("windUp")[-1]) for run in runs)
    stiffness = 50 / (high - low)
    return stiffness, 2 * (low - 50 / stiffness)


@pytest.mark.parametrize("gearset", [1, 2, 3, 4])
def test_lumped_values_are_the_measured_ones(gearset: int) -> None:
    flat = energy_bench(3).flat
    binding = {
        name: flat.by_name[f"gearbox.P{gearset}.data.{name}"].binding for name in ("c_lumped", "b_lumped")
    }
    assert binding["c_lumped"] is not None
    assert binding["b_lumped"] is not None
    stiffness, play = measured(gearset)
    assert binding["c_lumped"].number == pytest.approx(stiffness, rel=1e-3)
    assert binding["b_lumped"].number == pytest.approx(play, rel=1e-3)


@pytest.fixture(scope="module")
def sweep() -> acausal.Result:
    """The whole sweep at level 4; the other levels: `python -m benchmarks.sweep`."""
    return energy_bench(4).simulate(interval=5e-3)


@pytest.mark.slow
def test_every_gear_of_the_sweep_is_reached(sweep: acausal.Result) -> None:
    found = gears(sweep)
    assert [one.gear for one in found] == [-1, *range(1, 11), *range(9, 0, -1)]
    for one in found:
        assert abs(one.error) <= 0.003, one
        assert one.slip < 0.01, one
    assert found[-1].output_speed >= 20
    # In first the two-way clutch holds again after the last downshift
    late = (sweep.time > 43.8) & (sweep.time < 44)
    assert np.abs(sweep.values("slip_F1")[late]).max() < 0.025


@pytest.mark.slow
def test_clutches_hold_within_their_capacity(sweep: acausal.Result) -> None:
    assert max(overload(sweep).values()) <= 1 + 1e-9


@pytest.mark.slow
def test_energy_of_the_sweep_is_accounted_for(sweep: acausal.Result) -> None:
    assert sweep.values("account.E_in")[-1] > 5e5
    assert np.abs(sweep.values("account.error")).max() < 1e-4


@pytest.mark.parametrize("level", [2, 3])
def test_energy_of_elastic_gearsets_is_accounted_for(level: int) -> None:
    """From reverse into first, with all teeth passing through their play."""
    run = energy_bench(level).simulate(stop_time=1.0)
    assert run.values("account.E_moved")[-1] > 1e4
    assert np.abs(run.values("account.error")).max() < 1e-4


def test_energy_of_individual_planets_is_accounted_for() -> None:
    """The first teeth that meet at level 1; the whole sweep: `python -m benchmarks.sweep 1`."""
    run = energy_bench(1).simulate(stop_time=0.05, interval=1e-3)
    assert run.values("account.E_moved")[-1] > 40
    assert run.values("account.E_loss")[-1] > 0.1
    assert np.abs(run.values("account.error")).max() < 1e-4


@pytest.mark.slow
def test_plates_that_let_go_hardly_slipping_do_not_chatter() -> None:
    """C2 in the shift to seventh: its slip is below what CVODE's errors are on shafts of 300 rad/s."""
    run = energy_bench(4).simulate(stop_time=18.4, solver="cvode", interval=1e-2)
    assert run.statistics.events < 60


@pytest.mark.parametrize("solver", ["lieuler", "rosenbrock"])
def test_linearly_implicit_steps_ten_times_as_long_as_stable_ones_of_heun(solver: str) -> None:
    """Level 1, where teeth touch and part within a step; Heun's longest stable step is 7.4 us."""
    bench = energy_bench(1)
    wanted = bench.simulate(stop_time=0.03, rtol=1e-5, compiled=False).final(["vehicle.inertia.w"])
    found = bench.simulate(stop_time=0.03, solver=solver, step=7.5e-5, compiled=False)
    assert found.final(["vehicle.inertia.w"])["vehicle.inertia.w"] == pytest.approx(
        wanted["vehicle.inertia.w"], rel=0.02
    )
    assert found.statistics.events < 20
