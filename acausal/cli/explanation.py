"""`acausal explain`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from acausal.cli.commands import Target
from acausal.cli.output import check_writable, print_diagnostics, print_json, print_text
from acausal.errors import UsageProblem, fail
from acausal.explain.explanation import Explanation, explain

_PLOTS = (".png", ".svg", ".pdf")


@dataclass(frozen=True)
class Wish:
    """The settings of `acausal explain`, as they were typed."""

    block: int | None
    latex: bool
    everything: bool
    plot: Path | None
    html: Path | None


def run_explain(target: Target, wish: Wish, *, as_json: bool) -> None:
    """Compile as far as the causal system, write the files, print. What cannot work is refused first."""
    check(wish)
    explanation = explain(target.run("causal"))
    text = _json(explanation, wish) if as_json else _text(explanation, wish)
    write(explanation, wish)
    if isinstance(text, str):
        print_text(text)
        for file in (wish.plot, wish.html):
            if file is not None:
                print_text(f"wrote {file}")
    else:
        print_diagnostics(explanation.warnings)
        print_json(text)


def check(wish: Wish) -> None:
    """Raises `UsageProblem` for settings that do not fit."""
    if wish.latex and wish.block is None:
        raise fail(UsageProblem, "usage.latex", "--latex is about one block", hint="add --block NUMBER")
    if wish.plot is not None and wish.plot.suffix.lower() not in _PLOTS:
        problem = f"`{wish.plot}` cannot be drawn"
        raise fail(UsageProblem, "usage.plot", problem, hint=f"end the name in {', '.join(_PLOTS)}")
    for file in (wish.plot, wish.html):
        check_writable(file)


def write(explanation: Explanation, wish: Wish) -> None:
    """The drawing and the page that were asked for. Raises `UsageProblem` when a file cannot be written."""
    try:
        if wish.plot is not None:
            explanation.plot(wish.plot)
        if wish.html is not None:
            wish.html.write_text(explanation.html(), encoding="utf-8")
    except OSError as problem:
        what = f"cannot write `{problem.filename or wish.html}`: {problem.strerror or problem}"
        raise fail(UsageProblem, "usage.output", what) from None


def _text(explanation: Explanation, wish: Wish) -> str:
    if wish.block is not None:
        return explanation.block_text(wish.block, latex=wish.latex)
    from acausal.explain.text import explanation_text

    return explanation_text(explanation, everything=wish.everything)


def _json(explanation: Explanation, wish: Wish) -> dict[str, object]:
    from acausal.explain.data import block_data, with_latex

    if wish.block is None:
        return explanation.to_json()
    data = block_data(explanation, wish.block)
    return with_latex(data, explanation.block(wish.block)) if wish.latex else data
