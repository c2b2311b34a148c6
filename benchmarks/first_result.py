"""The time from the command to the finished result.

CPU time of `acausal simulate MODEL` in a process of its own, interpreter and imports included, after a run
that fills the caches; median of five. `imports` is that of a process that only imports what the command does.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from statistics import median

from benchmarks.measure import Row
from benchmarks.valve_chain import NAME, valve_chain

REPEATS = 5
CLUTCHES = "Modelica.Mechanics.Rotational.Examples.CoupledClutches"
IMPORTS = "import acausal.cli.app, acausal.cli.commands, acausal.cli.simulation, acausal.simulate.native"


def rows(quick: bool = False) -> Iterator[Row]:
    """The imports, a model of this project, and the Modelica Standard Library's where there is one."""
    repeats = 1 if quick else REPEATS
    yield {"command": "imports alone", "CPU s": _seconds(["-c", IMPORTS], repeats)}
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / f"{NAME}.mo"
        file.write_text(valve_chain())
        yield {"command": "valve chain, 138 states", "CPU s": _seconds(_simulate(str(file)), repeats)}
    if "MODELICAPATH" in os.environ:
        yield {"command": "CoupledClutches", "CPU s": _seconds(_simulate(CLUTCHES), repeats)}


def _simulate(model: str) -> list[str]:
    return ["-m", "acausal", "simulate", model]


def _seconds(arguments: list[str], repeats: int) -> float:
    """The median after a run that is not counted."""
    return round(median([_once(arguments) for _ in range(repeats + 1)][1:]), 2)


def _once(arguments: list[str]) -> float:
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, *arguments], check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
