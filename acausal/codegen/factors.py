"""Linear blocks whose matrix no run changes: factored once, when the parameters are known.

The matrix of such a block consists of numbers and parameters. Its inverse is among the *factors* `w` of the
program, which a Function of the parameters gives; with them the block is solved by one product, `z = W b`.
Where the matrix is singular the factors are not-a-number, and so is the solution: then the run-time asks the
functions that solve blocks anew, which know about minimum norm.

Measured, derivatives with one block of n tearing variables, factored each time against once, microseconds on
the virtual machine and compiled: a ladder of resistors, n = 15: 5.7 -> 1.7 and 1.1 -> 0.16, n = 32: 12 -> 3.0
and 2.3 -> 0.46, n = 112: 61 -> 13 and 7.2 -> 8.6; dense matrices, n = 15: 7.2 -> 0.7 and 3.0 -> 0.12, n = 49:
87 -> 2.3 and 53 -> 1.5. Hence the inverse of a large sparse matrix is not kept.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca
from casadi import MX, SX, Function

from acausal.codegen.casadi_expressions import FORWARD
from acausal.codegen.program import Program
from acausal.codegen.scope import block_scope
from acausal.codegen.segments import QUICK_LINEAR, expressions, reads
from acausal.codegen.solvers import linear_system, regular_solution, scaled_system
from acausal.symbolic.causal import Block, BlockKind
from acausal.symbolic.expressions.expr import Expr

LARGEST, LARGEST_SPARSE = 300, 64
"""Tearing variables up to which the inverse of a block is kept."""
_SPARSE = 0.2
"""Share of entries below which a matrix is sparse."""


@dataclass(frozen=True)
class Factors:
    """`run(p) -> w`: column by column, the inverses of `blocks`, whose part of `w` begins at `first`."""

    blocks: tuple[Block, ...]
    first: tuple[int, ...]
    run: Function

    @property
    def size(self) -> int:
        return int(self.run.nnz_out(0))

    def inverse(self, block: Block, w: MX) -> MX | None:
        """The inverse of the block's matrix, if it is among the factors `w`."""
        if block not in self.blocks:
            return None
        begin, n = self.first[self.blocks.index(block)], len(block.tearing)
        return ca.reshape(w[begin : begin + n * n], n, n)


def factors(program: Program) -> Factors | None:
    """The factors of a program; None where no block has a constant matrix and more than a few unknowns."""
    parameters = next(leaves for name, leaves in program.groups if name == "p")
    p = MX.sym("p", len(parameters))
    places = {leaf: i for i, leaf in enumerate(parameters)}
    found: list[Block] = []
    values: list[MX] = []
    for segment in program.segments:
        size = len(segment.block.tearing)
        if not segment.implicit or segment.block.kind is not BlockKind.LINEAR:
            continue
        if QUICK_LINEAR < size <= LARGEST:
            inverse = _inverse(segment.block, program, places, p)
            if inverse is not None:
                found.append(segment.block)
                values.append(ca.vec(inverse))
    if not found:
        return None
    sizes = [len(block.tearing) ** 2 for block in found]
    first = tuple(sum(sizes[:i]) for i in range(len(sizes)))
    return Factors(tuple(found), first, Function("factors", [p], [ca.vertcat(*values)], ["p"], ["w"]))


def known_of(block: Block, program: Program) -> tuple[Expr, ...]:
    """What the block's equations read."""
    return reads(expressions([block]), program.slots, own=block.unknowns)


def _inverse(block: Block, program: Program, places: dict[Expr, int], p: MX) -> MX | None:
    """The inverse as a function of the parameters; None where the matrix depends on anything else."""
    known = known_of(block, program)
    z, u, scope = block_scope(block, known)
    matrix, _ = linear_system(block, z, u, scope)
    n = len(block.tearing)
    if n > LARGEST_SPARSE and matrix.nnz() < _SPARSE * n * n:
        return None
    moving = [u[i] for i, leaf in enumerate(known) if leaf not in places]
    if moving and ca.depends_on(matrix, ca.vertcat(*moving)):
        return None
    rows, columns, scaled = scaled_system(matrix)
    given: Sequence[SX] = [scaled, rows, columns]
    system = Function("matrix", [u], given, ["u"], ["S", "r", "c"], FORWARD)
    taken = [p[places[leaf]] if leaf in places else MX(0) for leaf in known]
    s, r, c = system(ca.vertcat(*taken) if taken else MX(0, 1))
    solved, regular = regular_solution(s, MX.eye(n))
    return ca.if_else(regular, ca.mtimes(ca.mtimes(ca.diag(c), solved), ca.diag(r)), float("nan"))
