"""The result of one run: labelled values over time, with units."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from acausal.errors import Diagnostic
from acausal.lang.flat import Variable
from acausal.results.csv_file import CsvWriter
from acausal.results.signals import Layout
from acausal.results.stored import Writer, open_writer
from acausal.simulate.costs import EventCost, StateCost
from acausal.simulate.initialize import UsedStart
from acausal.simulate.matrices import Vector
from acausal.simulate.record import Ending
from acausal.simulate.selection import default_names, layout_of, place_of, unit_of, unknown_name
from acausal.simulate.standing import Standing
from acausal.symbolic.causal import CausalSystem
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.expressions.text import to_text

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Statistics:
    """What the run cost. `cpu_seconds`: integration with events and storing, nothing else (contract.md)."""

    solver: str
    stop_time: float
    steps: int
    rhs_evaluations: int
    jacobian_evaluations: int
    events: int
    cpu_seconds: float
    real_time_factor: float
    state_selections: int = 0
    """How often states were chosen anew (dynamic state selection)."""
    rejected: int = 0
    """Steps that the error test refused."""
    factorisations: int = 0
    max_step_seconds: float | None = None
    """Longest wall time of a fixed step, events at its end included; None with variable steps."""
    phase_seconds: Mapping[str, float] = field(default_factory=dict[str, float])
    """CPU seconds of the `start`, of `compile_c`, of new choices of states (`select_states`), of the `run`,
    and of writing to a file on the way (`store`)."""


@dataclass(frozen=True)
class Result:
    """Values of every variable at the output grid and on both sides of every event (at equal times)."""

    system: CausalSystem
    time: Vector
    leaves: tuple[Expr, ...]
    data: Vector
    """One row per time, one column per leaf."""
    parameters: dict[str, float]
    statistics: Statistics
    starts: tuple[UsedStart, ...]
    warnings: tuple[Diagnostic, ...] = ()
    ended: Ending | None = None
    """The `terminate` that ended the run before its stop time."""
    state_costs: tuple[StateCost, ...] = ()
    """Which states set the step size, largest influence first; empty for solvers that do not say."""
    event_costs: tuple[EventCost, ...] = ()
    """Which conditions and discrete variables made the events, most events first."""
    file: Path | None = None
    """Where the rows are, of a run that was stored as it went; only the last row is here then."""
    standing: Standing | None = None
    """From where another run can go on; None where this one stopped in the middle of an event."""

    @cached_property
    def _columns(self) -> dict[str, int]:
        return {to_text(leaf): i for i, leaf in enumerate(self.leaves)}

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Everything that can be asked for: variables in declaration order, parameters, derivatives."""
        return tuple(dict.fromkeys([*(v.name for v in self.system.flat.variables), *self._columns]))

    def values(self, name: str) -> Vector:
        """The values of `name` over time; aliases and parameters included. Raises `LookupProblem`."""
        place = place_of(self.system, self._columns, self.parameters, name)
        if place is None:
            raise unknown_name(self.system, name, self.names)
        if place.column is None:
            return np.full(len(self.time), place.value)
        return place.factor * self.data[:, place.column]

    def variable(self, name: str) -> Variable | None:
        """The declaration; None for a derivative."""
        return self.system.flat.by_name.get(name)

    def unit(self, name: str) -> str:
        """The declared unit; that of `der(x)` is the unit of `x` per second."""
        return unit_of(self.system, name)

    def __getitem__(self, name: str) -> xr.DataArray:
        """`result["line.p"]`: values over time as a labelled array with its unit."""
        import xarray as xr  # a quarter of a second that the command line does not need

        variable = self.variable(name)
        attributes = {"units": self.unit(name), "long_name": variable.description if variable else ""}
        coordinate = xr.DataArray(self.time, dims="time", attrs={"units": "s"})
        return xr.DataArray(
            self.values(name), dims="time", coords={"time": coordinate}, name=name, attrs=attributes
        )

    def final(self, names: Iterable[str]) -> dict[str, float]:
        """The values at the end."""
        return {name: float(self.values(name)[-1]) for name in names}

    @property
    def default_names(self) -> tuple[str, ...]:
        """States and public variables of the top level (contract.md)."""
        return default_names(self.system)

    @cached_property
    def all_names(self) -> tuple[str, ...]:
        """Every variable that changes, protected ones too."""
        return tuple(v.name for v in self.system.flat.unknowns)

    def to_xarray(self, names: Sequence[str] | None = None) -> xr.Dataset:
        """A Dataset over `time` with units; parameters and statistics are its attributes."""
        import xarray as xr

        chosen = self.default_names if names is None else tuple(names)
        arrays = {name: self[name] for name in chosen}
        coordinate = xr.DataArray(self.time, dims="time", attrs={"units": "s"})
        return xr.Dataset(arrays, coords={"time": coordinate}, attrs={"model": self.system.flat.name})

    def plot(self, *names: str, path: str | Path | None = None) -> Figure:
        """Draws the chosen variables (or `default_names`), and writes PNG, SVG or PDF to `path`."""
        from acausal.plotting import plot  # Matplotlib takes half a second to import

        return plot(self, names or None, path)

    def to_csv(self, path: str | Path, names: Sequence[str] | None = None) -> Path:
        """Writes `time` and the chosen variables with all digits; the same run gives the same bytes."""
        return self._written(CsvWriter, Path(path), names)

    def save(self, path: str | Path, names: Sequence[str] | None = None) -> Path:
        """Writes the chosen variables as the name's ending says: .csv, .mat, .nc or .parquet.

        `acausal.read_result` reads any of them. Raises `LookupProblem`, `UsageProblem` (`usage.output`,
        `usage.parquet`) and `SimulationProblem` (`result.write`).
        """
        return self._written(open_writer, Path(path), names)

    def _written(
        self, opened: Callable[[Path, Layout], Writer], path: Path, names: Sequence[str] | None
    ) -> Path:
        chosen = self.default_names if names is None else tuple(names)
        layout, columns = layout_of(self.system, self.leaves, self.parameters, chosen)
        writer = opened(path, layout)
        writer.write(self.time, self.data[:, columns])
        writer.close()
        return path
