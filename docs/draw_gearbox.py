# pyright: reportUnknownMemberType=false
"""Draw the figures of the page on the gearbox, into docs/figures, and print its tables.

`python docs/draw_gearbox.py`.

One run of `TenSpeed.Benches` at each level, from the start through the shift from second to third; half a
minute of CPU time, most of it level 1. Nothing is drawn that the models do not give.
"""

from __future__ import annotations

import io
import re
from collections.abc import Mapping
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

import acausal
from acausal.analysis.linearize import snapshots
from acausal.analysis.snapshot import Snapshot
from acausal.simulate.result import Result

FOLDER = Path(__file__).parent / "figures"
COLOURS = {1: "#0072b2", 2: "#009e73", 3: "#e69f00", 4: "#d55e00"}
"""From the palette of Okabe and Ito, told apart by the colour-blind."""
MARKERS = {1: ".", 2: "x", 3: "+", 4: "o"}
START, STOP = 10.15, 10.75
"""Around the shift from second to third, which is commanded at 10 s."""
SNAPSHOT = 11.9
PANELS = (
    ("outputTorque", "output torque in N m"),
    ("slip_C3", "slip of C3 in rad/s"),
    ("torque_C3", "torque of C3 in N m"),
    ("torque_C2", "torque of C2 in N m"),
)


def main() -> None:
    """Draw the figures and print the tables."""
    mpl.rcParams.update({"svg.hashsalt": "acausal", "svg.fonttype": "none", "font.size": 8.0})
    runs: dict[int, Result] = {}
    points: dict[int, Snapshot] = {}
    for level in (4, 3, 2, 1):
        compiled = acausal.load(f"TenSpeed.Benches.GearboxL{level}").compile()
        runs[level] = compiled.simulate(stop_time=STOP, interval=1e-3)
        points[level] = snapshots(compiled.code, [SNAPSHOT])[0]
        costs = sorted(runs[level].state_costs, key=lambda cost: -cost.influence)[:8]
        print(f"level {level}: {len(compiled.states)} states, {runs[level].statistics.steps} steps")
        for cost in costs:
            print(f"| `{cost.state}` | {100 * cost.influence:.1f} |")
        print(f"step limit of Heun at {SNAPSHOT} s: {1e6 * points[level].step_limit('heun'):.3g} us")
    draw_shift(runs)
    draw_plane(points)


def draw_shift(runs: Mapping[int, Result]) -> None:
    """Traces of the shift, all levels over each other; the finest one below."""
    figure = Figure(figsize=(7.2, 5.2), layout="constrained")
    for number, (name, label) in enumerate(PANELS, start=1):
        axes = figure.add_subplot(2, 2, number)
        for level, run in sorted(runs.items()):
            shown = (run.time >= START) & (run.time <= STOP)
            axes.plot(
                run.time[shown],
                run.values(name)[shown],
                color=COLOURS[level],
                linewidth=1.0,
                label=f"level {level}",
            )
        axes.set_ylabel(label)
        axes.set_xlabel("time in s")
        axes.grid(visible=True, color="#dddddd", linewidth=0.5)
        axes.margins(x=0)
    figure.axes[0].legend(fontsize="small")
    save(figure, "gearbox-shift")


def draw_plane(points: Mapping[int, Snapshot]) -> None:
    """Eigenvalues in third gear: frequency over decay, both in logarithmic scales."""
    figure = Figure(figsize=(7.2, 4.2), layout="constrained")
    axes = figure.add_subplot(1, 1, 1)
    for level, point in sorted(points.items()):
        values = point.eigenvalues[np.abs(point.eigenvalues) > 1.0]
        values = values[values.imag >= 0]
        axes.scatter(
            np.maximum(-values.real, 0.1),
            np.maximum(values.imag, 1.0),
            s=22,
            linewidths=0.9,
            marker=MARKERS[level],
            facecolors="none" if MARKERS[level] == "o" else COLOURS[level],
            edgecolors=COLOURS[level] if MARKERS[level] == "o" else None,
            label=f"level {level}",
        )
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("decay in 1/s")
    axes.set_ylabel("angular frequency in rad/s; below 1: none")
    axes.grid(visible=True, color="#dddddd", linewidth=0.5)
    axes.legend(fontsize="small")
    save(figure, "gearbox-eigenvalues")


def save(figure: Figure, name: str) -> None:
    """Write an SVG whose text is the same in every run; three decimals of a point are enough."""
    out = io.StringIO()
    figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None})
    short = re.sub(
        r"(?<=[ \"])-?\d+\.\d{2,}(?=[ \"\n])", lambda found: f"{float(found[0]):.1f}", out.getvalue()
    )
    lines = (line.rstrip() for line in short.splitlines())
    (FOLDER / f"{name}.svg").write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
