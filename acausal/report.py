"""A causalised system as one piece of HTML: how a compiled model shows itself in a notebook."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from html import escape

from acausal.symbolic.causal import Assignment, Block, BlockKind, CausalEquation, CausalSystem
from acausal.symbolic.describe import place
from acausal.symbolic.expressions.text import to_text

LIMIT = 200
"""Rows of a table that are shown before it says how many more there are."""

_STYLE = """\
<style>
.acausal {font-size: 13px; line-height: 1.45; max-width: 72em}
.acausal h3 {margin: 0 0 .1em; font-size: 1.2em}
.acausal p {margin: 0 0 .6em; opacity: .8}
.acausal dl {display: flex; flex-wrap: wrap; gap: .3em 2em; margin: .4em 0 .8em}
.acausal dt {opacity: .7; font-size: .9em; font-weight: normal}
.acausal dd {margin: 0; font-weight: 600}
.acausal table {border-collapse: collapse; margin: .3em 0 .8em}
.acausal th, .acausal td {text-align: left; vertical-align: top; padding: .15em 1.2em .15em 0}
.acausal td {white-space: normal}
.acausal tr {border-top: 1px solid rgba(128, 128, 128, .25); background: none}
.acausal th {font-weight: 600; opacity: .8; white-space: nowrap}
.acausal code {font-size: .95em; background: none; padding: 0; overflow-wrap: anywhere}
.acausal small {opacity: .65}
.acausal summary {cursor: pointer; font-weight: 600; margin: .3em 0}
</style>"""


def html_report(system: CausalSystem) -> str:
    """Title, counts, states and why they are, blocks in order with their equations, aliases."""
    flat = system.flat
    parts = (
        f'{_STYLE}\n<div class="acausal">\n<h3>{escape(flat.name)}</h3>',
        f"<p>{escape(flat.description)}</p>" if flat.description else "",
        _counts(system),
        _table(("state", "unit", "start", "description", "why"), _states(system)) if system.states else "",
        _folded("What is no state", ("variable", "why"), _others(system)),
        _folded("Blocks, in order", ("", "solved for", "by", "from"), _blocks(system.blocks), is_open=True),
        _folded("Aliases", ("variable", "equals", "from"), _aliases(system)),
    )
    return "\n".join(part for part in parts if part) + "\n</div>"


def _counts(system: CausalSystem) -> str:
    largest = max(system.blocks, key=lambda block: block.size, default=None)
    torn = max((len(block.tearing) for block in system.blocks), default=0)
    size = f" (largest {largest.size}, torn to {torn})" if largest is not None and largest.size > 1 else ""
    facts = {
        "equations": f"{len(system.flat.equations)}",
        "unknowns": f"{len(system.flat.unknowns)}",
        "aliases": f"{len(system.aliases)}",
        "index": f"{system.index}",
        "states": f"{len(system.states)}",
        "blocks": f"{len(system.blocks)}{size}",
        "zero crossings": f"{len(system.zero_crossings)}",
    }
    return (
        f"<dl>{''.join(f'<div><dt>{name}</dt><dd>{value}</dd></div>' for name, value in facts.items())}</dl>"
    )


def _states(system: CausalSystem) -> Iterator[Sequence[str]]:
    reasons = {choice.name: choice.reason for choice in system.choices}
    starts = {value.name: value for value in system.initial.values}
    for name in system.states:
        variable, start = system.flat.by_name[name], starts.get(name)
        shown = f"{_code(to_text(start.value))} <small>{escape(start.reason)}</small>" if start else ""
        unit, description = escape(variable.unit), escape(variable.description)
        yield _code(name), unit, shown, description, escape(reasons.get(name, ""))


def _others(system: CausalSystem) -> Iterator[Sequence[str]]:
    for choice in system.choices:
        if not choice.is_state:
            yield _code(choice.name), escape(choice.reason)


def _blocks(blocks: Iterable[Block]) -> Iterator[Sequence[str]]:
    for number, block in enumerate(blocks, 1):
        if block.kind is BlockKind.EXPLICIT:
            yield f"{number}", *_assignment(block.assignments[0])
            continue
        kind = f"{block.kind.value} block of {block.size}, torn to {len(block.tearing)}"
        yield (
            f"{number}",
            ", ".join([_code(to_text(leaf)) for leaf in block.tearing]),
            f"<small>{kind}</small>",
            "",
        )
        for assignment in block.assignments:
            yield "", *_assignment(assignment)
        for residual in block.residuals:
            yield "", "", _code(f"0 = {to_text(residual.value)}"), _origin(residual.equation)


def _assignment(assignment: Assignment) -> tuple[str, str, str]:
    value = _code(f":= {to_text(assignment.value)}")
    return _code(to_text(assignment.unknown)), value, _origin(assignment.equation)


def _origin(equation: CausalEquation) -> str:
    times = equation.differentiations
    derived = "" if times == 0 else ", differentiated" + ("" if times == 1 else f" {times} times")
    component = f" in {equation.flat.component}" if equation.flat.component else ""
    return f"<small>{escape(place(equation.flat.span) + component + derived)}</small>"


def _aliases(system: CausalSystem) -> Iterator[Sequence[str]]:
    for alias in system.aliases:
        yield (
            _code(alias.name),
            _code(to_text(alias.value)),
            f"<small>{escape(place(alias.equation.span))}</small>",
        )


def _code(text: str) -> str:
    return f"<code>{escape(text)}</code>"


def _folded(title: str, head: Sequence[str], rows: Iterable[Sequence[str]], *, is_open: bool = False) -> str:
    """A table that can be folded away; nothing where there are no rows."""
    table = _table(head, rows)
    return (
        f"<details{' open' if is_open else ''}><summary>{title}</summary>{table}</details>" if table else ""
    )


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Rows of cells that are HTML already; nothing where there are none."""
    lines = [f"<tr>{''.join(f'<td>{cell}</td>' for cell in row)}</tr>" for row in rows]
    if not lines:
        return ""
    if len(lines) > LIMIT:
        more = f"and {len(lines) - LIMIT} more lines"
        lines[LIMIT:] = [f'<tr><td colspan="{len(head)}"><small>{more}</small></td></tr>']
    titles = "".join(f"<th>{title}</th>" for title in head)
    return f"<table><thead><tr>{titles}</tr></thead><tbody>\n" + "\n".join(lines) + "\n</tbody></table>"
