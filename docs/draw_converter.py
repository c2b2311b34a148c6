# pyright: reportUnknownMemberType=false
"""Draw the figures of the page on the torque converter: `python docs/draw_converter.py [NAME]...`.

Every line is a run of `TenSpeed.Benches` or a solution of `acausal.study.converter`. Written to docs/figures.
"""

from __future__ import annotations

import sys
from collections.abc import Callable

import numpy as np
from figure_files import save
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

import acausal
from acausal.simulate.result import Result
from acausal.study.converter import NOMINAL
from acausal.study.converter.flow import flow_at
from acausal.study.converter.laws import balance

Array = NDArray[np.float64]
COLOURS = ("#0072b2", "#009e73", "#e69f00", "#d55e00", "#cc79a7")
STYLES = ("-", "--", "-.", ":", (0, (1, 2)))
DOWN = """
model Down
  extends TenSpeed.Interfaces.ConverterBench(
    redeclare model Torus = TenSpeed.Converter.TorusL{level},
    torus(w_t_start = 212, Q_start = -1e-2),
    redeclare TenSpeed.Converter.SpeedSource impellerSource(w_start = 200),
    redeclare TenSpeed.Converter.SpeedSource turbineSource(
      w_start = {start}, w_end = {end}, startTime = 100, duration = 4000));
end Down;
"""
STEP = """
model Step
  extends TenSpeed.Interfaces.ConverterBench(
    redeclare model Torus = TenSpeed.Converter.TorusL{level},
    torus(w_p_start = 139, Q_start = 0.045),
    redeclare TenSpeed.Converter.TorqueSource impellerSource(
      tau_start = 60, tau_end = 200, startTime = 0.5, duration = 0.05),
    redeclare TenSpeed.Converter.SpeedSource turbineSource(w_start = 100));
end Step;
"""


def thinned(x: Array, y: Array, points: int = 200) -> tuple[Array, Array]:
    """Fewer points of a line, evenly along it."""
    finite = np.isfinite(x) & np.isfinite(y)
    x, y = x[finite], y[finite]
    length = np.hypot(np.diff(x) / max(float(np.ptp(x)), 1e-9), np.diff(y) / max(float(np.ptp(y)), 1e-9))
    along = np.concatenate([[0.0], np.cumsum(length)])
    chosen = np.unique(np.searchsorted(along, np.linspace(0, float(along[-1]), points)).clip(0, len(x) - 1))
    return x[chosen], y[chosen]


def line(axes: Axes, x: Array, y: Array, label: str, which: int, style: int = 0) -> None:
    """One line with few points."""
    axes.plot(*thinned(x, y), color=COLOURS[which], ls=STYLES[style], lw=1.3, label=label)


def run(text: str, stop: float, points: int) -> Result:
    """Run a model given as text."""
    return acausal.loads(text).compile().simulate(stop_time=stop, interval=stop / points)


def draw_curves() -> Figure:
    """Torque ratio, efficiency and K over the speed ratio."""
    figure = Figure(figsize=(7, 3.4), layout="constrained")
    left = figure.add_subplot()
    right = left.twinx()
    for level, style in ((1, 0), (5, 3)):
        result = acausal.load(f"TenSpeed.Benches.TorqueConverterL{level}").compile().simulate()
        ratio, torque, capacity = (
            result.values(name) for name in ("speedRatio", "torqueRatio", "capacityFactor")
        )
        on = (result.time >= 10) & (ratio <= 0.996)
        line(left, ratio[on], torque[on], f"torque ratio, level {level}", 0, style)
        line(left, ratio[on], ratio[on] * torque[on], f"efficiency, level {level}", 1, style)
        line(right, ratio[on], capacity[on], "", 3, style)
        left.plot([], [], color=COLOURS[3], ls=STYLES[style], label=f"K, level {level}")
    left.set(xlabel="speed ratio", ylabel="torque ratio, efficiency", xlim=(0, 1), ylim=(0, 2.2))
    right.set(ylabel="K in rpm/sqrt(N m)", ylim=(0, 440))
    return figure


