"""`python -m acausal.demo --out out`: report to the terminal and `out/report.txt`, plots to `out/`."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from acausal.demo.figures import draw
from acausal.demo.report import print_gears, print_regulators, report_console
from acausal.demo.systems import gear_trials, problems, regulator_trials
from acausal.errors import AcausalError


def main(arguments: Sequence[str] | None = None) -> int:
    """0 when ratios and state counts are as they have to be, else 1."""
    parser = argparse.ArgumentParser(prog="python -m acausal.demo", description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("out"), help="folder for the report and the plots")
    out: Path = parser.parse_args(arguments).out
    try:
        return run(out)
    except (AcausalError, OSError) as error:
        print(error, file=sys.stderr)
        return 1


def run(out: Path) -> int:
    """Run both systems; write and print everything."""
    out.mkdir(parents=True, exist_ok=True)
    console = report_console()
    gears = gear_trials()
    print_gears(console, gears)
    regulators = regulator_trials()
    print_regulators(console, regulators)
    wrong = list(problems(gears, regulators))
    for problem in wrong:
        console.print(f"[bold red]wrong:[/] {problem}")
    if not wrong:
        console.print("All ratios and state counts are as they have to be.")
    files = [*draw(gears, regulators, out), out / "report.txt"]
    console.print(f"Written: {', '.join(map(str, files))}", soft_wrap=True)
    (out / "report.txt").write_text(
        "\n".join(line.rstrip() for line in console.export_text().splitlines()) + "\n", encoding="utf-8"
    )
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
