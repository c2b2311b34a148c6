"""CVODE (variable-order BDF) from SUNDIALS through scikit-sundae, with callbacks into the compiled Functions.

Steps. scikit-sundae does not pass CVODE's step counter on. It is recovered from the times at which CVODE
asks for derivatives: every attempted step evaluates at its end, and a rejected attempt is followed by an
earlier time, so accepted steps are the forward moves. The trial evaluations that choose the first step size
come before the first Jacobian, where counting starts anew.

Not-a-number. scikit-sundae ignores what callbacks return, so a failing evaluation cannot be reported as
recoverable. It fills the derivatives with not-a-number instead; the corrector then does not converge and
CVODE takes a quarter of the step, exactly as it does for a recoverable failure.
"""

from __future__ import annotations

import warnings
from contextlib import redirect_stdout
from typing import Literal, Protocol

import numpy as np
from scipy.sparse import csc_matrix
from sksundae.cvode import CVODE, CVODEResult

from acausal.simulate.evaluator import Evaluator
from acausal.simulate.failures import culprit, stopped
from acausal.simulate.matrices import Vector, is_finite
from acausal.simulate.solver import BATCH, SLOW_BATCHES, Arrival, Tolerances, Work

SPARSE_FROM = 50
"""From this number of states on, the linear solver is sparse (SuperLU) instead of dense."""

_TOO_MUCH_WORK, _COLLAPSED = -1, -1000
_ROUND = 64 * np.finfo(float).eps
"""Instants that differ by less are the same."""

_CAUSES = {
    _COLLAPSED: (
        "simulate.step-collapse",
        "its steps have become so short that the run would need more of them than are allowed",
    ),
    -1: ("simulate.too-many-steps", "too many steps were needed"),
    -2: ("simulate.tolerance", "the tolerance asks for more accuracy than numbers of 64 bits have"),
    -3: ("simulate.step-too-small", "the error test failed with the smallest step"),
    -4: ("simulate.no-convergence", "the corrector did not converge with the smallest step"),
}


class EventCallback(Protocol):
    """A zero-crossing callback that can forget what scikit-sundae keeps in it."""

    def forget(self) -> None: ...


class Stepper(Protocol):
    """What CVODE and IDA have in common."""

    def step(
        self, t: float, method: Literal["normal", "onestep"] = ..., tstop: float | None = ...
    ) -> CVODEResult: ...


class _Roots:
    """The zero-crossing callback; scikit-sundae keeps every event in lists on this object."""

    def __init__(self, evaluator: Evaluator) -> None:
        self.terminal = [True] * len(evaluator.located)
        self.direction = [0] * len(evaluator.located)
        self._evaluator = evaluator
        self._i: list[object] = []
        self._t: list[object] = []
        self._y: list[object] = []

    def __call__(self, t: float, y: Vector, events: Vector, /) -> None:
        evaluator = self._evaluator
        evaluator.at(t, y[: evaluator.x.size])
        evaluator.crossings(events)

    def forget(self) -> None:
        """Empties those lists, which scikit-sundae would otherwise copy after every step."""
        for kept in (self._i, self._t, self._y):
            kept.clear()


