# pyright: reportUnknownMemberType=false
"""Eigenvalues in the complex plane, mode shapes and frequency responses, drawn with Matplotlib.

Axes are linear while all eigenvalues are of one size, and else symmetrically logarithmic: the slow modes of a
stiff model would all lie on the origin. Colours and markers tell snapshots apart, also in grey.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, log10, pi
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from numpy.typing import ArrayLike, NDArray

from acausal.analysis.bode import Bode
from acausal.analysis.words import value_text, when
from acausal.plotting import COLOURS, STYLES, NotebookFigure, plain, write_figure

if TYPE_CHECKING:
    from acausal.analysis.batch import Variants
    from acausal.analysis.snapshot import Snapshot
    from acausal.analysis.sweep import Locus

MARKERS = ("o", "x", "s", "^", "D", "v")
_SPREAD = 300.0
"""From here on, the ratio of the largest to the smallest eigenvalue asks for logarithmic axes."""
_DECADES = 1e-6
_APART = 0.035
_SMALL = 1e-3
_DAMPING = (0.02, 0.1, 0.3, 0.7)
_LABELLED = 8
_STATES = 16


def draw_plane(
    snapshots: Sequence[Snapshot], path: str | Path | None = None, names: Sequence[str] | None = None
) -> NotebookFigure:
    """The eigenvalues of snapshots in one complex plane: real part in 1/s, imaginary part in rad/s and Hz.

    Grey rays are lines of equal damping ratio; the right half, where modes grow, is shaded. The numbers are
    those of the first snapshot's least damped modes. Raises UsageProblem `plot.format` for other files.
    """
    figure, axes = _figure(8.0, 5.6)
    values = [snapshot.eigenvalues for snapshot in snapshots]
    threshold = scale_axes(axes, np.concatenate(values) if values else np.zeros(0, complex))
    for i, (snapshot, roots) in enumerate(zip(snapshots, values, strict=True)):
        label = names[i] if names is not None else title_of(snapshot)
        scatter_roots(axes, roots, i, label)
    if snapshots:
        _number(axes, snapshots[0])
    dress_plane(axes, threshold)
    figure.legend(loc="outside upper left", fontsize="small", ncols=1 if len(snapshots) < 3 else 2)
    return _written(figure, path)


def title_of(snapshot: Snapshot) -> str:
    """`Model, initial` or `Model, 0.5 s`."""
    return plain(f"{snapshot.model}, {when(snapshot)}")


def scatter_roots(axes: Axes, roots: NDArray[np.complex128], i: int, label: str) -> None:
    """One set of eigenvalues, with the i-th colour and marker."""
    marker = MARKERS[i % len(MARKERS)]
    axes.plot(
        roots.real,
        roots.imag,
        marker=marker,
        color=COLOURS[i % len(COLOURS)],
        linestyle="none",
        markersize=7,
        markerfacecolor="none",
        markeredgewidth=1.5,
        label=label,
        zorder=3,
    )


def scale_axes(axes: Axes, roots: NDArray[np.complex128]) -> float:
    """Chooses linear or symmetrically logarithmic axes, and their ends.

    The size below which logarithmic axes are linear; 0 for linear axes.
    """
    sizes = np.abs(roots)
    sizes = sizes[sizes > 0]
    largest = float(sizes.max(initial=0.0)) or 1.0
    threshold = 0.0
    if sizes.size and largest / float(sizes.min()) > _SPREAD:
        threshold = 10.0 ** np.floor(np.log10(max(float(sizes.min()), largest * _DECADES)))
        axes.set_xscale("symlog", linthresh=threshold, linscale=1.0)
        axes.set_yscale("symlog", linthresh=threshold, linscale=1.0)
    up = 1.3 * max(float(np.abs(roots.imag).max(initial=0.0)), 0.3 * largest)
    right = 1.5 * max(float(roots.real.max(initial=0.0)), 0.0)
    axes.set_xlim(
        -1.3 * max(float(-roots.real.min(initial=0.0)), 0.3 * largest),
        max(right, threshold or 0.08 * largest),
    )
    axes.set_ylim(-up, up)
    return threshold


def dress_plane(axes: Axes, threshold: float) -> None:
    """Axes' names and units, the unstable half, rays of equal damping, a second scale in Hz."""
    left, right = axes.get_xlim()
    bottom, top = axes.get_ylim()
    axes.axvspan(0, right, color="#D55E00", alpha=0.08, linewidth=0)
    axes.axvline(0, color="#777777", linewidth=0.8)
    axes.axhline(0, color="#777777", linewidth=0.8)
    for ratio in _DAMPING:
        _ray(axes, ratio, 1.5 * max(abs(left), top))
    axes.set_xlim(left, right)
    axes.set_ylim(bottom, top)
    kind = ", logarithmic" if threshold else ""
    axes.set_xlabel(f"real part [1/s]{kind}")
    axes.set_ylabel(f"imaginary part [rad/s]{kind}")
    axes.grid(visible=True, color="#EEEEEE", linewidth=0.6)
    hertz = axes.secondary_yaxis("right", functions=(_to_hertz, _to_radians))
    if threshold:
        hertz.set_yscale("symlog", linthresh=threshold / (2 * pi), linscale=1.0)
        ends = [10.0**k for k in range(ceil(log10(threshold)), ceil(log10(top / (2 * pi))))]
        hertz.set_yticks([*(-end for end in reversed(ends)), 0.0, *ends])
    hertz.set_ylabel("imaginary part / 2π [Hz]")


