"""`acausal metrics`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from acausal.cli.output import check_writable, print_json, print_table, print_text
from acausal.errors import UsageProblem, fail
from acausal.study.metrics.converter import converter_figures, curves
from acausal.study.metrics.engagements import engagements
from acausal.study.metrics.sweep import GearShift, averages, gear_shifts
from acausal.study.metrics.table import Table, read_table

KINDS = ("shift", "converter", "engagement")
_COLUMNS = (
    "torque_hole",
    "recovery_overshoot",
    "settling_time",
    "torque_phase",
    "inertia_phase",
    "peak_to_peak_derivative",
)


@dataclass(frozen=True)
class Options:
    """What only some kinds take: a reference result, a piston's stop (m), a window (s), a drawing."""

    reference: Path | None = None
    stop: float | None = None
    start: float | None = None
    end: float | None = None
    plot: Path | None = None


_TAKEN = {
    "shift": ("plot",),
    "converter": ("reference", "plot"),
    "engagement": ("stop", "start", "end"),
}
_SPELLED = {"start": "--from", "end": "--to"}


def run_metrics(result: Path, kind: str, options: Options, *, as_json: bool) -> None:
    """Read the result, print the figures, draw them."""
    if kind not in KINDS:
        raise fail(
            UsageProblem,
            "usage.kind",
            f"there are no metrics of the kind `{kind}`",
            hint=f"use {', '.join(KINDS)}",
        )
    for name in ("reference", "stop", "start", "end", "plot"):
        if getattr(options, name) is not None and name not in _TAKEN[kind]:
            option = _SPELLED.get(name, f"--{name}")
            raise fail(UsageProblem, "usage.metrics-option", f"`{option}` does not go with `--kind {kind}`")
    check_writable(options.plot)
    table = read_table(result)
    if kind == "converter":
        _converter(table, options, as_json=as_json)
    elif kind == "engagement":
        _engagement(table, options, as_json=as_json)
    else:
        _shift(table, options.plot, as_json=as_json)


def _converter(table: Table, options: Options, *, as_json: bool) -> None:
    sweep = curves(table)
    reference = None if options.reference is None else curves(read_table(options.reference))
    figures = converter_figures(sweep, reference).to_json()
    if options.plot is not None:
        from acausal.study.metrics.converter_drawing import draw_converter

        draw_converter(
            {"sweep": sweep} | ({} if reference is None else {"reference": reference}), options.plot
        )
    if as_json:
        print_json({"kind": "converter", **figures})
        return
    print_table([(name.replace("_", " "), _number(value)) for name, value in figures.items()], ("figure", ""))
    if options.plot is not None:
        print_text(f"wrote {options.plot}")


_PRESSURES = ("delay", "rise", "corner_time", "corner_pressure", "overshoot")


def _engagement(table: Table, options: Options, *, as_json: bool) -> None:
    found = engagements(table, options.stop, options.start, options.end)
    if as_json:
        print_json({"kind": "engagement", "engagements": [one.to_json() for one in found]})
        return
    rows = [
        (one.name or "pressure", *(_number(getattr(one.figures, k)) for k in _PRESSURES)) for one in found
    ]
    titles = ("clutch", "delay s", "rise s", "corner s", "corner Pa", "overshoot %")
    print_table(rows, titles, right=range(1, len(titles)))


def _shift(table: Table, plot: Path | None, *, as_json: bool) -> None:
    shifts = gear_shifts(table)
    if plot is not None:
        from acausal.study.metrics.drawing import draw_shifts

        draw_shifts(table, shifts, plot)
    if as_json:
        print_json(
            {"kind": "shift", "shifts": [one.to_json() for one in shifts], "averages": averages(shifts)}
        )
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
