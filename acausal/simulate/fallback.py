"""The fixed-step methods in NumPy, for machines without a C compiler: the same formulas, slower.

Where the run-time in C is built it is used instead (`native`); the tests compare both.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from time import perf_counter

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csc_matrix, identity
from scipy.sparse.linalg import splu

from acausal.errors import AcausalError
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.events import operators
from acausal.simulate.failures import culprit, stopped
from acausal.simulate.matrices import Vector
from acausal.simulate.solver import Arrival, Tolerances, Work

_SAME = 1e-9
"""Ends of steps closer than this, in steps, are one."""
_HALVINGS = 60


@dataclass(frozen=True)
class _Explicit:
    """A Runge-Kutta method: `x + h sum b_i k_i`, `k_i = f(t + c_i h, x + h sum a_ij k_j)`."""

    a: tuple[tuple[float, ...], ...]
    b: tuple[float, ...]
    c: tuple[float, ...]


@dataclass(frozen=True)
class _Implicit:
    """A Rosenbrock method as in `runtime/rosenbrock.c`."""

    gamma: float
    a: tuple[tuple[float, ...], ...]
    c: tuple[tuple[float, ...], ...]
    alpha: tuple[float, ...]
    d: tuple[float, ...]
    m: tuple[float, ...]


_HEUN = _Explicit(((), (1.0,)), (0.5, 0.5), (0.0, 1.0))
EXPLICIT = {
    "euler": _Explicit(((),), (1.0,), (0.0,)),
    "heun": _HEUN,
    "rk3": _Explicit(((), (1 / 3,), (0.0, 2 / 3)), (0.25, 0.0, 0.75), (0.0, 1 / 3, 2 / 3)),
    "dopri5": _Explicit(
        (
            (),
            (1 / 5,),
            (3 / 40, 9 / 40),
            (44 / 45, -56 / 15, 32 / 9),
            (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
            (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
        ),
        (35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84),
        (0.0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1.0),
    ),
}
IMPLICIT = {
    "lieuler": _Implicit(1.0, ((),), ((),), (0.0,), (1.0,), (1.0,)),
    "rosenbrock": _Implicit(
        1.0, ((), (), ()), ((), (-0.5,), (-0.5, 1.0)), (0.0, 0.0, 0.0), (1.0, 0.5, 1.0), (0.0, 0.0, 1.0)
    ),
}


class FixedStep:
    """A `Solver` with steps of one length; the grid of steps begins at the start of the run."""

    def __init__(self, evaluator: Evaluator, tolerances: Tolerances, method: str) -> None:
        self._evaluator = evaluator
        self._limits = tolerances
        self._method = method
        self._time, self._x = tolerances.start, evaluator.x.copy()
        self._old: tuple[float, Vector] | None = None
        self._latest: tuple[float, Vector] | None = None
        self._steps = self._rhs = self._jacobians = 0
        self._longest = 0.0
        rows, columns = (np.asarray(v) for v in evaluator.code.pattern.get_triplet())
        self._pattern = rows, columns
        rising = np.array([1.0 if op in ("gt", "ge") else -1.0 for op in operators(evaluator.code.system)])
        self._rising = rising
        self._armed = np.zeros(len(rising), dtype=np.bool_)

    @property
    def work(self) -> Work:
        return Work(self._steps, self._rhs, self._jacobians, longest=self._longest)

    @property
    def influence(self) -> None:
        """Steps of one length are set by nothing."""
        return None

    def restart(self, time: float, x: Vector) -> None:
        self._time, self._x = time, x.copy()
        self._old = self._latest = None
        self._armed = self._away(time, x) > 0

    def _away(self, time: float, x: Vector) -> Vector:
        """How far each root is on the side of its mode; located ones only, the others count as far."""
        evaluator = self._evaluator
        if not evaluator.m.size:
            return np.zeros(0)
        evaluator.at(time, x)
        away = np.full(evaluator.m.size, np.inf)
        side = np.where(evaluator.m != 0, 1.0, -1.0) * self._rising
        shifted = np.zeros(evaluator.located.size)
        evaluator.crossings(shifted)
        away[evaluator.located] = side[evaluator.located] * shifted
        return away

    def advance(self, target: float, stop: float) -> Arrival:
        """To `target` by steps that end there at the latest; earlier where something crosses zero."""
        del stop
        step, start = self._limits.step, self._limits.start
        while self._time < target:
            began = perf_counter()
            end = start + (np.floor((self._time - start) / step + _SAME) + 1) * step
            end = float(end) if target - end > _SAME * step else target
            time, x = self._time, self._x
            after = self._step(time, x, end - time)
            crossed = self._crossed(end, after)
            if crossed.any() and self._limits.locate:
                end, after, crossed = self._locate(time, x, end, crossed)
            self._time, self._x, self._old = end, after, self._latest
            self._longest = max(self._longest, perf_counter() - began)
            self._steps += 1
            if self._steps > self._limits.max_steps:
                raise self._failure("simulate.too-many-steps", "too many steps were needed")
            if crossed.any():
                return Arrival(end, after, crossed)
        return Arrival(self._time, self._x)

    def _crossed(self, time: float, x: Vector) -> NDArray[np.int_]:
        """Which roots are on the other side: +1 rising, -1 falling."""
        away = self._away(time, x)
        over = self._armed & (away < 0)
        self._armed |= away > 0
        falling = np.where(self._evaluator.m != 0, 1.0, -1.0) * self._rising
        return np.where(over, -falling, 0).astype(np.int_)

    def _locate(
        self, time: float, x: Vector, end: float, crossed: NDArray[np.int_]
    ) -> tuple[float, Vector, NDArray[np.int_]]:
        """The shortest step after which something has crossed, by bisection of the step's length."""
        low, high, after = time, end, self._step(time, x, end - time)
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            if not low < middle < high:
                break
            trial = self._step(time, x, middle - time)
            found = self._crossed(middle, trial)
            if found.any():
                high, after, crossed = middle, trial, found
            else:
                low = middle
        return high, after, crossed

    def _slope(self, time: float, x: Vector) -> Vector:
        evaluator = self._evaluator
        evaluator.at(time, x)
        self._rhs += 1
        if not evaluator.evaluate():
            culprit(evaluator)
            raise self._failure("simulate.not-finite", "a derivative is not a number")
        return evaluator.xdot.copy()

    def _step(self, time: float, x: Vector, h: float) -> Vector:
        """The states after a step of length `h`."""
        if not x.size:
            return x
        if self._method == "ab2":
            return self._two_step(time, x, h)
        if self._method in IMPLICIT:
            return self._rosenbrock(IMPLICIT[self._method], time, x, h)
        return self._runge_kutta(EXPLICIT[self._method], time, x, h)

    def _runge_kutta(self, method: _Explicit, time: float, x: Vector, h: float) -> Vector:
        slopes: list[Vector] = []
        for row, c in zip(method.a, method.c, strict=True):
            slopes.append(self._slope(time + c * h, x + h * _sum(row, slopes)))
        return x + h * _sum(method.b, slopes)

    def _two_step(self, time: float, x: Vector, h: float) -> Vector:
        slope = self._slope(time, x)
        self._latest = time, slope
        if self._old is None:
            return self._runge_kutta(_HEUN, time, x, h)
        before, old = self._old
        ratio = 0.5 * h / (time - before)
        return x + h * ((1.0 + ratio) * slope - ratio * old)

    def _rosenbrock(self, method: _Implicit, time: float, x: Vector, h: float) -> Vector:
        slope = self._slope(time, x)
        solve = self._factored(h * method.gamma)
        rate = self._rate(time, x, slope, h)
        stages: list[Vector] = []
        for row, mixed, alpha, d in zip(method.a, method.c, method.alpha, method.d, strict=True):
            moved = alpha != 0.0 or any(row)
            f = self._slope(time + alpha * h, x + _sum(row, stages)) if moved else slope
            stages.append(solve(f + _sum(mixed, stages) / h + d * h * rate))
        return x + _sum(method.m, stages)

    def _rate(self, time: float, x: Vector, slope: Vector, h: float) -> Vector:
        """The derivative of f by time, by a difference; the run-time has it exact."""
        delta = min(np.sqrt(2.2e-16 * max(1e-5, abs(time))), 0.5 * h)
        return (self._slope(time + delta, x) - slope) / delta

    def _factored(self, h: float) -> Callable[[Vector], Vector]:
        """Solves `(1 / h - J) k = b` at the evaluator's point."""
        evaluator = self._evaluator
        evaluator.jac()
        self._jacobians += 1
        size = evaluator.x.size
        jacobian = csc_matrix((evaluator.jacobian, self._pattern), shape=(size, size))
        try:
            factors = splu((identity(size, format="csc") / h - jacobian).tocsc())
        except RuntimeError:
            raise self._failure(
                "simulate.singular-step", "the matrix of an implicit step was singular"
            ) from None
        return lambda right: np.asarray(factors.solve(right), dtype=np.float64)

    def _failure(self, code: str, cause: str) -> AcausalError:
        return stopped(
            self._evaluator, self._limits, "the integration", code, cause, self._time, self._x.copy()
        )


def _sum(factors: tuple[float, ...], vectors: list[Vector]) -> Vector | float:
    total: Vector | float = 0.0
    for factor, vector in zip(factors, vectors, strict=False):
        if factor != 0.0:
            total = total + factor * vector
    return total
