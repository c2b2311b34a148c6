"""Events at known instants: `sample`, and conditions that depend on time alone between events.

They are stepped to exactly. Instants that differ by rounding only are one event.
"""

from __future__ import annotations

import math

import numpy as np

from acausal.errors import SimulationProblem, fail
from acausal.simulate.call import call
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import at, number, span_of
from acausal.symbolic.expressions.expr import symbols
from acausal.symbolic.expressions.text import to_text

_ROUND = 64 * np.finfo(float).eps


class Schedule:
    """The instants ahead of one run."""

    def __init__(self, evaluator: Evaluator, start: float) -> None:
        code = evaluator.code
        starts, intervals = (v.ravel() for v in call(code.discrete.schedule, evaluator.p))
        for i in np.flatnonzero(~((intervals > 0) & np.isfinite(intervals) & np.isfinite(starts))):
            raise _bad_sample(evaluator, int(i), float(starts[i]), float(intervals[i]))
        self.starts, self.intervals = np.ascontiguousarray(starts), np.ascontiguousarray(intervals)
        """Of each sample."""
        slack = _rounding(start)
        self._counts = np.maximum(np.ceil((start - starts - slack) / intervals), 0.0)

    @property
    def counts(self) -> Vector:
        """Of each sample, the number of its next instant."""
        return self._counts

    def go_on(self, counts: tuple[float, ...]) -> None:
        """Goes on with numbers that `counts` gave."""
        self._counts = np.array(counts, dtype=float)

    def next(self, evaluator: Evaluator, time: float) -> float:
        """The first instant after `time`; infinite if there is none."""
        ahead = math.inf
        if self.starts.size:
            ahead = float((self.starts + self._counts * self.intervals).min())
        if evaluator.instants.size:
            evaluator.instant()
            instants = evaluator.instants
            later = instants[instants > time + _rounding(time)]  # not-a-number and infinity are never
            if later.size:
                ahead = min(ahead, float(later.min()))
        return ahead

    def due(self, time: float) -> Vector:
        """1 for every sample whose instant this is, and 0; those instants are then past."""
        if not self.starts.size:
            return self.starts
        instants = self.starts + self._counts * self.intervals
        now = instants <= time + np.maximum(_rounding(time), 1e-10 * self.intervals)
        self._counts[now] += 1.0
        return now.astype(float)


def _rounding(time: float) -> float:
    """What instants near `time` may differ by and still be the same."""
    return float(_ROUND * max(abs(time), 1e-300))


def is_reached(time: float, instant: float) -> bool:
    """Whether `instant` is not clearly after `time`."""
    return instant - time <= _rounding(time)


def _bad_sample(evaluator: Evaluator, i: int, start: float, interval: float) -> Exception:
    system = evaluator.code.system
    node = system.discrete.samples[i]
    span = span_of(system, node)
    names = symbols([node])
    if math.isfinite(start):
        what, hint = f"the interval {number(interval)} s", "it must be a number greater than zero"
    else:
        what, hint = f"the start {number(start)} s", "it must be a number"
    message = f"`{to_text(node)}` has {what} {at(float(evaluator.t[0]))}"
    return fail(SimulationProblem, "simulate.sample-interval", message, span, names=names, hint=hint)
