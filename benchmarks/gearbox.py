"""The share of real time that the shift sweep of the ten-speed gearbox takes, by level.

CPU time of the integration with events and storing, over simulated time, on one core, with the default solver
at 1e-6 and steps up to 1 ms; output every 1 ms. One run at each level. The functions are compiled C, and the
compiler's time is not part of it; the last row is the same run on the virtual machine.
"""

from __future__ import annotations

from collections.abc import Iterator

import acausal
from benchmarks.measure import Row

TARGETS = {4: 0.03, 3: 0.2, 2: None, 1: 2.0}
STOP, RTOL, MAX_STEP = 50.0, 1e-6, 1e-3
QUICK_STOP = 12.0


def rows(quick: bool = False) -> Iterator[Row]:
    """One row per level, the simplest first."""
    for level in TARGETS:
        yield sweep(level, compiled=True, stop=QUICK_STOP if quick else STOP)
    yield sweep(4, compiled=False, stop=QUICK_STOP if quick else STOP)


def sweep(level: int, *, compiled: bool, stop: float) -> Row:
    """One run."""
    model = acausal.load(f"TenSpeed.Benches.GearboxL{level}").compile()
    cost = model.simulate(stop_time=stop, rtol=RTOL, max_step=MAX_STEP, compiled=compiled).statistics
    return {
        "level": level,
        "functions": "C" if compiled else "virtual machine",
        "states": len(model.states),
        "CPU s": round(cost.cpu_seconds, 2),
        "real-time factor": round(cost.real_time_factor, 4),
        "target": TARGETS[level] or "",
        "steps": cost.steps,
        "rejected": cost.rejected,
        "events": cost.events,
    }
