"""Which modes hold right after an instant, and when events accumulate.

At an instant a root `g = left - right` may be zero to rounding. Its relation then takes the value that it
has a moment later along the present derivatives, so that a solver started here moves away from the root
with the mode that fits, instead of sticking to it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from acausal.errors import Diagnostic, SimulationProblem
from acausal.runtime.event_binding import RECENT, SHRINKING
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import at, crossing_text, leaf_name, some, span_of
from acausal.simulate.texts import point_text
from acausal.symbolic.causal import CausalSystem
from acausal.symbolic.expressions.expr import symbols
from acausal.symbolic.expressions.text import to_text

BAND = 1e-9
"""Relative to both sides' sizes: closer to zero than this, a root counts as zero."""
_NOISE = 1e-14
_CLEAR = 1e-15
ZENO_SHARE = 1e-6
"""`RECENT` events within this share of the simulated time are an accumulation."""
RESOLVED = 1e-8
"""So are `SHRINKING` whose distances shrink, in the end below this share of a second or of a shorter run."""


def literal_modes(ops: tuple[str, ...], roots: Vector) -> Vector:
    """The relations' values from their roots alone."""
    sign, at_zero = _truth(ops)
    return np.where(roots == 0.0, at_zero, sign * roots > 0.0)


@lru_cache(maxsize=16)
def _truth(ops: tuple[str, ...]) -> tuple[Vector, Vector]:
    """The sign of roots for which relations hold, and whether they do at zero."""
    sign = np.array([1.0 if op in ("gt", "ge") else -1.0 for op in ops])
    return sign, np.array([float(op in ("ge", "le")) for op in ops])


def operators(system: CausalSystem) -> tuple[str, ...]:
    """The relations' operators, in the order of the modes."""
    return tuple(crossing.relation.op for crossing in system.zero_crossings)


def crossed_modes(ops: tuple[str, ...], modes: Vector, crossed: NDArray[np.int_]) -> Vector:
    """The modes after roots crossed zero in the given directions."""
    beyond = literal_modes(ops, crossed.astype(float))
    return np.where(crossed != 0, beyond, modes)


def against(evaluator: Evaluator, crossed: NDArray[np.int_], ahead: float) -> NDArray[np.bool_]:
    """Which crossings go against the way that their root goes here: artefacts of a step below the tolerance.

    So a ball that has just been thrown up is seen to fall, where one step covers its whole flight.
    """
    evaluator.event()
    roots = evaluator.roots.copy()
    near = (crossed != 0) & evaluator.is_zero(roots, BAND)
    if not near.any():
        return near
    time, x = float(evaluator.t[0]), evaluator.x.copy()
    evaluator.at(time + ahead, x + ahead * evaluator.xdot)
    evaluator.event()
    change = evaluator.roots - roots
    evaluator.at(time, x)
    return near & (np.sign(change) == -crossed) & ~evaluator.is_zero(change, _CLEAR)


@dataclass(frozen=True)
class Instant:
    """A point in time: `crossed` marks the roots located there, `roots` are those found then."""

    time: float
    x: Vector
    ahead: float
    """How far to look forward."""
    crossed: NDArray[np.bool_]
    roots: Vector
    undecided: bool = False
    """A root that rests at exactly zero may have either mode."""
    anchored: bool = False
    """Crossed relations keep the value that the crossing gave them, whatever the values are now."""
    met: NDArray[np.bool_] | None = None
    """Which roots were zero in a mode that was tried before at this instant."""
    released: NDArray[np.bool_] | None = None
    """Except those that watch an `integer(...)`, which are about another number once that has changed."""


def wanted_modes(
    evaluator: Evaluator, ops: tuple[str, ...], instant: Instant
) -> tuple[Vector, NDArray[np.bool_]]:
    """The values that the relations have now, or a moment later where their root is zero, and where it is.

    Zero, whatever rounding says, are the located roots as long as they have their values, and what rested
    there (`Evaluator.hold`). A root that was zero in another mode is looked at a moment later, too: the path
    parameter of a diode, of exactly zero while it is a voltage, has as a current the rounding of voltages
    over its resistance. The evaluator is settled at the instant. Raises `SimulationProblem` where a side is
    not a number.
    """
    time, x, ahead = instant.time, instant.x, instant.ahead
    evaluator.event()
    evaluator.size()
    roots, sizes = evaluator.roots.copy(), evaluator.sizes.copy()
    _check(evaluator, roots, time)
    wanted = literal_modes(ops, roots)
    located = instant.crossed & (np.abs(roots - instant.roots) <= BAND * sizes)
    kept = instant.crossed & instant.anchored
    if instant.released is not None:
        kept = kept & ~instant.released
    wanted = np.where(kept, evaluator.m, wanted)
    near = (located | (np.abs(roots) <= BAND * sizes) | evaluator.within(roots)) & ~kept
    looked = near if instant.met is None else (near | instant.met) & ~kept
    if not looked.any():
        return wanted, near
    evaluator.at(time + ahead, x + ahead * evaluator.xdot)
    evaluator.event()
    later = evaluator.roots.copy()
    evaluator.at(time, x)
    moved = looked & (np.abs(later - roots) > _NOISE * sizes)
    still = near & ~moved & ((roots != 0) | instant.undecided)
    wanted = np.where(moved, literal_modes(ops, later), wanted)
    return np.where(still, evaluator.m, wanted), near


