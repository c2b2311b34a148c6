"""The flow at given speeds: the zeros of the net pressure, bracketed on a grid and then closed in.

A zero through which the net pressure falls is stable at these speeds, one through which it rises is not.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from acausal.study.converter.geometry import Array, Geometry
from acausal.study.converter.laws import balance

Choice = Literal["upper", "lower"]
_GRID = 60
_BISECTIONS = 40
_NEWTON = 12


@dataclass(frozen=True, eq=False)
class Flow:
    """The chosen zero (m3/s), and how many stable zeros there are."""

    Q: Array
    stable: NDArray[np.int64]


def flow_at(w_p: Array, w_t: Array, g: Geometry, choice: Choice = "upper") -> Flow:
    """The largest (`upper`: the branch that continues from lower speed ratios) or smallest stable flow."""
    w_p, w_t = np.broadcast_arrays(w_p, w_t)
    largest = g.A * g.R_p * np.hypot(w_p, w_t) + 10 * g.Q_0
    cubic = (np.arange(-_GRID, _GRID + 1) / _GRID) ** 3
    grid = largest[:, None] * np.sort(np.concatenate([cubic, 1e-3 * cubic[1:-1:2]]))[None, :]
    pressure = balance(grid, w_p[:, None], w_t[:, None], g.column())[0].pressure
    falls = (pressure[:, :-1] > 0) & ~(pressure[:, 1:] > 0)
    if choice == "upper":
        at = falls.shape[1] - 1 - np.argmax(falls[:, ::-1], axis=1)
    else:
        at = np.argmax(falls, axis=1)
    rows = np.arange(len(at))
    left, right = grid[rows, at], grid[rows, at + 1]
    return Flow(closed_in(left, right, w_p, w_t, g), falls.sum(axis=1))


def closed_in(left: Array, right: Array, w_p: Array, w_t: Array, g: Geometry) -> Array:
    """The zero between a point where the net pressure is positive and one where it is not."""
    for _ in range(_BISECTIONS):
        middle = (left + right) / 2
        positive = balance(middle, w_p, w_t, g)[0].pressure > 0
        left, right = np.where(positive, middle, left), np.where(positive, right, middle)
    flow = (left + right) / 2
    best = np.abs(balance(flow, w_p, w_t, g)[0].pressure)
    for _ in range(_NEWTON):
        step = 1e-7 * (np.abs(flow) + 1e-3 * g.Q_0)
        slope = (
            balance(flow + step, w_p, w_t, g)[0].pressure - balance(flow - step, w_p, w_t, g)[0].pressure
        ) / (2 * step)
        trial = flow - balance(flow, w_p, w_t, g)[0].pressure / np.where(slope < 0, slope, -np.inf)
        trial = np.clip(trial, left, right)
        found = np.abs(balance(trial, w_p, w_t, g)[0].pressure)
        flow, best = np.where(found < best, trial, flow), np.minimum(found, best)
    return flow
