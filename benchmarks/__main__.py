"""`python -m benchmarks --out DIR`: run every benchmark, print its table, write its rows as CSV."""

from __future__ import annotations

import argparse
import csv
import os
import platform
from collections.abc import Callable, Iterable
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from rich.console import Console
from rich.table import Table

import acausal
from benchmarks import (
    comparison,
    eigenvalues,
    first_result,
    gearbox,
    run_time,
    scale,
    solvers,
    steps,
    tearing,
)
from benchmarks.measure import Row

BENCHMARKS: dict[str, Callable[[bool], Iterable[Row]]] = {
    "scale": lambda quick: scale.rows(quick=quick),
    "comparison": lambda quick: comparison.rows(quick=quick),
    "run_time": lambda _: run_time.rows(),
    "solvers": lambda quick: solvers.rows(quick=quick),
    "eigenvalues": lambda quick: eigenvalues.rows(quick=quick),
    "first_result": lambda quick: first_result.rows(quick=quick),
    "gearbox": lambda quick: gearbox.rows(quick=quick),
    "steps": lambda quick: steps.rows(quick=quick),
    "tearing": lambda _: tearing.rows(),
}


def main() -> None:
    """Run them all, or those named."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("names", nargs="*", help=f"of {', '.join(BENCHMARKS)}; default all")
    parser.add_argument("--out", type=Path, default=Path("out"))
    parser.add_argument("--quick", action="store_true", help="smaller models and shorter time limits")
    arguments = parser.parse_args()
    unknown = [name for name in arguments.names if name not in BENCHMARKS]
    if unknown:
        parser.error(f"there is no benchmark {unknown[0]}; there are {', '.join(BENCHMARKS)}")
    arguments.out.mkdir(parents=True, exist_ok=True)
    console = Console()
    console.print(environment())
    for name in arguments.names or BENCHMARKS:
        rows = list(BENCHMARKS[name](arguments.quick))
        console.print(as_table(name, rows))
        with (arguments.out / f"{name}.csv").open("w", newline="") as file:
            writer = csv.DictWriter(file, fieldnames=list(rows[0]))
            writer.writeheader()
            writer.writerows(rows)


def environment() -> str:
    """Python, cores and the versions of what is compared."""
    found = [f"acausal {acausal.__version__}"]
    for package in ("casadi", "scikit-sundae", "rumoca", "pymoca"):
        try:
            found.append(f"{package} {version(package)}")
        except PackageNotFoundError:
            found.append(f"{package} not installed")
    return f"Python {platform.python_version()}, {os.cpu_count()} cores; {', '.join(found)}"


def as_table(name: str, rows: list[Row]) -> Table:
    """The rows for a terminal."""
    table = Table(title=name)
    for key in rows[0]:
        table.add_column(key, justify="left" if isinstance(rows[0][key], str) else "right")
    for row in rows:
        table.add_row(*[str(value) for value in row.values()])
    return table


if __name__ == "__main__":
    main()
