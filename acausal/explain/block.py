"""One block as text: what it solves, from which equations, how, what it needs and who needs it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from acausal.explain.collect import block_equations, given
from acausal.explain.explanation import Explanation
from acausal.explain.words import cut, kind_of, short, unknown_texts, where
from acausal.symbolic.causal import Block, BlockKind
from acausal.symbolic.describe import equation_text, leaf_texts
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.expressions.text import to_text

_MOST_NAMES = 40


def block_text(explanation: Explanation, number: int, *, latex: bool) -> str:
    """Everything about block `number`. Raises `UsageProblem` where there is none."""
    block = explanation.block(number)
    lines = [
        f"block {number} of {len(explanation.system.blocks)} of {explanation.name}: {kind_of(block)}",
        *_listed("unknowns", unknown_texts(block)),
        *(_listed("tearing variables", leaf_texts(block.tearing)) if block.size > 1 else ()),
        *_titled("equations", _equations(block, latex)),
        *_titled("how it is solved", _solution(block, latex)),
        *_titled("needs", _needs(explanation, number, block)),
        *_titled("needed by", [_named(explanation, n) for n in explanation.dependencies.needed_by[number]]),
    ]
    return "\n".join(lines)


def _listed(title: str, names: Sequence[str]) -> Iterator[str]:
    yield f"  {title}: {cut(names, _MOST_NAMES)}"


def _titled(title: str, lines: Sequence[str]) -> Iterator[str]:
    if lines:
        yield f"  {title}"
        yield from (f"    {line}" for line in lines)


def _equations(block: Block, latex: bool) -> list[str]:
    lines: list[str] = []
    for equation in block_equations(block):
        lines.append(f"{short(equation_text(equation))}  ({where(equation)})")
        lines += _latex(equation.left, equation.right, latex)
        if equation.differentiations:
            lines.append(f"  from {short(equation_text(equation.flat))}")
    return lines


def _solution(block: Block, latex: bool) -> list[str]:
    how = "linear in" if block.kind is BlockKind.LINEAR else "Newton's method for"
    lines = [f"{how} {cut(leaf_texts(block.tearing), _MOST_NAMES)}; given these"] if block.tearing else []
    for assignment in block.assignments:
        lines.append(f"{to_text(assignment.unknown)} := {short(to_text(assignment.value))}")
        lines += _latex(assignment.unknown, assignment.value, latex)
    lines += [f"0 = {short(to_text(residual.value))}" for residual in block.residuals]
    return lines


def _latex(left: Expr, right: Expr, wanted: bool) -> list[str]:
    """The LaTeX of an equation; nothing where it is not wanted, or the equation is too long for it."""
    if not wanted:
        return []
    from acausal.explain.latex import equation_latex

    text = equation_latex(left, right)
    return [f"  {text}" if text is not None else "  (too long for LaTeX)"]


def _needs(explanation: Explanation, number: int, block: Block) -> list[str]:
    known = leaf_texts(given(explanation.system, block))
    lines = [f"given: {cut(known, _MOST_NAMES)}"] if known else []
    return lines + [_named(explanation, other) for other in explanation.dependencies.needs[number]]


def _named(explanation: Explanation, number: int) -> str:
    block = explanation.system.blocks[number - 1]
    return f"block {number} ({cut(unknown_texts(block), 5)})"
