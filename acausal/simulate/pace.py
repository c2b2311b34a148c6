"""Whether a run gets on: a step size that collapses is noticed long before all steps are used up."""

from __future__ import annotations

from acausal.simulate.solver import BATCH, SLOW_BATCHES, Tolerances


class Pace:
    """The pace of one run, judged now and then."""

    def __init__(self, limits: Tolerances) -> None:
        self._limits = limits
        self._judged, self._slow = (0, limits.start), 0

    def is_hopeless(self, steps: int, time: float) -> bool:
        """Whether at the pace of the last batches of steps the run would need more than are allowed."""
        limits = self._limits
        if steps - self._judged[0] < BATCH:
            return False
        progress = time - self._judged[1]
        hopeless = progress * limits.max_steps < limits.span * (steps - self._judged[0])
        self._judged = steps, time
        self._slow = self._slow + 1 if hopeless else 0
        return self._slow >= SLOW_BATCHES
