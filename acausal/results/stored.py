"""Results in files: which format a name means, and any of them read back."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

import numpy as np

from acausal.errors import AcausalError, LookupProblem, UsageProblem, fail
from acausal.results.csv_file import CsvWriter, read_csv
from acausal.results.mat_file import MatWriter, read_mat
from acausal.results.netcdf_file import NetcdfWriter, read_netcdf
from acausal.results.parquet_file import ParquetWriter, read_parquet, require_pyarrow
from acausal.results.signals import Layout, Signal, Vector

if TYPE_CHECKING:
    import xarray as xr

MAX_BYTES = 4_000_000_000


class Writer(Protocol):
    """A file of results that grows."""

    @property
    def rows(self) -> int: ...

    def write(self, time: Vector, rows: Vector) -> None:
        """Adds rows: `layout.width` numbers each. Raises `SimulationProblem` (`result.write`)."""
        ...

    def close(self) -> None:
        """Makes the file whole. Raises `SimulationProblem` (`result.write`)."""
        ...

    def abandon(self) -> None:
        """Leaves what is there as it is; nothing happens to a file that was closed."""
        ...


def open_writer(path: Path, layout: Layout, rows: int | None = None) -> Writer:
    """A new file in the format that its ending names, CSV if none; `rows`: an existing one goes on there.

    Raises `UsageProblem` (`usage.output`, `usage.parquet`).
    """
    match path.suffix.lower():
        case ".mat":
            return MatWriter(path, layout, rows)
        case ".nc":
            return NetcdfWriter(path, layout, rows)
        case ".parquet":
            return ParquetWriter(path, layout, rows)
        case _:
            return CsvWriter(path, layout, rows)


def check_format(path: Path) -> None:
    """Raises `UsageProblem` where the format needs what is not installed."""
    if path.suffix.lower() == ".parquet":
        require_pyarrow()


@dataclass(frozen=True, eq=False)
class StoredResult:
    """A result read back: `data` has one row per instant and one column per signal."""

    model: str
    time: Vector
    signals: tuple[Signal, ...]
    data: Vector

    @cached_property
    def _columns(self) -> dict[str, int]:
        return {signal.name: i for i, signal in enumerate(self.signals)}

    @property
    def names(self) -> tuple[str, ...]:
        """The signals in the order of the file, without `time`."""
        return tuple(signal.name for signal in self.signals)

    def values(self, name: str) -> Vector:
        """One signal over time. Raises `LookupProblem` (`result.unknown-name`)."""
        if name == "time":
            return self.time
        if name not in self._columns:
            message = f"the file has no signal `{name}`"
            raise fail(LookupProblem, "result.unknown-name", message, names=[name])
        return self.data[:, self._columns[name]]

    def unit(self, name: str) -> str:
        """The unit; empty where the file says none, as CSV never does."""
        return self.signals[self._columns[name]].unit if name in self._columns else ""

    def description(self, name: str) -> str:
        return self.signals[self._columns[name]].description if name in self._columns else ""

    def __getitem__(self, name: str) -> xr.DataArray:
        """A signal as a labelled array with its unit."""
        return self.to_xarray([name])[name]

    def to_xarray(self, names: Sequence[str] | None = None) -> xr.Dataset:
        """A Dataset over `time` with units and descriptions."""
        import xarray as xr  # a quarter of a second that the command line does not need

        arrays = {
            name: (
                ("time",),
                self.values(name),
                {"units": self.unit(name), "long_name": self.description(name)},
            )
            for name in (self.names if names is None else names)
        }
        coordinate = xr.DataArray(self.time, dims="time", attrs={"units": "s"})
        return xr.Dataset(arrays, coords={"time": coordinate}, attrs={"model": self.model})


def read_result(path: str | Path) -> StoredResult:
    """A result in any of the formats, told by its first bytes.

    A file that a killed run left is read as far as it goes. Raises `UsageProblem` (`result.not-a-result`).
    """
    file = Path(path)
    try:
        if file.stat().st_size > MAX_BYTES:
            raise ValueError(f"it is larger than {MAX_BYTES // 10**9} GB")
        with file.open("rb") as opened:
            first = opened.read(32)
        found = _read(file, first)
    except AcausalError:
        raise
    except (OSError, ValueError, TypeError, KeyError, IndexError, AssertionError) as problem:
        raise _unreadable(file, str(problem)) from None
    if not len(found.time):
        raise _unreadable(file, "it holds no rows")
    if (np.diff(found.time) < 0).any():
        raise _unreadable(file, "its time runs backwards")
    return found


def _read(file: Path, first: bytes) -> StoredResult:
    if first.startswith(b"CDF"):
        model, signals, time, data = read_netcdf(file)
    elif first.startswith(b"PAR1"):
        model, signals, time, data = read_parquet(file)
    elif b"Aclass" in first:
        model, (signals, time, data) = "", read_mat(file)
    elif b"\0" in first:
        raise ValueError("it is of no known format")
    else:
        model, (signals, time, data) = "", read_csv(file)
    return StoredResult(model, time, signals, data)


def _unreadable(path: Path, why: str) -> UsageProblem:
    message = f"`{path}` cannot be read as a result: {why}"
    hint = "give a file that `acausal simulate -o` wrote: .csv, .mat, .nc or .parquet"
    return fail(UsageProblem, "result.not-a-result", message, hint=hint)
