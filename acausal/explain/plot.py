# pyright: reportUnknownMemberType=false
"""The incidence of equations and unknowns before and after sorting, drawn.

Drawn with Figure and FigureCanvasAgg, so no display and none of pyplot's global state is used. Files carry no
dates and no random identifiers. Large systems are drawn as pixels, so that a file stays small.
"""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PatchCollection
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from numpy.typing import NDArray

from acausal.errors import UsageProblem, fail
from acausal.explain.explanation import Explanation
from acausal.explain.words import short
from acausal.symbolic.describe import equation_text, leaf_texts

PLOTS = (".png", ".svg", ".pdf")
MOST_LABELS = 30
"""Systems of more equations are drawn without the texts of equations and unknowns."""
MOST_PIXELS = 800
"""Rows and columns of the image; of a larger system, a pixel stands for several."""
MOST_SQUARES = 120
"""Systems of more equations are drawn as pixels."""
_LABEL_LENGTH = 34
_POINT, _LOOP, _EDGE = "#0072B2", "#D55E00", "#F6D5BF"

Pairs = NDArray[np.int64]


def incidence_svg(explanation: Explanation) -> str:
    """The drawing as an SVG element to stand in a page."""
    buffer = BytesIO()
    save_figure(_figure(explanation), buffer, "svg")
    text = buffer.getvalue().decode()
    return text[text.index("<svg") :]


def write_incidence(explanation: Explanation, path: Path) -> None:
    """Write PNG, SVG or PDF. Raises `UsageProblem` for other endings."""
    if path.suffix.lower() not in PLOTS:
        hint = f"end the name in {', '.join(PLOTS)}"
        raise fail(UsageProblem, "plot.format", f"cannot write a plot to `{path}`", hint=hint)
    save_figure(_figure(explanation), path, path.suffix.lower()[1:])


def save_figure(figure: Figure, target: Path | BytesIO, kind: str) -> None:
    """Write the drawing as `png`, `svg` or `pdf`, without dates and random identifiers."""
    metadata = {
        "png": {"Software": ""},
        "svg": dict.fromkeys(["Date", "Creator", "Format", "Type"]),
        "pdf": {"CreationDate": None},
    }[kind]
    with mpl.rc_context({"svg.hashsalt": "acausal", "svg.fonttype": "path"}):
        figure.savefig(target, format=kind, dpi=150, metadata=metadata)


def _figure(explanation: Explanation) -> Figure:
    """Two panels: the model's order, and the order of solving with the blocks."""
    found = explanation.incidence
    size = len(found.equations)
    labelled = size <= MOST_LABELS
    height = 1.8 + 0.24 * size if labelled else 5.8
    figure = Figure(figsize=(2.0 * height + (5.0 if labelled else 0.6), height + 0.6), layout="constrained")
    FigureCanvasAgg(figure)
    before, after = figure.subplots(1, 2)
    pairs = np.array(found.pairs, dtype=np.int64).reshape(-1, 2)
    moved = np.column_stack(
        [np.array(found.row_to, int)[pairs[:, 0]], np.array(found.column_to, int)[pairs[:, 1]]]
    )
    rows = [short(equation_text(equation), 10_000) for equation in found.equations] if labelled else []
    columns = list(leaf_texts(found.unknowns)) if labelled else []
    panel(before, pairs, size, f"as the model has it: {size} equations")
    label_axes(before, rows, columns)
    loops = [n for n in found.sizes if n > 1]
    _blocks(after, found.sizes)
    panel(
        after,
        moved,
        size,
        f"as it is solved: {len(found.sizes)} blocks, largest {max(loops, default=min(size, 1))}",
    )
    label_axes(after, _moved(rows, found.row_to), _moved(columns, found.column_to))
    return figure


def _moved(labels: Sequence[str], to: Sequence[int]) -> list[str]:
    return [label for _, label in sorted(zip(to, labels, strict=False))]


def panel(axes: Axes, pairs: Pairs, size: int, title: str) -> None:
    """One matrix: squares if it is small, else an image in which a pixel may stand for several entries."""
    extent = max(size, 1)
    axes.set_title(title, fontsize=10)
    if size <= MOST_SQUARES:
        squares = [Rectangle((column + 0.12, row + 0.12), 0.76, 0.76) for row, column in pairs.tolist()]
        axes.add_collection(PatchCollection(squares, facecolor=_POINT, edgecolor="none", zorder=2))
    else:
        cells = min(size, MOST_PIXELS)
        image = np.zeros((cells, cells), dtype=np.uint8)
        scaled = pairs * cells // size
        image[scaled[:, 0], scaled[:, 1]] = 1
        axes.imshow(
            np.ma.masked_equal(image, 0),
            cmap=ListedColormap([_POINT]),
            extent=(0, size, size, 0),
            interpolation="nearest",
            zorder=2,
        )
    axes.set(xlim=(0, extent), ylim=(extent, 0), aspect="equal")
    axes.set_xlabel("unknown")
    axes.set_ylabel("equation")
    axes.tick_params(labelsize=8)


def _blocks(axes: Axes, sizes: Sequence[int]) -> None:
    """Frames around loops, and thin ones around the single equations of small systems."""
    starts = np.concatenate([[0], np.cumsum(sizes, dtype=np.int64)]).tolist()
    total = starts[-1]
    loops = [Rectangle((at, at), n, n) for at, n in zip(starts, sizes, strict=False) if n > 1]
    single = [Rectangle((at, at), 1, 1) for at, n in zip(starts, sizes, strict=False) if n == 1]
    axes.add_collection(PatchCollection(loops, facecolor=_EDGE, edgecolor=_LOOP, linewidth=1.0, zorder=1))
    if total <= MOST_SQUARES:
        axes.add_collection(
            PatchCollection(single, facecolor="none", edgecolor="#888888", linewidth=0.6, zorder=3)
        )


def label_axes(axes: Axes, rows: Sequence[str], columns: Sequence[str]) -> None:
    """The texts of equations and unknowns, where there are any."""
    if not rows:
        return
    axes.set_xlabel("")
    axes.set_ylabel("")
    axes.set_xticks(
        [i + 0.5 for i in range(len(columns))], [_plain(c) for c in columns], rotation=90, fontsize=8
    )
    axes.set_yticks([i + 0.5 for i in range(len(rows))], [_plain(r) for r in rows], fontsize=8)
    axes.tick_params(length=0)


def _plain(text: str) -> str:
    """Text that Matplotlib takes literally, cut where it is long."""
    cut = text if len(text) <= _LABEL_LENGTH else text[: _LABEL_LENGTH - 3] + "..."
    return cut.replace("\\", "\\\\").replace("$", r"\$") if "$" in cut else cut
