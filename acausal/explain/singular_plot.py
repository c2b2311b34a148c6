# pyright: reportUnknownMemberType=false
"""The incidence of a structurally singular model, ordered by the decomposition of Dulmage and Mendelsohn."""

from __future__ import annotations

from html import escape
from io import BytesIO
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from acausal.explain.html_parts import PAGE_STYLE, STYLE
from acausal.explain.plot import MOST_LABELS, label_axes, panel, save_figure
from acausal.explain.singular import decomposed, singular_text
from acausal.explain.words import short
from acausal.lang.flat import FlatModel
from acausal.symbolic.describe import equation_text

_OVER, _UNDER = "#F6D5BF", "#CFE8F5"


def write_singular_plot(flat: FlatModel, path: Path) -> None:
    """Write PNG, SVG or PDF."""
    save_figure(_figure(flat), path, path.suffix.lower()[1:])


def singular_page(flat: FlatModel, problem: str) -> str:
    """One page: the error, both parts, the drawing."""
    buffer = BytesIO()
    save_figure(_figure(flat), buffer, "svg")
    drawing = buffer.getvalue().decode()
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f"<title>{escape(flat.name)} is singular</title>\n<style>\n{STYLE}\n{PAGE_STYLE}\n</style>\n</head>\n"
        f'<body>\n<div class="acausal">\n<h3>{escape(flat.name)}</h3>\n<pre>{escape(problem)}</pre>\n'
        f"<pre>{escape(singular_text(flat, everything=True))}</pre>\n"
        f"<figure>{drawing[drawing.index('<svg') :]}</figure>\n</div>\n</body>\n</html>\n"
    )


def _figure(flat: FlatModel) -> Figure:
    """One panel: too many equations first, then what is determined, then too few."""
    system, parts = decomposed(flat)
    order = (parts.over, parts.well, parts.under)
    rows = [eq for part in order for eq in part.equations]
    columns = [var for part in order for var in part.variables]
    row_to = {eq: i for i, eq in enumerate(rows)}
    column_to = {var: i for i, var in enumerate(columns)}
    pairs = np.array(
        [(row_to[eq], column_to[var]) for eq in rows for var in system.incidence[eq]], dtype=np.int64
    ).reshape(-1, 2)
    size = max(len(rows), len(columns))
    labelled = size <= MOST_LABELS
    height = 1.8 + 0.24 * size if labelled else 5.8
    figure = Figure(figsize=(height + (5.0 if labelled else 0.6), height + 0.6), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots()
    panel(axes, pairs, size, "too many equations (orange), determined, too few equations (blue)")
    _shade(axes, (0, 0), (len(parts.over.variables), len(parts.over.equations)), _OVER)
    corner = (len(columns) - len(parts.under.variables), len(rows) - len(parts.under.equations))
    _shade(axes, corner, (len(parts.under.variables), len(parts.under.equations)), _UNDER)
    if labelled:
        texts = [short(equation_text(system.equations[eq]), 10_000) for eq in rows]
        label_axes(axes, texts, [system.unknowns[var].name for var in columns])
    return figure


def _shade(axes: Axes, corner: tuple[int, int], size: tuple[int, int], colour: str) -> None:
    """A part without any equation, or any unknown, is a line."""
    width, height = (max(length, 0.08) for length in size)
    axes.add_patch(Rectangle(corner, width, height, facecolor=colour, edgecolor="#888888", zorder=1))
