"""Start values as inputs of the initial problem, so that a run can change them without compiling again.

Every condition `x = start` of the initial problem, wherever it ended up (solved by itself, a residual of a
torn block, or a redundant check), reads its start value from the input `start(x)`. A start value that depends
on a parameter which the initial problem itself determines (`fixed = false`) stays an expression.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from acausal.lang.flat import Origin
from acausal.symbolic.causal import Assignment, Block, CausalEquation, CausalSystem, InitialValue, Residual
from acausal.symbolic.expressions.expr import Expr, sub, sym, symbols
from acausal.symbolic.parameters import dependent_parameters, free_parameters


def start_leaf(name: str) -> Expr:
    """The input of the initial problem that holds the start value of `name`."""
    return sym(f"start({name})")


@dataclass(frozen=True)
class OpenStarts:
    """Initial blocks and checks with start values as inputs; `closed` names those that are expressions."""

    blocks: tuple[Block, ...]
    checks: tuple[Residual, ...]
    closed: frozenset[str]


def open_starts(system: CausalSystem) -> OpenStarts:
    """Rewrites every `x = start` of the initial problem. O(size of the initial problem)."""
    flat = system.flat
    free = {v.name for v in (*free_parameters(flat), *dependent_parameters(flat, system.parameters))}
    values = {value.name: value for value in system.initial.values}
    closed = frozenset(v.name for v in values.values() if free and free.intersection(symbols([v.value])))
    opener = _Opener(system, {name: v for name, v in values.items() if name not in closed})
    blocks = tuple(opener.block(block) for block in system.initial.blocks)
    return OpenStarts(blocks, tuple(opener.residual(r) for r in system.initial.checks), closed)


class _Opener:
    """Knows which equations are start conditions."""

    def __init__(self, system: CausalSystem, values: dict[str, InitialValue]) -> None:
        self._by_name = system.flat.by_name
        self._values = values

    def _is_start(self, equation: CausalEquation) -> bool:
        """Whether the initial problem made this equation from a start value, not the model."""
        left, flat = equation.left, equation.flat
        value = self._values.get(left.name) if left.op == "sym" else None
        return (
            value is not None
            and equation.right is value.value
            and flat.origin is Origin.EQUATION
            and flat.span == self._by_name[value.name].span
        )

    def block(self, block: Block) -> Block:
        if not any(self._is_start(part.equation) for part in (*block.assignments, *block.residuals)):
            return block
        assignments = tuple(self._assignment(a) for a in block.assignments)
        residuals = tuple(self.residual(r) for r in block.residuals)
        return replace(block, assignments=assignments, residuals=residuals)

    def _assignment(self, assignment: Assignment) -> Assignment:
        equation = assignment.equation
        if assignment.unknown is not equation.left or not self._is_start(equation):
            return assignment
        return replace(assignment, value=start_leaf(equation.left.name))

    def residual(self, residual: Residual) -> Residual:
        equation = residual.equation
        if not self._is_start(equation):
            return residual
        return replace(residual, value=sub(equation.left, start_leaf(equation.left.name)))
