"""The Python interface: `load` or `loads` a model, `compile` it, `simulate`, look at it.

>>> import acausal
>>> decay = acausal.loads("model Decay Real x(start = 1, fixed = true); equation der(x) = -x; end Decay;")
>>> run = decay.compile().simulate(stop_time=1.0)
>>> round(float(run["x"][-1]), 4)
0.3679
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, cast

from acausal.analysis.methods import Linearizing
from acausal.errors import Diagnostic, Source, UsageProblem, fail
from acausal.lang.base_reading import decoded, is_base_modelica
from acausal.lang.flat import FlatModel
from acausal.lang.library import Library, read_source
from acausal.pipeline import Compilation, Stage, compile_model, print_stage
from acausal.sources import (
    FILE_ENDINGS,
    ParameterValue,
    add_source,
    as_modelica,
    class_name,
    existing_file,
    searched_directories,
    stored_root,
)
from acausal.summary import summary_of
from acausal.symbolic.balance import check_balance
from acausal.symbolic.parameters import order_parameters
from acausal.symbolic.user_lines import at_users_lines

if (
    TYPE_CHECKING
):  # CasADi, SUNDIALS and xarray take a second to import, and checking a model needs none of them
    from acausal.codegen.functions import Code
    from acausal.explain.explanation import Explanation
    from acausal.export.c_export import Package
    from acausal.export.casadi_model import CasadiModel
    from acausal.simulate.inputs import InputValue
    from acausal.simulate.jacobian import Jacobian
    from acausal.simulate.overrides import Override
    from acausal.simulate.result import Result
    from acausal.simulate.simulate import After
    from acausal.symbolic.causal import Block, CausalSystem


@dataclass(frozen=True)
class Model:
    """A class that can be compiled: where it is found and its full name."""

    library: Library
    name: str
    parse_seconds: float = 0.0
    """What reading and parsing it took; files of a library that it uses are read when they are needed."""

    @property
    def title(self) -> str:
        """The full name; of a file of Base Modelica, that of the model it was made from."""
        definition = self.library.find(self.name).definition
        return decoded(definition.name) if is_base_modelica(definition.span.source) else self.name

    def check(
        self, parameters: Mapping[str, ParameterValue] | None = None, /, **more: ParameterValue
    ) -> tuple[Diagnostic, ...]:
        """Names, types, units and the balance of equations; returns warnings, raises `AcausalError`.

        A model with connectors of its own is judged as a component: something may be connected to them.
        """
        compilation = self.run({**(parameters or {}), **more}, stop_after="flat")
        assert compilation.flat is not None
        check_flat(compilation.flat)
        return compilation.warnings

    def compile(
        self,
        parameters: Mapping[str, ParameterValue] | None = None,
        /,
        only: Sequence[str] | None = None,
        **more: ParameterValue,
    ) -> CompiledModel:
        """Compile with parameters applied: `compile(R=2)`, or `compile({"motor.R": 2})` for dotted names.

        A string is Modelica text. `only` names variables (`"line.p"`, `"der(x)"`): what they do not need is
        left out, which makes a run cheaper and changes no value of what is left. A parameter of that name is
        given as `{"only": ...}`. Raises the `AcausalError` of the stage that finds something wrong.
        """
        return CompiledModel(self.run({**(parameters or {}), **more}, only=only))

    def show(self, stage: Stage) -> str:
        """The text of one stage of the pipeline: `ast`, `instance`, `flat`, `causal` or `code`."""
        return print_stage(self.run({}, stop_after=stage), stage)

    def run(
        self,
        parameters: Mapping[str, ParameterValue],
        stop_after: Stage = "code",
        only: Sequence[str] | None = None,
    ) -> Compilation:
        """The pipeline up to a stage. Raises the `AcausalError` of the stage that finds something wrong."""
        texts = {name: as_modelica(value, name) for name, value in parameters.items()}
        _check_only(only)
        compilation = compile_model(self.library, self.name, texts, stop_after, outputs=only)
        seconds = dict(compilation.seconds)
        for step in ("parse", "total"):
            seconds[step] += self.parse_seconds
        return replace(compilation, seconds=seconds)

    def __repr__(self) -> str:
        return f"<Model {self.name}>"


@dataclass(frozen=True)
class CompiledModel(Linearizing):
    """A model that went through the whole pipeline; every stage can be looked at."""

    compilation: Compilation

    @property
    def flat(self) -> FlatModel:
        assert self.compilation.flat is not None
        return self.compilation.flat

    @property
    def causal(self) -> CausalSystem:
        assert self.compilation.causal is not None
        return self.compilation.causal

    @property
    def code(self) -> Code:
        assert self.compilation.code is not None
        return self.compilation.code

    @property
    def name(self) -> str:
        return self.flat.name

    @property
    def states(self) -> tuple[str, ...]:
        """Names of the continuous states after index reduction."""
        return self.causal.states

    @property
    def index(self) -> int:
        """0 explicit ODE, 1 with algebraic parts, +1 per level of differentiation."""
        return self.causal.index

    @property
    def blocks(self) -> tuple[Block, ...]:
        return self.causal.blocks

    @property
    def warnings(self) -> tuple[Diagnostic, ...]:
        return self.compilation.warnings

    @property
    def summary(self) -> dict[str, object]:
        """The keys of `acausal compile --json`."""
        return summary_of(self.compilation)

    def show(self, stage: Stage) -> str:
        """The text of one stage: `ast`, `instance`, `flat`, `causal` or `code`."""
        return print_stage(self.compilation, stage)

    def explain(self) -> Explanation:
        """What every stage did to the model, and why: `print` it, or use `.to_json()` and `.html()`."""
        from acausal.explain.explanation import explain

        return explain(self.compilation)

    def simulate(
        self,
        *,
        stop_time: float | None = None,
        start_time: float | None = None,
        rtol: float | None = None,
        atol: float | None = None,
        max_step: float | None = None,
        interval: float | None = None,
        solver: str = "auto",
        step: float | None = None,
        events: str = "locate",
        compiled: bool | None = None,
        keep: Callable[[Result], None] | None = None,
        parameters: Mapping[str, Override] | None = None,
        start: Mapping[str, float] | None = None,
        inputs: Mapping[str, InputValue] | None = None,
        store: str | Path | None = None,
        variables: Sequence[str] | None = None,
        after: After | None = None,
        progress: Callable[[float], None] | None = None,
    ) -> Result:
        """Integrate from `start_time` to `stop_time` (s).

        What is not given comes from the `experiment` annotation, else it is 0 to 1 s, 1e-6, 1/500 of the
        duration. `parameters` and `start` change tunable parameters and start values without compiling again.
        `inputs` gives the model's inputs: constants, functions of time, or tables `(times, values)`.
        `store` writes `variables` to a file while the run goes on, `after` continues a run or stored result.
        These and the rest are those of `acausal.simulate.simulate`. Raises `InitializationProblem`,
        `SimulationProblem`, and `UsageProblem` for settings that cannot be.
        """
        from acausal.simulate.simulate import simulate

        return simulate(
            self.code,
            stop_time=stop_time,
            start_time=start_time,
            rtol=rtol,
            atol=atol,
            max_step=max_step,
            interval=interval,
            solver=solver,
            step=step,
            events=events,
            compiled=compiled,
            keep=keep,
            parameters=parameters,
            start=start,
            inputs=inputs,
            store=store,
            variables=variables,
            after=after,
            progress=progress,
        )

    def export_c(
        self,
        folder: str | Path,
        *,
        name: str | None = None,
        solver: str = "heun",
        step: float | None = None,
        stop_time: float | None = None,
        interval: float | None = None,
        events: str = "locate",
        tunable: Sequence[str] = (),
        variables: Sequence[str] = (),
        everything: bool = False,
    ) -> Package:
        """Write a package of C99 that runs the model without anything else; see docs/export.md.

        Settings are those of `simulate` with a fixed-step `solver`; `tunable` names what the program takes
        from its table of parameters (`"all"` for all), `variables` its outputs. Raises `UnsupportedProblem`
        for what has no C, `UsageProblem` and `LookupProblem`.
        """
        from acausal.export.c_export import export_c

        package = export_c(
            self.code,
            name=name,
            solver=solver,
            step=step,
            stop_time=stop_time,
            interval=interval,
            events=events,
            tunable=tunable,
            variables=variables,
            everything=everything,
        )
        package.write(Path(folder))
        return package

    def to_casadi(
        self,
        *,
        variables: Sequence[str] = (),
        everything: bool = False,
        parameters: Mapping[str, Override] | None = None,
        start: Mapping[str, float] | None = None,
        inputs: Mapping[str, InputValue] | None = None,
    ) -> CasadiModel:
        """CasADi Functions `ode`, `dae`, `jac`, `events`, `update`, `outputs`, `initial`; see docs/export.md.

        `variables` names the outputs; the rest says from which start the labels have their values.
        """
        from acausal.export.casadi_model import to_casadi

        return to_casadi(
            self.code,
            variables=variables,
            everything=everything,
            parameters=parameters,
            start=start,
            inputs=inputs,
        )

    def jacobian(
        self,
        of: str = "derivatives",
        wrt: str = "states",
        *,
        time: float | None = None,
        states: Mapping[str, float] | None = None,
        parameters: Mapping[str, Override] | None = None,
        start: Mapping[str, float] | None = None,
        inputs: Mapping[str, InputValue] | None = None,
    ) -> Jacobian:
        """The exact sparse Jacobian of `derivatives`, `events`, `outputs` or `residuals`, with names.

        `wrt` are `states`, `inputs` or `parameters`; for residuals also `unknowns`. The point is the initial
        one at `time` (s), with some `states` replaced. Raises `UsageProblem`, `LookupProblem`,
        `InitializationProblem` and `SimulationProblem`.
        """
        from acausal.simulate.jacobian import jacobian_at

        when = time if time is not None else self.flat.experiment.start_time or 0.0
        return jacobian_at(
            self.code, of, wrt, time=when, states=states, parameters=parameters, start=start, inputs=inputs
        )

    def __repr__(self) -> str:
        states = ", ".join(self.states) or "none"
        return f"<CompiledModel {self.name}: index {self.index}, {len(self.states)} states ({states})>"

    def _repr_html_(self) -> str:
        from acausal.explain.html import html_fragment

        return html_fragment(self.explain())


def _check_only(only: object) -> None:
    """Raises `UsageProblem` where `only=` is not a list of names; callers without types may pass anything."""
    if only is None:
        return
    if isinstance(only, list | tuple):
        names = cast("Sequence[object]", only)
        if names and all(isinstance(name, str) for name in names):
            return
    hint = 'a parameter of this name is given as compile({"only": ...})'
    raise fail(UsageProblem, "usage.only", "`only` is a list of the names of variables", hint=hint)


def load(name_or_path: str | Path, *, name: str | None = None, path: Sequence[str | Path] = ()) -> Model:
    """A model by its dotted name on the library path, or from a file `FILE.mo` or `FILE.bmo`.

    From a file, `name` picks the class (default: the last one in it); `path` is searched before MODELICAPATH.
    Raises `UsageProblem`, `LookupProblem` and `SyntaxProblem`.
    """
    began = perf_counter()
    library = Library(searched_directories(path))
    text = str(name_or_path)
    if text.endswith(FILE_ENDINGS):
        file = existing_file(text)
        library = Library((*library.directories, *stored_root(file)))
        found = add_source(library, read_source(file, text), name, file)
    elif name is not None:
        raise fail(
            UsageProblem,
            "usage.class",
            "a class can be picked from a file only",
            hint=f"load `{text}.{name}`",
        )
    else:
        found = library.find(class_name(text)).path
    return Model(library, found, perf_counter() - began)


def loads(text: str, name: str | None = None, *, path: Sequence[str | Path] = ()) -> Model:
    """A model from Modelica text; `name` picks the class (default: the last one)."""
    began = perf_counter()
    library = Library(searched_directories(path))
    found = add_source(library, Source("<string>", text), name, None)
    return Model(library, found, perf_counter() - began)


def check_flat(flat: FlatModel) -> None:
    """What a check looks at behind the flat model: the order of parameters, the balance of equations.

    Raises `TypeProblem` and `BalanceProblem`.
    """
    with at_users_lines(flat):
        order_parameters(flat)
        check_balance(flat, as_component=True)
