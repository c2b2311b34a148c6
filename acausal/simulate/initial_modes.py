"""Which modes hold at the start: those that agree with the solution of the initial problem in these modes.

Tried in turn, each bounded: from the modes that the start values suggest, all conditions updated together;
the same from all false; from the start values again, but changing only the first condition that disagrees
(Murty's least-index rule for complementarity problems, 1974, which ends for networks of diodes and valves
where updating all at once goes round in circles).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from acausal.codegen.functions import Code
from acausal.errors import AcausalError, InitializationProblem, fail
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import crossing_text, some
from acausal.simulate.walk import Walked
from acausal.symbolic.expressions.expr import symbols

MAX_ITERATIONS = 50
_PER_MODE = 4

Solve = Callable[[Vector], Walked]
"""The initial problem's solution in given modes; raises `InitializationProblem` where there is none."""
Wanted = Callable[[Vector, Vector], Vector]
"""The modes that the solution asks for, from the present modes and the values."""


@dataclass(frozen=True)
class _Attempt:
    """How one search went: its result, or the modes that came round again, or an error."""

    found: tuple[Walked, Vector] | None = None
    circle: list[Vector] = field(default_factory=list[Vector])
    error: AcausalError | None = None


def consistent_modes(code: Code, suggested: Vector, solve: Solve, wanted: Wanted) -> tuple[Walked, Vector]:
    """The solution and its modes. Raises `InitializationProblem` naming the conditions that do not settle."""
    none = np.zeros(len(suggested))
    if not suggested.size:
        return solve(none), none
    failed: list[_Attempt] = []
    for start, one_by_one in ((suggested, False), (none, False), (suggested, True), (none, True)):
        attempt = _search(start, one_by_one, solve, wanted)
        if attempt.found is not None:
            return attempt.found
        failed.append(attempt)
    circles = [attempt.circle for attempt in failed if attempt.circle]
    if circles:
        raise _no_modes(code, circles[-1])
    errors = [attempt.error for attempt in failed if attempt.error is not None]
    raise errors[0]


def _search(start: Vector, one_by_one: bool, solve: Solve, wanted: Wanted) -> _Attempt:
    modes = start.copy()
    visited: list[Vector] = []
    for _ in range(MAX_ITERATIONS + (_PER_MODE * len(start) if one_by_one else 0)):
        try:
            walked = solve(modes)
        except InitializationProblem as error:
            return _Attempt(error=error)
        following = wanted(modes, walked.values)
        if np.array_equal(following, modes):
            return _Attempt((walked, modes))
        visited.append(modes)
        if one_by_one:
            first = int(np.flatnonzero(following != modes)[0])
            following = np.where(np.arange(len(modes)) == first, following, modes)
        again = [i for i, seen in enumerate(visited) if np.array_equal(seen, following)]
        if again:
            return _Attempt(circle=visited[again[0] :])
        modes = following
    return _Attempt(circle=visited)


def _no_modes(code: Code, circle: list[Vector]) -> AcausalError:
    changing = np.any(np.array(circle) != circle[0], axis=0) if len(circle) > 1 else circle[0] >= 0
    crossings = [c for c, changes in zip(code.system.zero_crossings, changing, strict=True) if changes]
    texts = some([crossing_text(crossing) for crossing in crossings])
    return fail(
        InitializationProblem,
        "initialize.mode-cycle",
        f"no consistent initial modes: the conditions {texts} switch back and forth",
        crossings[0].span,
        names=symbols([crossing.relation for crossing in crossings]),
        hint="change start values so that the conditions are decided, or add a hysteresis",
    )
