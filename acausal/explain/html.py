"""An explanation as HTML: a fragment for notebooks, and a page by itself. No script, no outside resource."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from html import escape

from acausal.explain.explanation import Explanation
from acausal.explain.html_parts import PAGE_STYLE, STYLE, Paper, Row, code, fold_away, rows, small
from acausal.explain.words import by_whom, kind_of, often, use, when_not, where
from acausal.symbolic.causal import Assignment, Block, BlockKind, CausalSystem
from acausal.symbolic.describe import equation_text, leaf_texts, place
from acausal.symbolic.expressions.text import to_text

LIMIT = 200
"""Rows of a notebook's table that are shown before it says how many more there are."""

PAGE_LIMIT = 10_000
"""Rows of a table of the page, so that a browser can still open it for a system of 100,000 equations."""

_CELL, _PAGE = Paper(LIMIT, linked=False), Paper(PAGE_LIMIT, linked=True)


def html_fragment(explanation: Explanation) -> str:
    """Counts, states and why they are, blocks in order with their equations, aliases; long tables cut."""
    return f"<style>\n{STYLE}\n</style>\n{_body(explanation, _CELL)}"


def html_page(explanation: Explanation) -> str:
    """Everything on one page, tables up to `PAGE_LIMIT` rows, the incidence drawn.

    Browsers search in folded sections too.
    """
    from acausal.explain.plot import incidence_svg

    drawing = f"<figure>{incidence_svg(explanation)}</figure>" if explanation.system.blocks else ""
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(explanation.name)} explained</title>\n<style>\n{STYLE}\n{PAGE_STYLE}\n</style>\n"
        f"</head>\n<body>\n{_body(explanation, _PAGE, drawing)}\n</body>\n</html>\n"
    )


def _body(explanation: Explanation, paper: Paper, drawing: str = "") -> str:
    flat = explanation.system.flat
    parts = (
        f'<div class="acausal">\n<h3>{escape(flat.name)}</h3>',
        f"<p>{escape(flat.description)}</p>" if flat.description else "",
        _counts(explanation),
        _warnings(explanation),
        paper.table(("state", "unit", "start", "description", "why"), rows(_states(explanation))),
        *_tables(explanation, paper),
        fold_away("Incidence, before and after sorting", drawing, is_open=True),
        small(", ".join(f"{step} {spent:.3f} s" for step, spent in explanation.seconds.items())),
    )
    return "\n".join(part for part in parts if part) + "\n</div>"


def _tables(explanation: Explanation, paper: Paper) -> Iterator[str]:
    system = explanation.system
    yield paper.folded("What is no state", ("variable", "why"), rows(_others(explanation)))
    yield paper.folded("States chosen anew", ("while", "then", "by"), rows(_dynamic(explanation)))
    yield paper.folded("Differentiated", ("equation", "", "from"), rows(_differentiated(explanation)))
    head = ("", "solved for", "by", "from", "needs")
    needs = explanation.dependencies.needs if paper.linked else None
    yield paper.folded("Loops", ("block", "", "tearing"), _loops(explanation, paper))
    yield paper.folded(
        "Blocks, in order",
        head if needs is not None else head[:-1],
        _blocks(system.blocks, "block", paper, needs),
        is_open=True,
    )
    yield paper.folded("Aliases", ("variable", "equals", "from"), rows(_aliases(explanation)))
    yield paper.folded("Start values", ("variable", "start", "use"), rows(_starts(system)))
    if paper.linked:
        initial = _blocks(system.initial.blocks, "initial", paper, None)
        yield paper.folded("Initial system, in order", head[:-1], initial)
    yield paper.folded("Zero crossings", ("relation", "from"), rows(_crossings(explanation)))
    yield paper.folded("At events", ("discrete value", "from"), rows(_discrete(explanation)))


def _counts(explanation: Explanation) -> str:
    system = explanation.system
    largest = max(system.blocks, key=lambda block: block.size, default=None)
    torn = max((len(block.tearing) for block in system.blocks), default=0)
    size = f" (largest {largest.size}, torn to {torn})" if largest is not None and largest.size > 1 else ""
    kinds = ", ".join(f"{explanation.count(kind)} {kind.value}" for kind in BlockKind)
    facts = {
        "equations": f"{system.equation_count}",
        "unknowns": f"{system.unknown_count}",
        "aliases": f"{len(system.aliases)}",
        "index": f"{system.index}",
        "states": f"{len(system.states)}",
        "blocks": f"{len(system.blocks)}{size}",
        "of which": kinds,
        "zero crossings": f"{len(system.events)}",
    }
    cells = (f"<div><dt>{name}</dt><dd>{value}</dd></div>" for name, value in facts.items())
    return f"<dl>{''.join(cells)}</dl>"


