"""What the event loop asks of an integrator. CVODE is the first; one-step methods fit the same protocol."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from acausal.simulate.cruise import Cruise
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.events import EventGuard
from acausal.simulate.matrices import Vector
from acausal.simulate.schedule import Schedule
from acausal.simulate.settle import Settling

BATCH = 20_000
"""Steps that a solver may take before its pace is judged."""
SLOW_BATCHES = 4
"""So many batches in a row at a pace at which `max_steps` do not cover the run: the step size collapsed."""


@dataclass(frozen=True)
class Arrival:
    """Where `advance` stopped: at the target, or before it because zero crossings were located.

    `crossed` has one entry per crossing: +1 rising, -1 falling, 0 not; None when the target was reached.
    """

    time: float
    x: Vector
    crossed: NDArray[np.int_] | None = None


@dataclass(frozen=True)
class Sweep:
    """Where `sweep` stopped: at an event (`crossed`), at `until` (`is_there`), or on the way.

    `rows` are the outputs at `times`. If the last row `is_suspect`, `time` and `x` are its point: there an
    assertion is violated, or something is not finite.
    """

    time: float
    x: Vector
    crossed: NDArray[np.int_] | None
    times: Vector
    rows: Vector
    is_suspect: bool
    is_there: bool
    taken: int
    """How many of the targets are passed: between their rows are those of events that were handled."""
    is_crowded: bool = False
    """The events that were handled accumulate."""


@dataclass(frozen=True)
class Influence:
    """Per state: summed share of the squared error estimate, failures of the error test, other failures."""

    share: Vector
    error_failures: NDArray[np.int64]
    convergence_failures: NDArray[np.int64]


@dataclass(frozen=True)
class Work:
    """Cost so far. `compiling`: CPU seconds that are no part of it; `longest`: a fixed step's wall time."""

    steps: int
    rhs_evaluations: int
    jacobian_evaluations: int
    rejected: int = 0
    factorisations: int = 0
    compiling: float = 0.0
    longest: float = 0.0

    def __add__(self, other: Work) -> Work:
        return Work(
            self.steps + other.steps,
            self.rhs_evaluations + other.rhs_evaluations,
            self.jacobian_evaluations + other.jacobian_evaluations,
            self.rejected + other.rejected,
            self.factorisations + other.factorisations,
            self.compiling + other.compiling,
            max(self.longest, other.longest),
        )


@dataclass(frozen=True)
class Tolerances:
    """Relative tolerance, absolute tolerances of the states, step limits (0: none), simulated time.

    For solvers with dense output: `sample`, how often roots are looked at (s). For fixed steps: `step` (s),
    counted from `start`, and whether crossings are to `locate` inside a step. Steps of variable length that
    only `max_step` keeps short end at multiples of `step` after `start` (0: anywhere).
    """

    rtol: float
    atol: Vector
    min_step: float
    max_step: float
    max_steps: int
    span: float = 1.0
    start: float = 0.0
    sample: float = 0.0
    step: float = 0.0
    locate: bool = True


class Solver(Protocol):
    """An integrator over an evaluator's derivatives."""

    @property
    def work(self) -> Work: ...

    @property
    def influence(self) -> Influence | None:
        """What every state did to the step size; None where the integrator does not say."""
        ...

    def restart(self, time: float, x: Vector) -> None:
        """Begin anew at this point (after an event)."""
        ...

    def advance(self, target: float, stop: float) -> Arrival:
        """Integrate to `target`, never evaluating beyond `stop`; stop early at zero crossings."""
        ...


@runtime_checkable
class Sweeper(Solver, Protocol):
    """A `Solver` that writes outputs on the way, without stopping for them."""

    def sweep(self, targets: Vector, until: float) -> Sweep:
        """Integrate to `until` at most, writing outputs at the increasing `targets`."""
        ...

    def handle(
        self, settling: Settling, schedule: Schedule, guard: EventGuard, ahead: float
    ) -> Cruise | None:
        """Handle events on the way, if that can be done."""
        ...


SolverFactory = Callable[[Evaluator, Tolerances], Solver]