def check_conditions(evaluator: Evaluator, time: float) -> None:
    """Raises `SimulationProblem` where a located condition has no side at the evaluator's point."""
    if evaluator.located.size:
        evaluator.event()
        roots = np.zeros(evaluator.m.size)
        roots[evaluator.located] = evaluator.roots[evaluator.located]
        _check(evaluator, roots, time)


def _check(evaluator: Evaluator, roots: Vector, time: float) -> None:
    """A condition that is not a number has no side."""
    if np.isfinite(roots).all():
        return
    evaluator.explain()
    crossing = evaluator.code.system.zero_crossings[int(np.flatnonzero(~np.isfinite(roots))[0])]
    message = f"the condition {crossing_text(crossing)} cannot be decided {at(time)}: a side is not a number"
    names = symbols([crossing.relation])
    values = point_text(evaluator, names)
    hint = f"with {values}" if values else ""
    raise SimulationProblem(Diagnostic("simulate.not-finite", message, crossing.span, names, hint))


class EventGuard:
    """Counts events, and tells an accumulation (Zeno behaviour) from many events.

    The run-time in C does the same in the same arrays.
    """

    def __init__(self, system: CausalSystem, span: float) -> None:
        self.count = 0
        """Stops at which something happened."""
        self.stops = 0
        self.shortest = ZENO_SHARE * span
        """So many stops as are remembered within this time are an accumulation."""
        self.resolved = RESOLVED * min(span, 1.0)
        """So are some whose distances shrink below this time."""
        self.recent = np.zeros(RECENT)
        """When the last stops were, in turn."""
        width = len(system.events) + len(system.discrete.unknowns)
        self.involved = np.zeros((RECENT, width), np.uint8)
        self.tally = np.zeros(width, np.int64)
        """Events that each mode and discrete value took part in."""
        self.system = system

    def add(self, time: float, changed: NDArray[np.bool_], happened: bool) -> None:
        """Notes one stop, which modes and discrete values were involved, and whether it was an event.

        Raises `SimulationProblem` (`simulate.zeno`) where they accumulate.
        """
        place = self.stops % RECENT
        self.count += happened
        self.stops += 1
        self.recent[place], self.involved[place] = time, changed
        if happened:
            self.tally += changed
        if self._is_dense() or self._shrinks():
            raise self.crowded()

    def _times(self) -> Vector:
        """Of the stops that are remembered, in order."""
        count = min(self.stops, RECENT)
        return self.recent[np.arange(self.stops - count, self.stops) % RECENT]

    def _is_dense(self) -> bool:
        times = self._times()
        return len(times) == RECENT and bool(times[-1] - times[0] <= self.shortest)

    def _shrinks(self) -> bool:
        """Whether the time between stops goes to zero like a geometric series, and has all but got there."""
        if self.stops < SHRINKING:
            return False
        times = self._times()[-SHRINKING:]
        pairs = times[2:] - times[:-2]
        if not pairs[-1] <= min(self.resolved, 1e-2 * pairs[0]):
            return False
        return bool((pairs[1:] <= pairs[:-1]).all())

    def crowded(self) -> SimulationProblem:
        """The stops that are remembered are an accumulation."""
        system, times = self.system, self._times()
        involved = [bool(column.any()) for column in self.involved[: len(times)].T]
        own, samples = system.events, system.discrete.samples
        crossings = [c for c, on in zip(own, involved, strict=False) if on]
        variables = [a for a, on in zip(system.discrete.assignments, involved[len(own) :], strict=True) if on]
        what = "the conditions " + some([crossing_text(crossing) for crossing in crossings])
        hint = "the time between events shrinks to zero (Zeno): add a hysteresis, a dwell time or damping"
        if not crossings and variables:
            what = "changes of " + some([leaf_name(a.unknown) for a in variables])
        elif not crossings and samples:
            what = some([f"`{to_text(node)}`" for node in samples])
            hint = "the interval is too short beside the simulated time"
        dense = f"{len(times)} within {times[-1] - times[0]:.3g} s"
        if not self._is_dense():
            dense = f"the last of {len(times)} are only {times[-1] - times[-2]:.3g} s apart"
        message = f"events accumulate {at(float(times[-1]))}: {dense}, all by {what}"
        names = symbols([*(c.relation for c in crossings), *(a.unknown for a in variables)])
        spans = [*(c.span for c in crossings), *(a.equation.flat.span for a in variables)]
        if not spans:
            spans = [span_of(system, node) for node in samples] or [system.flat.span]
            names = symbols(samples)
        return SimulationProblem(Diagnostic("simulate.zeno", message, spans[0], names, hint))
