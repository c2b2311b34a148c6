"""Published reference results: one folder for each model, with a table and a list of the signals that count.

A folder `Modelica/Blocks/Examples/PID_Controller` holds `PID_Controller.csv` and `comparisonSignals.txt`.
"""

from __future__ import annotations

import csv
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tests.reference.tube import Curve, Vector

SIGNALS = "comparisonSignals.txt"


@dataclass(frozen=True)
class Reference:
    """One model and its folder."""

    model: str
    folder: Path

    @property
    def table(self) -> Path:
        return self.folder / f"{self.folder.name}.csv"

    @property
    def signals(self) -> tuple[str, ...]:
        """The names that are compared."""
        lines = (self.folder / SIGNALS).read_text(encoding="utf-8-sig").split("\n")
        return tuple(name for line in lines if (name := line.strip()) and name.lower() != "time")

    def curves(self) -> dict[str, Curve]:
        """The table's columns by name."""
        with self.table.open(encoding="utf-8-sig", newline="") as file:
            names = [name.strip() for name in next(csv.reader(file))]
            data: Vector = np.loadtxt(file, delimiter=",", ndmin=2, dtype=np.float64)
        return {name: Curve(data[:, 0], data[:, i]) for i, name in enumerate(names) if i}


def references(root: Path) -> Iterator[Reference]:
    """All models of a folder of reference results, by name."""
    for file in sorted(root.rglob(SIGNALS)):
        yield Reference(".".join(file.parent.relative_to(root).parts), file.parent)
