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

    def array(self, array: Vector | NDArray[np.int32] | NDArray[np.int64] | NDArray[np.uint8]) -> int:
        """Keeps an array, and says where it is."""
        self.kept.append(array)
        return pointer(array)


def numbers(address: int, count: int) -> Vector:
    """The numbers that stand there, as an array over them."""
    if not count:
        return np.zeros(0)
    return np.ctypeslib.as_array((ctypes.c_double * count).from_address(address))


def flags(address: int, count: int) -> NDArray[np.int_]:
    """A copy of the C integers that stand there."""
    return np.ctypeslib.as_array((ctypes.c_int * count).from_address(address)).astype(np.int_)


def table_structures(tables: Sequence[tuple[int, Table]], memory: Memory) -> ctypes.Array[TableStructure]:
    """Inputs that are tables, by position, for the run-time."""
    structures = (TableStructure * len(tables))()
    for structure, (position, table) in zip(structures, tables, strict=True):
        structure.position, structure.count = position, len(table.times)
        structure.times = memory.array(np.array(table.times))
        structure.values = memory.array(np.array(table.values))
    memory.kept.append(structures)
    return structures
