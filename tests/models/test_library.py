"""Every bundled example compiles and runs, and is its own test through `error` where it has one."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

import acausal
from acausal.lang.library import ClassNode, Library, bundled_directories

LIMITS = {
    # `error` compares with the turbulent law, which holds away from zero pressure difference only
    "Hydraulics.Examples.OrificeFlow": 1e-3,
    "Hydraulics.Examples.SpoolEdgeSweep": 1.0,
}
AT_REST = ("Hydraulics.Examples.SpoolBetweenStops", "Hydraulics.Examples.RegulatorBench")
"""`error` is a balance of forces that holds at rest, at the end."""


def examples() -> Iterator[str]:
    """Full names of all models in packages called Examples."""
    library = Library(tuple(bundled_directories()))
    for name in ("Mechanics", "Hydraulics", "TenSpeed"):
        yield from _below(library.find(name))


def _below(node: ClassNode) -> Iterator[str]:
    definition = node.definition
    if ".Examples." in node.path and definition.kind == "model" and not definition.class_prefixes.partial:
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
