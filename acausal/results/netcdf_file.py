"""NetCDF, classic format with 64-bit offsets: one record for each row, so that it grows at its end.

Unidata, The NetCDF Classic Format Specification. `xarray.open_dataset` reads it, with units and descriptions.
"""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
from scipy.io import netcdf_file

from acausal.results.row_file import RowFile
from acausal.results.signals import Layout, Signal, Vector

_CHAR, _DOUBLE = 2, 6
_DIMENSION, _VARIABLE, _ATTRIBUTE = 10, 11, 12
_COUNT = 4
"""Where the number of records stands."""


class NetcdfWriter:
    """Rows as records of big-endian doubles."""

    def __init__(self, path: Path, layout: Layout, rows: int | None = None) -> None:
        """A new file; with `rows`, an existing one that goes on after so many rows."""
        self._layout = layout
        self.rows = rows or 0
        head = _head(layout)
        end = len(head) + self.rows * 8 * (len(layout.signals) + 1)
        self._file = RowFile(path, head if rows is None else None, end)

    def write(self, time: Vector, rows: Vector) -> None:
        """Adds rows."""
        table = np.column_stack([time, self._layout.table(rows)])
        size = 8 * table.shape[1]
        self.rows += self._file.append(table.astype(">f8").tobytes(), size) // size
        self._file.patch(_COUNT, struct.pack(">i", self.rows), self.rows)
        self._file.check(self.rows)

    def close(self) -> None:
        self._file.close()

    abandon = close


def _name(text: str) -> bytes:
    data = text.encode()
    return struct.pack(">i", len(data)) + data + bytes(-len(data) % 4)


def _attributes(texts: dict[str, str]) -> bytes:
    found = {key: text for key, text in texts.items() if text}
    if not found:
        return bytes(8)
    parts = [_name(key) + struct.pack(">i", _CHAR) + _name(text) for key, text in found.items()]
    return struct.pack(">ii", _ATTRIBUTE, len(parts)) + b"".join(parts)


def _head(layout: Layout) -> bytes:
    """All before the first record."""
    titles = ["time", *(signal.name.replace("/", "\N{DIVISION SLASH}") for signal in layout.signals)]
    notes = [{"units": "s"}, *({"long_name": s.description, "units": s.unit} for s in layout.signals)]
    for note, signal in zip(notes[1:], layout.signals, strict=True):
        note["modelica_name"] = signal.name if "/" in signal.name else ""
    first = b"CDF\x02" + struct.pack(">i", 0) + struct.pack(">ii", _DIMENSION, 1) + _name("time")
    first += struct.pack(">i", 0) + _attributes({"model": layout.model, "source": "acausal"})
    first += struct.pack(">ii", _VARIABLE, len(titles))
    parts = [
        _name(title) + struct.pack(">ii", 1, 0) + _attributes(note) + struct.pack(">ii", _DOUBLE, 8)
        for title, note in zip(titles, notes, strict=True)
    ]
    begin = len(first) + sum(map(len, parts)) + 8 * len(parts)
    return first + b"".join(part + struct.pack(">q", begin + 8 * i) for i, part in enumerate(parts))


def read_netcdf(path: Path) -> tuple[str, tuple[Signal, ...], Vector, Vector]:
    """Model, signals, time and values. Raises `ValueError`."""
    with netcdf_file(str(path), "r", mmap=False) as file:
        if "time" not in file.variables:
            raise ValueError("it has no `time`")
        time = np.asarray(file.variables["time"][:], dtype=np.float64)
        names = [
            name for name, one in file.variables.items() if name != "time" and one.dimensions == ("time",)
        ]
        signals = [_signal(name, file.variables[name]) for name in names]
        columns = [np.asarray(file.variables[name][:], dtype=np.float64) for name in names]
        model = _text(getattr(file, "model", b""))
    return model, tuple(signals), time, np.column_stack(columns) if columns else np.empty((len(time), 0))


def _signal(name: str, variable: object) -> Signal:
    texts = [_text(getattr(variable, key, b"")) for key in ("modelica_name", "units", "long_name")]
    return Signal(texts[0] or name, texts[1], texts[2])


def _text(data: object) -> str:
    return data.decode() if isinstance(data, bytes) else str(data)
