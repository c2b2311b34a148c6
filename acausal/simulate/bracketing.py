"""One equation in one unknown, where neither Newton's method nor a homotopy gets anywhere.

From the guess, points ever farther away on both sides are looked at until the residual changes its sign; the
nearest change is halved down to rounding (Dekker 1969 without its secants: kinks and jumps do no harm), and
taken if the residual gets small there: at a pole it does not. So a switch finds its other branch when the one
it was on ends. All is bounded.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from acausal.simulate import newton
from acausal.simulate.matrices import Vector
from acausal.simulate.newton import Solution, System

_FIRST = 1e-6
_GROWTH = 1.5
_LOOKS = 120
_HALVINGS = 200


def bracketed(system: System, start: Vector, nominal: Vector) -> Solution | None:
    """The solution at the nearest change of sign that is one, None if there is none."""
    origin, unit = float(start[0]), float(nominal[0])

    def value(z: float) -> float:
        with np.errstate(all="ignore"):
            return float(system(np.array([z]))[0][0])

    ends = {side: (origin, value(origin)) for side in (1.0, -1.0)}
    step = _FIRST * max(unit, abs(origin))
    for _ in range(_LOOKS):
        for side in (1.0, -1.0):
            before, at_before = ends[side]
            z = origin + side * step
            at_z = value(z)
            ends[side] = z, at_z
            if math.isfinite(at_before) and math.isfinite(at_z) and (at_before > 0) != (at_z > 0):
                middle = _halved(value, before, at_before, z)
                found = newton.solve(system, np.array([middle]), nominal)
                if found.converged and min(before, z) <= found.z[0] <= max(before, z):
                    return found
        step *= _GROWTH
    return None


def _halved(value: Callable[[float], float], a: float, at_a: float, b: float) -> float:
    """Where the sign changes between a and b."""
    for _ in range(_HALVINGS):
        middle = 0.5 * (a + b)
        if middle in (a, b):
            break
        if (value(middle) > 0) == (at_a > 0):
            a = middle
        else:
            b = middle
    return 0.5 * (a + b)
