"""Solves one implicit block by robust methods, or says why it cannot be solved."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from acausal.codegen.linear import CONSISTENT
from acausal.codegen.program import ImplicitCode
from acausal.errors import AcausalError, SimulationProblem
from acausal.simulate import continuation, newton
from acausal.simulate.bracketing import bracketed
from acausal.simulate.call import call, residual_and_jacobian
from acausal.simulate.matrices import (
    Matrix,
    Vector,
    dependent_rows,
    is_finite,
    minimum_norm,
    row_sums,
    scaled,
    solve_regular,
)
from acausal.simulate.messages import block_problem, leaf_name, number, some, values_text
from acausal.symbolic.causal import Block, BlockKind
from acausal.symbolic.expressions.expr import Expr


@dataclass(frozen=True)
class Walk:
    """How to solve: `kind` of error to raise, nominal values and first guesses (by text), and the time.

    `local`: a few Newton iterations from the guess only, as a step along a path may take.
    """

    kind: type[AcausalError]
    time: float
    nominal: dict[Expr, float]
    guess: dict[str, float]
    local: bool = False


_LOCAL = newton.BRIEF
"""Newton iterations of a step along a path."""


def solve_block(code: ImplicitCode, known: Vector, how: Walk) -> tuple[Vector, bool]:
    """The tearing variables, and whether a homotopy was needed. Raises `how.kind` naming the block."""
    nominal = np.array([how.nominal.get(leaf, 1.0) for leaf in code.block.tearing])
    if code.block.kind is BlockKind.LINEAR:
        return _linear(code, known, nominal, how), False
    return _nonlinear(code, known, nominal, how)


def _linear(code: ImplicitCode, known: Vector, nominal: Vector, how: Walk) -> Vector:
    """The solution; of a singular system the one of minimum norm in units of nominal values."""
    residual, jacobian = residual_and_jacobian(code.residual, np.zeros(len(nominal)), known)
    if not (np.isfinite(residual).all() and is_finite(jacobian)):
        rows = [i for i, value in enumerate(residual) if not np.isfinite(value)]
        raise _problem(code.block, rows, how, "not-finite", "not a number in a system of equations", "")
    sums = row_sums(jacobian, nominal)
    rows = np.where(sums > 0, sums, 1.0)
    matrix = scaled(jacobian, rows, nominal)
    z = solve_regular(matrix, -residual / rows)
    if z is not None:
        return z * nominal
    z = minimum_norm(matrix, -residual / rows) * nominal
    terms = call(code.terms, np.zeros(len(nominal)), known)[0].ravel() + row_sums(jacobian, np.abs(z))
    off = np.abs(residual + np.asarray(jacobian @ z))
    if np.all(off <= CONSISTENT * terms):
        return z
    raise singular(
        code.block, dependent_rows(matrix) or (), how, list(zip(code.reads, known.tolist(), strict=True))
    )


def singular(
    block: Block, dependent: tuple[int, ...], how: Walk, known: Sequence[tuple[Expr, float]] = ()
) -> AcausalError:
    """The error for equations that depend on each other and have no common solution at the `known` values."""
    why = (
        "these equations depend on each other and contradict each other at this point: "
        "look for a missing reference, a zero gain, or two ideal elements that fight"
        if block.size > 1
        else "the coefficient of its unknown is zero here, and the rest of the equation is not"
    )
    given = values_text([(leaf, value) for leaf, value in known if leaf.op in ("sym", "der")])
    hint = f"{why}; with {given}" if given else why
    return _problem(block, list(dependent), how, "singular-block", "a system of equations is singular", hint)


def _nonlinear(code: ImplicitCode, known: Vector, nominal: Vector, how: Walk) -> tuple[Vector, bool]:
    block = code.block
    start = np.array([how.guess.get(leaf_name(leaf), 0.0) for leaf in block.tearing])

    def system(z: Vector) -> tuple[Vector, Matrix]:
        return residual_and_jacobian(code.residual, z, known)

    brief = how.local or (len(start) == 1 and how.kind is SimulationProblem)  # looking around is better then
    solution = newton.solve(system, start, nominal, _LOCAL if brief else newton.MAX_ITERATIONS)
    if solution.converged:
        return solution.z, False
    continued = None if how.local else _otherwise(system, start, nominal, how)
    if continued is not None:
        return continued.z, True
    residual, jacobian = system(solution.z)
    dependent = newton.null_rows(jacobian, solution.z, nominal)
    if dependent is not None and len(dependent) > 1:
        raise singular(block, dependent, how)
    raise _unsolved(block, solution, residual, start, how)


def _otherwise(system: newton.System, start: Vector, nominal: Vector, how: Walk) -> newton.Solution | None:
    """By a homotopy, or for one unknown by looking around: that first in a run, where a branch may end."""
    ways = [lambda: continuation.follow(system, start, nominal)]
    if len(start) == 1:
        ways.insert(0 if how.kind is SimulationProblem else 1, lambda: bracketed(system, start, nominal))
    return next((found for way in ways if (found := way()) is not None), None)


def _unsolved(
    block: Block, solution: newton.Solution, residual: Vector, start: Vector, how: Walk
) -> AcausalError:
    """Names the unknowns with the values last tried, and the equations that are off most."""
    size = np.abs(np.nan_to_num(solution.scaled, nan=np.inf, posinf=1e300))
    worst = [int(i) for i in np.argsort(-size, kind="stable")[:3]]
    began = values_text(zip(block.tearing, start.tolist(), strict=True))
    ended = values_text(zip(block.tearing, solution.z.tolist(), strict=True))
    off = some([number(float(residual[i])) for i in worst])
    return _problem(
        block,
        worst,
        how,
        "no-solution",
        f"found no solution of a nonlinear block (off by {off} at {ended})",
        f"the search began at {began}: give better start values, or check that a solution exists",
    )


def _problem(block: Block, rows: list[int], how: Walk, code: str, what: str, hint: str) -> AcausalError:
    return block_problem(how.kind, f"simulate.{code}", what, block, how.time, rows, hint)