def draw_branches() -> Figure:
    """Flow over the speed ratio: all steady states, and slow sweeps in both directions."""
    figure = Figure(figsize=(7, 3.4), layout="constrained")
    axes = figure.add_subplot()
    ratio = np.linspace(0.965, 1.03, 261)
    w_p, w_t = np.full(ratio.shape, 200.0), 200 * ratio
    for choice in ("upper", "lower"):
        flow = flow_at(w_p, w_t, NOMINAL, choice).Q
        line(axes, ratio, 1e3 * flow, "stable" if choice == "upper" else "", 0)
    middle = np.array([_middle(float(x)) for x in ratio])
    line(axes, ratio, 1e3 * middle, "unstable at given speeds", 0, 3)
    for level, which in ((1, 3), (4, 2)):
        for start, end, style in ((185, 212, 1), (212, 185, 2)):
            result = run(DOWN.format(level=level, start=start, end=end), 4200, 2100)
            on = result.time > 100
            name = f"level {level}, {'rising' if end > start else 'falling'}"
            flow = 1e3 * result.values("torus.Q")[on]
            line(axes, result.values("speedRatio")[on], flow, name, which, style)
    axes.set(xlabel="speed ratio", ylabel="flow in l/s", xlim=(0.965, 1.03))
    return figure


def _middle(ratio: float) -> float:
    """The flow at which the net pressure rises through zero; not-a-number where there is none."""
    flow = np.linspace(1e-5, 3e-2, 6000)
    pressure = balance(flow, np.full(6000, 200.0), np.full(6000, 200 * ratio), NOMINAL)[0].pressure
    rises = np.flatnonzero((pressure[:-1] < 0) & (pressure[1:] >= 0))
    return float(flow[rises[0]]) if len(rises) else float("nan")


def draw_transient() -> Figure:
    """A tip-in at constant speed of the turbine, at levels 1 to 4."""
    figure = Figure(figsize=(7, 2.8), layout="constrained")
    left, right = figure.subplots(1, 2)
    for level in (1, 2, 3, 4):
        result = run(STEP.format(level=level), 1.5, 750)
        on = result.time > 0.4
        for axes, name in ((left, "impellerSpeed"), (right, "turbineTorque")):
            line(axes, result.time[on], result.values(name)[on], f"level {level}", level - 1, level - 1)
    left.set(xlabel="time in s", ylabel="impeller in rad/s")
    right.set(xlabel="time in s", ylabel="turbine in N m")
    return figure


def draw_drive() -> Figure:
    """60 s of driving at level 1."""
    figure = Figure(figsize=(7, 3.6), layout="constrained")
    upper, lower = figure.subplots(2, 1, sharex=True)
    result = acausal.load("TenSpeed.Benches.TorqueConverterDriveL1").compile().simulate(interval=0.05)
    for axes, names in (
        (upper, {"impeller": "impellerSpeed", "turbine": "turbineSpeed", "stator": "converter.torus.w_s"}),
        (
            lower,
            {"into the circuit": "impellerTorque", "out of it": "turbineTorque", "lock-up": "lockupTorque"},
        ),
    ):
        for i, (label, name) in enumerate(names.items()):
            line(axes, result.time, result.values(name), label, (0, 3, 1)[i], (0, 1, 2)[i])
    upper.set(ylabel="speed in rad/s")
    lower.set(xlabel="time in s", ylabel="torque in N m", xlim=(0, 60))
    return figure


FIGURES: dict[str, Callable[[], Figure]] = {
    "curves": draw_curves,
    "branches": draw_branches,
    "transient": draw_transient,
    "drive": draw_drive,
}


if __name__ == "__main__":
    for chosen in sys.argv[1:] or FIGURES:
        save("converter", chosen, FIGURES[chosen]())
