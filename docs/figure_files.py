"""Writes the figures of the pages on converter and valves, the same bytes for the same lines."""

from __future__ import annotations

import io
import re
from pathlib import Path

import matplotlib as mpl
from matplotlib.figure import Figure

FOLDER = Path(__file__).parent / "figures"


def save(page: str, name: str, figure: Figure) -> None:
    """Write `figures/PAGE-NAME.svg`, with grids and legends."""
    for axes in figure.axes:
        axes.grid(visible=True, lw=0.3)
        if axes.get_legend_handles_labels()[0]:
            axes.legend(fontsize=7, frameon=False)
    with mpl.rc_context({"svg.fonttype": "none", "svg.hashsalt": name, "font.size": 9}):
        text = io.StringIO()
        figure.savefig(text, format="svg", metadata={"Date": None})
    short = re.sub(
        r"(?<=[ \"])-?\d+\.\d{2,}(?=[ \"\n])", lambda found: f"{float(found[0]):.1f}", text.getvalue()
    )
    lines = (line.rstrip() for line in short.splitlines())
    (FOLDER / f"{page}-{name}.svg").write_text("\n".join(lines) + "\n", encoding="utf-8")
