"""Steady states, also of what turns.

A shaft that turns at a constant speed has no equilibrium: its angle grows. Its speed is steady all the same,
because nothing depends on the angle: moving all angles that turn together changes no derivative. These
directions are the null space N of the Jacobian. Steady means that the derivatives lie in it,

    f(x) = N a,   N^T (x - x_0) = 0,

which is solved for x and the rates a by Newton's method.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acausal.errors import SimulationProblem, fail
from acausal.simulate.evaluator import Evaluator

Vector = NDArray[np.float64]

MAX_ITERATIONS = 1000
_NULL = 1e-10
"""Singular value of the balanced Jacobian, relative to the largest, that counts as zero."""
_CONVERGED = 1e-10
_FIRST = 1e-6
"""Length of the first step in seconds."""
_LONGEST = 1e6
"""From here on steps are Newton's."""
_PATIENCE = 2.0
"""By how much the residual may grow on the way: a transient need not be monotonic."""


@dataclass(frozen=True, eq=False)
class Steady:
    """A steady point. `rates` are the derivatives of the states: zero, but for angles that turn."""

    x: Vector
    rates: Vector
    iterations: int


def steady_state(evaluator: Evaluator) -> Steady:
    """From the evaluator's present point, with its time, parameters, inputs, modes and discrete values.

    Linearly implicit Euler steps whose length grows as the residual falls lead to where Newton's method
    converges (pseudo-transient continuation; C. T. Kelley, D. E. Keyes, SIAM J. Numer. Anal. 35 (1998),
    508-523). Raises SimulationProblem `steady.none` where that is not so within `MAX_ITERATIONS`.
    """
    e, scale = evaluator, evaluator.x_nominal
    time, x, tau = float(e.t[0]), e.x.copy(), _FIRST
    residual = np.zeros(len(x))
    for iteration in range(MAX_ITERATIONS):
        e.at(time, x)
        e.settle()
        jacobian = _jacobian(e) * scale / scale[:, None]
        null = _null_space(jacobian)
        rate, residual = _split(e.xdot, scale, null)
        size = float(np.linalg.norm(residual))
        newton = _newton(jacobian - null @ (null.T @ jacobian), residual)
        if _is_small(newton, x / scale):
            return Steady(x + newton * scale, rate, iteration)
        step = newton if tau >= _LONGEST else np.linalg.solve(np.eye(len(x)) / tau - jacobian, residual)
        step = step - null @ (null.T @ step)
        after = _size_at(e, time, x + step * scale, null)
        if after < (1.0 if tau >= _LONGEST else _PATIENCE) * size:
            x = x + step * scale
            tau = min(tau * min(max(size / max(after, 1e-300), 1.5), 10.0), _LONGEST)
        else:
            tau = tau / 4
    worst = int(np.argmax(np.abs(residual)))
    name = e.code.system.states[worst]
    raise fail(
        SimulationProblem,
        "steady.none",
        f"no steady state in {MAX_ITERATIONS} iterations: `der({name})` is still {e.xdot[worst]:.4g}",
        names=[name],
        hint="simulate until the model has come to rest and take that instant",
    )


def _jacobian(evaluator: Evaluator) -> Vector:
    evaluator.jac()
    pattern = evaluator.code.pattern
    n = len(evaluator.x)
    dense = np.zeros((n, n))
    dense[pattern.row(), pattern.get_col()] = evaluator.jacobian
    return dense


def _null_space(matrix: Vector) -> Vector:
    """Orthonormal columns that span what the matrix maps to zero."""
    if not len(matrix):
        return np.zeros((0, 0))
    sizes = np.maximum(np.abs(matrix).max(axis=1, initial=0.0), 1e-300)
    _, values, adjoint = np.linalg.svd(matrix / sizes[:, None])
    return np.asarray(adjoint[values <= _NULL * max(float(values[0]), 1e-300)].T, dtype=np.float64)


def _split(derivatives: Vector, scale: Vector, null: Vector) -> tuple[Vector, Vector]:
    """Derivatives within the null space, and the rest, scaled."""
    scaled = derivatives / scale
    within = null @ (null.T @ scaled)
    return within * scale, scaled - within


def _newton(jacobian: Vector, residual: Vector) -> Vector:
    """The shortest step that makes the residual zero to first order."""
    sizes = np.maximum(np.abs(jacobian).max(axis=1, initial=0.0), 1e-300)
    left: Vector = np.asarray(jacobian / sizes[:, None], dtype=np.float64)
    right: Vector = np.asarray(-residual / sizes, dtype=np.float64)
    return np.asarray(np.linalg.lstsq(left, right, rcond=_NULL)[0], dtype=np.float64)


def _is_small(step: Vector, x: Vector) -> bool:
    """Whether the step changes nothing any more."""
    return float(np.abs(step).max(initial=0.0)) <= _CONVERGED * max(1.0, float(np.abs(x).max(initial=0.0)))


def _size_at(e: Evaluator, time: float, x: Vector, null: Vector) -> float:
    """The size of the residual at another point; infinite where the model has no value."""
    e.at(time, x)
    if not e.evaluate():
        return np.inf
    return float(np.linalg.norm(_split(e.xdot, e.x_nominal, null)[1]))
