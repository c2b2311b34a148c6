"""The examples of the Modelica Standard Library flatten, and have as many equations as unknowns.

MODELICAPATH names the library's versions to try, each as a folder with `Modelica/package.mo` in it.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import pytest

from acausal.errors import UnsupportedProblem
from acausal.lang.flat import FlatModel
from acausal.lang.library import ClassNode, Library
from acausal.pipeline import compile_model

# The fixture that isolates the tests takes MODELICAPATH away, so it is read when this file is collected.
MODELICAPATH = [Path(part) for part in os.environ.get("MODELICAPATH", "").split(os.pathsep) if part]
ROOTS = [folder for folder in MODELICAPATH if (folder / "Modelica" / "package.mo").is_file()]
PACKAGES = (
    "Modelica.Blocks.Examples",
    "Modelica.Mechanics.Rotational.Examples",
    "Modelica.Mechanics.Translational.Examples",
)
NOT_YET = frozenset(
    {
        "unsupported.external-function",
        "unsupported.external-object",
        "unsupported.expandable",
        "unsupported.getInstanceName",
        "unsupported.String",
    }
)
"""What examples of these packages are still refused for, by name."""
COUNTS = {
    # the source of motion 7, the mass 7, the signal 1
    "Modelica.Mechanics.Translational.Examples.Accelerate": 7 + 7 + 1,
    # three inertias, gear with support, spring, damper, fixed, torque with support, signal
    "Modelica.Mechanics.Rotational.Examples.First": 3 * 7 + 9 + 6 + 9 + 2 + 6 + 1,
    # two first-order blocks, signal, inverse constraints, feedback, filter of order one
    "Modelica.Blocks.Examples.InverseModel": 2 * 2 + 1 + 4 + 3 + 3,
}
"""Equations by hand: a flange has two, an inertia or a mass seven, a block one for each signal and state."""

pytestmark = [
    pytest.mark.msl,
    pytest.mark.skipif(not ROOTS, reason="MODELICAPATH does not name the Modelica Standard Library"),
]


def examples(node: ClassNode) -> Iterator[str]:
    """All models below a package that can be compiled."""
    for name in node.child_names():
        child = node.child(name)
        assert child is not None
        prefixes = child.definition.class_prefixes
        if child.definition.kind == "package":
            if name not in ("Clocked", "Utilities", "BusUsage_Utilities"):
                yield from examples(child)
        elif child.definition.kind == "model" and not prefixes.partial:
            yield child.path


def flat_of(library: Library, name: str) -> FlatModel:
    flat = compile_model(library, name, stop_after="flat").flat
    assert flat is not None
    return flat


@pytest.mark.parametrize("package", PACKAGES)
@pytest.mark.parametrize("root", ROOTS or [Path("none")], ids=lambda root: root.name)
def test_examples_flatten_and_balance(root: Path, package: str) -> None:
    library = Library((root,))
    names = list(examples(library.find(package)))
    assert len(names) > 10
    refused: list[str] = []
    for name in names:
        flat = flat_or_refusal(library, name)
        if isinstance(flat, FlatModel):
            assert flat.equation_count == len(flat.unknowns), name
        else:
            assert NOT_YET.issuperset(flat.codes), f"{name}: {flat}"
            refused.append(name)
    assert len(refused) < len(names)


def flat_or_refusal(library: Library, name: str) -> FlatModel | UnsupportedProblem:
    try:
        return flat_of(library, name)
    except UnsupportedProblem as problem:
        return problem


@pytest.mark.parametrize("name", COUNTS)
@pytest.mark.parametrize("root", ROOTS or [Path("none")], ids=lambda root: root.name)
def test_number_of_equations(root: Path, name: str) -> None:
    assert flat_of(Library((root,)), name).equation_count == COUNTS[name]
