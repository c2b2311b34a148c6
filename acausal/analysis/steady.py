"""Steady states, also of what turns.

Steady means that the derivatives lie in the directions N in which positions may turn (`equilibrium`),

    f(x) = N a,   N^T (x - x_0) = 0,

which is solved for x and the rates a by Newton's method. Time stands still on the way, so sources keep the
value of the instant; modes and discrete values follow: a step ends where a relation changes, and the event
there is settled as in a run.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acausal.analysis.equilibrium import NULL, split, turning
from acausal.analysis.linear import state_matrix
from acausal.errors import AcausalError, SimulationProblem, fail
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.events import crossed_modes, operators
from acausal.simulate.messages import crossing_text, some
from acausal.simulate.reselect import Reselection
from acausal.simulate.settle import Settling

Vector = NDArray[np.float64]

MAX_ITERATIONS = 1000
MAX_EVENTS = 300
_CONVERGED = 1e-10
_ROUNDING = 1e-13
_FIRST = 1e-6
"""Length of the first step in seconds."""
_DRIFTING = 1.0
"""Up to this length of a step, in seconds, positions that may turn do so in the second attempt."""
_LONGEST = 1e6
"""From here on steps are Newton's."""
_PATIENCE = 2.0
"""By how much the residual may grow on the way: a transient need not be monotonic."""
_AHEAD = 1e-9
_CLEAR = 1e-9
"""A root beyond this, relative to its sides, has left zero."""
_STALLED = 40
"""This many of the longest steps without an end are too many."""


@dataclass(frozen=True, eq=False)
class Steady:
    """A steady point. `rates` are the derivatives of the states: zero, but for positions that turn.

    `evaluator` is that of the states chosen there, with the modes that hold.
    """

    evaluator: Evaluator
    x: Vector
    rates: Vector
    iterations: int
    events: int = 0


def steady_state(evaluator: Evaluator) -> Steady:
    """From the evaluator's present point, with its time, parameters and inputs.

    Linearly implicit Euler steps whose length grows as the residual falls lead to where Newton's method
    converges (pseudo-transient continuation; C. T. Kelley, D. E. Keyes, SIAM J. Numer. Anal. 35 (1998),
    508-523). Raises SimulationProblem `steady.none` where that is not so within `MAX_ITERATIONS`, naming what
    keeps moving, and `steady.switching` where modes do not come to rest.

    Positions that may turn stay where they are; if that leads nowhere, they turn during short steps, so that
    what is loose now can touch a little later.
    """
    e = evaluator
    before = [array.copy() for array in (e.x, e.m, e.d, e.guess)]
    try:
        return _Search(e, drifting=0.0).run()
    except SimulationProblem as error:
        for array, kept in zip((e.x, e.m, e.d, e.guess), before, strict=True):
            array[:] = kept
        try:
            return _Search(e, drifting=_DRIFTING).run()
        except SimulationProblem:
            raise error from None


