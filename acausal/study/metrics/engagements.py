"""Every clutch pressure of a stored result that has a command."""

from __future__ import annotations

from dataclasses import asdict, dataclass

import numpy as np

from acausal.errors import UsageProblem, fail
from acausal.study.metrics.engagement import Engagement, engagement
from acausal.study.metrics.table import Table
from acausal.study.metrics.traces import Trace

_TRAVEL = 0.98


@dataclass(frozen=True)
class NamedEngagement:
    """The figures of one clutch; `name` is empty for a result with a single pressure."""

    name: str
    figures: Engagement

    def to_json(self) -> dict[str, object]:
        return {"name": self.name, **asdict(self.figures)}


def engagements(
    table: Table, stop: float | None = None, start: float | None = None, end: float | None = None
) -> list[NamedEngagement]:
    """The figures of `pressure` with `current` and, if stored, `position`; or of all `pressure_X` alike.

    `stop` (m) is where the piston has reached its end stop: by default 98 % of its travel in the window from
    `start` to `end` (s), which is the whole result by default. Raises UsageProblem `metrics.missing-signal`,
    `metrics.not-a-number`, `metrics.no-window`, `metrics.out-of-range`.
    """
    if stop is not None and not np.isfinite(stop):
        raise fail(
            UsageProblem, "metrics.out-of-range", f"a piston cannot stop at {stop:g} m", names=["stop"]
        )
    time = table.trace("time").time
    first = float(time[0]) if start is None else start
    last = float(time[-1]) if end is None else end
    if not float(time[0]) <= first < last <= float(time[-1]):
        raise fail(
            UsageProblem,
            "metrics.no-window",
            f"the result has no window from {first:g} to {last:g} s",
            hint=f"it goes from {float(time[0]):g} to {float(time[-1]):g} s",
        )
    if "pressure" in table.columns:
        suffixes = [""]
    else:
        suffixes = [f"_{name}" for name in table.traces("pressure_")]
        if not suffixes:
            table.trace("pressure")
    found: list[NamedEngagement] = []
    for suffix in suffixes:
        pressure, command = (table.trace(f"{kind}{suffix}") for kind in ("pressure", "current"))
        position = f"position{suffix}"
        piston = table.trace(position).between(first, last) if position in table.columns else None
        within = pressure.between(first, last)
        reached = _end_of_travel(piston, within) if stop is None else stop
        figures = engagement(command.between(first, last), within, piston, reached)
        found.append(NamedEngagement(suffix.removeprefix("_"), figures))
    return found


def _end_of_travel(piston: Trace | None, pressure: Trace) -> float | None:
    """98 % of the travel that the pressure causes: up, or down where it falls."""
    if piston is None or np.ptp(piston.values) == 0:
        return None
    first = float(piston.values[0])
    rises = pressure.values[-1] >= pressure.values[0]
    end = float(piston.values.max() if rises else piston.values.min())
    return None if end == first else first + _TRAVEL * (end - first)
