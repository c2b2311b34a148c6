"""What a snapshot leaves out: events that are near, and relations that are frozen although they would switch.

A linearisation is valid as long as no relation changes. How long that is, to first order, follows from the
relation's root r (left minus right side) and its rate along the motion: t = -r / (dr/dt).
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

import numpy as np
from numpy.typing import NDArray

from acausal.analysis.linear import Matrix, state_matrix
from acausal.analysis.modes import Modes
from acausal.errors import SimulationProblem
from acausal.simulate.evaluator import Evaluator
from acausal.symbolic.describe import place
from acausal.symbolic.expressions.expr import symbols
from acausal.symbolic.expressions.text import to_text

MOST_TRIED = 64
"""Relations that are tried the other way round to explain a growing mode."""
_CHANGE = 1e-6
"""Of the states, relative, over which rates of roots are taken."""
_ZERO = 1e-9
_FOLLOWING = 10
_CLEARLY = 1e-9
"""A real part beyond this, relative to the largest eigenvalue, grows."""


@dataclass(frozen=True)
class Relation:
    """A relation that can switch: its text and place, whether it holds, and when it will change.

    `root` is left minus right side, `seconds` the time to its change if all goes on as now: 0 at the
    switching point, infinite where it moves away from it.
    """

    text: str
    where: str
    names: tuple[str, ...]
    holds: bool
    root: float
    seconds: float

    def to_json(self) -> dict[str, object]:
        return {
            "relation": self.text,
            "where": self.where,
            "holds": self.holds,
            "root": self.root,
            "seconds": None if self.seconds == inf else self.seconds,
        }


@dataclass(frozen=True)
class Growing:
    """A mode that grows, by its place among the modes, and the relations that, switched, would calm it."""

    mode: int
    states: tuple[str, ...]
    calmed_by: tuple[Relation, ...]


def relations(evaluator: Evaluator) -> tuple[Relation, ...]:
    """Every relation with its mode, in the model's order; the evaluator is settled and stays where it is."""
    system = evaluator.code.system
    own = system.events
    if not own:
        return ()
    seconds, roots = _seconds(evaluator)
    return tuple(
        Relation(
            to_text(crossing.relation),
            place(crossing.span),
            symbols([crossing.relation]),
            bool(evaluator.m[i]),
            float(roots[i]),
            float(seconds[i]),
        )
        for i, crossing in enumerate(own)
    )


def _seconds(e: Evaluator) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """When each root changes its sign, and the roots."""
    time, x, rates = float(e.t[0]), e.x.copy(), e.xdot.copy()
    roots, sizes = _roots(e)
    fastest = float(np.abs(rates / np.maximum(np.abs(x), e.x_nominal)).max(initial=0.0))
    h = min(_CHANGE / fastest if fastest > 0 else inf, 1e-3)
    e.at(time + h, x + h * rates)
    later = _roots(e)[0] if e.evaluate() else roots
    e.at(time, x)
    e.settle()
    slopes = (later - roots) / h
    crossings = e.code.system.zero_crossings
    above = np.array([crossing.relation.op in ("gt", "ge") for crossing in crossings], bool)
    side = np.where(above == (e.m != 0.0), 1.0, -1.0)  # that of the root as long as the mode holds
    with np.errstate(divide="ignore", invalid="ignore"):
        seconds = np.where(roots * slopes < 0, -roots / slopes, inf)
    seconds = np.where(np.abs(roots) <= _ZERO * sizes, np.where(side * slopes < 0, 0.0, inf), seconds)
    e.instant()
    timed = [i for i, crossing in enumerate(crossings) if crossing.instant is not None]
    ahead = e.instants - time
    seconds[timed] = np.where(np.isfinite(ahead) & (ahead > _ZERO * max(abs(time), 1e-300)), ahead, inf)
    return seconds, roots


def _roots(e: Evaluator) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    e.event()
    e.size()
    return e.roots.copy(), e.sizes.copy()


def growing(evaluator: Evaluator, found: Modes, known: tuple[Relation, ...]) -> tuple[Growing, ...]:
    """The modes that grow, one of each conjugate pair, and what is frozen that may be the reason.

    Each of up to `MOST_TRIED` relations is switched by itself; where fewer modes grow then, it is named.
    """
    which = [i for i, mode in enumerate(found.modes) if mode.grows and mode.eigenvalue.imag >= 0]
    if not which:
        return ()
    count = _growing_count(state_matrix(evaluator), evaluator.x_nominal)
    calming = tuple(known[i] for i in range(min(len(known), MOST_TRIED)) if _count(evaluator, i) < count)
    states = evaluator.code.system.states
    return tuple(Growing(i, found.modes[i].leading(states), calming) for i in which)


def _count(e: Evaluator, relation: int) -> int:
    """How many modes grow with one relation the other way round."""
    before, held, guess = e.m.copy(), e.d.copy(), e.guess.copy()
    e.m[relation] = 1.0 - e.m[relation]
    try:
        e.settle()
        _follow(e)
        count = _growing_count(state_matrix(e), e.x_nominal)
    except SimulationProblem:
        count = len(e.x) + 1
    e.m[:], e.d[:], e.guess[:] = before, held, guess
    e.settle()
    return count


def _follow(e: Evaluator) -> None:
    """Lets discrete variables follow from the modes, all else as it is."""
    unknowns = len(e.code.system.discrete.unknowns)
    for _ in range(_FOLLOWING if unknowns else 0):
        e.update()
        found = e.update.outputs[0]
        if np.array_equal(found, e.d[:unknowns]) or not np.isfinite(found).all():
            return
        e.d[:unknowns] = found
        e.settle()


def _growing_count(a: Matrix, scale: NDArray[np.float64]) -> int:
    if not np.isfinite(a).all():
        return len(a) + 1
    values = np.linalg.eigvals(a * scale / scale[:, None])
    return int((values.real > _CLEARLY * max(float(np.abs(values).max(initial=0.0)), 1e-300)).sum())
