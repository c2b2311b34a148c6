"""What the event loop asks of an integrator. CVODE is the first; one-step methods fit the same protocol."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from acausal.simulate.evaluator import Evaluator
from acausal.simulate.matrices import Vector


@dataclass(frozen=True)
class Arrival:
    """Where `advance` stopped: at the target, or before it because zero crossings were located.

    `crossed` has one entry per crossing: +1 rising, -1 falling, 0 not; None when the target was reached.
    """

    time: float
    x: Vector
    crossed: NDArray[np.int_] | None = None


@dataclass(frozen=True)
class Work:
    """Cost so far."""

    steps: int
    rhs_evaluations: int
    jacobian_evaluations: int

    def __add__(self, other: Work) -> Work:
        return Work(
            self.steps + other.steps,
            self.rhs_evaluations + other.rhs_evaluations,
            self.jacobian_evaluations + other.jacobian_evaluations,
        )


@dataclass(frozen=True)
class Tolerances:
    """Relative tolerance, absolute tolerances of the states, step limits (0: none), simulated time."""

    rtol: float
    atol: Vector
    min_step: float
    max_step: float
    max_steps: int
    span: float = 1.0


class Solver(Protocol):
    """An integrator over an evaluator's derivatives."""

    @property
    def work(self) -> Work: ...

    def restart(self, time: float, x: Vector) -> None:
        """Begin anew at this point (after an event)."""
        ...

    def advance(self, target: float, stop: float) -> Arrival:
        """Integrate to `target`, never evaluating beyond `stop`; stop early at zero crossings."""
        ...


SolverFactory = Callable[[Evaluator, Tolerances], Solver]
