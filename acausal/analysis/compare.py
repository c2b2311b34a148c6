"""Two models' modes side by side: which of one level of fidelity is which of the other.

States need not have the same names, so modes are paired by where they lie: least total distance of the
logarithms of their sizes and of their angles in the complex plane, where a mode without a partner within
`REACH` stays alone. States of the same name that take part in both bring modes closer.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import log

import numpy as np
from scipy.optimize import linear_sum_assignment

from acausal.analysis.modes import Mode
from acausal.analysis.snapshot import Snapshot

REACH = log(2.0)
"""As far as partners may be apart: a factor of two in size, or as much in angle."""
_SHARED = 0.5
"""What states in common take off the distance, at most."""


@dataclass(frozen=True)
class Pair:
    """The numbers of two modes, from 1, as their snapshots list them; None where one has no partner."""

    one: int | None
    other: int | None


def pairs(one: Snapshot, other: Snapshot) -> tuple[Pair, ...]:
    """Every mode of both, one of each conjugate pair, in the order of the first, the lonely ones last."""
    mine, theirs = _upper(one), _upper(other)
    cost = np.array([[_distance(one, a, other, b) for _, b in theirs] for _, a in mine])
    cost = cost.reshape(len(mine), len(theirs))
    rows, columns = linear_sum_assignment(np.minimum(cost, REACH))
    partner = {int(r): int(c) for r, c in zip(rows, columns, strict=True) if cost[r, c] < REACH}
    found = [
        Pair(number, theirs[partner[i]][0] if i in partner else None) for i, (number, _) in enumerate(mine)
    ]
    taken = frozenset(partner.values())
    lonely = [Pair(None, number) for i, (number, _) in enumerate(theirs) if i not in taken]
    return (*found, *lonely)


def _upper(snapshot: Snapshot) -> list[tuple[int, Mode]]:
    return [(i, m) for i, m in enumerate(snapshot.modes.modes, 1) if m.eigenvalue.imag >= 0]


def _distance(one: Snapshot, a: Mode, other: Snapshot, b: Mode) -> float:
    """Of two modes; both at 0 are as near as can be, one at 0 is far from all others."""
    shared = dict(zip(other.states, b.participation.tolist(), strict=True))
    common = sum(
        min(share, shared.get(s, 0.0)) for s, share in zip(one.states, a.participation.tolist(), strict=True)
    )
    near = 1 - _SHARED * common
    x, y = a.eigenvalue, b.eigenvalue
    if x == 0 or y == 0:
        return 0.0 if x == y else 10 * REACH
    return near * abs(complex(log(abs(x) / abs(y)), float(np.angle(x) - np.angle(y))))


def comparison_json(one: Snapshot, other: Snapshot) -> dict[str, object]:
    """The key `compare` of `acausal eigen --compare --json`: the other snapshot and the pairs of modes."""
    return {
        "snapshot": other.to_json(),
        "modes": [_pair_json(one, other, pair) for pair in pairs(one, other)],
    }


def _pair_json(one: Snapshot, other: Snapshot, pair: Pair) -> dict[str, object]:
    a = one.modes.modes[pair.one - 1] if pair.one is not None else None
    b = other.modes.modes[pair.other - 1] if pair.other is not None else None
    return {
        "mode": pair.one,
        "other": pair.other,
        "frequency_hz": [m.frequency_hz if m is not None else None for m in (a, b)],
        "damping_ratio": [m.damping_ratio if m is not None else None for m in (a, b)],
        "frequency_change": change(a, b),
    }


def change(a: Mode | None, b: Mode | None) -> float | None:
    """How much higher the other's natural frequency is, relative to the first's."""
    if a is None or b is None or not a.frequency_hz:
        return None
    return b.frequency_hz / a.frequency_hz - 1
