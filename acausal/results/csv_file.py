"""CSV: `time` first, all digits; the same run gives the same bytes."""

from __future__ import annotations

import csv
import warnings
from pathlib import Path

import numpy as np

from acausal.results.row_file import RowFile
from acausal.results.signals import Layout, Signal, Vector

_BLOCK = 1 << 20


class CsvWriter:
    """Rows as text."""

    def __init__(self, path: Path, layout: Layout, rows: int | None = None) -> None:
        """A new file; with `rows`, an existing one that goes on after so many rows."""
        self._layout = layout
        self.rows = rows or 0
        names = ["time", *(_field(signal.name) for signal in layout.signals)]
        head = (",".join(names) + "\n").encode() if rows is None else None
        self._file = RowFile(path, head, 0 if rows is None else _end(path, rows + 1))

    def write(self, time: Vector, rows: Vector) -> None:
        """Adds rows."""
        table = np.column_stack([time, self._layout.table(rows)]).tolist()
        lines = [",".join(map(repr, row)) for row in table]
        data = ("\n".join(lines) + "\n").encode()
        self.rows += data.count(b"\n", 0, self._file.append(data))
        self._file.check(self.rows)

    def close(self) -> None:
        self._file.close()

    abandon = close


def _field(name: str) -> str:
    """Quoted where a name holds a comma or a quote, as `a[1,2]` does."""
    return '"' + name.replace('"', '""') + '"' if "," in name or '"' in name else name


def _end(path: Path, lines: int) -> int:
    """How many bytes so many lines have."""
    position = 0
    with path.open("rb") as file:
        while block := file.read(_BLOCK):
            if (found := block.count(b"\n")) < lines:
                lines -= found
                position += len(block)
                continue
            at = -1
            for _ in range(lines):
                at = block.index(b"\n", at + 1)
            return position + at + 1
    return position


def read_csv(path: Path) -> tuple[tuple[Signal, ...], Vector, Vector]:
    """Signals, time and values; a last line cut short is left out. Raises `ValueError` for no table."""
    text = path.read_bytes()
    whole = text[: text.rfind(b"\n") + 1] if b"\n" in text else text
    lines = whole.decode("utf-8-sig").splitlines()
    names = next(csv.reader(lines[:1]), None)
    if not names:
        raise ValueError("it is empty")
    with warnings.catch_warnings(action="ignore"):  # of no rows at all, which is said below
        values = np.loadtxt(lines[1:], delimiter=",", ndmin=2)
    if "time" not in names or len(set(names)) != len(names):
        raise ValueError("its first line must name the columns, one of them `time`, none twice")
    if values.shape[1] != len(names):
        raise ValueError(f"it has {len(names)} names, but rows of {values.shape[1]} numbers")
    at = names.index("time")
    signals = tuple(Signal(name) for name in names if name != "time")
    return signals, values[:, at], np.delete(values, at, axis=1)
