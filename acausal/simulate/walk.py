"""Evaluates a program piece by piece, with robust solvers and exact messages.

Slower than the stitched Functions by orders of magnitude, so it runs once at the start, and again when the
integrator's Functions return something that is not a number: then it names the block or equation.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from acausal.codegen.program import ExplicitCode, Program, implicit_code
from acausal.codegen.segments import Segment
from acausal.errors import AcausalError, InitializationProblem, fail
from acausal.simulate.block_solvers import Walk, singular, solve_block
from acausal.simulate.call import call
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import at, leaf_name, shown, values_text
from acausal.symbolic.causal import Assignment, Block
from acausal.symbolic.describe import quoted
from acausal.symbolic.expressions.expr import Expr, postorder, unknown_leaves


@dataclass(frozen=True)
class Walked:
    """The values of all slots, and the blocks that needed a homotopy."""

    values: Vector
    continued: tuple[Block, ...] = ()


def walk(program: Program, inputs: Vector, how: Walk) -> Walked:
    """All slots' values, given those of the inputs. Raises `how.kind` naming what cannot be computed."""
    slots = program.slots
    values = np.full(len(slots), np.nan)
    values[: len(inputs)] = inputs
    continued: list[Block] = []
    for code in program.codes:
        known = values[[slots[leaf] for leaf in code.reads]]
        targets = [slots[leaf] for leaf in code.writes]
        if isinstance(code, ExplicitCode):
            values[targets] = call(code.run, known)[0].ravel()
        else:
            z, homotopy = solve_block(code, known, how)
            values[targets] = np.concatenate([z, call(code.rest, z, known)[0].ravel()])
            continued += [code.block] if homotopy else []
        if not np.isfinite(values[targets]).all():
            raise _not_finite(code.segment, values, slots, how)
    return Walked(values, tuple(continued))


def _not_finite(segment: Segment, values: Vector, slots: dict[Expr, int], how: Walk) -> AcausalError:
    """Names the first unknown of the run that is not a number, its equation and the values that went in."""
    for block in segment.blocks:
        bad = {unknown for unknown in block.unknowns if not np.isfinite(values[slots[unknown]])}
        if bad and not bad.isdisjoint(block.tearing):
            return _bad_linear(block, values, slots, how)
        for assignment in block.assignments:
            if assignment.unknown in bad:
                return not_finite(assignment, values, slots, how)
    raise AssertionError("called with a value that is not finite")


def _bad_linear(block: Block, values: Vector, slots: dict[Expr, int], how: Walk) -> AcausalError:
    """The error of a small linear block: made a piece of its own, it is solved by the robust method."""
    code = implicit_code(Segment((block,), True), slots, "failed")
    try:
        solve_block(code, values[[slots[leaf] for leaf in code.reads]], how)
    except AcausalError as error:
        return error
    return singular(block, tuple(range(len(block.residuals))), how)


def _divisors(value: Expr) -> Iterator[Expr]:
    """The symbols that an expression is divided by."""
    for node in postorder([value]):
        if node.op == "div":
            stack = [node.args[1]]
            while stack:
                factor = stack.pop()
                if factor.op in ("mul", "neg"):
                    stack += factor.args
                elif factor.op == "sym":
                    yield factor


def not_finite(assignment: Assignment, values: Vector, slots: dict[Expr, int], how: Walk) -> AcausalError:
    """The error for one assignment whose value is not a number or infinite."""
    unknown, equation = assignment.unknown, assignment.equation
    value = values[slots[unknown]]
    inputs = [leaf for leaf in unknown_leaves(assignment.value) if leaf in slots]
    given = values_text([(leaf, float(values[slots[leaf]])) for leaf in inputs])
    zeros = [
        leaf_name(leaf) for leaf in _divisors(assignment.value) if leaf in slots and not values[slots[leaf]]
    ]
    lost = (
        f"the equation does not determine {leaf_name(unknown)} while {quoted(zeros)} is zero; "
        if zeros
        else ""
    )
    what = "not a number" if np.isnan(value) else "infinite"
    system = "initial" if how.kind is InitializationProblem else "running"
    return fail(
        how.kind,
        "simulate.not-finite",
        f"{leaf_name(unknown)} is {what} {at(how.time)} in the {system} system, "
        f"computed from `{shown(equation)}`",
        equation.flat.span,
        names=[leaf_name(unknown), *map(leaf_name, inputs)],
        hint=lost + (f"with {given}" if given else ""),
    )
