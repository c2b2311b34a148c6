"""Continuation from the simplified expressions of `homotopy` to the actual ones, for the initial problem.

The blended model (`symbolic.homotopy`) is compiled when it is first needed. Its initial problem is solved at
lambda = 0, where only the simplified expressions count, and followed to lambda = 1 in steps that double after
a success and halve after a failure; every step starts from the values and modes of the one before and takes
few Newton iterations, so that it stays on its branch (Sielemann et al., "Robust initialization of
differential-algebraic equations using homotopy", Modelica Conference 2011). Steps are bounded in number and
in length. What is found is where the search for the actual solution starts again.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from acausal.codegen.functions import Code, generate
from acausal.errors import AcausalError, Diagnostic, InitializationProblem
from acausal.simulate.initial_modes import Switched
from acausal.simulate.walk import Walked
from acausal.symbolic.causalise import causalise
from acausal.symbolic.describe import equation_with_place, listed
from acausal.symbolic.expressions.evaluate import EvaluationFailed, NotConstant, evaluate
from acausal.symbolic.expressions.text import to_text
from acausal.symbolic.homotopy import LAMBDA, blended, homotopy_equations

MAX_STEPS = 100
_FIRST, _LONGEST, _SHORTEST = 0.1, 0.25, 1e-5


@dataclass(frozen=True)
class PathPoint:
    """A solution of the blended initial problem."""

    walked: Walked
    switched: Switched


Solve = Callable[[float, PathPoint | None], PathPoint]
"""The solution at one lambda, starting from another one; raises `InitializationProblem`."""


@dataclass(frozen=True)
class Followed:
    """The end of the path: values by name, of relations and of frozen values, and the number of steps."""

    values: Mapping[str, float]
    switched: Mapping[object, float]
    steps: int


def compiled_blend(code: Code, error: InitializationProblem) -> Code:
    """The blended model as code. Raises `error` with the reason added where it cannot be compiled."""
    assert code.system.homotopy is not None
    try:
        return generate(causalise(blended(code.system.homotopy), unevaluated=(LAMBDA,)))
    except AcausalError as problem:
        reason = f"the simplified equations cannot be used: {problem.diagnostics[0].message}"
        raise _with(error, code, reason) from None


def follow(code: Code, blend: Code, solve: Solve, error: InitializationProblem) -> Followed:
    """From lambda = 0 to 1. Raises `error` with what stopped the continuation added."""
    try:
        point = solve(0.0, None)
    except InitializationProblem as problem:
        reason = f"the simplified equations have no solution either: {problem.diagnostics[0].message}"
        raise _with(error, code, reason) from None
    reached, step = 0.0, _FIRST
    for count in range(1, MAX_STEPS + 1):
        target = min(1.0, reached + step)
        try:
            point = solve(target, point)
        except InitializationProblem as problem:
            step /= 2
            if step < _SHORTEST:
                raise _with(error, code, _stopped(reached, count, problem)) from None
            continue
        reached, step = target, min(2 * step, _LONGEST)
        if reached >= 1.0:
            return Followed(_named(blend, point), _switched(blend, point), count)
    reason = (
        f"the continuation from the simplified equations was at {reached:.3g} of 1 after {MAX_STEPS} steps"
    )
    raise _with(error, code, reason)


def _stopped(reached: float, count: int, problem: InitializationProblem) -> str:
    return (
        f"the continuation from the simplified equations got to {reached:.3g} of 1 in {count} steps: "
        f"{problem.diagnostics[0].message}"
    )


def used(code: Code, error: InitializationProblem, steps: int) -> Diagnostic:
    """The report of a success."""
    return Diagnostic(
        "initialize.homotopy-operator",
        f"the initial values were found from the simplified equations in {steps} steps of `homotopy`, "
        f"because from the start values alone: {error.diagnostics[0].message}",
        error.diagnostics[0].span,
        error.diagnostics[0].names,
        "better start values make this unnecessary",
        "warning",
    )


def _with(error: InitializationProblem, code: Code, reason: str) -> InitializationProblem:
    assert code.system.homotopy is not None
    equations = homotopy_equations(code.system.homotopy)
    texts = listed([equation_with_place(e) for e in equations], 3)
    more = Diagnostic(
        "initialize.homotopy-failed",
        f"{reason} (homotopy in {texts})",
        equations[0].span if equations else code.system.flat.span,
        hint="choose simplified expressions that the start values can solve and that lead to the actual",
    )
    return InitializationProblem([*error.diagnostics, more])


def _switched(blend: Code, point: PathPoint) -> dict[object, float]:
    frozen = zip(blend.system.discrete.frozen, point.switched.d.tolist(), strict=True)
    return {**dict(zip(blend.relations, point.switched.m.tolist(), strict=True)), **dict(frozen)}


def _named(blend: Code, point: PathPoint) -> dict[str, float]:
    """All values by name, those of aliases too."""
    slots, values = blend.initial.slots, point.walked.values
    found = {to_text(leaf): float(values[slot]) for leaf, slot in slots.items() if leaf.op in ("sym", "der")}
    for alias in blend.system.aliases:
        try:
            value = evaluate(alias.value, found.get)
        except (NotConstant, EvaluationFailed):
            continue
        if isinstance(value, int | float):
            found[alias.name] = float(value)
    return found


def switched_like(code: Code, suggested: Switched, found: Mapping[object, float]) -> Switched:
    """What the path's end says of the relations and frozen values that both systems have."""
    frozen = code.system.discrete.frozen
    m = [found.get(relation, value) for relation, value in zip(code.relations, suggested.m, strict=True)]
    d = [found.get(leaf, value) for leaf, value in zip(frozen, suggested.d, strict=True)]
    return Switched(np.array(m), np.array(d))


def lambda_leaf_position(blend: Code) -> int:
    """Where the parameter lambda stands among the parameters."""
    return blend.system.parameters.index(LAMBDA)
