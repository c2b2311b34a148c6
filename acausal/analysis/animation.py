# pyright: reportUnknownMemberType=false
"""A mode in motion: its shape over one period, as a GIF."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.animation import PillowWriter
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from acausal.analysis.words import value_text
from acausal.plotting import COLOURS, plain

if TYPE_CHECKING:
    from acausal.analysis.snapshot import Snapshot

_FRAMES, _RATE, _STATES = 40, 20, 20


def animate(snapshot: Snapshot, mode: int, path: Path) -> None:
    """Writes Re(shape exp(i phase)) over one period as a GIF; damping is left out, or little would be seen.

    `mode` counts from 0 in `modes.modes`. States are in nominal values, the largest 1, those that take part
    most first. Raises IndexError for other numbers.
    """
    chosen = snapshot.modes.modes[mode]
    shape = chosen.shape[:, 0] / snapshot.nominals
    order = np.argsort(-np.abs(shape), kind="stable")[:_STATES][::-1]
    positions: list[int] = order.tolist()
    shape = shape[order] / np.abs(shape).max()
    names = [plain(snapshot.states[i]) for i in positions]
    figure = Figure(figsize=(7.0, 1.3 + 0.27 * len(names)), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    bars = axes.barh(range(len(names)), shape.real, color=COLOURS[0])
    axes.set_yticks(range(len(names)), names)
    axes.set_xlim(-1.1, 1.1)
    axes.set_xlabel("shape, in nominal values")
    axes.axvline(0, color="#777777", linewidth=0.8)
    axes.set_title(
        plain(f"{snapshot.model}: mode {mode + 1}, {value_text(chosen.eigenvalue)} 1/s"), fontsize="medium"
    )
    writer = PillowWriter(fps=_RATE)
    with writer.saving(figure, str(path), dpi=80):
        for phase in np.linspace(0, 2 * np.pi, _FRAMES, endpoint=False):
            for bar, width in zip(bars.patches, (shape * np.exp(1j * phase)).real.tolist(), strict=True):
                bar.set_width(float(width))
            writer.grab_frame()
