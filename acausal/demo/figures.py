# pyright: reportUnknownMemberType=false
"""The plots that `make run` draws, in PNG and SVG."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from acausal.demo.systems import TOLERANCE, GearTrial, RegulatorTrial

if TYPE_CHECKING:
    from matplotlib.typing import RcKeyType

BLUE, ORANGE, GREEN, PINK, SKY, BLACK = "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#222222"
"""Of Okabe and Ito's palette (Color Universal Design, 2008)."""
_GREY = "#777777"
_BODIES = (1, 2, 3, 4, 5, 6, 7, 8)
_STYLE: dict[RcKeyType, object] = {
    "font.size": 9,
    "axes.titlesize": 9.5,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#E3E3E3",
    "grid.linewidth": 0.6,
    "legend.frameon": False,
    "svg.hashsalt": "acausal",
}


def draw(gears: Sequence[GearTrial], regulators: Sequence[RegulatorTrial], folder: Path) -> list[Path]:
    """Writes `gears` and `regulator`, each as PNG and SVG; the same results give the same bytes."""
    written: list[Path] = []
    with mpl.rc_context(_STYLE):
        for name, figure in (("gears", gear_figure(gears)), ("regulator", regulator_figure(regulators))):
            for kind, metadata in (("png", {"Software": ""}), ("svg", {"Date": None})):
                path = folder / f"{name}.{kind}"
                figure.savefig(path, dpi=150, metadata=metadata)
                written.append(path)
    return written


def _figure(width: float, height: float, title: str) -> Figure:
    figure = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    figure.suptitle(title, x=0.01, ha="left", fontsize=12, fontweight="bold")
    return figure


def gear_figure(trials: Sequence[GearTrial]) -> Figure:
    """Ratios against the published ones, their deviations, and how the bodies run up in three gears."""
    figure = _figure(10, 7.4, "Ten-speed kinematics: one model, eleven gears, one degree of freedom in each")
    grid = figure.add_gridspec(3, 3, height_ratios=(2.2, 1, 2.2))
    ratios = figure.add_subplot(grid[0, :])
    deviations = figure.add_subplot(grid[1, :], sharex=ratios)
    _ratios(ratios, trials)
    _deviations(deviations, trials)
    shown = [trial for trial in trials if trial.gear in (1, 5, -1)]
    for column, trial in enumerate(shown):
        axes = figure.add_subplot(grid[2, column])
        _run_up(axes, trial)
        if column == 0:
            axes.set_ylabel("speed of bodies [rad/s]")
    return figure


def _ratios(axes: Axes, trials: Sequence[GearTrial]) -> None:
    places = np.arange(len(trials))
    published = [trial.published for trial in trials]
    axes.axhline(0, color=_GREY, linewidth=0.8)
    axes.bar(places, published, width=0.62, color="#CFE3F1", edgecolor=BLUE, linewidth=0.8, label="published")
    axes.plot(places, [t.ratio for t in trials], "o", color=ORANGE, markersize=5, label="simulated")
    for place, trial in zip(places, trials, strict=True):
        above = trial.ratio > 0
        axes.annotate(
            f"{trial.ratio:.3f}",
            (float(place), trial.ratio),
            xytext=(0, 7 if above else -7),
            textcoords="offset points",
            ha="center",
            va="bottom" if above else "top",
            fontsize=8,
        )
    axes.set_ylim(min(published) - 1.4, max(published) + 1.4)
    axes.set_ylabel("input / output speed [-]")
    axes.set_title("Ratio at the end of the run")
    axes.legend(loc="upper right", ncols=2)
    axes.tick_params(labelbottom=False)
    axes.grid(visible=False, axis="x")


def _deviations(axes: Axes, trials: Sequence[GearTrial]) -> None:
    places = np.arange(len(trials))
    axes.axhspan(-1e3 * TOLERANCE, 1e3 * TOLERANCE, color="#E2F2EC", zorder=0)
    axes.axhline(0, color=_GREY, linewidth=0.8)
    values = [1e3 * trial.deviation for trial in trials]
    axes.vlines(places, 0, values, color=ORANGE, linewidth=2)
    axes.plot(places, values, "o", color=ORANGE, markersize=4)
    axes.set_ylim(-1.35e3 * TOLERANCE, 1.35e3 * TOLERANCE)
    axes.set_yticks([-1e3 * TOLERANCE, 0, 1e3 * TOLERANCE])
    axes.set_xticks(places, [f"{t.title}\n{t.engaged}" for t in trials], fontsize=8)
    axes.set_ylabel("deviation [10$^{-3}$]")
    axes.set_title("Simulated less published; shaded: what is allowed")
    axes.grid(visible=False, axis="x")


