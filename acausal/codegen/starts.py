"""Start values as inputs of the initial problem, so that a run can change them without compiling again.

Every condition `x = start` of the initial problem, wherever it ended up (solved by itself, a residual of a
torn block, or a redundant check), reads its start value from the input `start(x)`. A start value that depends
on a parameter which the initial problem itself determines (`fixed = false`) stays an expression.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from acausal.codegen.segments import expressions
from acausal.errors import UnsupportedProblem, fail
from acausal.lang.flat import Origin
from acausal.symbolic.causal import Assignment, Block, CausalEquation, CausalSystem, InitialValue, Residual
from acausal.symbolic.expressions.expr import Expr, sub, sym, symbols


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
    free = {v.name for v in system.flat.parameters if not v.is_fixed}
    values = {value.name: value for value in system.initial.values}
    closed = frozenset(v.name for v in values.values() if free and free.intersection(symbols([v.value])))
    opener = _Opener(system, {name: v for name, v in values.items() if name not in closed})
    blocks = tuple(opener.block(block) for block in system.initial.blocks)
    if free:
        _check_dependents(system, free)
    return OpenStarts(blocks, tuple(opener.residual(r) for r in system.initial.checks), closed)


def _check_dependents(system: CausalSystem, free: set[str]) -> None:
    """Refuses an initial problem that reads a parameter computed from one which it determines."""
    of: dict[str, str] = {}
    for name in system.parameters:
        binding = system.flat.by_name[name].binding
        used = symbols([binding]) if binding is not None and name not in free else ()
        source = next((n for n in used if n in free or n in of), None)
        if source is not None:
            of[name] = of.get(source, source)
    for name in symbols([*expressions(system.initial.blocks), *(c.value for c in system.initial.checks)]):
        if name in of:
            raise fail(
                UnsupportedProblem,
                "codegen.dependent-parameter",
                f"the initial equations use parameter `{name}`, which is computed from `{of[name]}`, "
                "which they determine",
                system.flat.by_name[name].span,
                names=[name, of[name]],
                hint=f"give `{name}` fixed = false too, and its value in an initial equation",
            )


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
