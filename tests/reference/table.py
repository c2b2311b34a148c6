"""The verdicts as a table: kept as CSV, from which a page of the documentation is made."""

from __future__ import annotations

import csv
from collections import Counter
from dataclasses import asdict, fields
from pathlib import Path

from tests.reference.judge import AGREES, DEVIATES, FAILS, SIMULATES, Verdict

ROOT = Path(__file__).resolve().parents[2]
TABLE = ROOT / "docs" / "reference-results.csv"
PAGE = ROOT / "docs" / "reference-results.md"
PACKAGES = (
    "Modelica.Blocks.Examples",
    "Modelica.Mechanics.Rotational.Examples",
    "Modelica.Mechanics.Translational.Examples",
)
_KEYS = ("version", *(field.name for field in fields(Verdict) if field.name != "seconds"))

_HEAD = """\
# Reference results

The Modelica Association publishes results of the examples of its standard library, with a list of the
signals that count for each. The examples are simulated over the interval of their own `experiment`
annotation (of the reference, where that was made over another one; this is noted), with the default solver
and tolerance, and compared with these on the grid of the reference:

- every value has to be within 0.2 % of the signal's range of the reference (a constant: 1e-6 of its value);
- within 2e-3 s of an event of either (runs shorter than a second: 2e-3 of their length) it may have any
  value that the reference has within that time. Elsewhere no shift in time is allowed.

*agrees*: all listed signals do. *simulates*: it runs to its end, there is nothing to compare it with.
*deviates* and *fails*: for the reason stated. The page is made from `docs/reference-results.csv`, which

    python -m tests.reference --library DIR --references DIR --version 4.1.0 --table FILE.csv

writes.

Known reasons: `ImpureGenerator` draws from a hidden state, and its sequence is the tool's own. The references
of 4.0.0 for two examples with noise come from other seeds (of instance names); the same models agree with
those of 4.1.0.

The start of `Multivibrator` and `SignalGenerator` has three solutions; start values lead to the one between
the saturated ones, `homotopy` is a fallback only. `L_stat` of `ForceCurrentBehaviour` is a quotient of two
values that are rounding. `ForceStrokeBehaviour` prescribes a velocity that jumps to a mass. In
`SMPM_NoLoad` an angle is at the point where it changes from pi to -pi. `SMPM_Braking`: two solvers agree at
a tolerance of 1e-9, about 1e-4 of the way in angle from the reference. `ChopperStepDown_RL` agrees with a
tolerance of 1e-8: what is off is a current of 1e-5 A in an open switch of 1e5 Ohm. `HBridge_DC_Drive` has
about 96,000 events.
"""


def read_rows(table: Path) -> list[dict[str, str]]:
    """The lines of the table."""
    with table.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def write_rows(table: Path, version: str, found: list[Verdict]) -> None:
    """Puts the verdicts about one version in place of those that the table holds."""
    names = {one.model for one in found}
    old = read_rows(table) if table.is_file() else []
    rows = [row for row in old if not (row["version"] == version and row["model"] in names)]
    new = [{"version": version} | asdict(one) for one in found]
    rows += [{key: str(one[key]) for key in _KEYS} for one in new]
    rows.sort(key=lambda row: (row["model"], row["version"]))
    with table.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, _KEYS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def page_text(rows: list[dict[str, str]]) -> str:
    """The page: how many, and for each package a table of all its examples."""
    versions = sorted({row["version"] for row in rows}, reverse=True)
    lines = [_HEAD, "## How many\n", f"| package | version | {AGREES} | {SIMULATES} | {DEVIATES} | {FAILS} |"]
    lines.append("|---|---|---|---|---|---|")
    packages = sorted({_package(row) for row in rows}, key=lambda name: (name not in PACKAGES, name))
    for package in packages:
        for version in versions:
            here = [row for row in rows if _package(row) == package and row["version"] == version]
            counts = Counter(row["verdict"] for row in here)
            numbers = " | ".join(str(counts[key]) for key in (AGREES, SIMULATES, DEVIATES, FAILS))
            lines += [f"| {package} | {version} | {numbers} |"] if here else []
    for package in packages:
        lines += ["", f"## {package}\n", "| example | " + " | ".join(versions) + " | signals | reason |"]
        lines.append("|---" * (len(versions) + 3) + "|")
        lines += _models([row for row in rows if _package(row) == package], package, versions)
    return "\n".join(lines) + "\n"


def _package(row: dict[str, str]) -> str:
    return row["model"].partition(".Examples.")[0] + ".Examples"


def _models(rows: list[dict[str, str]], package: str, versions: list[str]) -> list[str]:
    lines: list[str] = []
    for model in dict.fromkeys(row["model"] for row in rows):
        here = {row["version"]: row for row in rows if row["model"] == model}
        verdicts = [here[version]["verdict"] if version in here else "" for version in versions]
        signals = max(int(row["signals"]) for row in here.values())
        reasons = dict.fromkeys(row["reason"].replace("|", "\\|") for row in here.values() if row["reason"])
        cells = [model.removeprefix(f"{package}."), *verdicts, str(signals or ""), "; ".join(reasons)]
        lines.append(f"| {' | '.join(cells)} |")
    return lines
