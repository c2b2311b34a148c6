"""The oil is replaced at the top of a bench, circuit or gearbox, and reaches every part."""

from __future__ import annotations

import re

import pytest

import acausal

MINERAL = "redeclare package Oil = Hydraulics.Media.OilMineralVG32"
BENCHES = [
    *(
        f"{name}L{level}"
        for name in ("LinearSolenoid", "LubricationRegulator", "CutValve")
        for level in (1, 5)
    ),
    *(
        "ShiftSolenoidL1",
        "MainRegulatorFlowL1",
        "MainRegulatorPressureL5",
        "ConverterRegulatorL5",
        "LockupControlL1",
    ),
    *("LineAccumulatorL1", "LineAccumulatorL4", "TwoWayClutchValveL1", "RegulationCircuitPressure"),
    "TorqueConverterDriveL4",
]


@pytest.mark.parametrize("name", BENCHES)
def test_every_part_has_the_oil_of_the_bench(name: str) -> None:
    assert viscosities(f"model X extends TenSpeed.Benches.{name}({MINERAL}); end X;") == {"3.2e-05"}


def test_every_cylinder_has_the_oil_of_the_gearbox() -> None:
    assert viscosities(f"model X extends TenSpeed.Gearbox.Level4({MINERAL}); end X;") == {"3.2e-05"}


@pytest.mark.parametrize("valve", ["ReliefValve", "ThreeWayValve", "ThreeWayMap", "MainRegulatorValve"])
def test_every_part_of_a_valve_has_its_oil(valve: str) -> None:
    assert viscosities(f"model X extends Hydraulics.Valves.{valve}({MINERAL}); end X;") == {"3.2e-05"}


def viscosities(text: str) -> set[str]:
    """Values of all parameters `nu` that are not taken from another one."""
    flat = acausal.loads(text).show("flat")
    found = re.findall(r"parameter Real '(?:[^']*\.)?nu'\(.*?\) = ([^ ]+) \"", flat)
    assert found
    return {value for value in found if not value.startswith("'")}


def test_another_oil_changes_a_run() -> None:
    """A laminar flow is in inverse proportion to the viscosity."""
    runs = [
        acausal.loads(f"model X extends Hydraulics.Examples.LaminarOrificeFlow{oil}; end X;")
        .compile()
        .simulate()
        for oil in ("", f"(capillary({MINERAL}))")
    ]
    flows = [abs(float(run.values("capillary.m_flow")[-1])) for run in runs]
    assert flows[1] / flows[0] == pytest.approx(29.6 / 32, rel=1e-9)
