"""What integrators call: derivatives and their slopes with the linear blocks solved inside one graph.

`Code.ode` solves linear blocks of several unknowns by a solver that copes with a singular matrix, at the
price of calls between functions and of their derivatives. Here such blocks, up to `QUICK_LINEAR` unknowns,
are part of the graph, which gives not-a-number where the matrix is singular: then the run-time asks
`Code.ode` and `Code.jac`.

Large linear blocks whose matrix no run changes are solved by their factors (`factors`), which are computed
once and are one more input, `w`. What remains for a solver are nonlinear and other large linear blocks. The
slopes (`slopes`) take the blocks as solved at the point.

Measured on the gearbox at level 4 (29 states, one block of 40 equations torn on 4 unknowns): the compiled C
has 24,000 lines instead of 230,000 and integrates five times faster.
"""

from __future__ import annotations

from dataclasses import dataclass

from casadi import Function

from acausal.codegen.factors import factors
from acausal.codegen.program import Program
from acausal.codegen.scope import Scope
from acausal.codegen.segments import needs_solver
from acausal.codegen.slopes import slopes
from acausal.codegen.solvers import Nominals
from acausal.codegen.stitch import Goal, stitched
from acausal.symbolic.causal import Block
from acausal.symbolic.expressions.expr import Expr


@dataclass(frozen=True)
class Quick:
    """Derivatives and slopes for integrators; each is None where `Code` has nothing quicker."""

    ode: Function | None
    """As `Code.ode`; not-a-number where a linear block is singular."""
    slopes: Function | None
    """`(t, x, p, m, u, d, z) -> (J, rate)`, d xdot / d x sparse and d xdot / d t dense (or without entries),
    with `z` solved at that point; not-a-number where a block is singular."""
    factors: Function | None
    """`p -> w`, the last input of both if it is there."""


def quick(program: Program, rates: tuple[Expr, ...], nominals: Nominals) -> Quick:
    """All for the derivatives `rates`. Raises `UnsupportedProblem` for what has no numeric code."""
    blocks = [segment.block for segment in program.segments if segment.implicit]
    found = factors(program) if rates else None
    if found is not None:
        ode = stitched(program, "ode", [Goal("xdot", rates)], nominals, found)
        return Quick(ode, slopes(program, rates, blocks, found), found.run)
    return Quick(_ode(program, rates, blocks), slopes(program, rates, blocks, None), None)


def _ode(program: Program, rates: tuple[Expr, ...], blocks: list[Block]) -> Function | None:
    if not blocks or any(needs_solver(block) for block in blocks):
        return None
    scope = Scope([*program.groups, ("z", program.guesses)])
    scope.run(program.blocks, needs_solver)
    return scope.function("ode", [("xdot", scope.column(rates)), ("z_out", scope.column(program.guesses))])