class _Search:
    """The way from one point to the steady one."""

    def __init__(self, evaluator: Evaluator, drifting: float) -> None:
        self._drifting = drifting
        self.time = float(evaluator.t[0])
        self.events = 0
        self._reselection = Reselection(evaluator, 1.0)
        self._adopt(evaluator, evaluator.x.copy())

    def _adopt(self, evaluator: Evaluator, x: Vector) -> None:
        """Goes on with these states."""
        system = evaluator.code.system
        self.e, self.x = evaluator, x
        self.scale = evaluator.x_nominal
        self.units = [system.flat.by_name[name].unit for name in system.states]
        self._first = self.x / self.scale
        self._settling = Settling(evaluator, _AHEAD)
        self._ops = operators(system)
        self._touched = np.zeros(len(self._ops), dtype=np.int_)

    def run(self) -> Steady:
        """Steps until Newton's step changes nothing."""
        tau, long, count = _FIRST, 0, self.events
        jacobian, residual = np.zeros((0, 0)), np.zeros(len(self.x))
        for iteration in range(MAX_ITERATIONS):
            if count != self.events:
                tau, long, count = min(tau, 1e-2 * _LONGEST), 0, self.events
            jacobian = self._jacobian()
            null = turning(jacobian, self.units)
            rate, residual = split(self.e.xdot / self.scale, null)
            across = jacobian - null @ (null.T @ jacobian)
            sizes = np.abs(jacobian).max(axis=1, initial=0.0)
            sizes = np.where(sizes > 0, sizes, 1.0)
            newton = _newton(across, residual, sizes)
            if _is_small(newton, self.x / self.scale) and self._is_there(residual / sizes):
                x = self.x + newton * self.scale
                return Steady(self.e, x, rate * self.scale, iteration, self.events)
            long = long + 1 if tau >= _LONGEST else 0
            if long > _STALLED:
                break
            step = newton if tau >= _LONGEST else _implicit(jacobian, residual, tau)
            if tau > self._drifting:
                step = step - null @ (null.T @ step)
            tau = self._advance(step, null, tau, float(np.linalg.norm(residual)))
        raise self._none(jacobian, residual)

    def _advance(self, step: Vector, null: Vector, tau: float, size: float) -> float:
        """Takes the step, as far as modes hold on it; the length of the next one."""
        target = self.x + step * self.scale
        after = self._size_at(target, null)
        if not np.isfinite(after):
            return tau / 4
        if self._lost(target):
            self._event(target)
            return tau
        if after < (1.0 if tau >= _LONGEST else _PATIENCE) * size:
            self.x = target
            return min(tau * min(max(size / max(after, 1e-300), 1.5), 10.0), _LONGEST)
        return tau / 4

    def _is_there(self, change: Vector) -> bool:
        """Whether the residual is no more than a negligible change of the states would make it.

        Negligible beside the values at the outset: those on the way grow where nothing holds them.
        """
        first, now = (float(np.abs(x).max(initial=0.0)) for x in (self._first, self.x / self.scale))
        return float(np.abs(change).max(initial=0.0)) <= 10 * _CONVERGED * max(1.0, first) + _ROUNDING * now

    def _jacobian(self) -> Vector:
        """In nominal values, at the present point, whose blocks are solved."""
        e = self.e
        e.at(self.time, self.x)
        e.settle()
        return state_matrix(e) * self.scale / self.scale[:, None]

    def _size_at(self, x: Vector, null: Vector) -> float:
        """The size of the residual at another point; infinite where the model has no value."""
        self.e.at(self.time, x)
        if not self.e.evaluate():
            return np.inf
        return float(np.linalg.norm(split(self.e.xdot / self.scale, null)[1]))

    def _lost(self, x: Vector) -> bool:
        """Whether a relation has another value at `x` than its mode says."""
        return bool(self._crossed(x).any())

    def _crossed(self, x: Vector) -> NDArray[np.int_]:
        """The sign of the roots at `x` whose relations lost their modes; 0 of the others."""
        e = self.e
        if not self._ops:
            return self._touched
        e.at(self.time, x)
        e.event()
        e.size()
        clear = (np.abs(e.roots) > _CLEAR * e.sizes) & ~e.within(e.roots)
        signs = np.where(clear, np.sign(np.nan_to_num(e.roots)), 0.0).astype(np.int_)
        return np.where(crossed_modes(self._ops, e.m, signs) != e.m, signs, 0)

    def _event(self, target: Vector) -> None:
        """Goes to where the first mode is lost on the way to `target`, and settles it."""
        self.events += 1
        low, high = 0.0, 1.0
        for _ in range(50):
            middle = (low + high) / 2
            low, high = (low, middle) if self._lost(self._between(middle, target)) else (middle, high)
        x = self._between(high, target)
        crossed = self._crossed(x)
        self._touched = crossed if crossed.any() else self._touched
        if self.events > MAX_EVENTS:
            raise self._switching()
        self.e.at(self.time, x)
        self._settling.remember()
        self.x = self._settling.settle(self.time, x, crossed)
        if self._reselection.is_due(self.e):
            self._adopt(*self._reselection(self.e, self.time, self.x))
        self.e.at(self.time, self.x)
        self.e.hold(1e4 * _AHEAD)

    def _between(self, share: float, target: Vector) -> Vector:
        return self.x + share * (target - self.x)

    def _switching(self) -> AcausalError:
        crossings = [c for c, on in zip(self.e.code.system.zero_crossings, self._touched, strict=True) if on]
        texts = some([crossing_text(crossing) for crossing in crossings])
        return fail(
            SimulationProblem,
            "steady.switching",
            f"no steady state: modes changed {MAX_EVENTS} times on the way, lastly by {texts}",
            crossings[0].span if crossings else None,
            hint="the model may cycle for ever: simulate it, and take an instant",
        )

    def _none(self, jacobian: Vector, residual: Vector) -> AcausalError:
        """What keeps moving, and whether anything acts against it."""
        names = self.e.code.system.states
        rates = np.abs(self.e.xdot / self.scale)
        worst = [int(i) for i in np.argsort(-np.abs(residual), kind="stable")]
        moving = [i for i in worst if abs(residual[i]) > 1e-3 * abs(residual[worst[0]])][:5]
        texts = ", ".join(f"der({names[i]}) = {self.e.xdot[i]:.4g}" for i in moving)
        free = _unopposed(jacobian, residual)
        why = "the search did not come to an end"
        if free.any():
            listed = [names[int(i)] for i in np.argsort(-free * rates, kind="stable") if free[i] > 0.1]
            why = f"nothing acts back on {some([f'`{name}`' for name in listed])}, whatever their values are"
        return fail(
            SimulationProblem,
            "steady.none",
            f"no steady state was found: {why}; {texts}",
            names=[names[i] for i in moving],
            hint="a source may feed what nothing drains; or simulate until it rests, and take that instant",
        )


