"""Which state holds the solver back: every state's share in the error estimates that set the step size."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from acausal.simulate.solver import Solver


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
