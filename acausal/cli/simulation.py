"""`acausal simulate`."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path

from acausal.api import CompiledModel
from acausal.cli.commands import Target
from acausal.cli.output import check_writable, print_diagnostics, print_json, print_table, print_text
from acausal.cli.progress import Progress
from acausal.errors import Diagnostic, UsageProblem, fail
from acausal.lang.flat import Variable
from acausal.results.parquet_file import part_of
from acausal.results.signals import Vector
from acausal.results.stored import StoredResult, check_format, read_result
from acausal.simulate.names import check_names
from acausal.simulate.result import Result
from acausal.simulate.selection import default_names
from acausal.simulate.simulate import simulate
from acausal.simulate.standing import Standing
from acausal.simulate.stream import Store, read_end
from acausal.symbolic.causal import CausalSystem

_SHOWN = 40
_COSTS = (
    "solver",
    "stop_time",
    "steps",
    "rhs_evaluations",
    "jacobian_evaluations",
    "events",
    "cpu_seconds",
    "real_time_factor",
)
_PLOTS = (".png", ".svg", ".pdf")


@dataclass(frozen=True)
class Run:
    """The settings of `acausal simulate`, as they were typed."""

    stop_time: float | None
    solver: str
    rtol: float | None
    atol: float | None
    max_step: float | None
    interval: float | None
    variables: tuple[str, ...]
    everything: bool
    output: Path | None
    plot: Path | None
    step: float | None = None
    events: str = "locate"

    after: Path | None = None

    @property
    def file(self) -> Path | None:
        """Where the rows go: a run that goes on adds to its file, unless another one is named."""
        return self.output if self.output is not None else self.after

    def chosen(self, system: CausalSystem) -> tuple[str, ...]:
        """The variables that are kept: `-v`, else `--all`, else the states and the top level's."""
        if self.everything:
            return tuple(dict.fromkeys([*self.variables, *(v.name for v in system.flat.unknowns)]))
        return self.variables or default_names(system)


def run_simulate(target: Target, run: Run, *, as_json: bool) -> None:
    """Compile, integrate, write the files, print the summary. What cannot work is refused before the run."""
    if run.plot is not None and run.plot.suffix.lower() not in _PLOTS:
        problem = f"`{run.plot}` cannot be drawn"
        raise fail(UsageProblem, "usage.plot", problem, hint=f"end the name in {', '.join(_PLOTS)}")
    for file in (run.file, run.plot):
        check_writable(file)
    if run.file is not None:
        check_format(run.file)
    compiled = CompiledModel(target.run())
    print_diagnostics(compiled.warnings)
    check_names(compiled.code, run.variables)
    result, names = _run(compiled, run)
    print_diagnostics(result.warnings)
    if run.plot is not None:
        _draw(result, names, run.plot)
    if as_json:
        print_json(summary(result, names, run))
    else:
        print_run(result, names, run)


def _run(compiled: CompiledModel, run: Run) -> tuple[Result, tuple[str, ...]]:
    """The run, and the variables that are kept of it."""
    names = run.chosen(compiled.causal)
    standing = store = None
    if run.after is not None:
        standing = read_end(run.after)
        names, store = continued(run, standing)
    elif run.output is not None:
        store = Store(run.output, names)
    progress = progress_of(compiled, run, standing)
    with progress.watching():
        result = simulate(
            compiled.code,
            stop_time=run.stop_time,
            solver=run.solver,
            rtol=run.rtol,
            atol=run.atol,
            max_step=run.max_step,
            interval=run.interval,
            step=run.step,
            events=run.events,
            keep=lambda partial: _keep(partial, names, run),
            store=store,
            after=standing,
            progress=progress,
        )
    return result, names


def continued(run: Run, standing: Standing) -> tuple[tuple[str, ...], Store]:
    """The variables of the stored run, and the file: its own, or another that gets its rows first."""
    assert run.after is not None
    stored = read_result(run.after if run.after.is_file() else part_of(run.after))
    _check_rows(run.after, stored, standing)
    if run.everything or (run.variables and run.variables != stored.names):
        problem = f"`{run.after}` holds the variables that it was begun with"
        raise fail(UsageProblem, "usage.continue", problem, hint="leave -v and --all out")
    if run.output is None or run.output.absolute() == run.after.absolute():
        return stored.names, Store(run.after, stored.names, standing.rows)
    return stored.names, Store(run.output, stored.names, standing.rows, stored)


def _check_rows(path: Path, stored: StoredResult, standing: Standing) -> None:
    """Raises `UsageProblem` where the file is not the one that the run left: cut short or exchanged."""
    count, rows = len(stored.time), standing.rows
    if count < rows:
        why = f"it holds {count} rows, and the run wrote {rows}"
    elif rows and float(stored.time[rows - 1]) != standing.time:
        why = f"its row {rows} is of {stored.time[rows - 1]:g} s, and the run stood at {standing.time:g} s"
    else:
        return
    problem = f"`{path}` cannot be continued: {why}"
    raise fail(UsageProblem, "usage.continue", problem, hint="it was cut short or changed: run it anew")


