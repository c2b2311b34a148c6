"""CVODE through scikits-odes, an optional backend for comparison (the extra `scikits-odes`).

Dense linear algebra and Python callbacks: what it is good for is a second implementation of the same method.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acausal.errors import AcausalError, UnsupportedProblem, fail
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.events import operators
from acausal.simulate.failures import culprit, stopped
from acausal.simulate.matrices import Vector
from acausal.simulate.solver import Arrival, Tolerances, Work

_AT_STOP, _AT_ROOT = 1, 2
_NEAR = 1e-9
_ROUND = 1e-14


def _wrapper() -> Any:
    """scikits-odes' CVODE class. Raises `UnsupportedProblem` where it is not installed."""
    try:
        return import_module("scikits_odes_sundials.cvode").CVODE
    except ImportError:
        raise fail(
            UnsupportedProblem,
            "simulate.solver-missing",
            "scikits-odes is not installed",
            hint="apt install libsundials-dev, then pip install 'acausal[scikits-odes]'; or choose cvode",
        ) from None


class ScikitsOdes:
    """The `Solver` over scikits-odes' CVODE (BDF)."""

    def __init__(self, evaluator: Evaluator, tolerances: Tolerances) -> None:
        self._evaluator = evaluator
        self._limits = tolerances
        self._size = max(1, evaluator.x.size)
        self._steps = self._rhs = self._jacobians = 0
        self._time = tolerances.start
        rows, columns = evaluator.code.pattern.get_triplet()
        self._pattern = np.asarray(rows, dtype=np.intp), np.asarray(columns, dtype=np.intp)
        rising = np.array([1.0 if op in ("gt", "ge") else -1.0 for op in operators(evaluator.code.system)])
        self._rising = rising
        longest = tolerances.max_step or tolerances.sample
        options: dict[str, object] = {"rootfn": self._roots, "nr_rootfns": evaluator.located.size}
        self._solver = _wrapper()(
            self._derivatives,
            old_api=False,
            one_step_compute=True,
            rtol=tolerances.rtol,
            atol=tolerances.atol if evaluator.x.size else 1.0,
            max_step_size=longest or 0.0,
            max_steps=tolerances.max_steps,
            jacfn=self._jacobian,
            **(options if evaluator.located.size else {}),
        )

    @property
    def work(self) -> Work:
        return Work(self._steps, self._rhs, self._jacobians)

    @property
    def influence(self) -> None:
        """Not known."""
        return None

    def _derivatives(self, t: float, y: Vector, yp: Vector) -> int:
        self._rhs += 1
        evaluator = self._evaluator
        if not evaluator.x.size:
            yp[0] = 0.0
            return 0
        evaluator.at(t, y)
        evaluator.solve()
        yp[:] = evaluator.xdot
        return 0 if np.isfinite(evaluator.xdot).all() else 1

    def _jacobian(self, t: float, y: Vector, fy: Vector, matrix: Vector) -> int:
        del fy
        self._jacobians += 1
        evaluator = self._evaluator
        matrix[:] = 0.0
        if evaluator.x.size:
            evaluator.at(t, y)
            evaluator.jac()
            matrix[self._pattern] = evaluator.jacobian
        return 0

    def _roots(self, t: float, y: Vector, g: Vector) -> int:
        evaluator = self._evaluator
        evaluator.at(t, y[: evaluator.x.size])
        evaluator.crossings(g)
        return 0

    def restart(self, time: float, x: Vector) -> None:
        """Begins anew at this point."""
        self._time = time
        self._solver.init_step(time, x if x.size else np.zeros(1))

    def advance(self, target: float, stop: float) -> Arrival:
        """To `target` by single steps, the last of which ends there."""
        del stop
        self._solver.set_options(tstop=target)
        while True:
            found = self._solver.step(target)
            self._steps += 1
            if found.flag < 0:
                raise self._failure(str(found.message))
            self._time = float(found.values.t)
            x = np.array(found.values.y[: self._evaluator.x.size])
            if found.flag == _AT_ROOT:
                return Arrival(self._time, x, self._crossed(self._time, x))
            if found.flag == _AT_STOP or target - self._time <= _ROUND * abs(target):
                return Arrival(target, x)
            if self._steps > self._limits.max_steps:
                raise self._failure("too many steps were needed")

    def _crossed(self, time: float, x: Vector) -> NDArray[np.int_]:
        """The roots that are zero to rounding, or on the other side of their modes."""
        evaluator = self._evaluator
        evaluator.at(time, x)
        evaluator.event()
        evaluator.size()
        side = np.where(evaluator.m != 0, 1.0, -1.0) * self._rising
        over = np.zeros(evaluator.m.size, dtype=np.bool_)
        over[evaluator.located] = (side * evaluator.roots <= _NEAR * evaluator.sizes)[evaluator.located]
        return np.where(over, -side, 0).astype(np.int_)

    def _failure(self, message: str) -> AcausalError:
        evaluator = self._evaluator
        culprit(evaluator)
        x = evaluator.x.copy()
        return stopped(evaluator, self._limits, "scikits-odes", "simulate.solver", message, self._time, x)
