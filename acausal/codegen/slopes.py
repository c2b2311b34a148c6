"""Slopes of the derivatives by the implicit function theorem, with the blocks solved at the point.

    J = F_x - F_z R_z^-1 R_x

with F the derivatives and R the residuals as functions of the states x and the tearing variables z, block by
block, and the same for the time. Where all blocks are small this is one expression graph; else the matrices
are, and blocks of more than `QUICK_LINEAR` unknowns are solved by sparse QR, or by their factors (`factors`).

Measured on a chain of 300 capacitors to ground and to each other (one block of 114 unknowns after tearing, a
dense Jacobian): 0.6 s to make the function, where differentiating through the solver takes 15 s.
"""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
from casadi import MX, SX, Function, Sparsity

from acausal.codegen.casadi_expressions import FORWARD, jacobian
from acausal.codegen.factors import Factors
from acausal.codegen.linear import solve_orthogonal
from acausal.codegen.program import Program
from acausal.codegen.scope import Scope
from acausal.codegen.segments import QUICK_LINEAR, is_switching
from acausal.codegen.solvers import QR
from acausal.symbolic.causal import Block
from acausal.symbolic.expressions.expr import Expr


def slopes(
    program: Program,
    rates: tuple[Expr, ...],
    blocks: list[Block],
    factors: Factors | None,
    by_group: str = "x",
) -> Function | None:
    """`(t, x, p, m, u, d, z[, w]) -> (J, rate)`; None where a mode may make a large block singular.

    Of any expressions in place of the derivatives, and by any group of inputs in place of the states.
    """
    large = [block for block in blocks if len(block.tearing) > QUICK_LINEAR]
    if not rates or any(is_switching(block) for block in large):
        return None
    scope = Scope([*program.groups, ("z", program.guesses)])
    scope.run(program.blocks)
    t, x, z = (scope.inputs[scope.names.index(name)] for name in ("t", by_group, "z"))
    by, goal = ca.vertcat(x, t), scope.column(rates)
    total = jacobian(goal, by)
    if large:
        parts = [total, jacobian(goal, z), *_residual_slopes(scope, blocks, by, z)]
        return _with_large(scope, parts, blocks, factors)
    if blocks:
        found = _block_slopes(*_residual_slopes(scope, blocks, by, z), blocks)
        total = total + ca.mtimes(jacobian(goal, z), found)
    matrix, rate = total[:, : x.shape[0]], total[:, x.shape[0]]
    dense = ca.densify(rate) if rate.nnz() else rate
    return scope.function("slopes", [("J", matrix), ("rate", dense)])


def _residual_slopes(scope: Scope, blocks: list[Block], by: SX, z: SX) -> tuple[SX, SX]:
    """The slopes of all residuals, by what is known and by the tearing variables."""
    column = scope.column([residual.value for block in blocks for residual in block.residuals])
    return jacobian(column, by), jacobian(column, z)


def _block_slopes(by_known: SX, by_z: SX, blocks: list[Block]) -> SX:
    """The slopes of the tearing variables, one row for each."""
    found = SX(0, by_known.shape[1])
    first = 0
    for block in blocks:
        rows = slice(first, first + len(block.tearing))
        right = by_known[rows, :] + ca.mtimes(by_z[rows, :first], found)
        found = ca.vertcat(found, -solve_orthogonal(by_z[rows, rows], right))
        first += len(block.tearing)
    return found


def _with_large(scope: Scope, parts: Sequence[SX], blocks: list[Block], factors: Factors | None) -> Function:
    """The slopes where some blocks are solved by matrices."""
    names = ["goal", "goal_by_z", "known", "by_z"]
    matrices = scope.function("matrices", list(zip(names, parts, strict=True)))
    inputs = [MX.sym(name, *matrices.size_in(i)) for i, name in enumerate(scope.names)]
    w = MX.sym("w", factors.size if factors is not None else 0)
    total, goal_by_z, by_known, by_z = matrices.call(inputs)
    found = MX(0, by_known.shape[1])
    first = 0
    for block in blocks:
        rows = slice(first, first + len(block.tearing))
        right = by_known[rows, :] + ca.mtimes(by_z[rows, :first], found)
        inverse = factors.inverse(block, w) if factors is not None else None
        found = ca.vertcat(found, -_solved(by_z[rows, rows], right, inverse))
        first += len(block.tearing)
    total = total + ca.mtimes(goal_by_z, found)
    count = int(total.shape[1]) - 1
    matrix, rate = total[:, :count], total[:, count]
    outputs = [matrix, ca.densify(rate) if rate.nnz() else rate]
    names_in = scope.names if factors is None else [*scope.names, "w"]
    given = inputs if factors is None else [*inputs, w]
    return Function("slopes", given, outputs, names_in, ["J", "rate"], FORWARD)


def _solved(matrix: MX, right: MX, inverse: MX | None) -> MX:
    """`matrix^-1 right`: full columns where `right` has an entry, no others."""
    n, pattern = int(right.shape[0]), right.sparsity()
    starts = pattern.colind()
    present = [j for j in range(int(right.shape[1])) if starts[j + 1] > starts[j]]
    if not present:
        return MX(n, right.shape[1])
    taken = ca.densify(right[:, present])
    if inverse is not None:
        found = ca.mtimes(inverse, taken)
    elif n <= QUICK_LINEAR:
        found = _small(matrix, taken)
    else:
        found = ca.solve(matrix, taken, "qr", QR)
    rows = list(range(n)) * len(present)
    columns = [j for j in present for _ in range(n)]
    return MX(Sparsity.triplet(n, int(right.shape[1]), rows, columns), ca.vec(found))


def _small(matrix: MX, right: MX) -> MX:
    """By a graph that says not-a-number where the matrix is singular."""
    a, b = SX.sym("a", matrix.sparsity()), SX.sym("b", right.sparsity())
    solve = Function("solved", [a, b], [ca.densify(solve_orthogonal(a, b))], FORWARD)
    return solve(matrix, right)
