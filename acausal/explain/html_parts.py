"""Pieces of HTML: tables that can be folded away, code, links between blocks. Everything is escaped here."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from html import escape

from acausal.explain.words import short

STYLE = """\
.acausal {font-size: 13px; line-height: 1.45; max-width: 72em}
.acausal h3 {margin: 0 0 .1em; font-size: 1.2em}
.acausal p {margin: 0 0 .6em; opacity: .8}
.acausal dl {display: flex; flex-wrap: wrap; row-gap: .3em; margin: .4em 0 .8em}
.acausal dl div {margin-right: 2em}
.acausal dt {opacity: .7; font-size: .9em; font-weight: normal}
.acausal dd {margin: 0; font-weight: 600}
.acausal table {border-collapse: collapse; margin: .3em 0 .8em}
.acausal th, .acausal td {text-align: left; vertical-align: top; padding: .15em 1.2em .15em 0}
.acausal td {white-space: normal}
.acausal tr {border-top: 1px solid rgba(128, 128, 128, .25); background: none}
.acausal th {font-weight: 600; opacity: .8; white-space: nowrap}
.acausal code {font-size: .95em; background: none; padding: 0; overflow-wrap: anywhere}
.acausal small {opacity: .65}
.acausal summary {cursor: pointer; font-weight: 600; margin: .3em 0}"""

PAGE_STYLE = """\
body {font-family: system-ui, sans-serif; margin: 2em; color-scheme: light dark}
.acausal {max-width: none}
.acausal tr:target {outline: 2px solid #D55E00}
.acausal pre {white-space: pre-wrap; margin: .3em 0}
.acausal figure {margin: .5em 0; background: white; width: fit-content; max-width: 100%; overflow: auto}
.acausal figure svg {max-width: 100%; height: auto}"""


@dataclass(frozen=True)
class Row:
    """Cells that are HTML already; `anchor` is what a link to the row says."""

    cells: Sequence[str]
    anchor: str = ""


@dataclass(frozen=True)
class Paper:
    """What tables are written on: a page has them whole and linked, a notebook's cell their beginning."""

    most_rows: int | None
    linked: bool

    def table(self, head: Sequence[str], rows: Iterable[Row]) -> str:
        """A table; nothing where there are no rows."""
        written = list(rows)
        if not written:
            return ""
        shown = written if self.most_rows is None else written[: self.most_rows]
        lines = [self._row(row) for row in shown]
        if len(shown) < len(written):
            more = f"and {len(written) - len(shown)} more lines"
            lines.append(f'<tr><td colspan="{len(head)}"><small>{more}</small></td></tr>')
        titles = "".join(f"<th>{title}</th>" for title in head)
        body = "\n".join(lines)
        return f"<table><thead><tr>{titles}</tr></thead><tbody>\n{body}\n</tbody></table>"

    def folded(self, title: str, head: Sequence[str], rows: Iterable[Row], *, is_open: bool = False) -> str:
        """A table that can be folded away, with its number of rows; nothing where there are none."""
        written = list(rows)
        anchored = sum(bool(row.anchor) for row in written)
        counted = f"{title} ({anchored or len(written)})"
        return fold_away(counted, self.table(head, written), is_open=is_open)

    def _row(self, row: Row) -> str:
        anchor = f' id="{row.anchor}"' if row.anchor and self.linked else ""
        return f"<tr{anchor}>{''.join(f'<td>{cell}</td>' for cell in row.cells)}</tr>"

    def blocks(self, numbers: Iterable[int]) -> str:
        """Numbers of blocks, linked where the page is."""
        link = '<a href="#block-{0}">{0}</a>' if self.linked else "{0}"
        return ", ".join([link.format(number) for number in numbers])


def fold_away(title: str, content: str, *, is_open: bool = False) -> str:
    """Content under a title that opens it; nothing where there is none."""
    return (
        f"<details{' open' if is_open else ''}><summary>{title}</summary>{content}</details>"
        if content
        else ""
    )


def rows(cells: Iterable[Sequence[str]]) -> Iterator[Row]:
    """Rows without anchors."""
    return (Row(row) for row in cells)


def code(text: str) -> str:
    """A piece of the model, cut where it is endless."""
    return f"<code>{escape(short(text))}</code>"


def small(text: str) -> str:
    """A remark."""
    return f"<small>{escape(text)}</small>" if text else ""
