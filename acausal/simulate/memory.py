"""Arrays that structures of the run-time in C point to."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from acausal.runtime.binding import TableStructure
from acausal.simulate.inputs import Table
from acausal.simulate.machine import pointer
from acausal.simulate.matrices import Vector


@dataclass
class Memory:
    """Everything that the structures point to."""

    kept: list[object] = field(default_factory=list[object])

    def array(self, array: Vector | NDArray[np.int32] | NDArray[np.int64]) -> int:
        """Keeps an array, and says where it is."""
        self.kept.append(array)
        return pointer(array)


def table_structures(tables: Sequence[tuple[int, Table]], memory: Memory) -> ctypes.Array[TableStructure]:
    """Inputs that are tables, by position, for the run-time."""
    structures = (TableStructure * len(tables))()
    for structure, (position, table) in zip(structures, tables, strict=True):
        structure.position, structure.count = position, len(table.times)
        structure.times = memory.array(np.array(table.times))
        structure.values = memory.array(np.array(table.values))
    memory.kept.append(structures)
    return structures