class Cvode:
    """The `Solver` over one CVODE instance. Without states there is a constant one, to locate events."""

    name = "CVODE"

    def __init__(
        self, evaluator: Evaluator, tolerances: Tolerances, method: Literal["BDF", "Adams"] = "BDF"
    ) -> None:
        self._evaluator = evaluator
        self._method: Literal["BDF", "Adams"] = method
        self._tolerances = tolerances
        self._size = max(1, evaluator.x.size)
        self._rhs_evaluations = self._jacobian_evaluations = 0
        self._steps = self._finished_steps = 0
        self._latest = -np.inf
        self._before = self._ahead = evaluator.guess.copy()
        self._settled = False
        self._time = -np.inf
        self._slow = 0
        self._broken: tuple[float, Vector] | None = None
        pattern = evaluator.code.pattern
        rows, columns = (np.asarray(v, dtype=np.intp) for v in pattern.get_triplet())
        self._rows, self._columns = rows, columns
        self._sparse = self._size > SPARSE_FROM and len(rows) > 0
        self._roots: EventCallback | None = None
        self._cvode: Stepper = self._create()

    def _create(self) -> Stepper:
        shape = (self._size, self._size)
        ones = np.ones(len(self._rows))
        limits = self._tolerances
        roots = _Roots(self._evaluator) if self._evaluator.located.size else None
        self._roots = roots
        longest = limits.max_step or limits.sample  # so that two crossings in one long step are not missed
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # the pattern is not used for differences: it is exact
            made = CVODE(
                self._derivatives,
                method=self._method,
                jacfn=self._sparse_jacobian if self._sparse else self._dense_jacobian,
                linsolver="sparse" if self._sparse else "dense",
                sparsity=csc_matrix((ones, (self._rows, self._columns)), shape=shape)
                if self._sparse
                else None,
                rtol=limits.rtol,
                atol=limits.atol if limits.atol.size else 1.0,
                min_step=limits.min_step,
                max_step=max(longest, limits.min_step) if longest else np.inf,
                max_num_steps=min(limits.max_steps, BATCH),
                eventsfn=roots,
                num_events=self._evaluator.located.size,
            )
        self._start = made.init_step
        return made

    @property
    def work(self) -> Work:
        steps = self._finished_steps + self._steps
        return Work(steps, self._rhs_evaluations, self._jacobian_evaluations)

    @property
    def influence(self) -> None:
        """Not known: scikit-sundae passes no error estimates on."""
        return None

    def _derivatives(self, t: float, y: Vector, yp: Vector, /) -> None:
        self._rhs_evaluations += 1
        evaluator = self._evaluator
        if t > self._latest:
            self._steps += 1
            self._before = evaluator.guess.copy()
        elif t < self._latest:  # a step was refused: blocks are looked for where the last one ended
            evaluator.guess[:] = self._before
        self._latest = t
        if not evaluator.x.size:
            yp[0] = 0.0
            return
        evaluator.at(t, y)
        evaluator.solve()
        slope = evaluator.xdot
        if not is_finite(slope) and np.isfinite(y).all():
            self._broken = t, y.copy()
        yp[:] = slope

    def _count_jacobian(self) -> None:
        self._jacobian_evaluations += 1
        if not self._settled:
            self._settled = True
            self._steps = 1

    def _at(self, t: float, y: Vector) -> None:
        self._count_jacobian()
        evaluator = self._evaluator
        if evaluator.x.size:
            evaluator.at(t, y)
            evaluator.jac()

    def _sparse_jacobian(self, t: float, y: Vector, yp: Vector, matrix: Vector, /) -> None:
        self._at(t, y)
        matrix[:] = self._evaluator.jacobian

    def _dense_jacobian(self, t: float, y: Vector, yp: Vector, matrix: Vector, /) -> None:
        self._at(t, y)
        matrix[self._rows, self._columns] = self._evaluator.jacobian

    def restart(self, time: float, x: Vector) -> None:
        self._finished_steps += self._steps
        self._steps = 0
        self._settled = False
        self._broken = None
        self._latest = self._time = time
        self._before = self._ahead = self._evaluator.guess.copy()
        self._begin(time, x)

    def _begin(self, time: float, x: Vector) -> None:
        self._start(time, x if x.size else np.zeros(1))

    def advance(self, target: float, stop: float) -> Arrival:
        """To `target` in pieces that end where the slope of an input jumps: as many as there are kinks.

        Steps reach beyond the target: blocks are looked for there from where the last steps ended, at the
        target from where the last row was.
        """
        guess = self._evaluator.guess
        last = guess.copy()
        guess[:] = self._ahead
        try:
            return self._reach(target, stop)
        finally:
            self._ahead = guess.copy()
            guess[:] = last

    def _reach(self, target: float, stop: float) -> Arrival:
        while True:
            kink = self._evaluator.inputs.next_kink(self._time)
            if kink >= target - _ROUND * max(abs(target), abs(self._time)):
                return self._advance(target, min(stop, max(kink, target)))
            arrival = self._advance(kink, kink)
            if arrival.crossed is not None:
                return arrival
            self.restart(arrival.time, arrival.x)

    def _advance(self, target: float, stop: float) -> Arrival:
        """To `target` without a kink in between, in batches of steps at whose ends the pace is judged."""
        size = self._evaluator.x.size
        limit = self._tolerances.max_steps
        for _ in range(limit // BATCH + 1):
            with redirect_stdout(None):  # scikit-sundae prints what it also returns
                found = self._cvode.step(target, method="normal", tstop=stop)
            time = float(found.t)
            exhausted = found.status == _TOO_MUCH_WORK
            if found.status < 0 and not exhausted:
                raise self._failure(found, found.status)
            if self.work.steps > limit:
                raise self._failure(found, _TOO_MUCH_WORK)
            if exhausted:
                self._judge(found, time - self._time)
                self._time = time
                continue
            self._time = time
            self._slow, self._broken = 0, None
            self._evaluator.judge_jumps(time)
            if found.status == 2 and found.i_events is not None and self._roots is not None:
                crossed = np.zeros(self._evaluator.m.size, dtype=np.int_)
                crossed[self._evaluator.located] = found.i_events[-1]
                self._roots.forget()
                return Arrival(time, found.y[:size], crossed)
            return Arrival(time, found.y[:size])
        raise AssertionError("the number of steps is bounded")

    def _judge(self, found: CVODEResult, progress: float) -> None:
        """Stops a run that at its present pace would need more steps than are allowed."""
        hopeless = progress * self._tolerances.max_steps < self._tolerances.span * BATCH
        self._slow = self._slow + 1 if hopeless else 0
        if self._slow >= SLOW_BATCHES:
            raise self._failure(found, _COLLAPSED)

    def _failure(self, found: CVODEResult, status: int) -> Exception:
        """Explains why CVODE gave up: an equation that is not finite, or states that change too fast."""
        evaluator = self._evaluator
        time = float(found.t)
        if self._broken is not None and status not in (_TOO_MUCH_WORK, _COLLAPSED):
            evaluator.at(*self._broken)
            culprit(evaluator)
        code, cause = _CAUSES.get(status, ("simulate.solver", found.message))
        self._take_guess(found.y)
        x = np.array(found.y[: evaluator.x.size])
        return stopped(evaluator, self._tolerances, self.name, code, cause, time, x)

    def _take_guess(self, y: Vector) -> None:
        """Where blocks were solved last; the evaluator knows."""
