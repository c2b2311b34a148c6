"""The gearbox: state counts found by the compiler, lumped gearsets against the measured ones."""

from __future__ import annotations

import numpy as np
import pytest

import acausal

PARTS = {  # level: states in cylinders, bodies and vehicle, planets
    1: (21, 18, 64),
    2: (21, 18, 0),
    3: (21, 16, 0),
    4: (21, 8, 0),
}


@pytest.mark.parametrize("level", PARTS)
def test_states(level: int) -> None:
    compiled = acausal.load(f"TenSpeed.Benches.GearboxL{level}").compile()
    cylinders = [name for name in compiled.states if ".cylinder" in name]
    planets = [name for name in compiled.states if "_planet" in name or "_orbit" in name]
    rest = len(compiled.states) - len(cylinders) - len(planets)
    assert (len(cylinders), rest, len(planets)) == PARTS[level]


def measured(gearset: int) -> tuple[float, float]:
    """Stiffness and play of a gearset at its sun, from the angles at rest under two torques."""
    model = acausal.load("TenSpeed.Benches.GearsetTorque")
    compiled = model.compile({"data": f"TenSpeed.Gearbox.Data.P{gearset}"})
    runs = [compiled.simulate(parameters={"tau": tau}) for tau in (50.0, 100.0)]
    low, high = (float(run.values("windUp")[-1]) for run in runs)
    stiffness = 50 / (high - low)
    return stiffness, 2 * (low - 50 / stiffness)


@pytest.mark.parametrize("gearset", [1, 2, 3, 4])
def test_lumped_values_are_the_measured_ones(gearset: int) -> None:
    flat = acausal.load("TenSpeed.Benches.GearboxL3").compile().flat
    binding = {
        name: flat.by_name[f"gearbox.P{gearset}.data.{name}"].binding for name in ("c_lumped", "b_lumped")
    }
    assert binding["c_lumped"] is not None
    assert binding["b_lumped"] is not None
    stiffness, play = measured(gearset)
    assert binding["c_lumped"].number == pytest.approx(stiffness, rel=1e-3)
    assert binding["b_lumped"].number == pytest.approx(play, rel=1e-3)


def test_sweep_shifts_gears() -> None:
    """The first 12 s of the sweep at level 4: reverse, park, neutral, first to third."""
    run = acausal.load("TenSpeed.Benches.GearboxL4").compile().simulate(stop_time=11.95, interval=0.05)
    ratio, gear, w_4 = run.values("ratio"), run.values("gear"), run.values("slip_F1")
    w_8 = run.values("gearbox.body[8].w")
    # In reverse and first the two-way clutch creeps under load; its share in w_1 is taken out
    i1, i2, i3, i4 = 130 / 42, 81 / 43, 103 / 37, 76 / 48
    first = (1 + i3) * (1 + i1) / i1 - i3 * (1 + i2)  # d w_1 / d w_4 with bodies 5 and 6 held
    reverse = i3 * (1 + i2) / ((1 + i3) * i4 / (1 + i4) - 1)  # with body 6 held and 7 on body 1
    share = {-1: reverse, 1: first}
    for time, wanted, table in ((1.95, -1, -3.974), (7.95, 1, 5.246), (9.95, 2, 3.271), (11.95, 3, 2.185)):
        i = int(np.searchsorted(run.time, time - 1e-9))
        creep = share.get(wanted, 0.0) * w_4[i] / w_8[i]
        assert gear[i] == wanted
        assert ratio[i] - creep == pytest.approx(table, abs=0.003)


def test_clutches_hold_within_their_capacity() -> None:
    compiled = acausal.load("TenSpeed.Benches.GearboxL4").compile()
    run = compiled.simulate(stop_time=9.0, interval=0.01)
    for name in ("C1", "C2", "C3", "B1", "B2", "B3"):
        torque, capacity = run.values(f"torque_{name}"), run.values(f"gearbox.{name}.capacity")
        assert (np.abs(torque) <= capacity * (1 + 1e-9) + 1e-6).all()
