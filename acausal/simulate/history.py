"""The past of delayed expressions: `delay(e, T)` is `e` at `time - T`, its first value before that.

Values and slopes are kept at the ends of short pieces of the run and at both sides of events, and
interpolated by cubics between them (Hermite); what is older than the longest delay is dropped. Pieces are not
longer than the delays, so that the past is known; a delay that comes close to zero is extrapolated.

What changes at events only, delayed by a parameter, is constant between known instants: each jump comes back
as an event at its time plus the delay, and pieces may have any length.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from dataclasses import dataclass
from heapq import heappop, heappush

import numpy as np

from acausal.errors import SimulationProblem, fail
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import at, number, span_of
from acausal.symbolic.causal import CausalSystem
from acausal.symbolic.expressions.expr import symbols
from acausal.symbolic.expressions.text import to_text

_KEPT = 64
"""Points that are kept at least."""
_ROUND = 1e-9
_SAME = 1e-14
"""Of the time: instants that differ by rounding are the same."""


@dataclass(frozen=True)
class Sample:
    """Delayed expressions at an instant: values, delays, longest delays, and slopes of the first two."""

    time: float
    values: Vector
    lags: Vector
    longest: Vector
    value_slopes: Vector
    lag_slopes: Vector


class History:
    """The past of one run. Raises `SimulationProblem` (`simulate.delay`) for a delay that cannot be.

    `steady`: all delayed expressions change at events only, and the delays never.
    """

    def __init__(self, system: CausalSystem, *, steady: bool = False) -> None:
        self._system = system
        self._steady = steady
        self._jumps: list[float] = []
        self._times: list[float] = []
        self._samples: list[Sample] = []

    def piece(self, most: float) -> float:
        """How long the delayed values are known for: about the shortest delay, but `most` at most."""
        if self._steady:
            return math.inf
        return min(most, max(float(self._samples[-1].lags.min()), 1e-3 * most))

    def next_jump(self, time: float) -> float:
        """When a delayed value jumps for the first time clearly after `time`; infinite if that is unknown."""
        while self._jumps and self._jumps[0] - time <= _rounding(time):
            heappop(self._jumps)
        return self._jumps[0] if self._jumps else math.inf

    @property
    def size(self) -> int:
        """How many samples are kept."""
        return len(self._samples)

    @property
    def samples(self) -> tuple[Sample, ...]:
        """What is kept."""
        return tuple(self._samples)

    def add(self, sample: Sample) -> None:
        """Notes one sample, at the time of the last one or later."""
        wrong = ~((sample.lags >= 0) & (sample.lags <= sample.longest * (1 + _ROUND)))
        for i in np.flatnonzero(wrong):
            raise self._bad(sample, int(i))
        if self._steady and self._samples:
            for i in np.flatnonzero(sample.values != self._samples[-1].values):
                heappush(self._jumps, sample.time + float(sample.lags[i]))
        self._times.append(sample.time)
        self._samples.append(sample)
        first = sample.time - float(sample.longest.max())
        if len(self._times) > _KEPT and self._times[len(self._times) // 2] < first:
            past = bisect_right(self._times, first) - 1
            del self._times[:past], self._samples[:past]

    def fill(self, time: float, out: Vector) -> None:
        """The delayed values at `time`."""
        if not self._samples:
            return
        last = self._samples[-1]
        instants = time - (last.lags + (time - last.time) * last.lag_slopes)
        if self._steady:
            instants += _rounding(time)  # a jump is over where it happens
        for i, instant in enumerate(instants.tolist()):
            out[i] = self._value(i, instant)

    def _value(self, i: int, instant: float) -> float:
        after = bisect_right(self._times, instant)
        if after == 0:
            return float(self._samples[0].values[i])
        a = self._samples[after - 1]
        if after == len(self._times):
            return float(a.values[i] + (instant - a.time) * a.value_slopes[i])
        b = self._samples[after]
        h = b.time - a.time
        s = (instant - a.time) / h
        inner = (1 - s) * (h * a.value_slopes[i] * s + a.values[i] * (1 + 2 * s))
        outer = s * (b.values[i] * (3 - 2 * s) - h * b.value_slopes[i] * (1 - s))
        return float(inner * (1 - s) + outer * s) if h > 0 else float(b.values[i])

    def _bad(self, sample: Sample, i: int) -> Exception:
        lag, longest = float(sample.lags[i]), float(sample.longest[i])
        node = self._system.delays[i]
        message = f"the delay of `{to_text(node)}` is {number(lag)} s {at(sample.time)}"
        hint = f"it must lie between 0 and its longest value, {number(longest)} s"
        span = span_of(self._system, node)
        return fail(SimulationProblem, "simulate.delay", message, span, names=symbols([node]), hint=hint)


def _rounding(time: float) -> float:
    return _SAME * abs(time)
