"""`acausal profile`."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path

from acausal.api import CompiledModel
from acausal.cli.commands import Target
from acausal.cli.output import check_writable, print_diagnostics, print_json, print_table, print_text
from acausal.errors import UsageProblem, fail
from acausal.simulate.result import Result
from acausal.symbolic.describe import place

_SHOWN = 30
_PLOTS = (".png", ".svg", ".pdf")


@dataclass(frozen=True)
class Profiling:
    """The settings of `acausal profile`, as they were typed."""

    stop_time: float | None
    rtol: float | None
    plot: Path | None


def run_profile(target: Target, wish: Profiling, *, as_json: bool) -> None:
    """Runs the model with variable steps; prints which states set the step size, and what made the events."""
    if wish.plot is not None and wish.plot.suffix.lower() not in _PLOTS:
        problem = f"`{wish.plot}` cannot be drawn"
        raise fail(UsageProblem, "usage.plot", problem, hint=f"end the name in {', '.join(_PLOTS)}")
    check_writable(wish.plot)
    compiled = CompiledModel(target.load().run(target.parameters))
    print_diagnostics(compiled.warnings)
    result = compiled.simulate(stop_time=wish.stop_time, rtol=wish.rtol, solver="rodas")
    print_diagnostics(result.warnings)
    if wish.plot is not None:
        _draw(result, wish.plot)
    if as_json:
        print_json([asdict(cost) for cost in result.state_costs])
    else:
        _print(result)


def _print(result: Result) -> None:
    cost = result.statistics
    shown = result.state_costs[:_SHOWN]
    rows = [
        (c.state, f"{100 * c.influence:.1f} %", str(c.error_failures), str(c.convergence_failures))
        for c in shown
    ]
    print_table(rows, ("state", "influence", "error failures", "other failures"), right=[1, 2, 3])
    if len(result.state_costs) > len(shown):
        print_text(f"and {len(result.state_costs) - len(shown)} more")
    print_text(
        f"\n{cost.steps} steps and {cost.rejected} refused ones, {cost.rhs_evaluations} evaluations, "
        f"{cost.factorisations} factorisations, {cost.events} events; {cost.cpu_seconds:.3g} s of CPU time"
    )
    phases = [
        f"{name.replace('_', ' ')} {spent:.3g} s" for name, spent in cost.phase_seconds.items() if spent
    ]
    print_text("CPU time by phase: " + ", ".join(phases))
    _print_events(result)


def _print_events(result: Result) -> None:
    """Which lines of the model made the events."""
    shown = result.event_costs[:_SHOWN]
    if not shown:
        return
    print_text("")
    rows = [(cost.what, str(cost.events), place(cost.span)) for cost in shown]
    print_table(rows, ("what changed", "events", "line"), right=[1])
    if len(result.event_costs) > len(shown):
        print_text(f"and {len(result.event_costs) - len(shown)} more")


def _draw(result: Result, path: Path) -> None:
    from acausal.plotting import bars

    costs = result.state_costs[:_SHOWN][::-1]
    values = [100 * cost.influence for cost in costs]
    bars([cost.state for cost in costs], values, "influence on the step size (%)", path)