def _run_up(axes: Axes, trial: GearTrial) -> None:
    """The speeds of all bodies; those that turn alike share one line and one label."""
    time = trial.result.time
    speeds = {body: trial.result.values(f"gearbox.body[{body}].w") for body in _BODIES}
    ends: list[tuple[float, list[int]]] = []
    for body in _BODIES:
        end = float(speeds[body][-1])
        same = next((bodies for value, bodies in ends if abs(value - end) < 1e-3 * (1 + abs(end))), None)
        if same is None:
            ends.append((end, [body]))
        else:
            same.append(body)
    span = max(value for value, _ in ends) - min(value for value, _ in ends)
    places = _apart([value for value, _ in ends], 0.07 * span)
    for (end, bodies), place in zip(ends, places, strict=True):
        colour = BLUE if 1 in bodies else ORANGE if 8 in bodies else _GREY
        axes.plot(time, speeds[bodies[0]], color=colour, linewidth=2 if colour != _GREY else 1.1)
        role = {1: " input", 8: " output"}
        label = ", ".join(f"{body}{role.get(body, '')}" for body in bodies)
        if abs(end) < 1e-9:
            label += " held"
        axes.annotate(
            label,
            (1.02, place),
            xycoords=("axes fraction", "data"),
            va="center",
            fontsize=7.5,
            color=colour,
            annotation_clip=False,
        )
    axes.set_xlim(time[0], time[-1])
    axes.set_xlabel("time [s]")
    name = "Reverse" if trial.gear < 0 else f"Gear {trial.gear}"
    axes.set_title(f"{name}, {trial.engaged}")


def _apart(values: Sequence[float], gap: float) -> list[float]:
    """The values, moved up as little as it takes to be `gap` apart."""
    placed: list[float] = list(values)
    lowest = -np.inf
    for i in sorted(range(len(values)), key=lambda i: values[i]):
        placed[i] = lowest = max(values[i], lowest + gap)
    return placed


def regulator_figure(trials: Sequence[RegulatorTrial]) -> Figure:
    """A column for each supply: pressures, spool, flows through the three edges."""
    figure = _figure(10, 7.4, "Main regulator: one valve, three supplies")
    grid = figure.subplots(3, len(trials), sharex="col", sharey="row", squeeze=False)
    for column, trial in enumerate(trials):
        pressures, spool, flows = grid[:, column]
        states = len(trial.compiled.states)
        pressures.set_title(f"{trial.supply.capitalize()}: {states} states")
        _lines(pressures, trial, 1e-5, _PRESSURES)
        _lines(spool, trial, 1e3, _SPOOL)
        _lines(flows, trial, 6e4, _FLOWS)
        flows.set_xlabel("time [ms]")
    for row, label in enumerate(("pressure [bar]", "spool position [mm]", "flow out of the line [l/min]")):
        grid[row, 0].set_ylabel(label)
    grid[0, 0].legend(loc="center right", fontsize=8)
    grid[2, -1].legend(loc="upper left", fontsize=8)
    return figure


_SHOWN_SECONDS = {"MainRegulatorFlow": 0.3, "MainRegulatorPressure": 0.02, "MainRegulatorPressureRamp": 0.6}
"""Where something happens."""
_PRESSURES = (
    ("line.p", "line", BLUE, "-"),
    ("valve.feedbackChamber.p", "feedback chamber", ORANGE, "--"),
    ("valve.pilotChamber.p", "pilot chamber", GREEN, ":"),
)
_SPOOL = (("valve.spool.s", "spool", BLACK, "-"),)
_FLOWS = (
    ("valve.converterEdge.port_a.q", "to the converter", BLUE, "-"),
    ("valve.lubricationEdge.port_a.q", "to lubrication", ORANGE, "--"),
    ("valve.suctionEdge.port_a.q", "to suction", GREEN, ":"),
)


def _lines(
    axes: Axes, trial: RegulatorTrial, factor: float, lines: Sequence[tuple[str, str, str, str]]
) -> None:
    until = _SHOWN_SECONDS[trial.model]
    shown = trial.result.time <= until
    time = 1e3 * trial.result.time[shown]
    for name, label, colour, style in lines:
        values = factor * trial.result.values(name)[shown]
        axes.plot(time, values, linestyle=style, color=colour, linewidth=1.6, label=label)
    axes.set_xlim(0, 1e3 * until)
