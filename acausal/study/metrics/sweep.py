"""All shifts of a stored result: where the signal `gear` steps between adjacent forward gears."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, fields

import numpy as np

from acausal.errors import UsageProblem, fail
from acausal.study.metrics.shift import BAND, Shift, shift
from acausal.study.metrics.table import Table
from acausal.study.metrics.traces import Trace


@dataclass(frozen=True)
class GearShift:
    """One shift of a sweep."""

    from_gear: int
    to_gear: int
    figures: Shift

    def to_json(self) -> dict[str, object]:
        return {"from_gear": self.from_gear, "to_gear": self.to_gear, **asdict(self.figures)}


def gear_shifts(table: Table) -> list[GearShift]:
    """Every shift, in order; its window ends where the signal `gear` changes next, or with the result.

    It ends earlier where the signal `inputTorque`, if there is one, leaves the value it has at the command by
    2 % of its largest: what the drive does is not the shift's doing.

    Needs `gear`, `outputTorque`, and `slip_X` and `torque_X` of every friction element X. Raises UsageProblem
    `metrics.missing-signal`, `metrics.no-shift`.
    """
    gear, torque = table.trace("gear"), table.trace("outputTorque")
    slips, torques = table.traces("slip_"), table.traces("torque_")
    drive = table.trace("inputTorque") if "inputTorque" in table.columns else None
    changes = np.flatnonzero(np.diff(np.round(gear.values)))
    starts = gear.time[changes + 1]
    ends = np.append(starts, gear.time[-1])[1:]
    found: list[GearShift] = []
    for change, start, end in zip(changes, starts, ends, strict=True):
        before, after = (round(float(gear.values[i])) for i in (change, change + 1))
        steady = np.inf if drive is None else _steady_until(drive, float(start))
        until = min(float(end), steady)
        if min(before, after) >= 1 and abs(after - before) == 1 and until > start:
            figures = shift(torque, slips, torques, float(start), until)
            found.append(GearShift(before, after, figures))
    if not found:
        raise fail(
            UsageProblem,
            "metrics.no-shift",
            "the signal `gear` never steps between adjacent forward gears",
            names=["gear"],
            hint="run the sweep for longer; a single shift begins where `gear` changes by one",
        )
    return found


def _steady_until(drive: Trace, start: float) -> float:
    """When the drive leaves the value that it has at `start`; infinite if it never does."""
    values = drive.values[drive.time >= start]
    left = np.abs(values - drive.at(start)) > BAND * float(drive.magnitude.values.max())
    return float(drive.time[drive.time >= start][left.argmax()]) if left.any() else np.inf


def averages(shifts: Sequence[GearShift]) -> dict[str, float | None]:
    """The mean of every figure over the shifts that have it; None where none has."""
    means: dict[str, float | None] = {}
    for field in fields(Shift):
        values = [getattr(one.figures, field.name) for one in shifts]
        numbers = [value for value in values if isinstance(value, float | int)]
        if field.name not in ("start", "end", "oncoming", "offgoing"):
            means[field.name] = float(np.mean(numbers)) if numbers else None
    return means
