"""`acausal export`."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from acausal.api import CompiledModel
from acausal.cli.commands import Target
from acausal.cli.output import check_writable, print_diagnostics, print_json, print_table, print_text
from acausal.errors import UsageProblem, fail
from acausal.export.c_export import export_c
from acausal.export.casadi_model import to_casadi
from acausal.export.package import package_name
from acausal.export.support import check_kernels

_NAME = re.compile(r"(?:'(?:\\.|[^'])*'|\[[^\]]*\]|[^,\['])+")


@dataclass(frozen=True)
class Wish:
    """The settings of `acausal export`, as they were typed."""

    to: str
    output: Path | None
    name: str | None
    solver: str
    step: float | None
    stop_time: float | None
    interval: float | None
    events: str
    tunable: tuple[str, ...]
    variables: tuple[str, ...]
    everything: bool


def names_in(texts: Iterable[str]) -> tuple[str, ...]:
    """The names of `a,b[1,2]` and of further texts: commas in brackets and quotes belong to a name."""
    return tuple(name.strip() for text in texts for name in _NAME.findall(text) if name.strip())


def run_export(target: Target, wish: Wish, *, as_json: bool) -> None:
    """Compiles, writes, and says what was written. What cannot be exported leaves nothing behind."""
    if wish.to == "casadi":
        _export_casadi(target, wish, as_json=as_json)
        return
    if wish.output is not None and wish.output.exists() and not wish.output.is_dir():
        raise fail(UsageProblem, "usage.output", f"`{wish.output}` is a file; an export to C is a folder")
    compiled = CompiledModel(target.run())
    print_diagnostics(compiled.warnings)
    package = export_c(
        compiled.code,
        name=wish.name,
        solver=wish.solver,
        step=wish.step,
        stop_time=wish.stop_time,
        interval=wish.interval,
        events=wish.events,
        tunable=names_in(wish.tunable),
        variables=wish.variables,
        everything=wish.everything,
    )
    folder = wish.output if wish.output is not None else Path(package.name)
    package.write(folder)
    summary = {**package.summary(), "folder": str(folder)}
    if as_json:
        print_json(summary)
        return
    plan = package.plan
    print_text(f"{package.plan.code.system.flat.name} as C in {folder}\n")
    print_table(
        [
            ("states", str(len(plan.code.system.states))),
            ("inputs", str(len(plan.code.system.flat.inputs))),
            ("outputs", str(len(plan.outputs.names))),
            ("tunable", str(len(plan.tunables))),
            ("solver", f"{plan.options.solver} with steps of {plan.options.step:g} s"),
            ("files", f"{len(package.files)}, {sum(map(len, package.files.values())) // 1024} KiB"),
        ]
    )
    print_text(f"\nbuild it: make -C {folder}; run it: {folder}/{package.name} --help")


def _export_casadi(target: Target, wish: Wish, *, as_json: bool) -> None:
    compiled = CompiledModel(target.run())
    print_diagnostics(compiled.warnings)
    check_kernels(compiled.code)
    model = to_casadi(compiled.code, variables=wish.variables, everything=wish.everything)
    name = package_name(wish.name or compiled.name)
    file = wish.output if wish.output is not None else Path(f"{name}.casadi")
    check_writable(file)
    model.save(file)
    if as_json:
        print_json(
            {
                "model": model.name,
                "functions": list(model.functions),
                "states": list(model.names("x")),
                "inputs": list(model.names("u")),
                "outputs": list(model.names("y")),
                "tunables": list(model.names("tunable")),
                "files": {file.name: file.stat().st_size},
            }
        )
        return
    print_text(f"{model.name} as CasADi functions in {file}\n")
    print_table([(name, f"{f.n_instructions()} instructions") for name, f in model.functions.items()])
