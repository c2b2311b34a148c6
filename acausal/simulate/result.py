"""The result of one run: labelled values over time, with units."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from acausal.errors import Diagnostic, LookupProblem, fail
from acausal.lang.flat import Variable
from acausal.simulate.costs import StateCost
from acausal.simulate.initialize import UsedStart
from acausal.simulate.matrices import Vector
from acausal.simulate.names import NAME_IT_TOO, derivative_of_alias, did_you_mean, left_out
from acausal.simulate.record import Ending
from acausal.symbolic.causal import CausalSystem
from acausal.symbolic.expressions.evaluate import evaluate
from acausal.symbolic.expressions.expr import Constant, Expr, neg
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

    @cached_property
    def _columns(self) -> dict[str, int]:
        return {to_text(leaf): i for i, leaf in enumerate(self.leaves)}

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Everything that can be asked for: variables in declaration order, parameters, derivatives."""
        return tuple(dict.fromkeys([*(v.name for v in self.system.flat.variables), *self._columns]))

    def values(self, name: str) -> Vector:
        """The values of `name` over time; aliases and parameters included. Raises `LookupProblem`."""
        sign, seen = derivative_of_alias(self.system, name) or (1.0, name)
        for _ in range(len(self.system.aliases) + 1):
            column = self._columns.get(seen)
            if column is not None:
                return sign * self.data[:, column]
            if seen in self.parameters:
                return np.full(len(self.time), sign * self.parameters[seen])
            value = self.system.alias_values.get(seen)
            if value is None:
                break
            if value.op == "neg" and value.args[0].op == "sym":
                sign, value = -sign, neg(value)
            if value.op != "sym":
                return np.full(len(self.time), sign * self._constant(value))
            seen = value.name
        removed = self.system.removed
        gone = removed is not None and any(v.name == name for v in removed.variables)
        message = left_out(name) if gone else f"the result has no variable `{name}`"
        hint = NAME_IT_TOO if gone else did_you_mean(name, self.names)
        raise fail(LookupProblem, "result.unknown-name", message, names=[name], hint=hint)

    def _constant(self, value: Expr) -> float:
        def lookup(name: str) -> Constant | None:
            return self.parameters.get(name)

        number = evaluate(value, lookup)
        return float(number) if isinstance(number, int | float) else float("nan")

    def variable(self, name: str) -> Variable | None:
        """The declaration; None for a derivative."""
        return self.system.flat.by_name.get(name)

    def unit(self, name: str) -> str:
        """The declared unit; that of `der(x)` is the unit of `x` per second."""
        variable = self.variable(name)
        if variable is not None:
            return variable.unit
        inner = self.variable(name[4:-1]) if name.startswith("der(") else None
        if inner is None or not inner.unit:
            return ""
        return (
            "1/s"
            if inner.unit == "1"
            else f"{inner.unit}/s"
            if "/" not in inner.unit
            else f"({inner.unit})/s"
        )

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
        top = [v.name for v in self.system.flat.unknowns if v.top_level and not v.protected]
        return tuple(dict.fromkeys([*self.system.states, *top]))

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
        chosen = self.default_names if names is None else tuple(names)
        columns = [self.time, *(self.values(name) for name in chosen)]
        lines = [",".join(["time", *map(_csv_field, chosen)])]
        lines += [",".join(map(repr, row)) for row in np.column_stack(columns).tolist()]
        target = Path(path)
        target.write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")
        return target


def _csv_field(name: str) -> str:
    """Quoted where a name holds a comma or a quote, as `a[1,2]` does."""
    return '"' + name.replace('"', '""') + '"' if "," in name or '"' in name else name