def progress_of(compiled: CompiledModel, run: Run, standing: Standing | None) -> Progress:
    """The progress of a run from its start, or from where it goes on, to its stop time."""
    experiment = compiled.flat.experiment
    start = experiment.start_time or 0.0
    stop = run.stop_time if run.stop_time is not None else experiment.stop_time
    return Progress(start if standing is None else standing.time, start + 1.0 if stop is None else stop)


def _keep(partial: Result, names: tuple[str, ...], run: Run) -> None:
    """Says what there is of a run that did not get to its end."""
    if run.plot is not None:
        _draw(partial, names, run.plot)
    if run.file is None and run.plot is None:
        return
    message = f"the run stopped before its end; what was written ends at {partial.time[-1]:.9g} s"
    can = run.file is not None and partial.standing is not None
    hint = f"to go on: --continue {run.file}" if can else ""
    print_diagnostics([Diagnostic("simulate.partial", message, hint=hint, severity="warning")])


def _draw(result: Result, names: tuple[str, ...], path: Path) -> None:
    """Draws what the run kept. Raises `UsageProblem` when the file cannot be written."""
    from acausal.plotting import plot  # Matplotlib takes half a second to import

    try:
        plot(result if result.file is None else _Written(read_result(result.file), result), names, path)
    except OSError as problem:
        what = f"cannot write `{problem.filename or path}`: {problem.strerror or problem}"
        raise fail(UsageProblem, "usage.output", what) from None


@dataclass(frozen=True, eq=False)
class _Written:
    """The rows of a file with the units of the model: what a plot needs."""

    stored: StoredResult
    result: Result

    @property
    def time(self) -> Vector:
        return self.stored.time

    @property
    def default_names(self) -> tuple[str, ...]:
        return self.stored.names

    def values(self, name: str) -> Vector:
        return self.stored.values(name)

    def unit(self, name: str) -> str:
        return self.result.unit(name)

    def variable(self, name: str) -> Variable | None:
        return self.result.variable(name)


def event_sources(result: Result) -> list[dict[str, object]]:
    """Conditions and discrete variables behind the events, with their lines; most events first."""
    return [
        {"source": cost.what, "file": cost.span.file, "line": cost.span.line, "events": cost.events}
        for cost in result.event_costs
    ]


def summary(result: Result, names: tuple[str, ...], run: Run) -> dict[str, object]:
    """The JSON of `acausal simulate`."""
    statistics = asdict(result.statistics)
    return {
        "model": result.system.flat.name,
        **{key: statistics[key] for key in _COSTS},
        **({"max_step_seconds": longest} if (longest := statistics["max_step_seconds"]) is not None else {}),
        **_ending(result),
        **({"warnings": [w.to_json() for w in result.warnings]} if result.warnings else {}),
        "final": result.final(names),
        "result": None if run.file is None else str(run.file),
        "rejected": statistics["rejected"],
        "phase_seconds": statistics["phase_seconds"],
        "event_sources": event_sources(result),
    }


def _ending(result: Result) -> dict[str, object]:
    """`terminated`, where the model ended the run."""
    if result.ended is None:
        return {}
    return {"terminated": {"time": result.ended.time, "message": result.ended.message}}


def print_run(result: Result, names: tuple[str, ...], run: Run) -> None:
    """Final values, assumed starts and what the run cost, for people."""
    cost = result.statistics
    shown = names[:_SHOWN]
    print_text(f"{result.system.flat.name} at {cost.stop_time:g} s\n")
    titles = ("variable", "value", "unit", "description")
    print_table([_row(result, name) for name in shown], titles, right=[1])
    if len(names) > len(shown):
        print_text(f"and {len(names) - len(shown)} more; -o FILE writes all")
    assumed = [f"{start.name} = {start.value:g}" for start in result.starts if start.reason == "assumed"]
    if assumed:
        more = f" and {len(assumed) - _SHOWN} more" if len(assumed) > _SHOWN else ""
        print_text(f"\nassumed at the start, since not fixed: {', '.join(assumed[:_SHOWN])}{more}")
    changes = f", {cost.state_selections} changes of states" if cost.state_selections else ""
    print_text(
        f"\n{cost.solver}: {cost.steps} steps, {cost.rhs_evaluations} evaluations, "
        f"{cost.jacobian_evaluations} Jacobians, {cost.events} events{changes}\n"
        f"{cost.cpu_seconds:.3g} s of CPU time, {cost.real_time_factor:.3g} times real time"
    )
    if result.ended is not None:
        print_text(f"ended by the model at {result.ended.time:g} s: {result.ended.message}")
    for file in (run.file, run.plot):
        if file is not None:
            print_text(f"wrote {file}")


def _row(result: Result, name: str) -> tuple[str, str, str, str]:
    variable = result.variable(name)
    value = result.final([name])[name]
    return name, f"{value:.6g}", result.unit(name), variable.description if variable else ""
