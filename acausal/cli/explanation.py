"""`acausal explain`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from acausal.cli.commands import Target
from acausal.cli.output import check_writable, print_diagnostics, print_json, print_text
from acausal.errors import AcausalError, UsageProblem, fail
from acausal.explain.explanation import Explanation, explain

if TYPE_CHECKING:
    from acausal.codegen.functions import Code

_PLOTS = (".png", ".svg", ".pdf")


@dataclass(frozen=True)
class Wish:
    """The settings of `acausal explain`, as they were typed."""

    block: int | None
    latex: bool
    everything: bool
    plot: Path | None
    html: Path | None
    initial: bool = False


def run_explain(target: Target, wish: Wish, *, as_json: bool) -> None:
    """Compile as far as the causal system, write the files, print. What cannot work is refused first."""
    check(wish)
    try:
        compilation = target.run("code" if wish.initial else "causal")
    except AcausalError as error:
        _show_singular(target, wish, error, as_json=as_json)
        raise
    explanation = explain(compilation)
    if wish.initial and compilation.code is not None:
        _initial(explanation, compilation.code, everything=wish.everything, as_json=as_json)
        return
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


def _show_singular(target: Target, wish: Wish, error: AcausalError, *, as_json: bool) -> None:
    """Of a model that does not compile, what can be seen of its structure, if that is what is wrong."""
    from acausal.explain.singular import singular_text

    try:
        flat = target.run("flat").flat
    except AcausalError:
        return
    text = singular_text(flat, everything=wish.everything) if flat is not None else ""
    if flat is None or not text:
        return
    if not as_json:
        print_text(text)
        print_text("")
    if wish.plot is not None or wish.html is not None:
        from acausal.explain.singular_plot import singular_page, write_singular_plot

        if wish.plot is not None:
            write_singular_plot(flat, wish.plot)
        if wish.html is not None:
            wish.html.write_text(singular_page(flat, str(error)), encoding="utf-8")


def _initial(explanation: Explanation, code: Code, *, everything: bool, as_json: bool) -> None:
    """`--initial`: the conditions, and the point that they lead to."""
    from acausal.explain.start import initial_report
    from acausal.explain.text import initial_text

    if not as_json:
        print_text(initial_text(explanation))
        print_text("")
    report = initial_report(code)
    print_diagnostics(report.warnings)
    if as_json:
        print_json(explanation.to_json() | {"initial_point": report.to_json()})
    else:
        print_text(report.text(everything=everything))


def check(wish: Wish) -> None:
    """Raises `UsageProblem` for settings that do not fit."""
    if wish.latex and wish.block is None:
        raise fail(UsageProblem, "usage.latex", "--latex is about one block", hint="add --block NUMBER")
    if wish.initial and (wish.block is not None or wish.plot is not None or wish.html is not None):
        hint = "leave --block, --plot and --html out"
        raise fail(UsageProblem, "usage.initial", "--initial prints a report of its own", hint=hint)
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
