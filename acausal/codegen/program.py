"""A program: blocks in order over named groups of inputs, and its pieces as Functions.

Every input and every unknown has one slot in a vector of values. `Program.codes` holds one Function per
segment: with them the run-time can walk the program piece by piece, which is how the initial problem is
solved and how a failing block is named. `stitch` joins the same pieces to single Functions for the
integrator.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from casadi import SX, Function

from acausal.codegen.casadi_expressions import FORWARD, jacobian
from acausal.codegen.linear import term_sizes
from acausal.codegen.scope import Scope, block_scope
from acausal.codegen.segments import Segment, cut, expressions, reads
from acausal.symbolic.causal import Block
from acausal.symbolic.expressions.expr import Expr

Groups = tuple[tuple[str, tuple[Expr, ...]], ...]
"""Input groups: name and leaves, in slot order."""


@dataclass(frozen=True)
class ExplicitCode:
    """`run(u) -> w`: the values of `writes` from those of `reads`."""

    segment: Segment
    reads: tuple[Expr, ...]
    writes: tuple[Expr, ...]
    run: Function


@dataclass(frozen=True)
class ImplicitCode:
    """One torn block: `residual(z, u) -> (r, J)` and, at its solution, `rest(z, u) -> w` of its assignments.

    `u` are the values of `reads`, `z` those of the tearing variables, `J = dr/dz` sparse and exact.
    """

    segment: Segment
    reads: tuple[Expr, ...]
    residual: Function
    rest: Function

    @property
    def block(self) -> Block:
        return self.segment.block

    @cached_property
    def terms(self) -> Function:
        """`(z, u) -> size`: of each residual, `sum_j |dr / du_j| |u_j|`. Made when first needed."""
        z, u = self.residual.sx_in()
        total = term_sizes(self.residual.call([z, u])[0], u)
        return Function("terms", [z, u], [total], ["z", "u"], ["size"], FORWARD)

    @property
    def writes(self) -> tuple[Expr, ...]:
        return self.block.unknowns


SegmentCode = ExplicitCode | ImplicitCode


@dataclass(frozen=True)
class Program:
    """`blocks` evaluated in order, knowing the leaves of `groups`."""

    groups: Groups
    blocks: tuple[Block, ...]
    label: str

    @cached_property
    def segments(self) -> tuple[Segment, ...]:
        return cut(self.blocks)

    @cached_property
    def unknowns(self) -> tuple[Expr, ...]:
        """All that the blocks determine, in slot order."""
        return tuple(unknown for segment in self.segments for unknown in segment.writes)

    @cached_property
    def slots(self) -> dict[Expr, int]:
        """Position of every input and unknown in the vector of values.

        An input that is an unknown too (a parameter with `fixed = false`) has one slot, which is overwritten.
        """
        leaves = dict.fromkeys(leaf for _, group in self.groups for leaf in group)
        return {leaf: slot for slot, leaf in enumerate(leaves | dict.fromkeys(self.unknowns))}

    @cached_property
    def guesses(self) -> tuple[Expr, ...]:
        """Tearing variables of the implicit blocks: with their values known, everything else is explicit."""
        return tuple(z for s in self.segments if s.implicit for z in s.block.tearing)

    @property
    def is_explicit(self) -> bool:
        """Whether one expression graph evaluates everything."""
        return not any(segment.implicit for segment in self.segments)

    @cached_property
    def codes(self) -> tuple[SegmentCode, ...]:
        """Each segment as Functions, made when first needed."""
        return tuple(
            implicit_code(segment, self.slots, f"{self.label}_{i}")
            if segment.implicit
            else explicit_code(segment, self.slots, segment.writes, f"{self.label}_{i}")
            for i, segment in enumerate(self.segments)
        )


def explicit_code(
    segment: Segment, slots: dict[Expr, int], writes: Sequence[Expr], name: str
) -> ExplicitCode:
    """The run of blocks as one SX Function."""
    known = reads(expressions(segment.blocks), slots, own=segment.writes)
    scope = Scope([("u", known)])
    scope.run(segment.blocks)
    run = scope.function(name, [("w", scope.column(writes))])
    return ExplicitCode(segment, known, tuple(writes), run)


def implicit_code(segment: Segment, slots: dict[Expr, int], name: str) -> ImplicitCode:
    """Residual, exact Jacobian and remaining assignments of one block."""
    block = segment.block
    known = reads(expressions([block]), slots, own=block.unknowns)
    z, u, scope = block_scope(block, known)
    residual = scope.column([r.value for r in block.residuals])
    rest = scope.column([a.value for a in block.assignments])
    outputs: list[SX] = [residual, jacobian(residual, z)]
    return ImplicitCode(
        segment,
        known,
        Function(f"{name}_residual", [z, u], outputs, ["z", "u"], ["r", "J"], FORWARD),
        Function(f"{name}_rest", [z, u], [rest], ["z", "u"], ["w"], FORWARD),
    )