def _to_hertz(radians: ArrayLike) -> NDArray[np.float64]:
    return np.asarray(radians, dtype=np.float64) / (2 * pi)


def _to_radians(hertz: ArrayLike) -> NDArray[np.float64]:
    return np.asarray(hertz, dtype=np.float64) * (2 * pi)


def _ray(axes: Axes, ratio: float, size: float) -> None:
    """The lines of one damping ratio in both quadrants, its value at the upper one's end."""
    sizes = np.geomspace(1e-7, 1, 600) * size
    x, y = -ratio * sizes, np.sqrt(1 - ratio**2) * sizes
    for sign in (1, -1):
        axes.plot(x, sign * y, color="#BBBBBB", linewidth=0.7, linestyle=":", zorder=1)
    places = axes.transAxes.inverted().transform(axes.transData.transform(np.column_stack([x, y])))
    inside = np.flatnonzero((places[:, 0] > 0.04) & (places[:, 1] < 0.95))
    if inside.size:
        end = (float(x[inside[-1]]), float(y[inside[-1]]))
        axes.annotate(f"{ratio:g}", end, fontsize=7, color="#888888", ha="right", va="bottom")


def _number(axes: Axes, snapshot: Snapshot) -> None:
    """The numbers of the least damped modes, as the table lists them, where there is room."""
    modes = [(i, m) for i, m in enumerate(snapshot.modes.modes) if m.eigenvalue.imag >= 0]
    taken: list[NDArray[np.float64]] = []
    for i, mode in sorted(modes, key=lambda pair: (pair[1].eigenvalue == 0, pair[1].damping_ratio)):
        place = (mode.eigenvalue.real, mode.eigenvalue.imag)
        on_page = np.asarray(axes.transAxes.inverted().transform(axes.transData.transform(place)))
        if len(taken) < _LABELLED and all(np.abs(on_page - other).max() > _APART for other in taken):
            taken.append(on_page)
            axes.annotate(str(i + 1), place, xytext=(6, 5), textcoords="offset points", fontsize=8)


def draw_shape(snapshot: Snapshot, mode: int, path: str | Path | None = None) -> NotebookFigure:
    """A mode's shape and participation as bars, the states that take part most first.

    Shapes are in nominal values of the states, the largest 1, with their phase in degrees. `mode` counts
    from 0 in `modes.modes`. Raises IndexError for other numbers.
    """
    chosen = snapshot.modes.modes[mode]
    shape = chosen.shape[:, 0] / snapshot.nominals
    shape = shape / shape[np.abs(shape).argmax()]
    weight = np.maximum(chosen.participation, _SMALL * np.abs(shape))
    shown = max(int((weight > _SMALL / 2).sum()), 1)
    order = np.argsort(-weight, kind="stable")[: min(shown, _STATES)][::-1]
    positions: list[int] = order.tolist()
    names = [plain(snapshot.states[i]) for i in positions]
    figure = NotebookFigure(figsize=(9.0, 1.4 + 0.27 * len(names)), layout="constrained")
    FigureCanvasAgg(figure)
    left, right = figure.subplots(1, 2, sharey=True)
    left.barh(range(len(names)), shape[order].real, color=COLOURS[0], height=0.4, align="edge", label="real")
    if np.abs(shape.imag).max() > 1e-2:
        left.barh(
            range(len(names)),
            shape[order].imag,
            color=COLOURS[1],
            height=-0.4,
            align="edge",
            label="imaginary",
        )
        left.legend(fontsize="small", loc="best")
    left.set_yticks(range(len(names)), names)
    left.set_xlabel("shape, in nominal values")
    right.barh(range(len(names)), 100 * chosen.participation[order], color=COLOURS[2])
    right.set_xlabel("participation [%]")
    for axes in (left, right):
        axes.set_axisbelow(True)
        axes.grid(visible=True, axis="x", color="#EEEEEE", linewidth=0.6)
        axes.axvline(0, color="#777777", linewidth=0.8)
    frequency = (
        f", {chosen.frequency_hz:.4g} Hz, damping {chosen.damping_ratio:.3g}" if chosen.eigenvalue else ""
    )
    what = f"mode {mode + 1}, {value_text(chosen.eigenvalue)} 1/s{frequency}, {chosen.kind}"
    figure.suptitle(f"{title_of(snapshot)}: {what}", fontsize="medium")
    return _written(figure, path)


