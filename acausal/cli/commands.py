"""`acausal check` and `acausal compile`."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from acausal.api import Model, load
from acausal.cli.output import print_diagnostics, print_json, print_table, print_text
from acausal.errors import UsageProblem, fail
from acausal.pipeline import STAGES, Compilation, Stage, print_stage
from acausal.summary import summary_of

if TYPE_CHECKING:
    from acausal.symbolic.causal import CausalSystem

_SHOWN_STATES = 20


@dataclass(frozen=True)
class Target:
    """What a command works on: MODEL, `--class`, `--path`, `-p` and `--only`, as they were typed."""

    model: str
    class_name: str | None
    path: tuple[str, ...]
    assignments: tuple[str, ...]
    only: tuple[str, ...] = ()
    """`--only`: what the compiled model is for; everything where it is empty."""

    def load(self) -> Model:
        return load(self.model, name=self.class_name, path=self.path)

    def run(self, stop_after: Stage = "code") -> Compilation:
        """The pipeline up to a stage."""
        parameters = self.parameters
        return self.load().run(parameters, stop_after, self.only or None)

    @property
    def parameters(self) -> dict[str, str]:
        """Modelica text by name. Raises `UsageProblem` for what is not NAME=VALUE, or is given twice."""
        values: dict[str, str] = {}
        for assignment in self.assignments:
            name, equals, value = (part.strip() for part in assignment.partition("="))
            if not (name and equals and value):
                raise fail(
                    UsageProblem, "usage.parameter", f"`-p {assignment}` is not -p NAME=VALUE", names=[name]
                )
            if name in values:
                raise fail(UsageProblem, "usage.parameter", f"`{name}` is given twice with -p", names=[name])
            values[name] = value
        return values


def run_check(target: Target, *, as_json: bool) -> None:
    """Raises the `AcausalError` of what is wrong; prints the warnings."""
    parameters = target.parameters
    model = target.load()
    warnings = model.check(parameters)
    if as_json:
        print_json([warning.to_json() for warning in warnings])
        return
    print_diagnostics(warnings)
    count = f", {len(warnings)} warning{'s' if len(warnings) != 1 else ''}" if warnings else ""
    print_text(f"{model.title}: no errors{count}")


def run_compile(target: Target, *, stop_after: Stage | None, show: Stage | None, as_json: bool) -> None:
    """Prints a summary, or the text of the stage `show`; stops after that stage if not told otherwise."""
    last = stop_after or show or STAGES[-1]
    if show is not None and STAGES.index(show) > STAGES.index(last):
        problem = f"`--show {show}` comes after `--stop-after {last}`"
        raise fail(UsageProblem, "usage.stage", problem, hint="leave --stop-after out")
    compilation = target.run(last)
    print_diagnostics(compilation.warnings)
    if as_json:
        text = {} if show is None else {"text": print_stage(compilation, show)}
        print_json(summary_of(compilation) | text)
    elif show is not None:
        print_text(print_stage(compilation, show))
    else:
        print_summary(compilation)


def print_summary(compilation: Compilation) -> None:
    """What the model has become, for people."""
    flat, causal = compilation.flat, compilation.causal
    description = f": {flat.description}" if flat is not None and flat.description else ""
    print_text(f"{compilation.node.path}{description}\n")
    print_table(_facts(compilation))
    if causal is not None and causal.states:
        print_text("")
        reasons = {choice.name: choice.reason for choice in causal.choices}
        rows = [_state(causal, name, reasons.get(name, "")) for name in causal.states[:_SHOWN_STATES]]
        print_table(rows, ("state", "unit", "description", "why"))
        if len(causal.states) > _SHOWN_STATES:
            print_text(f"and {len(causal.states) - _SHOWN_STATES} more")


def _facts(compilation: Compilation) -> Iterator[tuple[str, str]]:
    flat, causal = compilation.flat, compilation.causal
    if flat is not None:
        yield "equations", f"{flat.equation_count} in {len(flat.unknowns)} unknowns"
    if causal is not None:
        largest = max(causal.blocks, key=lambda block: block.size, default=None)
        torn = max((len(block.tearing) for block in causal.blocks), default=0)
        yield "aliases", f"{len(causal.aliases)}"
        yield "index", f"{causal.index}"
        yield "states", f"{len(causal.states)}"
        blocks = f"{len(causal.blocks)}"
        yield "blocks", blocks + (f", the largest of {largest.size}, {torn} after tearing" if largest else "")
        yield "zero crossings", f"{len(causal.zero_crossings)}"
        if causal.removed is not None:
            removed = f"{causal.removed.equation_count} equations that {', '.join(causal.removed.outputs)}"
            yield "left out", f"{removed} {'does' if len(causal.removed.outputs) == 1 else 'do'} not need"
    yield "seconds", ", ".join(f"{step} {spent:.3f}" for step, spent in compilation.seconds.items())


def _state(causal: CausalSystem, name: str, reason: str) -> tuple[str, str, str, str]:
    variable = causal.flat.by_name[name]
    return name, variable.unit, variable.description, reason
