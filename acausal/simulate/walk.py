"""Evaluates a program piece by piece, with a robust solver and exact messages.

Slower than the stitched Functions by orders of magnitude, so it runs once at the start, and again when the
integrator's Functions return something that is not a number: then it names the block or equation.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from casadi import Function

from acausal.codegen.program import ExplicitCode, ImplicitCode, Program
from acausal.errors import AcausalError, fail
from acausal.simulate import newton
from acausal.simulate.messages import at, block_problem, equation_text, leaf_name, values_text
from acausal.simulate.newton import Vector
from acausal.symbolic.causal import Assignment, Block, BlockKind
from acausal.symbolic.expressions.expr import Expr, unknown_leaves


@dataclass(frozen=True)
class Walk:
    """How to walk: `kind` of error to raise, nominal values and first guesses (by text), and the time."""

    kind: type[AcausalError]
    time: float
    nominal: dict[Expr, float]
    guess: dict[str, float]


def call(function: Function, *args: Vector) -> list[Vector]:
    """The outputs as dense arrays (slow; not for the integrator)."""
    return [np.asarray(out.full(), dtype=float) for out in function.call([np.asarray(a) for a in args])]


def walk(program: Program, inputs: Vector, how: Walk) -> Vector:
    """The values of all slots, given those of the inputs. Raises `how.kind` naming what cannot be computed."""
    slots = program.slots
    values = np.full(len(slots), np.nan)
    values[: len(inputs)] = inputs
    for code in program.codes:
        known = values[[slots[leaf] for leaf in code.reads]]
        targets = [slots[leaf] for leaf in code.writes]
        if isinstance(code, ExplicitCode):
            values[targets] = call(code.run, known)[0].ravel()
            if not np.isfinite(values[targets]).all():
                raise _not_finite(code, values, slots, how)
        else:
            z = _solve(code, known, how)
            values[targets] = np.concatenate([z, call(code.rest, z, known)[0].ravel()])
    return values


def _solve(code: ImplicitCode, known: Vector, how: Walk) -> Vector:
    block = code.block
    nominal = np.array([how.nominal.get(leaf, 1.0) for leaf in block.tearing])
    start = np.array([how.guess.get(leaf_name(leaf), 0.0) for leaf in block.tearing])

    def system(z: Vector) -> tuple[Vector, Vector]:
        residual, jacobian = call(code.residual, z, known)
        return residual.ravel(), jacobian

    if block.kind is BlockKind.LINEAR:
        start = np.zeros(len(start))
        dependent = newton.null_rows(system(start)[1], start, nominal)
        if dependent is not None:
            raise _singular(block, dependent, how)
    solution = newton.solve(system, start, nominal)
    if solution.converged:
        return solution.z
    residual, jacobian = system(solution.z)
    dependent = newton.null_rows(jacobian, solution.z, nominal)
    if dependent is not None:
        raise _singular(block, dependent, how)
    order = np.argsort(-np.abs(np.nan_to_num(solution.scaled, nan=np.inf, posinf=1e300)), kind="stable")
    guesses = values_text([(leaf, how.guess.get(leaf_name(leaf), 0.0)) for leaf in block.tearing])
    raise block_problem(
        how.kind,
        "simulate.no-solution",
        "found no solution of a nonlinear block",
        block,
        how.time,
        [int(i) for i in order[:3]],
        f"the search began at {guesses}: give better start values, or check that a solution exists",
    )


def _singular(block: Block, dependent: tuple[int, ...], how: Walk) -> AcausalError:
    return block_problem(
        how.kind,
        "simulate.singular-block",
        "a system of equations is singular",
        block,
        how.time,
        dependent,
        "these equations depend on each other for the present values; look for a missing reference or a zero gain",
    )


def _not_finite(code: ExplicitCode, values: Vector, slots: dict[Expr, int], how: Walk) -> AcausalError:
    """Names the first unknown of the run that is not a number, its equation and the values that went in."""
    for block in code.segment.blocks:
        bad = [unknown for unknown in block.unknowns if not np.isfinite(values[slots[unknown]])]
        if bad and block.kind is BlockKind.LINEAR:
            return _singular(block, tuple(range(len(block.residuals))), how)
        for assignment in block.assignments:
            if assignment.unknown in bad:
                return not_finite(assignment, values, slots, how)
    raise AssertionError("called with a value that is not finite")


def not_finite(assignment: Assignment, values: Vector, slots: dict[Expr, int], how: Walk) -> AcausalError:
    """The error for one assignment whose value is not a number or infinite."""
    unknown, equation = assignment.unknown, assignment.equation
    value = values[slots[unknown]]
    inputs = [leaf for leaf in unknown_leaves(assignment.value) if leaf in slots]
    given = values_text([(leaf, float(values[slots[leaf]])) for leaf in inputs])
    what = "not a number" if np.isnan(value) else "infinite"
    return fail(
        how.kind,
        "simulate.not-finite",
        f"{leaf_name(unknown)} is {what} {at(how.time)}, computed from '{equation_text(equation)}'",
        equation.flat.span,
        names=[leaf_name(unknown), *map(leaf_name, inputs)],
        hint=f"with {given}" if given else "",
    )
