"""Every example of a library against published reference results.

    python -m tests.reference --library DIR --references DIR --version 4.1.0 [PACKAGE ...]

simulates the models of the packages one after the other, each in a process of its own, and compares those
that have a reference. `--table FILE` keeps the verdicts as CSV, from which the documentation is made.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from acausal.lang.library import Library
from acausal.survey import survey_classes
from tests.reference.judge import FAILS, Verdict
from tests.reference.published import Reference, references
from tests.reference.table import PACKAGES, ROOT, write_rows


def examples(library: Path, package: str) -> list[str]:
    """The models of a package with an `experiment` annotation."""
    found = Library((library,))
    return [one for one in survey_classes(found.find(package), True) if isinstance(one, str)]


def judged(model: str, library: Path, reference: Reference | None, seconds: float) -> Verdict:
    """The verdict of a process of its own."""
    command = [sys.executable, "-m", "tests.reference.judge", model, "--path", str(library)]
    command += ["--reference", str(reference.folder)] if reference is not None else []
    try:
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        return Verdict(model, FAILS, 0, f"not finished after {seconds:g} s", seconds)
    if done.returncode != 0:
        return Verdict(model, FAILS, 0, f"ended with {done.returncode}: {done.stderr.strip()[-200:]}")
    return Verdict(**json.loads(done.stdout))


def verdicts(library: Path, root: Path, packages: list[str], seconds: float) -> Iterator[Verdict]:
    """All models of the packages, in the order of the library, then those that only the references name."""
    known = {one.model: one for one in references(root)}
    for package in packages:
        models = examples(library, package)
        more = [name for name in known if name.startswith(f"{package}.") and name not in models]
        for model in [*models, *more]:
            yield judged(model, library, known.get(model), seconds)


def main() -> None:
    """The command line."""
    parser = argparse.ArgumentParser(prog="python -m tests.reference", description=__doc__)
    parser.add_argument("packages", nargs="*", default=list(PACKAGES))
    parser.add_argument("--library", type=Path, required=True, help="folder that holds Modelica/package.mo")
    parser.add_argument(
        "--references", type=Path, required=True, help="folder that holds Modelica/Blocks/..."
    )
    parser.add_argument("--version", required=True, help="of the library, as the table is to call it")
    parser.add_argument("--table", type=Path, help="CSV to which the verdicts are written")
    parser.add_argument("--seconds", type=float, default=600.0, help="most time for each model")
    given = parser.parse_args()
    found: list[Verdict] = []
    for verdict in verdicts(given.library, given.references, given.packages, given.seconds):
        print(f"{verdict.verdict:10}{verdict.seconds:8.1f} s  {verdict.model}  {verdict.reason}", flush=True)
        found.append(verdict)
    if given.table is not None:
        write_rows(given.table, given.version, found)


if __name__ == "__main__":
    main()
