"""`acausal simulate`."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path

from acausal.api import CompiledModel
from acausal.cli.commands import Target
from acausal.cli.output import check_writable, print_diagnostics, print_json, print_table, print_text
from acausal.errors import Diagnostic, UsageProblem, fail
from acausal.simulate.names import check_names
from acausal.simulate.result import Result

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

    def chosen(self, result: Result) -> tuple[str, ...]:
        """The variables that are kept: `-v`, else `--all`, else the states and the top level's."""
        if self.everything:
            return tuple(dict.fromkeys([*self.variables, *result.all_names]))
        return self.variables or result.default_names


def run_simulate(target: Target, run: Run, *, as_json: bool) -> None:
    """Compile, integrate, write the files, print the summary. What cannot work is refused before the run."""
    if run.plot is not None and run.plot.suffix.lower() not in _PLOTS:
        problem = f"`{run.plot}` cannot be drawn"
        raise fail(UsageProblem, "usage.plot", problem, hint=f"end the name in {', '.join(_PLOTS)}")
    for file in (run.output, run.plot):
        check_writable(file)
    compiled = CompiledModel(target.run())
    print_diagnostics(compiled.warnings)
    check_names(compiled.code, run.variables)
    result = compiled.simulate(
        stop_time=run.stop_time,
        solver=run.solver,
        rtol=run.rtol,
        atol=run.atol,
        max_step=run.max_step,
        interval=run.interval,
        step=run.step,
        events=run.events,
        keep=lambda partial: _keep(partial, run),
    )
    print_diagnostics(result.warnings)
    names = run.chosen(result)
    write_files(result, names, run)
    if as_json:
        print_json(summary(result, names, run))
    else:
        print_run(result, names, run)


def _keep(partial: Result, run: Run) -> None:
    """Writes what there is of a run that did not get to its end, and says so."""
    if run.output is None and run.plot is None:
        return
    write_files(partial, run.chosen(partial), run)
    message = f"the run stopped before its end; what was written ends at {partial.time[-1]:.9g} s"
    print_diagnostics([Diagnostic("simulate.partial", message, severity="warning")])


def write_files(result: Result, names: tuple[str, ...], run: Run) -> None:
    """The table and the plot that were asked for. Raises `UsageProblem` when a file cannot be written."""
    try:
        if run.output is not None:
            result.to_csv(run.output, names)
        if run.plot is not None:
            result.plot(*names, path=run.plot)
    except OSError as problem:
        what = f"cannot write `{problem.filename or run.output or run.plot}`: {problem.strerror or problem}"
        raise fail(UsageProblem, "usage.output", what) from None


def summary(result: Result, names: tuple[str, ...], run: Run) -> dict[str, object]:
    """The JSON of `acausal simulate`."""
    statistics = asdict(result.statistics)
    return {
        "model": result.system.flat.name,
        **{key: statistics[key] for key in _COSTS},
        **({"max_step_seconds": longest} if (longest := statistics["max_step_seconds"]) is not None else {}),
        **_ending(result),
        "final": result.final(names),
        "result": None if run.output is None else str(run.output),
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
        print_text(f"and {len(names) - len(shown)} more; -o FILE.csv writes all")
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
    for file in (run.output, run.plot):
        if file is not None:
            print_text(f"wrote {file}")


def _row(result: Result, name: str) -> tuple[str, str, str, str]:
    variable = result.variable(name)
    value = result.final([name])[name]
    return name, f"{value:.6g}", result.unit(name), variable.description if variable else ""
