# pyright: reportUnknownMemberType=false
"""Draw the figures of the page on valves: `python docs/draw_valves.py [NAME]...`, into docs/figures.

Left the characteristic, from the bench's own slow sweep; right the response to a step. Every line is a run of
`TenSpeed.Benches`; nothing is drawn that the models do not give.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from figure_files import save
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

import acausal
from acausal.simulate.result import Result

Array = NDArray[np.float64]
Changes = Mapping[str, str | float]
COLOURS = ("#0072b2", "#56b4e9", "#009e73", "#e69f00", "#d55e00")
"""Levels 1 to 5; from the palette of Okabe and Ito, told apart by the colour-blind."""
LABELS = {
    "i_cmd": ("current in A", 1.0),
    "p_out": ("outlet in bar", 1e-5),
    "p_line": ("line in bar", 1e-5),
    "p_pilot": ("pilot in bar", 1e-5),
    "p_command": ("command in bar", 1e-5),
    "p_drive": ("pressure to drive in bar", 1e-5),
    "q_supply": ("supply in l/min", 6e4),
    "q_drain": ("through the valve in l/min", 6e4),
    "drained": ("out of four lines in g/s", 1e3),
    "s": ("position in mm", 1e3),
}


@dataclass(frozen=True)
class Picture:
    """What is drawn of a valve: `levels` in the characteristic, `slow` the time that its sweep takes."""

    bench: str
    x: str
    y: str
    levels: tuple[int, ...]
    slow: tuple[float, float]
    step: Changes
    stop: float
    start: float = 0.0
    response: str = ""
    step_levels: tuple[int, ...] = (1, 2, 3, 4, 5)
    sweep: Changes = field(default_factory=dict[str, str | float])


def command(low: str, high: str, at: float = 0.01, duration: float = 0.002) -> Changes:
    """A step of the signal `command`."""
    values = f"{{{low}, {high}}}"
    return {"command.times": f"{{{at}}}", "command.values": values, "command.duration": duration}


SWEEP: Changes = {"command.times": "{0, 5}", "command.values": "{0, 1, 0}", "command.duration": 5.0}
DRIVE: Changes = {"drive.times": "{0.01}", "drive.values": "{101325, 9e5}", "drive.duration": 0.002}
PICTURES: dict[str, Picture] = {
    "linear-solenoid": Picture(
        "LinearSolenoid", "i_cmd", "p_out", (1, 5), (0, 10), command("0", "0.6"), 0.08, sweep=SWEEP
    ),
    "shift-solenoid": Picture(
        "ShiftSolenoid", "i_cmd", "p_out", (1, 4, 5), (0, 10), command("0", "1"), 0.08, sweep=SWEEP
    ),
    "main-regulator": Picture(
        "MainRegulatorFlow",
        "q_supply",
        "p_line",
        (1, 4, 5),
        (0.45, 2.5),
        {**command("3e5", "3e5"), "supply.startTime": 0.3, "supply.duration": 0.005},
        0.35,
        start=0.29,
    ),
    "lubrication-regulator": Picture(
        "LubricationRegulator",
        "q_drain",
        "p_out",
        (1, 5),
        (0.45, 2.5),
        {"supply.startTime": 0.3, "supply.duration": 0.005},
        0.4,
        start=0.29,
    ),
    "converter-regulator": Picture(
        "ConverterRegulator",
        "q_drain",
        "p_out",
        (1, 5),
        (0.45, 2.5),
        {"supply.startTime": 0.3, "supply.duration": 0.005},
        0.37,
        start=0.29,
    ),
    "accumulator": Picture(
        "LineAccumulator",
        "p_line",
        "s",
        (1,),
        (0, 6),
        {"supply.p_start": 8e5, "supply.p_end": 10e5, "supply.startTime": 0.3, "supply.duration": 0.002},
        0.5,
        start=0.28,
        step_levels=(1, 2, 3),
        sweep={"supply.startTime": 0.0, "supply.duration": 6.0},
    ),
    "lockup-control": Picture(
        "LockupControl",
        "p_command",
        "p_out",
        (1, 5),
        (0, 10),
        command("101325", "4e5"),
        0.08,
        sweep={**SWEEP, "command.values": "{101325, 7e5, 101325}"},
    ),
    "switch-valve": Picture(
        "SwitchValve", "p_pilot", "p_out", (1, 4, 5), (0.2, 4.8), command("101325", "8e5"), 0.06
    ),
    "cut-valve": Picture(
        "CutValve", "p_pilot", "drained", (1, 4, 5), (0.2, 4.8), command("101325", "8e5"), 0.06
    ),
    "two-way-clutch-valve": Picture(
        "TwoWayClutchValve",
        "p_drive",
        "s",
        (1, 3, 5),
        (0.0, 3.0),
        DRIVE,
        0.06,
        step_levels=(1, 2, 3, 4),
    ),
}


def thinned(x: Array, y: Array, points: int = 100) -> tuple[Array, Array]:
    """The curve at points that are evenly spaced along its drawn length."""
    if x.size <= points:
        return x, y
    spans = (max(float(np.ptp(v)), 1e-12) for v in (x, y))
    length = np.concatenate(
        [[0.0], np.cumsum(np.hypot(*(np.diff(v) / d for v, d in zip((x, y), spans, strict=True))))]
    )
    chosen = np.unique(np.searchsorted(length, np.linspace(0, length[-1], points)))
    return x[chosen], y[chosen]


def run(bench: str, changes: Changes, stop: float | None, points: int = 1000) -> Result:
    """A run of a bench with changes."""
    compiled = acausal.load(f"TenSpeed.Benches.{bench}").compile(dict(changes))
    return compiled.simulate(stop_time=stop, interval=stop / points if stop else None)


def draw_characteristic(axes: Axes, picture: Picture) -> None:
    """Quantity `y` over `x` during the slow sweep."""
    for level in picture.levels:
        result = run(f"{picture.bench}L{level}", picture.sweep, picture.slow[1] if picture.sweep else None)
        chosen = (result.time >= picture.slow[0]) & (result.time <= picture.slow[1])
        (x_label, x_scale), (y_label, y_scale) = LABELS[picture.x], LABELS[picture.y]
        x, y = x_scale * result.values(picture.x)[chosen], y_scale * result.values(picture.y)[chosen]
        axes.plot(*thinned(x, y), color=COLOURS[level - 1], label=f"level {level}")
        axes.set_xlabel(x_label)
        axes.set_ylabel(y_label)


def draw_response(axes: Axes, picture: Picture) -> None:
    """Quantity over time after the step, for every level."""
    name = picture.response or picture.y
    label, scale = LABELS[name]
    for level in picture.step_levels:
        result = run(f"{picture.bench}L{level}", picture.step, picture.stop, 2000)
        shown = result.time >= picture.start
        time, y = thinned(1e3 * result.time[shown], scale * result.values(name)[shown])
        axes.plot(time, y, color=COLOURS[level - 1], label=f"level {level}", lw=1)
    axes.set_xlabel("time in ms")
    axes.set_ylabel(label)


def two_panels() -> tuple[Figure, tuple[Axes, Axes]]:
    """A figure with two axes side by side."""
    figure = Figure(figsize=(8, 3), layout="constrained")
    left, right = figure.subplots(1, 2)
    return figure, (left, right)


def draw(picture: Picture) -> Figure:
    """Characteristic and step response."""
    figure, (left, right) = two_panels()
    draw_characteristic(left, picture)
    draw_response(right, picture)
    return figure


def draw_circuit() -> Figure:
    """Pressures of the regulation circuit over time: fed by a flow, and at a prescribed pressure."""
    figure, panels = two_panels()
    for axes, supply in zip(panels, ("Flow", "Pressure"), strict=True):
        result = run(f"RegulationCircuit{supply}", {}, None)
        for name, colour in zip(("line", "converter", "lubrication"), COLOURS[::2], strict=True):
            time, p = thinned(result.time, 1e-5 * result.values(f"p_{name}"))
            axes.plot(time, p, color=colour, label=name)
        other = axes.twinx()
        time, q = thinned(result.time, 6e4 * result.values("q_supply"))
        other.plot(time, q, color="#888888", ls="--", lw=1)
        other.set_ylabel("supply in l/min (dashed)")
        axes.set_xlabel("time in s")
        axes.set_ylabel("pressure in bar")
        axes.set_title(f"supply: {supply.lower()}", fontsize=9)
    return figure


def main(names: list[str]) -> None:
    """Draw what is named, by default everything."""
    for name, picture in PICTURES.items():
        if not names or name in names:
            save("valve", name, draw(picture))
    if not names or "circuit" in names:
        save("valve", "circuit", draw_circuit())


if __name__ == "__main__":
    main(sys.argv[1:])
