"""The largest step with which each explicit method stays stable on dx/dt = lambda x.

A one-step method multiplies x by R(z) with z = h lambda; it is stable where |R(z)| <= 1. The two-step
Adams-Bashforth method is stable where both roots of its characteristic polynomial are within the unit
circle. The limit is the first step at which that is lost, coming from 0.

Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, sections II.1, II.5
and III.3, and II (1996), sections IV.2 and V.1.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import inf

import numpy as np
from numpy.typing import NDArray

Complex = NDArray[np.complex128]
Growth = Callable[[Complex], NDArray[np.float64]]
"""z -> by how much one step multiplies the worst solution."""

_POINTS = 2_000
_BISECTIONS = 60
_SLACK = 1e-12
"""Growth beyond 1 that is rounding."""
_UNDAMPED = 1e-10
"""Damping ratio below which an eigenvalue counts as purely imaginary."""
_NEAR = 0.05
FLOOR = 1e-12
"""An eigenvalue this small beside the largest limits no step."""
_REACH = 4.0
"""No explicit method here is stable for |z| above."""


def _polynomial(*coefficients: float) -> Growth:
    """|R(z)| of a one-step method, coefficients from z^0 upwards."""
    falling = np.array(coefficients[::-1])
    return lambda z: np.abs(np.polyval(falling, z))


def _adams_bashforth_2(z: Complex) -> NDArray[np.float64]:
    """The larger root of w^2 - (1 + 3 z / 2) w + z / 2 = 0, by magnitude."""
    middle = 1 + 1.5 * z
    root = np.sqrt(middle**2 - 2 * z)
    return np.maximum(np.abs(middle + root), np.abs(middle - root)) / 2


GROWTH: dict[str, Growth] = {
    "euler": _polynomial(1, 1),
    "ab2": _adams_bashforth_2,
    "heun": _polynomial(1, 1, 1 / 2),
    "rk3": _polynomial(1, 1, 1 / 2, 1 / 6),
    "dopri5": _polynomial(1, 1, 1 / 2, 1 / 6, 1 / 24, 1 / 120, 1 / 600),
}
"""The explicit fixed-step methods by name."""


def step_limit(method: str, eigenvalues: Sequence[complex] | Complex, floor: float = 0.0) -> float:
    """The largest stable step in seconds; `inf` where no eigenvalue limits it.

    Eigenvalues within `floor` of zero do not count: what belongs to them stands still. Those with positive
    real part do not count either, because their solutions grow whatever the step. A purely imaginary one
    limits Euler's method to 0. Raises KeyError for an unknown method.
    """
    growth = GROWTH[method]
    values = np.asarray(eigenvalues, dtype=np.complex128)
    counted = values[(np.abs(values) > floor) & (values.real <= floor)]
    return min((_limit(growth, value) for value in counted), default=inf)


def step_limits(eigenvalues: Complex) -> dict[str, float]:
    """The limit of every explicit method; eigenvalues that are 0 beside the largest do not count."""
    floor = FLOOR * float(np.abs(eigenvalues).max(initial=0.0))
    return {method: float(step_limit(method, eigenvalues, floor)) for method in GROWTH}


def _limit(growth: Growth, eigenvalue: complex) -> float:
    """The first h at which |R(h lambda)| exceeds 1."""
    size = abs(eigenvalue)
    direction = eigenvalue / size
    if abs(direction.real) <= _UNDAMPED:
        direction = complex(0, direction.imag)
        if growth(np.array([_NEAR * direction]))[0] > 1 + _SLACK:
            return 0.0  # such growth is too small to be seen nearer to 0, but it is there
    radii = np.geomspace(1e-5, _REACH, _POINTS)
    stable = growth(np.asarray(radii * direction, dtype=np.complex128)) <= 1 + _SLACK
    if stable.all():
        return inf
    first = int(np.argmin(stable))
    if first == 0:
        return 0.0
    low, high = float(radii[first - 1]), float(radii[first])
    for _ in range(_BISECTIONS):
        middle = (low + high) / 2
        if growth(np.array([middle * direction]))[0] <= 1 + _SLACK:
            low = middle
        else:
            high = middle
    return low / size
