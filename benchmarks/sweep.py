"""Is the shift sweep of the gearbox right? `python -m benchmarks.sweep 4 [3 2 1]`.

At the end of every gear: the ratio against the table, with and without what the creeping two-way clutch adds
to it, and the slip of the engaged elements; over the whole sweep: torques within their capacities, wind-up of
the plates within capacity over stiffness, and the energy balance.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import acausal
from acausal.demo.systems import GEARS

Values = NDArray[np.float64]

ELEMENTS = ("C1", "C2", "C3", "B1", "B2", "B3")
TABLE = {gear: (held.removesuffix(" F1"), ratio) for gear, (held, ratio) in GEARS.items()}
"""Friction elements that hold, and speed of body 1 over that of body 8."""

_I1, _I2, _I3, _I4 = 130 / 42, 81 / 43, 103 / 37, 76 / 48
CREEP = {
    1: (1 + _I3) * (1 + _I1) / _I1 - _I3 * (1 + _I2),
    -1: _I3 * (1 + _I2) / ((1 + _I3) * _I4 / (1 + _I4) - 1),
}
"""By how much body 1 turns faster for each rad/s of body 4, the others as in first and in reverse."""
WINDOW = 0.5
"""Seconds at the end of a gear over which means are taken."""


@dataclass(frozen=True)
class Gear:
    """What the end of one gear was like; ratios and slips are means over its last half second."""

    gear: int
    until: float
    ratio: float
    error: float
    """Of the ratio without what body 4 adds to it."""
    slip: float
    """Largest mean magnitude of the slip of an engaged element, rad/s."""
    output_speed: float


def gears(run: acausal.Result) -> list[Gear]:
    """Every gear in which the output turns, in order."""
    time, gear = run.time, run.values("gear")
    changes = np.flatnonzero(np.diff(gear))
    ends = [*changes.tolist(), len(time) - 1]
    return [found for end in ends if (found := _gear(run, int(gear[end]), float(time[end]))) is not None]


def _gear(run: acausal.Result, gear: int, until: float) -> Gear | None:
    window = (run.time >= until - WINDOW) & (run.time <= until) & (run.values("gear") == gear)
    w_8 = run.values("gearbox.body[8].w")[window]
    if gear not in TABLE or float(np.abs(w_8).min()) <= 1:
        return None
    names, ratio = TABLE[gear]
    speeds = run.values("gearbox.body[1].w")[window] - CREEP.get(gear, 0.0) * run.values("slip_F1")[window]
    slips = [float(np.abs(run.values(f"slip_{name}")[window]).mean()) for name in names.split()]
    return Gear(
        gear,
        until,
        float(run.values("ratio")[window].mean()),
        float((speeds / w_8).mean()) - ratio,
        max(slips),
        float(w_8[-1]),
    )


def overload(run: acausal.Result) -> dict[str, float]:
    """Largest torque over capacity, and wind-up times stiffness over capacity, of each element."""
    found: dict[str, float] = {}
    for name in ELEMENTS:
        capacity = run.values(f"gearbox.{name}.capacity")
        stiffness = run.parameters[f"gearbox.{name}.c"]
        held = np.maximum(
            np.abs(run.values(f"torque_{name}")), stiffness * np.abs(run.values(f"gearbox.{name}.windUp"))
        )
        found[name] = float(((held - 1e-6) / np.maximum(capacity, 1e-6)).max())
    return found


def report(level: int, stop_time: float) -> Iterable[str]:
    """The figures of one level, a line each."""
    compiled = acausal.load(f"TenSpeed.Benches.GearboxL{level}Energy").compile()
    run = compiled.simulate(stop_time=stop_time, interval=5e-3)
    yield f"level {level}: {run.statistics.steps} steps, {run.statistics.events} events"
    for one in gears(run):
        yield (
            f"  {one.until:4.1f} s, gear {one.gear:2d}: ratio {one.ratio:7.4f}, no creep {one.error:+.4f} off"
            f" the table, slip {one.slip:.1e} rad/s, output at {one.output_speed:6.1f} rad/s"
        )
    worst = max(overload(run).items(), key=lambda item: item[1])
    yield f"  largest torque over capacity {worst[1]:.6f} ({worst[0]})"
    missing = float(np.abs(run.values("account.error")).max())
    yield f"  energy that is missing, of what the input moved: {missing:.1e}"


def main() -> None:
    """Print the report of every level asked for."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.sweep", description=__doc__)
    parser.add_argument("levels", nargs="+", type=int, choices=(1, 2, 3, 4))
    parser.add_argument("--stop-time", type=float, default=50.0)
    arguments = parser.parse_args()
    for level in arguments.levels:
        for line in report(level, arguments.stop_time):
            print(line)


if __name__ == "__main__":
    main()
