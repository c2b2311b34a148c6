"""How the command line prints: JSON, diagnostics, stage texts and tables. Lines are wrapped nowhere."""

from __future__ import annotations

import json
import math
import os
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, TextIO, cast

from acausal.errors import Diagnostic, UsageProblem, fail

if TYPE_CHECKING:
    from rich.console import Console
    from rich.text import Text

_CONTROL = dict.fromkeys((*range(9), *range(11, 32), 127), "\N{REPLACEMENT CHARACTER}")
_UNLIMITED = 10_000
_STYLES = {"error": "bold red", "warning": "bold yellow"}


def print_json(value: object) -> None:
    """One JSON value on standard output; a number that is not finite is null."""
    print(json.dumps(_finite(value), indent=2, allow_nan=False))


def _finite(value: object) -> object:
    match value:
        case float() if not math.isfinite(value):
            return None
        case dict():
            return {key: _finite(item) for key, item in cast("dict[str, object]", value).items()}
        case list() | tuple():
            return [_finite(item) for item in cast("Sequence[object]", value)]
        case _:
            return value


def print_diagnostics(problems: Iterable[Diagnostic]) -> None:
    """`file:line:column: error: ...` with the source line and the hint, on standard error."""
    texts = [problem.render().translate(_CONTROL) for problem in problems]
    if not texts:
        return
    if not sys.stderr.isatty():
        print("\n".join(texts), file=sys.stderr)
        return
    output = console(sys.stderr)
    for text in texts:
        for line in text.split("\n"):
            output.print(_coloured(line), soft_wrap=True)


def _coloured(line: str) -> Text:
    from rich.text import Text

    text = Text(line)
    for word, style in _STYLES.items():
        text.highlight_regex(rf"(?:^|(?<=: )){word}(?=: )", style)
    text.highlight_regex(r"^ +\| +\^+$", "red")
    text.highlight_regex(r"^  hint: ", "bold cyan")
    text.highlight_regex(r" \[[a-z-]+(?:\.[a-z-]+)*\]$", "dim")
    return text


def print_text(text: str) -> None:
    """A text as it is."""
    sys.stdout.write(text if text.endswith("\n") else text + "\n")


def print_table(rows: Iterable[Sequence[str]], titles: Sequence[str] = (), right: Iterable[int] = ()) -> None:
    """A table without frame; columns in `right` are numbers. Only the last column may be broken."""
    from rich.table import Table
    from rich.text import Text

    cells = [tuple(row) for row in rows]
    columns = len(titles) or max(map(len, cells), default=0)
    table = Table(
        box=None, pad_edge=False, padding=(0, 2, 0, 0), show_header=bool(titles), header_style="bold"
    )
    numbers = tuple(right)
    for i in range(columns):
        justify = "right" if i in numbers else "left"
        title = titles[i] if titles else ""
        table.add_column(title, justify=justify, no_wrap=i < columns - 1, overflow="fold")
    for row in cells:
        table.add_row(*(Text(cell) for cell in row))
    output = console(sys.stdout)
    with output.capture() as captured:
        output.print(table)
    print_text("\n".join(line.rstrip() for line in captured.get().splitlines()))


def console(stream: TextIO) -> Console:
    """A rich console that neither guesses colours nor, unless a person is looking, breaks lines."""
    from rich.console import Console

    width = None if stream.isatty() else _UNLIMITED
    return Console(file=stream, highlight=False, markup=False, emoji=False, soft_wrap=False, width=width)


def check_writable(file: Path | None) -> None:
    """Raises `UsageProblem` when `file` cannot be written."""
    if file is None:
        return
    if file.is_dir():
        raise fail(UsageProblem, "usage.output", f"`{file}` is a folder")
    if not file.parent.is_dir():
        raise fail(
            UsageProblem, "usage.output", f"there is no folder `{file.parent}` to write `{file.name}` to"
        )
    if not os.access(file if file.exists() else file.parent, os.W_OK):
        raise fail(UsageProblem, "usage.output", f"`{file}` cannot be written", hint="check its permissions")
