"""The MAT format of version 4 that Modelica tools exchange: `Aclass`, `name`, `description`, `dataInfo` and
`data_1`, `data_2`.

Matrices stand one after the other, each with a header of five integers and a name. `data_1` holds what is
constant, at the first and the last time; `data_2` one column for each row of the result, and comes last, so
that it grows at the end of the file. Signals that are equal or opposite share a column.
"""

from __future__ import annotations

import re
import struct
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from acausal.results.row_file import RowFile
from acausal.results.signals import Layout, Signal, Vector

_DOUBLE, _INTEGER, _TEXT = 0, 20, 51
_TYPES = ("f8", "f4", "i4", "i2", "u2", "u1")
_UNIT = re.compile(r"^(?P<text>.*?)\s*\[(?P<unit>[^\[\]|]*)(?:\|[^\[\]]*)?\]$", re.DOTALL)


class MatWriter:
    """Rows as columns of `data_2`."""

    def __init__(self, path: Path, layout: Layout, rows: int | None = None) -> None:
        """A new file; with `rows`, an existing one that goes on after so many rows."""
        self.rows = rows or 0
        self._width = layout.width + 1
        head = _head(layout)
        grown = _matrix("data_2", _DOUBLE, self._width, 0, b"")
        self._stride = 8 * (1 + len(_constants(layout)))
        self._count, self._times = len(head) + 8, len(head) - 2 * self._stride
        begin = len(head) + len(grown)
        end = begin + 8 * self._width * self.rows
        self._file = RowFile(path, head + grown if rows is None else None, end)

    def write(self, time: Vector, rows: Vector) -> None:
        """Adds rows."""
        data, size = np.column_stack([time, rows]).astype("<f8").tobytes(), 8 * self._width
        added = self._file.append(data, size) // size
        first = float(time[0]) if self.rows == 0 else None
        self.rows += added
        self._counted(first, float(time[added - 1]) if added else None)
        self._file.check(self.rows)

    def _counted(self, first: float | None, last: float | None = None) -> None:
        """Says how many rows there are, and from when to when."""
        self._file.patch(self._count, struct.pack("<i", self.rows), self.rows)
        if first is not None:
            self._file.patch(self._times, struct.pack("<d", first), self.rows)
        if last is not None:
            self._file.patch(self._times + self._stride, struct.pack("<d", last), self.rows)

    def close(self) -> None:
        self._file.close()

    abandon = close


def _constants(layout: Layout) -> list[Signal]:
    return [signal for signal in layout.signals if signal.column is None]


def _matrix(name: str, kind: int, rows: int, columns: int, data: bytes) -> bytes:
    return struct.pack("<5i", kind, rows, columns, 0, len(name) + 1) + name.encode() + b"\0" + data


def _texts(name: str, texts: list[str], *, by_columns: bool) -> bytes:
    """A matrix of characters; by columns: each text is one column."""
    coded = [text.encode() for text in texts]
    length = max(1, *map(len, coded))
    padded = [text.ljust(length, b" " if not by_columns else b"\0") for text in coded]
    if by_columns:
        return _matrix(name, _TEXT, length, len(texts), b"".join(padded))
    crossed = b"".join(bytes(text[i] for text in padded) for i in range(length))
    return _matrix(name, _TEXT, len(texts), length, crossed)


def _described(signal: Signal) -> str:
    return f"{signal.description} [{signal.unit}]".strip() if signal.unit else signal.description


def _head(layout: Layout) -> bytes:
    """All before `data_2`."""
    constant = _constants(layout)
    places = {signal.name: i + 2 for i, signal in enumerate(constant)}
    info = [(0, 1, 0, -1)]
    for signal in layout.signals:
        if signal.column is None:
            info.append((1, places[signal.name], 0, 0))
        else:
            info.append((2, int(signal.factor) * (signal.column + 2), 0, -1))
    fixed = np.tile(np.array([0.0, *(signal.value for signal in constant)]), 2)
    return b"".join(
        (
            _texts("Aclass", ["Atrajectory", "1.1", "", "binTrans"], by_columns=False),
            _texts("name", ["time", *(s.name for s in layout.signals)], by_columns=True),
            _texts("description", ["Time [s]", *map(_described, layout.signals)], by_columns=True),
            _matrix("dataInfo", _INTEGER, 4, len(info), np.array(info, dtype="<i4").tobytes()),
            _matrix("data_1", _DOUBLE, len(constant) + 1, 2, fixed.astype("<f8").tobytes()),
        )
    )


@dataclass(frozen=True, eq=False)
class _Stored:
    name: str
    values: Vector


def read_mat(path: Path) -> tuple[tuple[Signal, ...], Vector, Vector]:
    """Signals, time and values. Raises `ValueError` for what is no such file."""
    found = {one.name: one.values for one in _matrices(path.read_bytes())}
    if not {"Aclass", "name", "dataInfo", "data_2"} <= found.keys():
        raise ValueError("it lacks one of `Aclass`, `name`, `dataInfo`, `data_2`")
    turned = _strings(found["Aclass"])[3:4] == ["binTrans"]
    names = _strings(found["name"].T if turned else found["name"])
    described = found.get("description", np.zeros((1, len(names)) if turned else (len(names), 1)))
    texts = _strings(described.T if turned else described)
    info = found["dataInfo"].T if turned else found["dataInfo"]
    data = {n: found[f"data_{n}"].T if turned else found[f"data_{n}"] for n in (1, 2) if f"data_{n}" in found}
    time = data[2][:, 0]
    signals: list[Signal] = []
    columns: list[Vector] = []
    for name, text, (table, place) in zip(names, texts, info[:, :2].astype(int).tolist(), strict=True):
        if name.lower() == "time":
            continue
        source, at = data.get(table or 2), abs(place) - 1
        if source is None or not 0 <= at < source.shape[1]:
            raise ValueError(f"`{name}` is said to stand where nothing is")
        values = source[:, at] if table != 1 else np.full(len(time), source[0, at])
        columns.append(values if place > 0 else -values)
        split = _UNIT.match(text)
        signals.append(Signal(name, split["unit"], split["text"]) if split else Signal(name, "", text))
    return tuple(signals), time, np.column_stack(columns) if columns else np.empty((len(time), 0))


def _matrices(data: bytes) -> list[_Stored]:
    found: list[_Stored] = []
    at = 0
    while at + 20 <= len(data):
        order = "<" if struct.unpack_from("<i", data, at)[0] in range(1000) else ">"
        kind, rows, columns, imaginary, length = struct.unpack_from(f"{order}5i", data, at)
        precision = kind // 10 % 10
        if min(rows, columns, length) < 0 or imaginary or precision >= len(_TYPES) or length > 1000:
            raise ValueError("a header of a matrix makes no sense")
        name = data[at + 20 : at + 20 + length].rstrip(b"\0").decode("latin-1")
        form = np.dtype(f"{order}{_TYPES[precision]}")
        at += 20 + length
        if name == "data_2":  # of a run that was killed the count may be behind
            columns = min(columns, (len(data) - at) // max(1, form.itemsize * rows)) if rows else columns
        count = rows * columns
        if at + count * form.itemsize > len(data):
            raise ValueError(f"matrix `{name}` is cut short")
        values = np.frombuffer(data, form, count, at).astype(np.float64)
        found.append(_Stored(name, values.reshape((rows, columns), order="F")))
        at += count * form.itemsize
    return found


def _strings(characters: Vector) -> list[str]:
    """One text for each row."""
    lines = characters.astype(np.uint8)
    return [line.tobytes().rstrip(b"\0 ").decode("utf-8", "replace") for line in lines]
