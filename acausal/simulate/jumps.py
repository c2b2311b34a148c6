"""Jumps of blocks of one unknown: where the branch of solutions ends that a run was on, another one is taken.

A trial step may find another branch and be refused after that, so that a jump counts only once the run is
past it and on the new branch.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from acausal.errors import Diagnostic
from acausal.simulate.messages import at, leaf_name, number, some
from acausal.symbolic.causal import Block
from acausal.symbolic.describe import shown
from acausal.symbolic.expressions.expr import Expr


@dataclass(frozen=True)
class _Jump:
    """A block whose unknown went `before` -> `after` in a trial step that ends at `time`."""

    block: Block
    time: float
    before: float
    after: float


@dataclass
class Jumps:
    """The jumps of one run: each block's first one is kept, as a warning."""

    found: dict[Expr, Diagnostic] = field(default_factory=dict[Expr, Diagnostic])
    _pending: dict[Expr, _Jump] = field(default_factory=dict[Expr, _Jump])

    def note(self, block: Block, time: float, before: float, after: float) -> None:
        """A trial step found the block's solution beyond a fold."""
        if block.tearing[0] not in self.found:
            self._pending[block.tearing[0]] = _Jump(block, time, before, after)

    @property
    def are_pending(self) -> bool:
        """Whether a jump may have happened."""
        return bool(self._pending)

    def judge(self, time: float, now: Mapping[Expr, float]) -> None:
        """What the run got past by `time`, where the tearing variables are `now`."""
        for key, jump in list(self._pending.items()):
            if abs(now[key] - jump.after) <= abs(now[key] - jump.before) and key not in self.found:
                when = at(jump.time)
                self.found[key] = jump_warning(jump.block, when, jump.before, jump.after)
            if time >= jump.time or key in self.found:
                del self._pending[key]


def jump_warning(block: Block, when: str, before: float, after: float) -> Diagnostic:
    """Names the block, its variables, the instant and both values."""
    unknowns = tuple(map(leaf_name, block.unknowns))
    equation = block.residuals[0].equation
    noun = "unknown" if len(unknowns) == 1 else "unknowns"
    message = (
        f"the solution of a nonlinear block ended {when}, and another one was taken: "
        f"{unknowns[0]} from {number(before)} to {number(after)}; "
        f"block of {len(unknowns)} {noun} {some(unknowns)}; equation involved: `{shown(equation)}`"
    )
    hint = "only the block's first jump is told; if no jump is meant, make the characteristic unique"
    return Diagnostic("simulate.jump", message, equation.flat.span, unknowns, hint, "warning")