def _unopposed(jacobian: Vector, residual: Vector) -> Vector:
    """Of each state, its part in what no change of states can make zero: left null vectors that f meets."""
    sizes = np.abs(jacobian).max(axis=1, initial=0.0)
    rows = np.where(sizes > 0, sizes, 1.0)
    left, values, _ = np.linalg.svd(jacobian / rows[:, None])
    null = left[:, values <= NULL * max(float(values[0]), 1e-300)]
    within = null @ (null.T @ (residual / rows))
    total = float(np.linalg.norm(residual / rows))
    if not total or np.linalg.norm(within) < 1e-2 * total:
        return np.zeros(len(residual))
    return np.asarray(np.abs(within) / np.abs(within).max(), dtype=np.float64)


def _newton(jacobian: Vector, residual: Vector, sizes: Vector) -> Vector:
    """The shortest step that makes the residual zero to first order; rows are divided by `sizes`."""
    left: Vector = np.asarray(jacobian / sizes[:, None], dtype=np.float64)
    right: Vector = np.asarray(-residual / sizes, dtype=np.float64)
    return np.asarray(np.linalg.lstsq(left, right, rcond=NULL)[0], dtype=np.float64)


def _implicit(jacobian: Vector, residual: Vector, tau: float) -> Vector:
    """A step of linearly implicit Euler."""
    system: Vector = np.asarray(np.eye(len(residual)) / tau - jacobian, dtype=np.float64)
    return np.asarray(np.linalg.solve(system, residual), dtype=np.float64)


def _is_small(step: Vector, x: Vector) -> bool:
    """Whether the step changes nothing any more."""
    return float(np.abs(step).max(initial=0.0)) <= _CONVERGED * max(1.0, float(np.abs(x).max(initial=0.0)))
