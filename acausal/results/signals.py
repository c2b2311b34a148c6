"""What a file of results holds: signals over time, each with a name, a unit and a description."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]


@dataclass(frozen=True)
class Signal:
    """`factor` times a column of the rows that are written; without a column, a constant `value`."""

    name: str
    unit: str = ""
    description: str = ""
    column: int | None = None
    factor: float = 1.0
    value: float = 0.0


@dataclass(frozen=True)
class Layout:
    """The signals of one file, over rows of `width` numbers."""

    model: str
    signals: tuple[Signal, ...]
    width: int

    def table(self, rows: Vector) -> Vector:
        """The signals' values, one column each."""
        found = np.empty((len(rows), len(self.signals)))
        for i, signal in enumerate(self.signals):
            if signal.column is None:
                found[:, i] = signal.value
            else:
                found[:, i] = rows[:, signal.column] if signal.factor == 1.0 else -rows[:, signal.column]
        return found


def plain_layout(model: str, names: Sequence[str], units: Sequence[str], texts: Sequence[str]) -> Layout:
    """A layout in which every signal is a column of its own."""
    found = zip(names, units, texts, strict=True)
    return Layout(model, tuple(Signal(n, u, d, i) for i, (n, u, d) in enumerate(found)), len(names))
