"""Parquet, by PyArrow (the extra `parquet`): units and descriptions are the fields' metadata.

A Parquet file can be read only once it is closed. Until then the rows stand beside it in `FILE.part`, which
is NetCDF and readable at any time.
"""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from acausal.errors import SimulationProblem, UsageProblem, fail
from acausal.results.netcdf_file import NetcdfWriter, read_netcdf
from acausal.results.signals import Layout, Signal, Vector, plain_layout

if TYPE_CHECKING:
    import pyarrow as pa

_GROUP = 1 << 16
"""Rows in a group."""


def part_of(path: Path) -> Path:
    """The file that holds the rows until the Parquet file is made."""
    return path.with_name(path.name + ".part")


def require_pyarrow() -> None:
    """Raises `UsageProblem` (`usage.parquet`) where PyArrow is not installed."""
    if find_spec("pyarrow") is None:
        problem = "Parquet needs PyArrow, which is not installed"
        hint = "pip install 'acausal[parquet]', or write .mat, .nc or .csv"
        raise fail(UsageProblem, "usage.parquet", problem, hint=hint)


class ParquetWriter:
    """Rows in `FILE.part`, then in groups in the file itself."""

    def __init__(self, path: Path, layout: Layout, rows: int | None = None) -> None:
        """A new file; with `rows`, an existing one that goes on after so many rows."""
        require_pyarrow()
        self._path, self._layout = path, layout
        part = part_of(path)
        if rows is not None and not part.is_file():
            _, signals, time, values = read_parquet(path)
            names = [signal.name for signal in signals]
            texts = [signal.description for signal in signals]
            old = NetcdfWriter(part, plain_layout(layout.model, names, [s.unit for s in signals], texts))
            old.write(time[:rows], values[:rows])
            old.close()
        self._part = NetcdfWriter(part, layout, rows)

    @property
    def rows(self) -> int:
        return self._part.rows

    def write(self, time: Vector, rows: Vector) -> None:
        """Adds rows."""
        self._part.write(time, rows)

    def close(self) -> None:
        """Makes the file of the rows. Raises `SimulationProblem` (`result.write`)."""
        self._part.close()
        part = part_of(self._path)
        try:
            _, signals, time, values = read_netcdf(part)
            _write(self._path, self._layout, signals, time, values)
        except OSError as problem:
            message = f"cannot write `{self._path}`: {problem.strerror or problem}"
            raise fail(SimulationProblem, "result.write", message, hint=f"the rows are in `{part}`") from None
        part.unlink()

    def abandon(self) -> None:
        self._part.close()


def _write(path: Path, layout: Layout, signals: tuple[Signal, ...], time: Vector, values: Vector) -> None:
    import pyarrow as pa
    from pyarrow import parquet

    fields = [pa.field("time", pa.float64(), metadata={"units": "s"})]
    for signal in signals:
        notes = {"units": signal.unit, "description": signal.description}
        fields.append(pa.field(signal.name, pa.float64(), metadata={k: v for k, v in notes.items() if v}))
    schema: pa.Schema = pa.schema(fields, metadata={"model": layout.model})
    with parquet.ParquetWriter(str(path), schema) as writer:
        for start in range(0, max(1, len(time)), _GROUP):
            rows = slice(start, start + _GROUP)
            arrays = [pa.array(np.ascontiguousarray(column)) for column in (time[rows], *values[rows].T)]
            writer.write_table(pa.Table.from_arrays(arrays, schema=schema))


def read_parquet(path: Path) -> tuple[str, tuple[Signal, ...], Vector, Vector]:
    """Model, signals, time and values. Raises `ValueError`, and `UsageProblem` without PyArrow."""
    require_pyarrow()
    from pyarrow import parquet

    table: pa.Table = parquet.read_table(str(path))
    if "time" not in table.column_names:
        raise ValueError("it has no `time`")
    names = [name for name in table.column_names if name != "time"]
    signals: list[Signal] = []
    for name in names:
        notes = {k.decode(): v.decode() for k, v in (table.schema.field(name).metadata or {}).items()}
        signals.append(Signal(name, notes.get("units", ""), notes.get("description", "")))
    columns = [np.asarray(table.column(name).to_numpy(), dtype=np.float64) for name in names]
    time = np.asarray(table.column("time").to_numpy(), dtype=np.float64)
    model = (table.schema.metadata or {}).get(b"model", b"").decode()
    return model, tuple(signals), time, np.column_stack(columns) if columns else np.empty((len(time), 0))
