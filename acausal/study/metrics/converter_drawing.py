# pyright: reportUnknownMemberType=false
"""Curves of torque converters over the speed ratio, one picture."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from matplotlib.backends.backend_agg import FigureCanvasAgg

from acausal.plotting import COLOURS, NotebookFigure, write_figure
from acausal.study.metrics.converter import Curves

_STYLES = ("-", "--", ":", "-.")
_SHOWN = 0.985
"""K is shown up to here; it grows without bound."""


def draw_converter(sweeps: Mapping[str, Curves], path: Path) -> None:
    """Torque ratio, efficiency and K of each sweep; PNG, SVG or PDF."""
    figure = NotebookFigure(figsize=(7.0, 3.6), layout="constrained")
    FigureCanvasAgg(figure)
    left = figure.add_subplot(1, 1, 1)
    right = left.twinx()
    for (name, one), style in zip(sweeps.items(), _STYLES * len(sweeps), strict=False):
        drives = one.ratio <= 1
        x = one.ratio[drives]
        left.plot(x, one.torque_ratio[drives], style, color=COLOURS[0], label=f"torque ratio, {name}")
        left.plot(x, x * one.torque_ratio[drives], style, color=COLOURS[1], label=f"efficiency, {name}")
        near = one.ratio <= _SHOWN
        right.plot(one.ratio[near], one.capacity[near], style, color=COLOURS[2])
        left.plot([], [], style, color=COLOURS[2], label=f"K, {name}")
    left.set_xlabel("speed ratio")
    left.set_ylabel("torque ratio, efficiency")
    right.set_ylabel("K [rpm/sqrt(N.m)]")
    right.set_ylim(0, None)
    left.set_xlim(0, 1)
    left.set_ylim(0, None)
    left.grid(visible=True, color="#DDDDDD", linewidth=0.6)
    left.legend(loc="lower center", fontsize="small", framealpha=0.8)
    write_figure(figure, path)
