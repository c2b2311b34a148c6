"""Which state holds the solver back: every state's share in the error estimates that set the step size."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acausal.errors import Span
from acausal.simulate.messages import leaf_name
from acausal.simulate.solver import Solver
from acausal.symbolic.causal import CausalSystem
from acausal.symbolic.expressions.text import to_text


@dataclass(frozen=True)
class StateCost:
    """`influence` is the share of all states' squared, scaled error estimates, over all attempted steps.

    `error_failures` counts the refused steps in which this state's error was the largest,
    `convergence_failures` the steps that could not be computed while it moved fastest.
    """

    state: str
    influence: float
    error_failures: int
    convergence_failures: int


@dataclass(frozen=True)
class EventCost:
    """The events that a condition or a discrete variable took part in; one event may be of several."""

    what: str
    events: int
    span: Span


def event_costs(system: CausalSystem, tally: NDArray[np.int64]) -> tuple[EventCost, ...]:
    """Most events first. `tally` is of the model's conditions and then its discrete variables."""
    crossings = [(to_text(crossing.relation), crossing.span) for crossing in system.events]
    variables = [(leaf_name(a.unknown), a.equation.flat.span) for a in system.discrete.assignments]
    counted = zip((*crossings, *variables), tally.tolist(), strict=True)
    found = [EventCost(what, count, span) for (what, span), count in counted if count]
    return tuple(sorted(found, key=lambda cost: -cost.events))


class Costs:
    """Sums over the solvers of one run, whose states may differ."""

    def __init__(self) -> None:
        self._sums: dict[str, tuple[float, int, int]] = {}

    def add(self, solver: Solver | None, states: tuple[str, ...]) -> None:
        """Takes what a solver has to say, if it says anything."""
        found = solver.influence if solver is not None else None
        if found is None:
            return
        columns = (found.share, found.error_failures, found.convergence_failures)
        for name, *new in zip(states, *(column.tolist() for column in columns), strict=True):
            share, errors, others = self._sums.get(name, (0.0, 0, 0))
            self._sums[name] = share + new[0], errors + int(new[1]), others + int(new[2])

    def states(self) -> tuple[StateCost, ...]:
        """Largest influence first; shares of the whole."""
        total = float(np.sum([share for share, _, _ in self._sums.values()])) or 1.0
        found = [StateCost(name, share / total, a, b) for name, (share, a, b) in self._sums.items()]
        return tuple(sorted(found, key=lambda cost: (-cost.influence, cost.state)))
