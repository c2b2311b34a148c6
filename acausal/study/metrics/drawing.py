# pyright: reportUnknownMemberType=false
"""What was measured, drawn over the traces, one row of panels a shift."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg

from acausal.plotting import COLOURS, NotebookFigure, write_figure
from acausal.study.metrics.sweep import GearShift
from acausal.study.metrics.table import Table

_BEFORE = 0.2


def draw_shifts(table: Table, shifts: Sequence[GearShift], path: Path) -> None:
    """Output torque with its levels, and slip and torque of the two elements; PNG, SVG or PDF."""
    figure = NotebookFigure(figsize=(11.0, 2.2 * len(shifts) + 0.6), layout="constrained")
    FigureCanvasAgg(figure)
    for row, one in enumerate(shifts):
        left, right = (
            figure.add_subplot(len(shifts), 2, 2 * row + 1),
            figure.add_subplot(len(shifts), 2, 2 * row + 2),
        )
        _torque(left, table, one)
        _elements(right, table, one)
        for axes in (left, right):
            axes.grid(visible=True, color="#DDDDDD", linewidth=0.6)
            axes.margins(x=0)
            axes.legend(loc="best", fontsize="x-small", framealpha=0.8)
            if row == len(shifts) - 1:
                axes.set_xlabel("time [s]")
    write_figure(figure, path)


def _torque(axes: Axes, table: Table, one: GearShift) -> None:
    figures = one.figures
    part = table.trace("outputTorque").between(figures.start - _BEFORE, figures.end)
    axes.plot(
        part.time, part.values, color=COLOURS[0], linewidth=1.2, label=f"{one.from_gear} to {one.to_gear}"
    )
    axes.axhline(figures.final_torque, color="#777777", linewidth=0.8, linestyle="--", label="final")
    if figures.torque_hole:
        lowest = figures.final_torque + figures.torque_hole
        axes.axhline(
            lowest,
            color=COLOURS[1],
            linewidth=0.8,
            linestyle=":",
            label=f"hole {figures.torque_hole:.0f} N.m",
        )
    axes.axvline(figures.start, color="#777777", linewidth=0.8)
    axes.set_ylabel("torque [N.m]", fontsize="small")


def _elements(axes: Axes, table: Table, one: GearShift) -> None:
    figures = one.figures
    start, end = figures.start - _BEFORE, figures.end
    if figures.oncoming is not None:
        slip = table.trace(f"slip_{figures.oncoming}").between(start, end)
        length = "" if figures.inertia_phase is None else f", inertia phase {figures.inertia_phase:.2f} s"
        axes.plot(
            slip.time, slip.values, color=COLOURS[2], linewidth=1.2, label=f"slip {figures.oncoming}{length}"
        )
    axes.set_ylabel("slip [rad/s]", fontsize="small")
    if figures.offgoing is not None:
        torque = table.trace(f"torque_{figures.offgoing}").between(start, end)
        length = "" if figures.torque_phase is None else f", torque phase {figures.torque_phase:.2f} s"
        other = axes.twinx()
        other.plot(torque.time, torque.values, color=COLOURS[3], linewidth=1.2, linestyle="--")
        other.set_ylabel("torque [N.m]", fontsize="small")
        axes.plot([], [], color=COLOURS[3], linestyle="--", label=f"torque {figures.offgoing}{length}")
