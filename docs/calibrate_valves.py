"""Calibrate the maps of level 5 (and the time constant of level 3) on the benches of level 1.

`python docs/calibrate_valves.py` prints the parameters of each map. Procedure: run the bench of level 1, read
points at rest, and solve for the map's parameters. `tests/models/test_valves.py` fails when a map and level 1
come apart.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import acausal
from acausal.simulate.result import Result

Array = NDArray[np.float64]
P_0 = 101325.0
STEP_5 = 0.1893
"""Progress at which the quintic smooth step is 0.05, and 0.95 as far before its end."""


def run(
    bench: str,
    changes: dict[str, str | float] | None = None,
    stop: float | None = None,
    interval: float | None = None,
) -> Result:
    """A run of a bench, with structural changes."""
    compiled = acausal.load(f"TenSpeed.Benches.{bench}").compile(dict(changes or {}))
    return compiled.simulate(stop_time=stop, interval=interval)


def at(result: Result, name: str, times: NDArray[np.floating[Any]]) -> Array:
    """Values at stored instants."""
    return result.values(name)[np.searchsorted(result.time, times - 1e-9)]


def linear_solenoid(points: int = 40) -> dict[str, list[float]]:
    """Weights: least squares of the relative error over plateaus from 0 to 1 A."""
    steps: dict[str, str | float] = {
        "command.times": f"{{0.2*k for k in 1:{points}}}",
        "command.values": f"{{k/{points} for k in 0:{points}}}",
    }
    result = run("LinearSolenoidL1", steps, stop=0.2 * (points + 1))
    rest = 0.2 * np.arange(points + 1) + 0.198
    x, p, supply = (at(result, name, rest) for name in ("i_cmd", "p_out", "p_supply"))
    weight = (p - P_0) / (supply - P_0)
    terms = np.column_stack([np.ones_like(x), x, x**2, x**3, np.exp(-x / 0.02)])
    scale = 1 / np.maximum(weight, 0.03)
    found, *_ = np.linalg.lstsq(terms * scale[:, None], weight * scale, rcond=None)
    return {"weight": found[:4].tolist(), "closed": [float(found[4])]}


def shift_solenoid() -> dict[str, list[float]]:
    """From 5 % and 95 % of the pressure in a slow rise the ends of the smooth step; the weight at 1 A."""
    slow: dict[str, str | float] = {
        "command.times": "{0, 6}",
        "command.values": "{0.3, 0.44, 0.44}",
        "command.duration": 6.0,
    }
    result = run("ShiftSolenoidL1", slow, stop=6.5)
    weight = (result.values("p_out") - P_0) / (result.values("p_supply") - P_0)
    full = float(weight[-1])
    crossed = [float(result.values("i_cmd")[np.argmax(weight > part * full)]) for part in (0.05, 0.95)]
    width = (crossed[1] - crossed[0]) / (1 - 2 * STEP_5)
    return {"i_off": [crossed[0] - STEP_5 * width], "i_on": [crossed[1] + STEP_5 * width], "w_on": [full]}


def opening(bench: str, pressure: str, gain: float = 0.0) -> dict[str, list[float]]:
    """Pressure at which edges begin to open, its rise with the opening: from smallest and largest flow."""
    result = run(bench)
    rest = np.array([0.49, float(result.time[-1])])
    p, s = at(result, pressure, rest) - P_0, at(result, "s", rest)
    if gain:
        p = p - gain * (at(result, "p_pilot", rest) - P_0)
    stiffness = float((p[1] - p[0]) / (s[1] - s[0]))
    return {"p_closed": [float(p[0] - stiffness * s[0])], "stiffness": [stiffness]}


def lockup() -> dict[str, list[float]]:
    """Gain and offset: line through plateaus where the valve regulates."""
    result = run("LockupControlL1")
    rest = 0.2 * np.arange(4, 10) + 0.19
    command, p = at(result, "p_command", rest) - P_0, at(result, "p_out", rest) - P_0
    gain, offset = np.polyfit(command, p, 1)
    return {"gain": [float(gain)], "p_offset": [float(-offset)]}


def switch() -> dict[str, list[float]]:
    """Pilot pressures at which level 1 switches up and down, their mean, and the weight of the open valve."""
    result = run("SwitchValveL1")
    weight = (result.values("p_out") - P_0) / (result.values("p_supply") - P_0)
    pilot = result.values("p_pilot")
    open_ = np.flatnonzero(weight > 0.5)
    up, down = float(pilot[open_[0]]), float(pilot[open_[-1]])
    return {"up, down": [up, down], "p_switch": [(up + down) / 2], "w_on": [float(weight.max())]}


def two_way_clutch() -> dict[str, list[float]]:
    """Time constant: a third of the time from 5 % to 95 % of the way when 9 bar push to drive at once."""
    fast: dict[str, str | float] = {
        "drive.times": "{0.1, 9}",
        "drive.values": "{101325, 9e5, 9e5}",
        "drive.duration": 0.005,
    }
    result = run("TwoWayClutchValveL1", fast, stop=0.3, interval=1e-4)
    way = result.values("s") / result.values("valve.stage.stroke")
    start, end = (float(result.time[np.argmax(way > part)]) for part in (0.05, 0.95))
    return {"T": [(end - start) / 3]}


def main() -> None:
    """Print every map's parameters."""
    print("LinearMap", linear_solenoid())
    print("ShiftMap", shift_solenoid())
    print("MainMap", opening("MainRegulatorFlowL1", "p_line", gain=1.5))
    print("LubricationMap", opening("LubricationRegulatorL1", "p_out"))
    print("ConverterMap", opening("ConverterRegulatorL1", "p_out"))
    print("LockupMap", lockup())
    print("SwitchMap", switch())
    print("TwoWayClutchHysteresis", two_way_clutch())


if __name__ == "__main__":
    main()
