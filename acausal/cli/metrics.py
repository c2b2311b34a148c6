"""`acausal metrics`."""

from __future__ import annotations

from pathlib import Path

from acausal.cli.output import check_writable, print_json, print_table, print_text
from acausal.errors import UsageProblem, fail
from acausal.study.metrics.sweep import GearShift, averages, gear_shifts
from acausal.study.metrics.table import read_table

KINDS = ("shift",)
_COLUMNS = (
    "torque_hole",
    "recovery_overshoot",
    "settling_time",
    "torque_phase",
    "inertia_phase",
    "peak_to_peak_derivative",
)


def run_metrics(result: Path, kind: str, plot: Path | None, *, as_json: bool) -> None:
    """Read the result, print the figures, draw them."""
    if kind not in KINDS:
        raise fail(
            UsageProblem,
            "usage.kind",
            f"there are no metrics of the kind `{kind}`",
            hint=f"use {', '.join(KINDS)}",
        )
    check_writable(plot)
    table = read_table(result)
    shifts = gear_shifts(table)
    if plot is not None:
        from acausal.study.metrics.drawing import draw_shifts

        draw_shifts(table, shifts, plot)
    if as_json:
        print_json({"kind": kind, "shifts": [one.to_json() for one in shifts], "averages": averages(shifts)})
        return
    _print(shifts)
    if plot is not None:
        print_text(f"wrote {plot}")


def _print(shifts: list[GearShift]) -> None:
    rows = [
        (
            f"{one.from_gear} to {one.to_gear}",
            f"{one.figures.oncoming or '-'}/{one.figures.offgoing or '-'}",
            *(_number(getattr(one.figures, name)) for name in _COLUMNS),
        )
        for one in shifts
    ]
    means = averages(shifts)
    rows.append(("average", "", *(_number(means[name]) for name in _COLUMNS)))
    titles = (
        "shift",
        "on/off",
        "hole N.m",
        "overshoot %",
        "settling s",
        "torque phase s",
        "inertia phase s",
        "dT/dt N.m/s",
    )
    print_table(rows, titles, right=range(2, len(titles)))


def _number(value: object) -> str:
    return f"{value:.4g}" if isinstance(value, float | int) else "-"