def _warnings(explanation: Explanation) -> str:
    return "\n".join([f"<pre>{escape(warning.render())}</pre>" for warning in explanation.warnings])


def _states(explanation: Explanation) -> Iterator[Sequence[str]]:
    system = explanation.system
    reasons = {choice.name: choice.reason for choice in system.choices}
    starts = {value.name: value for value in system.initial.values}
    for name in system.states:
        variable, start = system.flat.by_name[name], starts.get(name)
        shown = f"{code(to_text(start.value))} {small(start.reason)}" if start else ""
        unit, description = escape(variable.unit), escape(variable.description)
        yield code(name), unit, shown, description, escape(reasons.get(name, ""))


def _others(explanation: Explanation) -> Iterator[Sequence[str]]:
    for choice in explanation.system.choices:
        if not choice.is_state:
            yield code(choice.name), escape(choice.reason)


def _dynamic(explanation: Explanation) -> Iterator[Sequence[str]]:
    dynamic = explanation.system.dynamic
    for monitor in dynamic.monitors if dynamic is not None else ():
        relation, change, constraints = when_not(monitor)
        yield code(relation), escape(change), small(constraints)


def _differentiated(explanation: Explanation) -> Iterator[Sequence[str]]:
    for entry in explanation.differentiated:
        how = f"{often(entry.times)}, {by_whom(entry)}"
        yield code(equation_text(entry.equation)), escape(how), small(where(entry.equation))


def _loops(explanation: Explanation, paper: Paper) -> Iterator[Row]:
    for number, block in explanation.loops:
        yield Row((paper.blocks([number]), kind_of(block), _names(block)))


def _blocks(
    blocks: Iterable[Block], prefix: str, paper: Paper, needs: Mapping[int, Sequence[int]] | None
) -> Iterator[Row]:
    """The rows of every block; `needs` adds a column."""
    for number, block in enumerate(blocks, 1):
        first, *others = _block(number, block)
        last = () if needs is None else (paper.blocks(needs[number]),)
        yield Row((*first, *last), f"{prefix}-{number}")
        for cells in others:
            yield Row((*cells, *("" for _ in last)))


def _block(number: int, block: Block) -> Iterator[Sequence[str]]:
    if block.kind is BlockKind.EXPLICIT:
        yield f"{number}", *_assignment(block.assignments[0])
        return
    kind = f"{block.kind.value} block of {block.size}, torn to {len(block.tearing)}"
    yield f"{number}", _names(block), small(kind), ""
    for assignment in block.assignments:
        yield "", *_assignment(assignment)
    for residual in block.residuals:
        yield "", "", code(f"0 = {to_text(residual.value)}"), small(where(residual.equation))


def _names(block: Block) -> str:
    return ", ".join([code(text) for text in leaf_texts(block.tearing)])


def _assignment(assignment: Assignment) -> tuple[str, str, str]:
    value = code(f":= {to_text(assignment.value)}")
    return code(to_text(assignment.unknown)), value, small(where(assignment.equation))


def _aliases(explanation: Explanation) -> Iterator[Sequence[str]]:
    for alias in explanation.system.aliases:
        yield code(alias.name), code(to_text(alias.value)), small(where(alias.equation))


def _starts(system: CausalSystem) -> Iterator[Sequence[str]]:
    for value in system.initial.values:
        yield code(value.name), code(to_text(value.value)), escape(use(value, system))
    for check in system.initial.checks:
        yield "", code(f"0 = {to_text(check.value)}"), f"must hold as well {small(where(check.equation))}"


def _discrete(explanation: Explanation) -> Iterator[Sequence[str]]:
    for a in explanation.system.discrete.assignments:
        text = f"{to_text(a.unknown)} := {to_text(a.value)}"
        yield code(text), small(place(a.equation.flat.span))


def _crossings(explanation: Explanation) -> Iterator[Sequence[str]]:
    for crossing in explanation.system.events:
        yield code(to_text(crossing.relation)), small(place(crossing.span))