def draw_locus(locus: Locus, path: str | Path | None = None) -> NotebookFigure:
    """The branches in the complex plane: a line each, its dots coloured by the parameter."""
    figure, axes = _figure(8.6, 5.8)
    roots = locus.roots
    threshold = scale_axes(axes, roots.ravel())
    for branch in roots.T:
        axes.plot(branch.real, branch.imag, color="#999999", linewidth=0.9, zorder=2)
    colour = np.repeat(np.asarray(locus.values)[:, None], roots.shape[1], axis=1).ravel()
    dots = axes.scatter(roots.real.ravel(), roots.imag.ravel(), c=colour, cmap="cividis", s=14, zorder=3)
    first = roots[0]
    axes.scatter(first.real, first.imag, s=60, facecolors="none", edgecolors="#000000", zorder=4)
    dress_plane(axes, threshold)
    unit = f" [{locus.unit}]" if locus.unit else ""
    figure.colorbar(dots, ax=axes, label=plain(f"{locus.name}{unit}"), pad=0.1)
    axes.set_title(title_of(locus.variants.first), fontsize="medium")
    return _written(figure, path)


def draw_cloud(variants: Variants, path: str | Path | None = None) -> NotebookFigure:
    """The eigenvalues of all variants in one complex plane, those of the first one marked."""
    figure, axes = _figure(8.0, 5.6)
    roots = variants.eigenvalues
    threshold = scale_axes(axes, roots.ravel())
    flat = roots.ravel()
    axes.scatter(flat.real, flat.imag, s=6, color=COLOURS[0], alpha=0.35, linewidths=0, zorder=2)
    scatter_roots(axes, roots[0], 1, "the first")
    dress_plane(axes, threshold)
    axes.set_title(plain(f"{variants.first.model}: {len(variants)} variants"), fontsize="medium")
    figure.legend(loc="outside lower left", fontsize="small")
    return _written(figure, path)


def draw_bode(response: Bode, path: str | Path | None = None) -> NotebookFigure:
    """Magnitude in dB and phase in degrees over frequency in Hz, one line for each pair of signals."""
    figure = NotebookFigure(figsize=(8.0, 5.6), layout="constrained")
    FigureCanvasAgg(figure)
    above, below = figure.subplots(2, 1, sharex=True)
    pairs = [(o, i) for o in range(len(response.outputs)) for i in range(len(response.inputs))]
    for k, (o, i) in enumerate(pairs):
        style = {"color": COLOURS[k % len(COLOURS)], "linestyle": STYLES[k // len(COLOURS) % len(STYLES)]}
        label = plain(f"{response.inputs[i]} to {response.outputs[o]}")
        above.semilogx(response.frequency, response.magnitude_db[o, i], linewidth=1.4, label=label, **style)
        below.semilogx(response.frequency, response.phase_deg[o, i], linewidth=1.4, **style)
    above.set_ylabel("magnitude [dB]")
    below.set_ylabel("phase [deg]")
    below.set_xlabel("frequency [Hz]")
    above.set_title(plain(response.title), fontsize="medium")
    above.legend(fontsize="small", loc="best", framealpha=0.8)
    for axes in (above, below):
        axes.grid(visible=True, which="both", color="#E5E5E5", linewidth=0.6)
        axes.margins(x=0)
    return _written(figure, path)


def _figure(width: float, height: float) -> tuple[NotebookFigure, Axes]:
    figure = NotebookFigure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure, figure.add_subplot()


def _written(figure: NotebookFigure, path: str | Path | None) -> NotebookFigure:
    if path is not None:
        write_figure(figure, Path(path))
    return figure
