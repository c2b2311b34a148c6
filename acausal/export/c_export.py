"""`export_c`: a compiled system as a package of C99 that needs nothing else."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from acausal.codegen.functions import Code
from acausal.errors import UsageProblem, fail
from acausal.export.outputs import chosen_names, outputs
from acausal.export.package import files, package_name
from acausal.export.plan import Plan
from acausal.export.support import check_c
from acausal.export.tunables import tunables
from acausal.simulate.options import resolve
from acausal.simulate.solvers import FIXED

DEFAULT_SOLVER = "heun"


@dataclass(frozen=True)
class Package:
    """An export: its files by their paths, and what the summary says."""

    name: str
    files: dict[str, str]
    plan: Plan

    def write(self, folder: Path) -> list[Path]:
        """Writes all files. Raises `UsageProblem` where that cannot be done."""
        written: list[Path] = []
        try:
            for path, text in self.files.items():
                target = folder / path
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_text(text, encoding="utf-8", newline="\n")
                written.append(target)
        except OSError as problem:
            what = f"cannot write `{problem.filename or folder}`: {problem.strerror or problem}"
            raise fail(UsageProblem, "usage.output", what) from None
        return written

    def summary(self) -> dict[str, object]:
        """What was exported, as JSON."""
        system = self.plan.code.system
        options = self.plan.options
        return {
            "model": system.flat.name,
            "name": self.name,
            "solver": options.solver,
            "step": options.step,
            "states": list(system.states),
            "inputs": [variable.name for variable in system.flat.inputs],
            "outputs": list(self.plan.outputs.names),
            "tunables": [t.name for t in self.plan.tunables],
            "zero_crossings": len(system.zero_crossings),
            "jacobian_entries": self.plan.code.pattern.nnz(),
            "files": {path: len(text.encode()) for path, text in self.files.items()},
        }


def export_c(
    code: Code,
    *,
    name: str | None = None,
    solver: str = DEFAULT_SOLVER,
    step: float | None = None,
    stop_time: float | None = None,
    interval: float | None = None,
    events: str = "locate",
    tunable: Sequence[str] = (),
    variables: Sequence[str] = (),
    everything: bool = False,
) -> Package:
    """The package of a system; `tunable` and `variables` are names, `everything` asks for all variables.

    Raises `UnsupportedProblem` for what has no C, `UsageProblem` and `LookupProblem` for what cannot be.
    """
    if solver not in FIXED:
        hint = f"there is {', '.join(FIXED)}"
        message = f"`{solver}` cannot be exported: it has no steps of one length"
        raise fail(UsageProblem, "export.solver", message, names=[solver], hint=hint)
    check_c(code)
    options = resolve(
        code.system.flat.experiment,
        stop_time=stop_time,
        interval=interval,
        solver=solver,
        step=step,
        events=events,
        has_events=bool(code.located),
    )
    chosen = outputs(code, chosen_names(code, variables, everything))
    plan = Plan(code, chosen, tunables(code, tunable), options)
    title = package_name(name or code.system.flat.name)
    return Package(title, files(plan, title), plan)
