"""Texts about equations, blocks and conditions that every run-time error uses."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from acausal.errors import AcausalError, Diagnostic, InitializationProblem, Span
from acausal.symbolic.causal import Block, BlockKind, CausalEquation, CausalSystem, ZeroCrossing
from acausal.symbolic.describe import place, shown
from acausal.symbolic.expressions.expr import Expr, postorder, symbols
from acausal.symbolic.expressions.text import to_text

_SHOWN = 8


def some(names: Sequence[str]) -> str:
    """The first few names, and how many more there are."""
    more = f" and {len(names) - _SHOWN} more" if len(names) > _SHOWN else ""
    return ", ".join(names[:_SHOWN]) + more


def leaf_name(leaf: Expr) -> str:
    """`x` or `der(x)`."""
    return to_text(leaf)


def number(value: float) -> str:
    """Six digits are enough to recognise a value."""
    return f"{value + 0.0:.6g}"  # -0 is 0


def at(time: float) -> str:
    """The instant, for the middle of a sentence."""
    return f"at time {time:.12g} s"


def values_text(pairs: Iterable[tuple[Expr, float]]) -> str:
    """`x = 1, y = 2` for a message."""
    return some([f"{leaf_name(leaf)} = {number(value)}" for leaf, value in pairs])


def block_equations(block: Block) -> list[CausalEquation]:
    """All equations of a block, residuals first."""
    return [r.equation for r in block.residuals] + [a.equation for a in block.assignments]


def block_problem(
    kind: type[AcausalError], code: str, what: str, block: Block, time: float, worst: Sequence[int], hint: str
) -> AcausalError:
    """An error about a torn block: one diagnostic for the block, one for each of its worst residuals."""
    unknowns = [leaf_name(leaf) for leaf in block.unknowns]
    noun = "unknown" if len(unknowns) == 1 else "unknowns"
    equations = [block.residuals[i].equation for i in worst] or block_equations(block)[:1]
    if code.endswith("singular-block"):  # what was put into the residuals may be the reason
        equations += [a.equation for a in block.assignments]
    texts = some([f"`{shown(e)}`" for e in equations])
    system = "initial" if kind is InitializationProblem else "running"
    message = (
        f"{what} {at(time)} in the {system} system: "
        f"block of {len(unknowns)} {noun} {some(unknowns)}; equations involved: {texts}"
    )
    first = Diagnostic(code, message, equations[0].flat.span, tuple(unknowns), hint)
    rest = [
        Diagnostic(code, f"involved as well: `{shown(e)}`", e.flat.span, tuple(symbols((e.left, e.right))))
        for e in equations[1:_SHOWN]
    ]
    return kind([first, *rest])


def crossing_text(crossing: ZeroCrossing) -> str:
    """`x < 1 (file:line)`."""
    return f"`{to_text(crossing.relation)}` ({place(crossing.span)})"


def span_of(system: CausalSystem, node: Expr) -> Span:
    """Where the model says `node`: the first equation or action that holds it, else the model's own place."""
    part = system.discrete
    blocks = [*system.blocks, Block(BlockKind.EXPLICIT, part.assignments)]
    held: list[tuple[tuple[Expr, ...], Span]] = []
    for block in blocks:
        held += [((a.value,), a.equation.flat.span) for a in block.assignments]
        held += [((r.value,), r.equation.flat.span) for r in block.residuals]
    held += [((reset.condition, reset.value), reset.span) for reset in part.resets]
    held += [((check.condition,), check.assertion.span) for check in part.checks]
    held += [((stop.condition,), stop.termination.span) for stop in part.stops]
    return next((span for values, span in held if node in postorder(values)), system.flat.span)
