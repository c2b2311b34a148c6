"""A table that grows by rows: times, and the numbers at each of them."""

from __future__ import annotations

import mmap

import numpy as np

from acausal.simulate.matrices import Vector

_FIRST = 64
"""Rows that there is room for at first, at least."""
_MOST = 2**26
"""Numbers for which room is made before they come. Memory is taken when it is written to."""

_LARGE = 2**20
"""Bytes from which on memory comes from the system page by page."""


def _room(rows: int, width: int) -> Vector:
    """Memory for so many rows, in small pages: NumPy asks for those of 2 MiB, which on a virtual machine
    that never had them before take a third of the time of a run of the gearbox."""
    if 8 * rows * width < _LARGE:
        return np.empty((rows, width))
    return np.frombuffer(mmap.mmap(-1, 8 * rows * width), dtype=np.float64).reshape(rows, width)


class Rows:
    """Rows of `width` numbers in one block of memory, of which about `expected` will come."""

    def __init__(self, width: int, expected: int = 0) -> None:
        room = max(_FIRST, min(expected, _MOST // max(1, width)))
        self.count = 0
        self._times, self._data = np.empty(room), _room(room, width)

    @property
    def times(self) -> Vector:
        return self._times[: self.count]

    @property
    def data(self) -> Vector:
        return self._data[: self.count]

    def add(self, time: float, row: Vector) -> None:
        """Takes one row to the end."""
        if self.count == len(self._times):
            self._grow(self.count + 1)
        self._times[self.count] = time
        self._data[self.count] = row
        self.count += 1

    def extend(self, times: Vector, rows: Vector) -> None:
        """Takes rows to the end."""
        first, end = self.count, self.count + len(times)
        if end > len(self._times):
            self._grow(end)
        self._times[first:end] = times
        self._data[first:end] = rows
        self.count = end

    def _grow(self, needed: int) -> None:
        room, times, data = max(needed, 2 * len(self._times)), self.times, self.data
        self._times, self._data = np.empty(room), _room(room, data.shape[1])
        self._times[: self.count], self._data[: self.count] = times, data

    def drop(self) -> None:
        """Forgets the last row."""
        self.count -= 1

    def keep_last(self) -> None:
        """Forgets all rows but the last, and their memory: who has them keeps them."""
        times, data = self.times[-1:], self.data[-1:]
        self.count = 0
        self._times, self._data = np.empty(_FIRST), np.empty((_FIRST, data.shape[1]))
        self.extend(times, data)
