"""Roots over a parameter, and over the variants of a table."""

from __future__ import annotations

import csv
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from acausal.analysis.batch import Decomposition, Variants, variants
from acausal.analysis.linearize import At, Setting
from acausal.analysis.modes import Complex
from acausal.analysis.tracking import Branches, follow
from acausal.analysis.words import modes_json
from acausal.codegen.functions import Code
from acausal.errors import UsageProblem, fail

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure

    from acausal.analysis.snapshot import Snapshot

MAX_VARIANTS = 1_000_000


@dataclass(frozen=True, eq=False)
class Locus:
    """Roots followed over one parameter: `branches.roots` (k, n) and everything else of the k variants."""

    name: str
    unit: str
    variants: Variants
    branches: Branches

    @property
    def values(self) -> tuple[float, ...]:
        return self.branches.values

    @property
    def roots(self) -> Complex:
        """(k, n) in 1/s, one column for each branch."""
        return self.branches.roots

    def snapshot(self, index: int) -> Snapshot:
        """The snapshot at one of the values; only its matrix and modes are that value's."""
        i = range(len(self.variants))[index]
        first, matrix = self.variants.first, self.variants.matrices[i]
        return first if i == 0 else replace(first, a=matrix, modes=self.variants.modes(i), growing=())

    def to_xarray(self) -> xr.DataArray:
        """The roots over the parameter and `branch`."""
        import xarray as xr  # takes a while to import

        coordinates = {self.name: list(self.values), "branch": list(range(1, self.roots.shape[1] + 1))}
        return xr.DataArray(
            self.roots, dims=(self.name, "branch"), coords=coordinates, attrs={"units": "1/s"}
        )

    def _repr_png_(self) -> bytes:
        from acausal.analysis.drawing import draw_locus

        return draw_locus(self).as_png()

    def to_json(self) -> dict[str, object]:
        """What `acausal eigen --sweep --json` prints."""
        branches = [
            {
                "re": branch.real.tolist(),
                "im": branch.imag.tolist(),
                "frequency_hz": (np.abs(branch) / (2 * np.pi)).tolist(),
                "damping_ratio": [-z.real / abs(z) if z else 0.0 for z in branch.tolist()],
            }
            for branch in self.roots.T
        ]
        return {
            "model": self.variants.first.model,
            "at": self.variants.first.at or "instant",
            "parameter": self.name,
            "unit": self.unit,
            "values": list(self.values),
            "states": list(self.variants.states),
            "branches": branches,
            "in_doubt": list(self.branches.in_doubt),
            "variants": variants_json(self.variants),
        }

    def plot(self, path: str | Path | None = None) -> Figure:
        """The branches in the complex plane; PNG, SVG or PDF."""
        from acausal.analysis.drawing import draw_locus

        return draw_locus(self, path)


def variants_json(found: Variants) -> list[dict[str, object]]:
    """One object for each variant, with the keys of a snapshot that its matrix gives, and `parameters`."""
    return [
        {
            "parameters": found.values_of(i),
            "time": found.first.time,
            "states": list(found.states),
            **modes_json(found.modes(i), found.states),
        }
        for i in range(len(found))
    ]


def sweep(
    code: Code,
    name: str,
    values: Sequence[float],
    at: At = "initial",
    setting: Setting | None = None,
) -> Locus:
    """Follows the roots over a parameter, or over a start value that is no parameter.

    Raises what `variants` raises, and UsageProblem `sweep.values` for fewer than two values.
    """
    if len(values) < 2:
        raise fail(
            UsageProblem, "sweep.values", f"`{name}` needs two values to be followed over", names=[name]
        )
    given = setting or Setting()
    is_start = name not in code.system.parameters and any(v.name == name for v in code.system.initial.values)

    def solved(chosen: Sequence[float]) -> Variants:
        parameters = {k: [_number(k, v)] * len(chosen) for k, v in given.parameters.items()}
        start = {k: [v] * len(chosen) for k, v in given.start.items()}
        (start if is_start else parameters)[name] = list(chosen)
        return variants(code, parameters, at, start=start, inputs=given.inputs, rtol=given.rtol)

    def solve(chosen: Sequence[float]) -> Decomposition:
        return whole.decomposition if tuple(chosen) == tuple(values) else solved(chosen).decomposition

    values = [float(value) for value in values]
    whole = solved(values)
    unit = code.system.flat.by_name[name].unit if name in code.system.flat.by_name else ""
    return Locus(name, unit, whole, follow(values, solve))


def _number(name: str, value: object) -> float:
    if isinstance(value, int | float):
        return float(value)
    hint = "compile the model with it"
    raise fail(UsageProblem, "sweep.values", f"`{name}` is no number here", names=[name], hint=hint)


def spaced(text: str) -> tuple[str, tuple[float, ...]]:
    """`name=a:b:n`: the name, and n values from a to b. Raises UsageProblem `usage.sweep`."""
    name, equals, rest = (part.strip() for part in text.partition("="))
    parts = rest.split(":")
    try:
        first, last, count = float(parts[0]), float(parts[1]), int(parts[2])
        valid = bool(equals and name) and len(parts) == 3 and isfinite(first) and isfinite(last)
    except (ValueError, IndexError):
        valid, first, last, count = False, 0.0, 0.0, 0
    if not valid or not 2 <= count <= MAX_VARIANTS:
        hint = "write --sweep name=a:b:n with n from 2 on"
        raise fail(UsageProblem, "usage.sweep", f"`--sweep {text}` is not name=a:b:n", hint=hint)
    return name, tuple(np.linspace(first, last, count).tolist())


def table_of(path: Path) -> dict[str, tuple[float, ...]]:
    """A CSV with one row for each variant and parameters' names in its first line.

    Raises UsageProblem `usage.table`.
    """
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            rows = [row for row in csv.reader(file, skipinitialspace=True) if row]
    except (OSError, UnicodeDecodeError, csv.Error) as problem:
        raise _unreadable(path, str(problem)) from None
    names = [name.strip() for name in rows[0]] if rows else []
    if len(rows) < 2 or not all(names) or len(set(names)) != len(names):
        raise _unreadable(path, "its first line must name the parameters, and a row for each variant follow")
    if len(rows) > MAX_VARIANTS:
        raise _unreadable(path, f"it has more than {MAX_VARIANTS} rows")
    values: list[list[float]] = []
    for number, row in enumerate(rows[1:], 2):
        try:
            numbers = [float(cell) for cell in row]
        except ValueError:
            raise _unreadable(path, f"line {number} holds what is no number") from None
        if len(numbers) != len(names):
            raise _unreadable(path, f"line {number} has {len(numbers)} numbers for {len(names)} names")
        values.append(numbers)
    columns: Mapping[str, tuple[float, ...]] = dict(zip(names, zip(*values, strict=True), strict=True))
    return dict(columns)


def _unreadable(path: Path, why: str) -> Exception:
    hint = "write a CSV with the names of parameters in its first line"
    return fail(UsageProblem, "usage.table", f"`{path}` is no table of variants: {why}", hint=hint)
