"""Which modes hold at the start: those that agree with the solution of the initial problem in these modes.

The discrete values follow: in every pass they are evaluated with the new modes, until neither changes.

Tried in turn, each bounded: from the modes that the start values suggest, all conditions updated together;
the same from all false; from the start values again, but changing only the first condition that disagrees
(Murty's least-index rule for complementarity problems, 1974, which ends for networks of diodes and valves
where updating all at once goes round in circles). Ideal diodes that all conduct, or all block, may contradict
their sources: where equations do so in all of these, the discrete values are those that the modes imply, and
the search begins at every assignment of up to `_FEW` modes.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import product
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from acausal.codegen.functions import Code
from acausal.errors import AcausalError, InitializationProblem, fail
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import crossing_text, leaf_name, some
from acausal.simulate.walk import Walked
from acausal.symbolic.expressions.expr import symbols

MAX_ITERATIONS = 50
_PER_MODE = 4
_FEW = 6
_EQUAL = 1e-9


@dataclass(frozen=True)
class Switched:
    """Modes and frozen values."""

    m: Vector
    d: Vector

    def agrees(self, other: Switched) -> bool:
        """Whether both are the same but for rounding."""
        return np.array_equal(self.m, other.m) and same_values(self.d, other.d)


class Problem(Protocol):
    """What the search asks of the initial problem."""

    def solve(self, switched: Switched) -> Walked:
        """The solution with these modes and frozen values; `InitializationProblem` where there is none."""
        ...

    def implied(self, modes: Vector) -> Switched:
        """These modes with the discrete values that follow from them and the start values."""
        ...

    def modes(self, switched: Switched, values: Vector) -> Vector:
        """The modes that the solution asks for."""
        ...

    def frozen(self, switched: Switched, values: Vector) -> Vector:
        """The discrete values that follow from the solution with the modes that it asked for."""
        ...


@dataclass(frozen=True)
class _Attempt:
    """How one search went: its result, or what came round again, or an error."""

    found: tuple[Walked, Switched] | None = None
    circle: list[Switched] = field(default_factory=list[Switched])
    error: AcausalError | None = None


def same_values(a: Vector, b: Vector) -> bool:
    """Equal to 1e-9: discrete Reals that come from an iteration differ by rounding."""
    if bool((a == b).all()):
        return True
    return bool(np.all((a == b) | (np.abs(a - b) <= _EQUAL * np.maximum(np.abs(a), np.abs(b)))))


def consistent_modes(code: Code, suggested: Switched, problem: Problem) -> tuple[Walked, Switched]:
    """The solution, its modes and frozen values.

    Raises `InitializationProblem` naming the conditions and discrete variables that do not settle.
    """
    if not suggested.m.size and not suggested.d.size:
        return problem.solve(suggested), suggested
    none = Switched(np.zeros(len(suggested.m)), suggested.d)
    failed: list[_Attempt] = []
    for start, one_by_one in ((suggested, False), (none, False), (suggested, True), (none, True)):
        attempt = _search(start, one_by_one, problem)
        if attempt.found is not None:
            return attempt.found
        failed.append(attempt)
    if all(_contradicts(attempt.error) for attempt in failed):
        for modes in _beginnings(suggested.m):
            attempt = _search(problem.implied(modes), False, problem)
            if attempt.found is not None:
                return attempt.found
    circles = [attempt.circle for attempt in failed if attempt.circle]
    if circles:
        raise _no_modes(code, circles[-1])
    errors = [attempt.error for attempt in failed if attempt.error is not None]
    raise errors[0]


def _contradicts(error: AcausalError | None) -> bool:
    """Whether equations of these modes have no common solution."""
    return error is not None and error.diagnostics[0].code == "simulate.singular-block"


def _beginnings(suggested: Vector) -> Iterator[Vector]:
    """Modes to begin the search from: the suggested ones, all true, then every assignment of a few."""
    count = len(suggested)
    yield suggested
    yield np.ones(count)
    if count <= _FEW:
        for modes in product((1.0, 0.0), repeat=count):
            yield np.array(modes)


def _search(start: Switched, one_by_one: bool, problem: Problem) -> _Attempt:
    present = start
    visited: list[Switched] = []
    for _ in range(MAX_ITERATIONS + (_PER_MODE * len(start.m) if one_by_one else 0)):
        try:
            walked = problem.solve(present)
        except InitializationProblem as error:
            return _Attempt(error=error)
        modes = problem.modes(present, walked.values)
        different = np.flatnonzero(modes != present.m)
        if one_by_one and different.size:
            modes = np.where(np.arange(len(modes)) == different[0], modes, present.m)
        following = Switched(modes, present.d)
        following = Switched(modes, problem.frozen(following, walked.values))
        if following.agrees(present):
            return _Attempt((walked, present))
        visited.append(present)
        again = [i for i, seen in enumerate(visited) if seen.agrees(following)]
        if again:
            return _Attempt(circle=visited[again[0] :])
        present = following
    return _Attempt(circle=visited)


def _no_modes(code: Code, circle: list[Switched]) -> AcausalError:
    changing = moving([switched.m for switched in circle])
    crossings = [c for c, changes in zip(code.system.zero_crossings, changing, strict=True) if changes]
    frozen = zip(code.system.discrete.frozen, moving([switched.d for switched in circle]), strict=True)
    variables = [leaf_name(leaf) for leaf, changes in frozen if changes]
    texts = [f"the conditions {some([crossing_text(c) for c in crossings])}"] if crossings else []
    texts += [f"the discrete values {some(variables)}"] if variables else []
    return fail(
        InitializationProblem,
        "initialize.mode-cycle",
        f"no consistent initial modes: {' and '.join(texts)} switch back and forth",
        crossings[0].span if crossings else code.system.flat.span,
        names=[*symbols([crossing.relation for crossing in crossings]), *variables],
        hint="change start values so that the conditions are decided, or add a hysteresis",
    )


def moving(visited: list[Vector]) -> NDArray[np.bool_]:
    """Which entries changed; all where there is one vector only."""
    if len(visited) == 1:
        return np.ones(len(visited[0]), dtype=np.bool_)
    return np.any(np.array(visited) != visited[0], axis=0)
