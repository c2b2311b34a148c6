"""Exports built with the system's C compiler, and their runs beside those inside Python."""

from __future__ import annotations

import csv
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from acausal.api import CompiledModel, loads
from acausal.runtime.build import compiler
from acausal.simulate.matrices import Vector

FLAGS = ("-std=c99", "-Wall", "-Wextra", "-Wconversion", "-Werror", "-ffp-contract=off")
"""Warnings are errors, as in the package's Makefile."""

needs_compiler = pytest.mark.skipif(compiler() is None, reason="there is no C compiler")


@dataclass(frozen=True)
class Built:
    """An executable and the folder of its package."""

    folder: Path
    name: str

    def run(self, *words: str, code: int = 0) -> subprocess.CompletedProcess[str]:
        """Runs it there, and checks its exit code."""
        found = subprocess.run(
            ["./program", *words], cwd=self.folder, capture_output=True, text=True, timeout=120, check=False
        )
        assert found.returncode == code, found.stderr
        return found

    def rows(self, *words: str) -> tuple[list[str], Vector]:
        """The course of the variables of the first variants: names, and one row of numbers for each time."""
        self.run("-o", "rows.csv", "-r", "results.csv", *words)
        return table(self.folder / "rows.csv", 1)


def table(path: Path, skip: int) -> tuple[list[str], Vector]:
    """Names and numbers of a CSV without its first columns."""
    with path.open(encoding="utf-8", newline="") as file:
        lines = list(csv.reader(file))
    return lines[0][skip:], np.array([[float(v) for v in line[skip:]] for line in lines[1:]])


def built(folder: Path, name: str, *flags: str) -> Built:
    """Compiles a package that was written there."""
    tool = compiler()
    assert tool is not None
    sources = [*sorted(folder.glob("*.c")), *sorted((folder / "runtime").glob("*.c"))]
    files = [str(source.relative_to(folder)) for source in sources]
    command = [tool.path, *FLAGS, *flags, "-I.", "-Iruntime", *files, "-o", "program", "-lm"]
    found = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300, check=False)
    assert found.returncode == 0, found.stderr[:3000]
    return Built(folder, name)


def exported(model: CompiledModel, folder: Path, *flags: str, **settings: object) -> Built:
    """Exports and compiles."""
    package = model.export_c(folder, **settings)  # type: ignore[arg-type]  # settings of one call, as they are
    return built(folder, package.name, *(flags or ("-O0",)))


def compiled(text: str) -> CompiledModel:
    """A model from its text."""
    return loads(text).compile()


def differences(
    model: CompiledModel,
    package: Built,
    solver: str,
    step: float,
    *,
    stop: float | None = None,
    interval: float | None = None,
) -> float:
    """The largest difference between both runs, relative to the size of each variable; times are equal."""
    given = [("--stop", stop), ("--interval", interval)]
    names, data = package.rows(*(word for name, v in given if v is not None for word in (name, repr(v))))
    result = model.simulate(solver=solver, step=step, stop_time=stop, interval=interval)
    reference = np.column_stack([result.time, *(result.values(name) for name in names[1:])])
    assert reference.shape == data.shape
    assert np.array_equal(reference[:, 0], data[:, 0])
    size = np.maximum(np.abs(reference).max(axis=0), 1e-300)
    return float((np.abs(reference - data).max(axis=0) / size).max())
