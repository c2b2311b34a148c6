# pyright: reportUnknownMemberType=false
"""Plots of results: one panel per unit over a shared time axis, in a colour-blind safe palette.

Drawn with Figure and FigureCanvasAgg, so no display and none of pyplot's global state is used. Files carry
no dates and no random identifiers: the same result gives the same bytes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Protocol

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from numpy.typing import NDArray

from acausal.errors import UsageProblem, fail
from acausal.lang.flat import Variable

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
"""Okabe and Ito's palette (Color Universal Design, 2008), yellow left out."""
STYLES = ("-", "--", "-.", ":")

DISPLAY_FACTORS: dict[tuple[str, str], float] = {
    ("Pa", "bar"): 1e-5,
    ("Pa", "MPa"): 1e-6,
    ("Pa", "kPa"): 1e-3,
    ("rad", "deg"): 180 / math.pi,
    ("rad/s", "rev/min"): 30 / math.pi,
    ("rad/s", "rpm"): 30 / math.pi,
    ("rad/s", "1/min"): 30 / math.pi,
    ("rad/s", "deg/s"): 180 / math.pi,
    ("m", "mm"): 1e3,
    ("m", "um"): 1e6,
    ("m2", "mm2"): 1e6,
    ("m3", "l"): 1e3,
    ("m3", "cm3"): 1e6,
    ("m3/s", "l/min"): 6e4,
    ("m/s", "km/h"): 3.6,
    ("kg", "g"): 1e3,
    ("s", "ms"): 1e3,
    ("W", "kW"): 1e-3,
    ("1", "%"): 1e2,
}
"""Display units that a plot converts to, and the factor from the unit; any other is shown in its own unit."""

_FORMATS = {".png": "png", ".svg": "svg", ".pdf": "pdf"}
_PANEL_HEIGHT, _WIDTH, _MARGIN = 2.2, 8.0, 0.9


class Plottable(Protocol):
    """What a plot needs of a result."""

    @property
    def time(self) -> NDArray[np.float64]: ...
    @property
    def default_names(self) -> tuple[str, ...]: ...
    def values(self, name: str) -> NDArray[np.float64]: ...
    def unit(self, name: str) -> str: ...
    def variable(self, name: str) -> Variable | None: ...


class NotebookFigure(Figure):
    """A figure that notebooks show; those of Matplotlib are shown only where pyplot made them."""

    def _repr_png_(self) -> bytes:
        return self.as_png()

    def as_png(self, dpi: int = 110) -> bytes:
        """The same picture each time."""
        buffer = BytesIO()
        self.savefig(buffer, format="png", dpi=dpi, metadata={"Software": ""})
        return buffer.getvalue()


@dataclass(frozen=True)
class _Curve:
    name: str
    unit: str
    factor: float


def plot(result: Plottable, names: Sequence[str] | None = None, path: str | Path | None = None) -> Figure:
    """Draws variables over time, one panel for each unit, and writes PNG, SVG or PDF if `path` is given.

    Without names, the result's default selection. Values are in SI units unless a `displayUnit` is
    declared that `DISPLAY_FACTORS` knows. Raises `LookupProblem` for unknown names and `UsageProblem` for
    other file types.
    """
    chosen = result.default_names if names is None else tuple(names)
    curves = [_curve(result, name) for name in chosen]
    panels = list(dict.fromkeys(curve.unit for curve in curves)) or [""]
    figure = NotebookFigure(figsize=(_WIDTH, _MARGIN + _PANEL_HEIGHT * len(panels)), layout="constrained")
    FigureCanvasAgg(figure)
    first: Axes | None = None
    for i, unit in enumerate(panels):
        axes = figure.add_subplot(len(panels), 1, i + 1, sharex=first)
        first = first or axes
        _panel(axes, result, [curve for curve in curves if curve.unit == unit], unit)
        axes.tick_params(labelbottom=i == len(panels) - 1)
        if i == len(panels) - 1:
            axes.set_xlabel("time [s]")
    if path is not None:
        write_figure(figure, Path(path))
    return figure


def bars(names: Sequence[str], values: Sequence[float], label: str, path: Path) -> None:
    """Writes horizontal bars, the first at the bottom, as PNG, SVG or PDF."""
    figure = Figure(figsize=(_WIDTH, _MARGIN + 0.25 * len(names)), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    axes.barh(range(len(names)), values, color=COLOURS[0])
    axes.set_yticks(range(len(names)), [plain(name) for name in names])
    axes.set_xlabel(label)
    write_figure(figure, path)


def _curve(result: Plottable, name: str) -> _Curve:
    unit = result.unit(name)
    variable = result.variable(name)
    display = variable.display_unit if variable else ""
    factor = DISPLAY_FACTORS.get((unit, display))
    return _Curve(name, unit, 1.0) if factor is None else _Curve(name, display, factor)


def _panel(axes: Axes, result: Plottable, curves: Sequence[_Curve], unit: str) -> None:
    for i, curve in enumerate(curves):
        colour = COLOURS[i % len(COLOURS)]
        style = STYLES[i // len(COLOURS) % len(STYLES)]
        values = curve.factor * result.values(curve.name)
        axes.plot(result.time, values, color=colour, linestyle=style, linewidth=1.4, label=plain(curve.name))
    label = f"[{unit}]" if unit else "[-]"
    axes.set_ylabel(plain(f"{curves[0].name} {label}" if len(curves) == 1 else label))
    axes.grid(visible=True, color="#DDDDDD", linewidth=0.6)
    axes.margins(x=0)
    if len(curves) > 1:
        axes.legend(loc="best", fontsize="small", framealpha=0.8)


def plain(text: str) -> str:
    """Text that Matplotlib takes literally: no mathematics between dollars, no leading underscore."""
    escaped = text.replace("$", r"\$")
    return f" {escaped}" if escaped.startswith("_") else escaped


def write_figure(figure: Figure, path: Path) -> None:
    """PNG, SVG or PDF by the file name, without dates. Raises UsageProblem `plot.format`."""
    kind = _FORMATS.get(path.suffix.lower())
    if kind is None:
        raise fail(
            UsageProblem,
            "plot.format",
            f"cannot write a plot to `{path}`",
            hint="use a file name that ends in .png, .svg or .pdf",
        )
    metadata = {"png": {"Software": ""}, "svg": {"Date": None}, "pdf": {"CreationDate": None}}[kind]
    with mpl.rc_context({"svg.hashsalt": "acausal", "svg.fonttype": "path"}):
        figure.savefig(path, format=kind, dpi=150, metadata=metadata)
