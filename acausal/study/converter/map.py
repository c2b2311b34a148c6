"""The map of level 5: capacity and torque ratio over the speed ratio, driving and overrunning."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from acausal.errors import UsageProblem, fail
from acausal.study.converter.flow import Choice, flow_at
from acausal.study.converter.geometry import NAMES, NOMINAL, Array, Geometry, numbers
from acausal.study.converter.laws import balance

_SPEED = 200.0


@dataclass(frozen=True, eq=False)
class ConverterMap:
    """Arrays over `ratio`: torque over squared speed of the faster ring, and torque out over torque in."""

    ratio: Array
    """Slower over faster speed: turbine over impeller driving, impeller over turbine overrunning."""
    capacity: Array
    torque_ratio: Array
    capacity_overrun: Array
    torque_ratio_overrun: Array

    def modifications(self) -> dict[str, str]:
        """As parameters of `TenSpeed.Converter.TorusL5`, in Modelica text."""
        arrays = {
            "ratio": self.ratio,
            "capacity": self.capacity,
            "torqueRatio": self.torque_ratio,
            "capacityOverrun": self.capacity_overrun,
            "torqueRatioOverrun": self.torque_ratio_overrun,
        }
        return {k: "{" + ", ".join(f"{x:.8g}" for x in v.tolist()) + "}" for k, v in arrays.items()}


def steady_map(geometry: Geometry = NOMINAL, ratio: Array | None = None) -> ConverterMap:
    """The map of one circuit, computed at 200 rad/s of the faster ring.

    Up to the end of the upper branch it follows that branch, then it falls to no torque at ratio 1. Raises
    UsageProblem `converter.sizes`, `converter.not-a-number`, `converter.out-of-range`.
    """
    if any(getattr(geometry, name).size > 1 for name in NAMES):
        message = "a map is of one circuit, not of several"
        raise fail(UsageProblem, "converter.sizes", message, hint="take one of them: geometry.take(...)")
    x = _ratios() if ratio is None else numbers("ratio", ratio, 1.0)
    fast, slow = np.full(len(x), _SPEED), _SPEED * x
    p, t = _torques(fast, slow, geometry, "upper")
    t_over, p_over = _torques(slow, fast, geometry, "lower")[::-1]
    end = x >= 1
    zero = np.zeros(len(x))
    one = np.ones(len(x))
    return ConverterMap(
        x,
        np.where(end, zero, p / _SPEED**2),
        np.where(end, one, -t / p),
        np.where(end, zero, t_over / _SPEED**2),
        np.where(end, one, -p_over / t_over),
    )


def _ratios() -> Array:
    """Denser towards 1, where the capacity falls steeply, and at coupling, where there is a kink."""
    return np.concatenate(
        [
            np.linspace(-1, 0, 6)[:-1],
            np.linspace(0, 0.85, 18),
            [
                0.87,
                0.88,
                0.885,
                0.89,
                0.8925,
                0.895,
                0.8965,
                0.8975,
                0.9,
                0.91,
                0.925,
                0.94,
                0.95,
                0.96,
                0.97,
            ],
            [0.975, 0.98, 0.984, 0.988, 0.99, 0.992, 0.994, 0.995, 0.996, 0.998, 1.0],
        ]
    )


def _torques(w_p: Array, w_t: Array, g: Geometry, choice: Choice) -> tuple[Array, Array]:
    found = balance(flow_at(w_p, w_t, g, choice).Q, w_p, w_t, g)[0]
    return found.tau_p, found.tau_t
