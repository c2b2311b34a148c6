"""The report that `make run` prints."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rich.console import Console
from rich.table import Table
from rich.text import Text

from acausal.api import CompiledModel
from acausal.demo.systems import TOLERANCE, GearTrial, RegulatorTrial
from acausal.symbolic.causal import CausalEquation

BAR = 1e5
_WIDTH = 108


def print_gears(console: Console, trials: Sequence[GearTrial]) -> None:
    """One line for each gear."""
    console.rule("[bold]1  Kinematics of the ten-speed: TenSpeed.Examples.FixedGear", align="left")
    console.print(
        "Eight bodies, four rigid planetary gearsets, three of seven elements engaged. Index reduction\n"
        "leaves one degree of freedom. Ratio: input over output speed at the end of a run-up with 150 N m.\n"
    )
    titles = ("gear", "engaged", "published", "simulated", "deviation")
    counts = ("equations", "aliases", "index", "states", "blocks", "largest", "seconds")
    table = _table((*titles, *counts), left=("engaged", "largest"))
    for trial in trials:
        good = abs(trial.deviation) <= TOLERANCE
        table.add_row(
            trial.title,
            trial.engaged,
            f"{trial.published:.3f}",
            f"{trial.ratio:.4f}",
            Text(f"{trial.deviation:+.4f}", style="green" if good else "bold red"),
            *_counts(trial.compiled),
            f"{trial.compile_seconds:.3f}",
        )
    console.print(table)
    if trials:
        states = ", ".join(trials[0].compiled.states)
        console.print(
            f"\nStates in every gear: {states}. Largest: unknowns of the largest block -> after tearing."
        )
        console.print("Seconds: parse, flatten, causalise and generate, on this machine.\n")


def print_regulators(console: Console, trials: Sequence[RegulatorTrial]) -> None:
    """One line for each supply, then the states and why one of them is gone."""
    console.rule("[bold]2  Main regulator: one valve, three supplies", align="left")
    console.print(
        "Spool with spring, three metering edges, feedback and pilot chambers behind orifices, line volume.\n"
        "Only the source at the line differs; no component is edited or told.\n"
    )
    titles = ("TenSpeed.Examples", "equations", "aliases", "index", "states", "blocks", "largest")
    table = _table((*titles, "line [bar]", "spool [mm]"), left=("TenSpeed.Examples", "largest"))
    for trial in trials:
        line, spool = trial.final("line.p") / BAR, trial.final("valve.spool.s") * 1e3
        table.add_row(trial.model, *_counts(trial.compiled), f"{line:.3f}", f"{spool:.3f}")
    console.print(table)
    console.print()
    for trial in trials:
        console.print(
            f"[bold]{trial.model}[/] ({trial.supply}): {len(trial.compiled.states)} states", highlight=False
        )
        for line in _explained(trial, trials[0]):
            console.print(Text(f"  {line}"), soft_wrap=True)
    console.print()
    print_seconds(console, trials)


def _explained(trial: RegulatorTrial, whole: RegulatorTrial) -> Iterator[str]:
    """The states; where one is missing that `whole` has, the constraint that holds it."""
    yield ", ".join(trial.compiled.states)
    for name in whole.compiled.states:
        if name not in trial.compiled.states:
            yield f"no state: {name}. Its derivative follows from an equation that was differentiated:"
            yield from (f"  {_source(equation)}" for equation in trial.differentiated)


def _source(equation: CausalEquation, width: int = 60) -> str:
    """The equation as it is written in its component, and where."""
    span, component = equation.flat.span, equation.flat.component
    text = " ".join(span.text.split())
    shown = text if len(text) <= width else f"{text[: width - 4]} ..."
    return f"{shown}  [{component}, {span.file.rpartition('/')[2]}:{span.line}]"


def print_seconds(console: Console, trials: Sequence[RegulatorTrial]) -> None:
    """Where the time went."""
    steps = ("parse", "flatten", "causalise", "codegen", "total")
    table = _table(("seconds", *steps, "run", "steps", "evaluations"), left=("seconds",))
    for trial in trials:
        seconds, cost = trial.compiled.compilation.seconds, trial.result.statistics
        spent = [f"{seconds[step]:.3f}" for step in steps]
        table.add_row(
            trial.model, *spent, f"{trial.run_seconds:.3f}", f"{cost.steps}", f"{cost.rhs_evaluations}"
        )
    console.print(table)
    console.print()


def _counts(compiled: CompiledModel) -> tuple[str, ...]:
    """Equations, aliases, index, states, blocks, the largest block."""
    causal = compiled.causal
    largest = max((block.size for block in causal.blocks), default=0)
    torn = max((len(block.tearing) for block in causal.blocks), default=0)
    numbers = (
        len(causal.flat.equations),
        len(causal.aliases),
        causal.index,
        len(causal.states),
        len(causal.blocks),
    )
    return (*map(str, numbers), f"{largest} -> {torn}" if largest > 1 else f"{largest}")


def _table(titles: Sequence[str], left: Sequence[str]) -> Table:
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="bold")
    for title in titles:
        table.add_column(Text(title), justify="left" if title in left else "right", no_wrap=True)
    return table


def report_console() -> Console:
    """A console that also records, wide enough for the tables."""
    console = Console(record=True, highlight=False)
    console.width = max(console.width, _WIDTH) if console.is_terminal else _WIDTH
    return console
