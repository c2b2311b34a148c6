"""The mechanics library: friction laws compared, and the library read by other tools."""

from __future__ import annotations

import os
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import acausal
from acausal.lang.library import bundled_directories

# The fixture that isolates the tests takes MODELICAPATH away, so it is read when this file is collected.
MODELICAPATH = os.environ.get("MODELICAPATH", "")
FOLDERS = ("Mechanics", "Signals", "TenSpeed")


@pytest.mark.parametrize(
    ("law", "kept"), [("elastic", 1e-3), ("rigid", 1e-12), ("karnopp", 0.01), ("smooth", 1e-6)]
)
def test_friction_laws_differ_in_how_plates_stick(law: str, kept: float) -> None:
    compiled = acausal.load("Mechanics.Rotational.Examples.FrictionLaws").compile(
        {"law": f"Mechanics.Types.StickLaw.{law}"}
    )
    run = compiled.simulate(rtol=1e-8)
    assert len(compiled.states) == 4
    assert np.abs(run.values("error")).max() < 0.02
    late = run.time > run.parameters["t_stick"] + 0.3
    assert np.abs(run.values("clutch.w_rel")[late]).max() <= kept


def test_rigid_plates_have_no_slip_at_all() -> None:
    run = acausal.load("Mechanics.Rotational.Examples.RigidClutchesInRow").compile().simulate(rtol=1e-8)
    for name in ("left", "right"):
        stuck = run.values(f"{name}.stuck") == 1
        assert stuck.any()
        assert not stuck.all()
        assert (run.values(f"{name}.slip")[stuck] == 0).all()
        assert np.abs(run.values(f"{name}.w_rel")[stuck]).max() < 1e-9
        held = np.abs(run.values(f"{name}.tau"))[stuck]
        assert (held <= run.values(f"{name}.capacity")[stuck] * (1 + 1e-9)).all()


def test_a_gearbox_with_rigid_clutches_shifts() -> None:
    run = acausal.load("TenSpeed.Examples.RigidClutches").compile().simulate()
    assert run.values("ratio")[-2] == pytest.approx(5.252, abs=0.005)
    held = [name for name in ("C1", "C2", "C3", "B1", "B2", "B3") if run.values(f"gearbox.{name}.stuck")[-2]]
    assert held == ["B1", "B2"]
    for name in held:
        assert run.values(f"gearbox.{name}.slip")[-2] == 0


def test_elastic_plates_wind_up_by_no_more_than_their_capacity() -> None:
    run = acausal.load("Mechanics.Rotational.Examples.ClutchSticks").compile().simulate()
    wind_up = np.abs(run.values("clutch.windUp")) * run.parameters["clutch.c"]
    assert (wind_up <= run.values("clutch.capacity") * (1 + 1e-9)).all()
    assert wind_up.max() > 0.9 * run.values("clutch.capacity").max()


def sources() -> list[Path]:
    """Every file of the libraries of this part."""
    return sorted(
        file
        for root in bundled_directories()
        for folder in FOLDERS
        for file in (Path(root) / folder).rglob("*.mo")
    )


@pytest.mark.slow
@pytest.mark.skipif(find_spec("pymoca") is None, reason="pymoca is not installed")
def test_pymoca_reads_the_libraries() -> None:
    parser: Any = import_module("pymoca.parser")
    unread = [file.name for file in sources() if parser.parse(file.read_text()) is None]
    assert len(sources()) > 100
    assert not unread


MIXED = """
model Mixed "Parts of both libraries between each other's flanges"
  Modelica.Mechanics.Rotational.Sources.ConstantTorque drive(tau_constant = 6);
  Mechanics.Rotational.Components.Inertia first(
    J = 0.2, phi(start = 0, fixed = true), w(start = 0, fixed = true));
  Modelica.Mechanics.Rotational.Components.IdealGear gear(ratio = 2, useSupport = false);
  Mechanics.Rotational.Components.IdealEngagement clutch(engaged = true);
  Modelica.Mechanics.Rotational.Components.Inertia second(J = 0.8);
  Modelica.Mechanics.Translational.Components.Fixed wall;
  Mechanics.Translational.Components.Spring spring(c = 50);
  Modelica.Mechanics.Translational.Components.Mass mass(
    m = 0.5, s(start = 0.1, fixed = true), v(start = 0, fixed = true));
  Modelica.Blocks.Sources.Constant push(k = 0);
  Mechanics.Translational.Sources.ForceSignal force;
equation
  connect(drive.flange, first.flange_a);
  connect(first.flange_b, gear.flange_a);
  connect(gear.flange_b, clutch.flange_a);
  connect(clutch.flange_b, second.flange_a);
  connect(wall.flange, spring.flange_a);
  connect(spring.flange_b, mass.flange_a);
  connect(push.y, force.f);
  connect(force.flange, mass.flange_b);
  annotation(uses(Modelica(version = "4.0.0")));
end Mixed;
"""


@pytest.mark.skipif(not MODELICAPATH, reason="MODELICAPATH does not name the Modelica Standard Library")
def test_flanges_connect_to_those_of_the_standard_library(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MODELICAPATH", MODELICAPATH)
    run = acausal.loads(MIXED, "Mixed").compile().simulate(stop_time=1.0, rtol=1e-8)
    # 6 N.m on 0.2 kg.m2 and, through the ratio 2, on 0.8 kg.m2
    assert run.values("first.w")[-1] == pytest.approx(6 / (0.2 + 0.8 / 4), rel=1e-9)
    assert run.values("mass.s") == pytest.approx(0.1 * np.cos(10 * run.time), abs=1e-7)
