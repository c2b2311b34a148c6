"""Cuts an ordered list of blocks into segments: runs of explicit blocks, and implicit blocks.

A segment reads values known before it and writes its unknowns. Small linear blocks are solved symbolically
and so belong to explicit runs; larger linear blocks, those of several unknowns that a mode may make singular,
and all nonlinear ones stand alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

from acausal.codegen.casadi_expressions import WRAPPERS
from acausal.symbolic.causal import Block, BlockKind
from acausal.symbolic.expressions.expr import Expr, postorder
from acausal.symbolic.expressions.operators import SWITCHING

INLINE_LINEAR = 3
"""Linear blocks with up to this many tearing variables are solved inside the expression graph."""
QUICK_LINEAR = 12
"""And up to this many where something else is at hand for a matrix that is singular (`codegen.quick`)."""


_SWITCHES = frozenset({"if", "abs", "min", "max", "sign"})


@dataclass(frozen=True)
class Segment:
    """`blocks` in order; implicit: exactly one block, which needs a solver."""

    blocks: tuple[Block, ...]
    implicit: bool

    @property
    def block(self) -> Block:
        """The implicit block."""
        return self.blocks[0]

    @property
    def writes(self) -> tuple[Expr, ...]:
        return tuple(unknown for block in self.blocks for unknown in block.unknowns)


def is_implicit(block: Block) -> bool:
    """Whether `block` needs a solver at run time."""
    if block.kind is not BlockKind.LINEAR:
        return block.kind is BlockKind.NONLINEAR
    return len(block.tearing) > INLINE_LINEAR or (len(block.tearing) > 1 and is_switching(block))


def needs_solver(block: Block) -> bool:
    """Whether `block` needs a solver even if a singular matrix is somebody else's."""
    if block.kind is BlockKind.LINEAR:
        return len(block.tearing) > QUICK_LINEAR
    return block.kind is BlockKind.NONLINEAR


def is_switching(block: Block) -> bool:
    """Whether the block's equations hold an `if` or alike, so that coefficients may vanish in one branch."""
    return any(node.op in _SWITCHES for node in postorder(expressions([block])))


def cut(blocks: Sequence[Block], implicit: Callable[[Block], bool] = is_implicit) -> tuple[Segment, ...]:
    """The segments of `blocks`, in order; `implicit` says which stand alone."""
    segments: list[Segment] = []
    run: list[Block] = []
    for block in blocks:
        if not implicit(block):
            run.append(block)
            continue
        if run:
            segments.append(Segment(tuple(run), False))
            run = []
        segments.append(Segment((block,), True))
    if run:
        segments.append(Segment(tuple(run), False))
    return tuple(segments)


def expressions(blocks: Iterable[Block]) -> list[Expr]:
    """Everything the blocks compute."""
    found: list[Expr] = []
    for block in blocks:
        found.extend(assignment.value for assignment in block.assignments)
        found.extend(residual.value for residual in block.residuals)
    return found


def reads(
    roots: Iterable[Expr], slots: Mapping[Expr, int], own: Iterable[Expr] = (), literal: bool = False
) -> tuple[Expr, ...]:
    """The leaves below `roots` that have a slot and are not in `own`, ordered by slot.

    A relation with a slot (its mode) is a leaf, except below `noEvent` and `smooth`, where it is computed.
    """
    mine = frozenset(own)
    found: set[Expr] = set()
    seen: tuple[set[Expr], set[Expr]] = (set(), set())
    stack = [(root, literal) for root in roots]
    while stack:
        node, computed = stack.pop()
        if node in seen[computed]:
            continue
        seen[computed].add(node)
        if node in slots and not (computed and node.op in SWITCHING):
            if node not in mine:
                found.add(node)
            continue
        below = computed or node.op in WRAPPERS
        stack.extend([(arg, below) for arg in node.args])
    return tuple(sorted(found, key=slots.__getitem__))
