"""A scope: expressions over one vector of known values, converted to SX without looking at what made them.

Working over fresh symbols keeps the cost of every block proportional to the block, however long the chain of
assignments before it is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import casadi as ca
from casadi import SX, Function

from acausal.codegen.casadi_expressions import FORWARD, Converter, jacobian
from acausal.codegen.linear import solve_orthogonal, solve_small, solve_switching, term_sizes
from acausal.codegen.segments import INLINE_LINEAR, expressions, is_implicit, reads
from acausal.symbolic.causal import Block, BlockKind
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.expressions.operators import SWITCHING


def column(parts: Sequence[SX]) -> SX:
    """A dense column of scalars (also of none)."""
    return ca.densify(ca.vertcat(*parts)) if parts else SX.zeros(0, 1)


def split(vector: SX) -> list[SX]:
    """The scalars of a column."""
    return list(ca.vertsplit(vector)) if vector.shape[0] else []


class Scope:
    """Values that `convert` may use: one SX per leaf, in groups that become the inputs of a Function."""

    def __init__(self, groups: Sequence[tuple[str, Sequence[Expr]]]) -> None:
        self.inputs = [SX.sym(name, len(leaves)) for name, leaves in groups]
        self.names = [name for name, _ in groups]
        self._slots: dict[Expr, int] = {}
        leaves: dict[Expr, SX] = {}
        modes: dict[Expr, SX] = {}
        for (_, group), symbol in zip(groups, self.inputs, strict=True):
            for leaf, scalar in zip(group, split(symbol), strict=True):
                (modes if leaf.op in SWITCHING else leaves)[leaf] = scalar
                self._slots[leaf] = len(self._slots)
        self.convert = Converter(leaves, modes)

    def column(self, roots: Iterable[Expr], literal: bool = False) -> SX:
        """The values of `roots` as one column."""
        return column([self.convert(root, literal) for root in roots])

    def run(self, blocks: Iterable[Block], implicit: Callable[[Block], bool] = is_implicit) -> None:
        """Solves explicit and small linear blocks in order; their unknowns become leaves.

        Of a block that is `implicit` the tearing variables must be leaves already.
        """
        for block in blocks:
            if block.kind is BlockKind.LINEAR and not implicit(block):
                self._run_linear(block)
            else:
                for assignment in block.assignments:
                    self._define(assignment.unknown, self.convert(assignment.value))

    def _define(self, unknown: Expr, value: SX) -> None:
        self.convert.leaves[unknown] = value
        self._slots[unknown] = len(self._slots)

    def _run_linear(self, block: Block) -> None:
        known = reads(expressions([block]), self._slots, own=block.unknowns)
        z, u, local = block_scope(block, known)
        residual = local.column([r.value for r in block.residuals])
        zero = SX.zeros(z.shape[0], 1)
        at_zero = Function("residual", [z, u], [residual]).call([zero, u])[0]
        matrix = jacobian(residual, z)
        if len(block.tearing) == 1:
            solution = solve_switching(matrix, -at_zero, term_sizes(at_zero, u))
        elif len(block.tearing) <= INLINE_LINEAR:
            solution = column(solve_small(matrix, -at_zero))
        else:
            solution = ca.densify(solve_orthogonal(matrix, -at_zero))
        values = local.column([a.value for a in block.assignments])
        solve = Function("linear", [u], [solution, *Function("rest", [z, u], [values]).call([solution, u])])
        results = solve.call([self.column(known)])
        unknowns = [split(result) for result in results]
        for unknown, value in zip(block.unknowns, unknowns[0] + unknowns[1], strict=True):
            self._define(unknown, value)

    def branch(self) -> Converter:
        """A new conversion that knows what this one does, with a memo of its own."""
        return Converter(dict(self.convert.leaves), dict(self.convert.modes))

    def function(
        self, name: str, outputs: Sequence[tuple[str, SX]], more: Sequence[tuple[str, SX]] = ()
    ) -> Function:
        """A Function of the scope's inputs and of `more`."""
        inputs, values = [*self.inputs, *(symbol for _, symbol in more)], [value for _, value in outputs]
        names = [*self.names, *(name for name, _ in more)]
        return Function(name, inputs, values, names, [output for output, _ in outputs], FORWARD)


def block_scope(block: Block, known: Sequence[Expr]) -> tuple[SX, SX, Scope]:
    """Symbols of tearing variables and known values, and a scope in which the assignments have run."""
    scope = Scope([("z", block.tearing), ("u", known)])
    for assignment in block.assignments:
        scope.convert.leaves[assignment.unknown] = scope.convert(assignment.value)
    return scope.inputs[0], scope.inputs[1], scope
