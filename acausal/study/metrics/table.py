"""A stored result read back: columns of numbers by name."""

from __future__ import annotations

import csv
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from acausal.errors import UsageProblem, fail
from acausal.study.metrics.traces import Trace, Vector

MAX_BYTES = 4_000_000_000


@dataclass(frozen=True, eq=False)
class Table:
    """Columns by name, all of one length; `time` is one of them."""

    columns: Mapping[str, Vector]

    def trace(self, name: str) -> Trace:
        """One signal. Raises UsageProblem `metrics.missing-signal`."""
        if name not in self.columns:
            raise fail(
                UsageProblem,
                "metrics.missing-signal",
                f"the result has no signal `{name}`",
                names=[name],
                hint=f"store it: acausal simulate ... -v {name}",
            )
        return Trace(self.columns["time"], self.columns[name])

    def traces(self, prefix: str) -> dict[str, Trace]:
        """All signals whose name begins with `prefix`, by the rest of their names."""
        return {
            name.removeprefix(prefix): self.trace(name) for name in self.columns if name.startswith(prefix)
        }


def read_table(path: Path) -> Table:
    """The CSV that `acausal simulate -o` writes. Raises UsageProblem `metrics.not-a-result`."""
    try:
        if path.stat().st_size > MAX_BYTES:
            raise ValueError(f"it is larger than {MAX_BYTES // 10**9} GB")
        with path.open(encoding="utf-8", newline="") as file:
            names = next(csv.reader(file), None)
            if names is None:
                raise ValueError("it is empty")
            with warnings.catch_warnings(action="ignore"):  # of no rows at all, which is said below
                values = np.loadtxt(file, delimiter=",", ndmin=2)
    except (OSError, ValueError) as problem:
        raise _unreadable(path, str(problem)) from None
    if "time" not in names or len(set(names)) != len(names):
        raise _unreadable(path, "its first line must name the columns, one of them `time`, none twice")
    if values.shape[1] != len(names):
        raise _unreadable(path, f"it has {len(names)} names, but rows of {values.shape[1]} numbers")
    if (np.diff(values[:, names.index("time")]) < 0).any():
        raise _unreadable(path, "its time runs backwards")
    return Table({name: values[:, i] for i, name in enumerate(names)})


def _unreadable(path: Path, why: str) -> UsageProblem:
    error = fail(
        UsageProblem,
        "metrics.not-a-result",
        f"`{path}` cannot be read as a result: {why}",
        hint="give a file that `acausal simulate -o FILE.csv` wrote",
    )
    return UsageProblem(error.diagnostics)
