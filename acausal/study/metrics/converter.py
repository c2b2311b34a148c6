"""What a torque converter's sweep of the speed ratio says: stall, coupling, efficiency, distance to another.

The sweep is the part of the result from the last instant at which the speed ratio is zero, before it first
reaches its largest value, up to there; only what rises above all before counts, so that a result in which the
ratio falls again, on another branch, is read on the way up.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass

import numpy as np

from acausal.errors import UsageProblem, fail
from acausal.study.metrics.table import Table
from acausal.study.metrics.traces import Trace, Vector, first_crossing

STANDSTILL = 1e-4
"""Speed ratio that counts as a stalled turbine."""
COMPARED_TO = 0.95
"""Speed ratio up to which curves are compared: beyond it K grows without bound."""

_ROUNDING = 1e-6


@dataclass(frozen=True, eq=False)
class Curves:
    """Torque ratio and capacity factor (rpm/sqrt(N.m)) over a strictly rising speed ratio."""

    ratio: Vector
    torque_ratio: Vector
    capacity: Vector


@dataclass(frozen=True)
class ConverterFigures:
    """None where a feature is absent from the sweep."""

    stall_torque_ratio: float | None
    """At speed ratio 0; None where the sweep does not begin there."""
    stall_capacity_factor: float | None
    """K at speed ratio 0 in rpm/sqrt(N.m)."""
    coupling_speed_ratio: float | None
    """Where the torque ratio first falls to 1, but for a millionth."""
    peak_efficiency: float | None
    """Largest speed ratio times torque ratio up to coupling; without coupling up to the end of the sweep."""
    peak_efficiency_speed_ratio: float | None
    """Where that is."""
    capacity_rms_error: float | None
    """Root mean square of the relative difference of K to the reference; None without one."""
    torque_ratio_rms_error: float | None
    """The same of the torque ratio."""

    def to_json(self) -> dict[str, object]:
        return asdict(self)


def curves(table: Table) -> Curves:
    """The sweep of a result with `speedRatio`, `torqueRatio`, `capacityFactor`.

    Raises UsageProblem `metrics.missing-signal`, `metrics.not-a-number`, `metrics.no-sweep`, and
    `metrics.out-of-range` where, up to a speed ratio of 0.95, one of the others is not positive.
    """
    ratio, torque, capacity = (
        table.trace(name).values for name in ("speedRatio", "torqueRatio", "capacityFactor")
    )
    last = int(np.argmax(ratio))
    still = np.flatnonzero(ratio[: last + 1] <= STANDSTILL)
    first = int(still[-1]) if len(still) else 0
    part = slice(first, last + 1)
    ratio, torque, capacity = ratio[part], torque[part], capacity[part]
    before = np.concatenate([[-np.inf], np.maximum.accumulate(ratio)[:-1]])
    rising = ratio > before
    if np.count_nonzero(rising) < 2:
        raise fail(
            UsageProblem,
            "metrics.no-sweep",
            "the speed ratio never rises",
            names=["speedRatio"],
            hint="sweep it from 0, as TenSpeed.Benches.TorqueConverterL1 does",
        )
    found = Curves(ratio[rising], torque[rising], capacity[rising])
    for name, values in (("torqueRatio", found.torque_ratio), ("capacityFactor", found.capacity)):
        wrong = (found.ratio <= COMPARED_TO) & ~(values > 0)
        if wrong.any():
            raise fail(
                UsageProblem,
                "metrics.out-of-range",
                f"`{name}` is not positive at the speed ratio {float(found.ratio[wrong][0]):g}",
                names=[name],
                hint="a driven converter takes and gives torque: look at the signs of both torques",
            )
    return found


def converter_figures(sweep: Curves, reference: Curves | None = None) -> ConverterFigures:
    """The figures of a sweep, and its distance to a reference."""
    stalled = float(sweep.ratio[0]) <= STANDSTILL and float(sweep.ratio[-1]) >= 0
    coupling = first_crossing(Trace(sweep.ratio, sweep.torque_ratio), 1 + _ROUNDING, rising=False)
    end = float(sweep.ratio[-1]) if coupling is None else coupling
    ratio = np.append(sweep.ratio[sweep.ratio < end], end)
    efficiency = ratio * np.interp(ratio, sweep.ratio, sweep.torque_ratio)
    best = int(np.argmax(efficiency))
    shared = sweep.ratio[:0] if reference is None else _shared(sweep, reference)
    return ConverterFigures(
        float(np.interp(0.0, sweep.ratio, sweep.torque_ratio)) if stalled else None,
        float(np.interp(0.0, sweep.ratio, sweep.capacity)) if stalled else None,
        coupling,
        float(efficiency[best]),
        float(ratio[best]),
        None if reference is None else _rms(shared, sweep, sweep.capacity, reference, reference.capacity),
        None
        if reference is None
        else _rms(shared, sweep, sweep.torque_ratio, reference, reference.torque_ratio),
    )


def _shared(sweep: Curves, reference: Curves) -> Vector:
    """The reference's own speed ratios from 0 on that the sweep covers."""
    low = max(0.0, float(sweep.ratio[0]))
    high = min(COMPARED_TO, float(sweep.ratio[-1]))
    return reference.ratio[(reference.ratio >= low) & (reference.ratio <= high)]


def _rms(where: Vector, sweep: Curves, values: Vector, reference: Curves, wanted: Vector) -> float | None:
    if not len(where):
        return None
    off = np.interp(where, sweep.ratio, values) / np.interp(where, reference.ratio, wanted) - 1
    return float(np.sqrt(np.mean(off**2)))
