"""Every bundled example compiles and runs, and is its own test through `error` where it has one."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np
import pytest

import acausal
from acausal.lang.library import ClassNode, Library, bundled_directories

LIMITS = {
    # `error` compares with the turbulent law, which holds away from zero pressure difference only
    "Hydraulics.Examples.OrificeFlow": 1e-3,
    "Hydraulics.Examples.SpoolEdgeSweep": 1.0,
    # the leakage of the covered edge takes a little from the outlet's pressure
    "Hydraulics.Examples.ThreeWaySpool": 5e-3,
}
AT_REST = (
    "Hydraulics.Examples.ClutchFilling",
    "Hydraulics.Examples.CylinderMoves",
    "Hydraulics.Examples.FeedbackLands",
    "Hydraulics.Examples.PumpAndLaminarLoad",
    "Hydraulics.Examples.RegulatorBench",
    "Hydraulics.Examples.ReliefHoldsPressure",
    "Hydraulics.Examples.ReliefSpool",
    "Hydraulics.Examples.ReliefSpoolMineralOil",
    "Hydraulics.Examples.SpoolBetweenStops",
    "Hydraulics.Examples.ThreeWaySpool",
    "Mechanics.Rotational.Examples.ElasticPlanetaryWindUp",
    "Mechanics.Rotational.Examples.FrictionBrakeHolds",
    "Mechanics.Rotational.Examples.GearPairWindUp",
    "Mechanics.Rotational.Examples.HelicalPlanetaryWindUp",
    "Mechanics.Rotational.Examples.SmoothClutchCreeps",
    "Mechanics.Translational.Examples.ClutchPistonAtPack",
)
"""`error` is a balance of forces that holds at rest, at the end."""


PACKAGES = ("Signals", "Mechanics", "Hydraulics", "Electrical", "TenSpeed")


def examples() -> Iterator[str]:
    """Full names of all models in packages called Examples."""
    return (name for name in models() if ".Examples." in name)


def components() -> Iterator[str]:
    """Full names of all models of libraries that are not examples."""
    return (name for name in models() if ".Examples." not in name and not name.startswith("TenSpeed."))


def models() -> Iterator[str]:
    """Full names of all models and blocks that are not partial."""
    library = Library(tuple(bundled_directories()))
    for name in PACKAGES:
        yield from _below(library.find(name))


def _below(node: ClassNode) -> Iterator[str]:
    definition = node.definition
    if definition.kind in ("model", "block") and not definition.class_prefixes.partial:
        yield node.path
    for name in node.child_names():
        child = node.child(name)
        if child is not None:
            yield from _below(child)


@pytest.mark.parametrize("name", list(examples()))
def test_example(name: str) -> None:
    compiled = acausal.load(name).compile()
    assert not [w for w in compiled.warnings if w.severity == "error"]
    run = compiled.simulate(rtol=1e-8)
    assert not run.warnings
    if "error" in compiled.flat.by_name:
        errors = np.abs(run.values("error"))
        worst = float(errors[-1] if name in AT_REST else np.max(errors))
        assert worst <= LIMITS.get(name, 1e-5), f"{name}: error {worst}"


def test_every_component_of_the_mechanics_library_has_an_example() -> None:
    folder = next(path for path in bundled_directories() if path.name == "mechanics") / "Mechanics"
    texts = {
        domain: " ".join(
            path.read_text(encoding="utf-8") for path in (folder / domain / "Examples").glob("*.mo")
        )
        for domain in ("Rotational", "Translational")
    }
    names = [name.split(".")[1:] for name in components() if name.startswith("Mechanics.")]
    assert len(names) > 50
    assert [path for path in names if not re.search(rf"\b{path[-1]}\b", texts[path[0]])] == []


@pytest.mark.parametrize("name", list(components()))
def test_component(name: str) -> None:
    """Every component is balanced by itself, whatever will be connected to it."""
    model = acausal.load(name)
    codes = problems(model)
    assert codes <= {"parameter.no-value", "array.unknown-size"}  # what the user must give is no fault


def problems(model: acausal.Model) -> set[str]:
    """Codes of what a check finds wrong."""
    try:
        model.check()
    except acausal.AcausalError as error:
        return {diagnostic.code for diagnostic in error.diagnostics}
    return set()
