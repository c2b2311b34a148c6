"""Event iteration: which modes hold right after an instant.

At an instant a root `g = left - right` may be zero to rounding. Its relation then takes the value that it
has a moment later along the present derivatives, so that a solver started here moves away from the root
with the mode that fits, instead of sticking to it. Modes change algebraic variables and derivatives and so
other relations; they are updated together until nothing changes. Modes that come round again are an error
that names their conditions: the solution would slide along the switching surface, or has no consistent mode
at all.
"""

from __future__ import annotations

import operator
from collections import deque
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from acausal.errors import AcausalError, Diagnostic, SimulationProblem
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import at, crossing_text, some
from acausal.symbolic.causal import CausalSystem
from acausal.symbolic.expressions.expr import symbols

MAX_ITERATIONS = 50
_PER_MODE = 4
BAND = 1e-9
"""Relative to both sides' sizes: closer to zero than this, a root counts as zero."""
_NOISE = 1e-14
ZENO_EVENTS = 100
ZENO_SHARE = 1e-6
"""This many events within this share of the simulated time are an accumulation."""

_TRUE = {"lt": operator.lt, "le": operator.le, "gt": operator.gt, "ge": operator.ge}


def literal_modes(code_relations: tuple[str, ...], roots: Vector) -> Vector:
    """The relations' values from their roots alone."""
    return np.array([float(_TRUE[op](g, 0.0)) for op, g in zip(code_relations, roots, strict=True)])


def operators(system: CausalSystem) -> tuple[str, ...]:
    """The relations' operators, in the order of the modes."""
    return tuple(crossing.relation.op for crossing in system.zero_crossings)


def crossed_modes(ops: tuple[str, ...], modes: Vector, crossed: NDArray[np.int_]) -> Vector:
    """The modes after roots crossed zero in the given directions."""
    beyond = literal_modes(ops, crossed.astype(float))
    return np.where(crossed != 0, beyond, modes)


def settle_modes(
    evaluator: Evaluator, time: float, x: Vector, ahead: float, crossed: NDArray[np.int_] | None = None
) -> None:
    """Iterates the evaluator's modes to a fixed point at this instant, looking `ahead` by a small time.

    `crossed` marks the roots that brought the solver here: zero, whatever rounding left of them.
    Raises `SimulationProblem` (`simulate.mode-cycle`) where the modes do not settle.
    """
    system = evaluator.code.system
    ops = operators(system)
    evaluator.at(time, x)
    evaluator.settle()
    if not ops:
        return
    at_root = crossed != 0 if crossed is not None else np.zeros(len(ops), dtype=np.bool_)
    before = evaluator.m.copy()
    circle = _iterate(evaluator, (time, x, ahead, at_root), one_by_one=False)
    if circle:
        evaluator.m[:] = before
        evaluator.settle()
        circle = _iterate(evaluator, (time, x, ahead, at_root), one_by_one=True)
    if circle:
        raise _cycle(system, circle, time)


def _iterate(
    evaluator: Evaluator, instant: tuple[float, Vector, float, NDArray[np.bool_]], one_by_one: bool
) -> list[Vector]:
    """Updates the modes until they agree with the values; the modes that came round again if they do not.

    `one_by_one`: only the first condition that disagrees changes (Murty's least-index rule), which ends for
    networks of diodes and clutches where updating all at once goes round in circles.
    """
    visited: list[Vector] = []
    for _ in range(MAX_ITERATIONS + (_PER_MODE * len(evaluator.m) if one_by_one else 0)):
        wanted = _wanted(evaluator, *instant)
        different = np.flatnonzero(wanted != evaluator.m)
        if not different.size:
            return []
        if one_by_one:
            wanted = np.where(np.arange(len(wanted)) == different[0], wanted, evaluator.m)
        visited.append(evaluator.m.copy())
        again = [i for i, seen in enumerate(visited) if np.array_equal(seen, wanted)]
        if again:
            return visited[again[0] :]
        evaluator.m[:] = wanted
        evaluator.settle()
    return visited


def _wanted(evaluator: Evaluator, time: float, x: Vector, ahead: float, at_root: NDArray[np.bool_]) -> Vector:
    """The values that the relations have now, or a moment later where their root is zero."""
    ops = operators(evaluator.code.system)
    evaluator.event()
    evaluator.size()
    roots, sizes = evaluator.roots.copy(), evaluator.sizes.copy()
    _check(evaluator, roots, time)
    wanted = literal_modes(ops, roots)
    near = at_root | (np.abs(roots) <= BAND * sizes)
    if not near.any():
        return wanted
    evaluator.at(time + ahead, x + ahead * evaluator.xdot)
    evaluator.event()
    later = evaluator.roots.copy()
    evaluator.at(time, x)
    moved = near & (np.abs(later - roots) > _NOISE * sizes)
    still = near & ~moved & (roots != 0)
    wanted = np.where(moved, literal_modes(ops, later), wanted)
    return np.where(still, evaluator.m, wanted)


def _check(evaluator: Evaluator, roots: Vector, time: float) -> None:
    """A condition that is not a number has no side."""
    if np.isfinite(roots).all():
        return
    evaluator.explain()
    crossing = evaluator.code.system.zero_crossings[int(np.flatnonzero(~np.isfinite(roots))[0])]
    message = f"the condition {crossing_text(crossing)} cannot be decided {at(time)}: a side is not a number"
    raise SimulationProblem(
        Diagnostic("simulate.not-finite", message, crossing.span, symbols([crossing.relation]))
    )


def _cycle(system: CausalSystem, history: list[Vector], time: float) -> AcausalError:
    changing = np.ptp(np.array(history), axis=0) > 0 if len(history) > 1 else history[0] >= 0
    crossings = [c for c, changes in zip(system.zero_crossings, changing, strict=True) if changes]
    texts = some([crossing_text(crossing) for crossing in crossings])
    names = symbols([crossing.relation for crossing in crossings])
    message = f"the conditions {texts} switch back and forth {at(time)} and do not settle"
    hint = "the solution slides along the switching point: use a hysteresis or a continuous characteristic"
    return SimulationProblem(Diagnostic("simulate.mode-cycle", message, crossings[0].span, names, hint))


@dataclass
class EventGuard:
    """Counts events, and tells an accumulation (Zeno behaviour) from many events."""

    system: CausalSystem
    span: float
    count: int = 0
    _recent: deque[tuple[float, NDArray[np.bool_]]] = field(default_factory=lambda: deque(maxlen=ZENO_EVENTS))

    def add(self, time: float, changed: NDArray[np.bool_]) -> None:
        """Notes one event instant; raises `SimulationProblem` (`simulate.zeno`) where they accumulate."""
        self.count += 1
        self._recent.append((time, changed))
        if len(self._recent) < ZENO_EVENTS or time - self._recent[0][0] > ZENO_SHARE * self.span:
            return
        involved = np.any(np.array([c for _, c in self._recent]), axis=0)
        crossings = [c for c, on in zip(self.system.events, involved, strict=True) if on]
        texts = some([crossing_text(crossing) for crossing in crossings])
        first = self._recent[0][0]
        message = (
            f"events accumulate {at(time)}: {ZENO_EVENTS} within {time - first:.3g} s, "
            f"all by the conditions {texts}"
        )
        hint = "the time between events shrinks to zero (Zeno): add a hysteresis, a dwell time or damping"
        names = symbols([crossing.relation for crossing in crossings])
        raise SimulationProblem(Diagnostic("simulate.zeno", message, crossings[0].span, names, hint))
