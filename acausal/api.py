"""The Python interface: `load` or `loads` a model, `compile` it, `simulate`, look at it.

>>> import acausal
>>> decay = acausal.loads("model Decay Real x(start = 1, fixed = true); equation der(x) = -x; end Decay;")
>>> run = decay.compile().simulate(stop_time=1.0)
>>> round(float(run["x"][-1]), 4)
0.3679
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from acausal.codegen.functions import Code
from acausal.errors import Diagnostic, LookupProblem, Source, SyntaxProblem, UsageProblem, fail
from acausal.lang.flat import FlatModel
from acausal.lang.library import Library, library_directories, read_source
from acausal.lang.parser import parse
from acausal.pipeline import Compilation, Stage, compile_model, print_stage
from acausal.simulate.result import Result
from acausal.simulate.simulate import simulate
from acausal.symbolic.balance import check_balance
from acausal.symbolic.causal import Block, CausalSystem

ParameterValue = float | int | bool | str
"""A number, a Boolean, or Modelica text (`"{1, 2}"`, `"Types.Mode.open"`)."""


@dataclass(frozen=True)
class Model:
    """A class that can be compiled: where it is found and its full name."""

    library: Library
    name: str

    def check(self, **parameters: ParameterValue) -> tuple[Diagnostic, ...]:
        """Names, types, units and the balance of equations; returns warnings, raises `AcausalError`."""
        return checked(self, parameters).warnings

    def compile(
        self, parameters: Mapping[str, ParameterValue] | None = None, /, **more: ParameterValue
    ) -> CompiledModel:
        """Compile with parameters applied: `compile(R=2)`, or `compile({"motor.R": 2})` for dotted names.

        A string is Modelica text. Raises the `AcausalError` of the stage that finds something wrong.
        """
        texts = {name: as_modelica(value) for name, value in {**(parameters or {}), **more}.items()}
        return CompiledModel(compile_model(self.library, self.name, texts))

    def show(self, stage: Stage) -> str:
        """The text of one stage of the pipeline."""
        return print_stage(compile_model(self.library, self.name, stop_after=stage), stage)


@dataclass(frozen=True)
class CompiledModel:
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

    def simulate(
        self,
        *,
        stop_time: float | None = None,
        start_time: float | None = None,
        rtol: float | None = None,
        atol: float | None = None,
        max_step: float | None = None,
        interval: float | None = None,
        solver: str = "cvode",
        parameters: Mapping[str, float] | None = None,
        start: Mapping[str, float] | None = None,
    ) -> Result:
        """Integrate from `start_time` to `stop_time` (s); what is not given comes from the `experiment` annotation.

        `parameters` and `start` change tunable parameters and start values without compiling again.
        """
        return simulate(
            self.code,
            stop_time=stop_time,
            start_time=start_time,
            rtol=rtol,
            atol=atol,
            max_step=max_step,
            interval=interval,
            solver=solver,
            parameters=parameters,
            start=start,
        )

    def __repr__(self) -> str:
        states = ", ".join(self.states) or "none"
        return f"<CompiledModel {self.name}: index {self.index}, {len(self.states)} states ({states})>"

    def _repr_html_(self) -> str:
        from acausal.report import html_report

        return html_report(self.causal)


def load(
    name_or_path: str | Path, *, name: str | None = None, path: Sequence[str | Path] = ()
) -> Model:
    """A model by its dotted name on the library path, or from a file `FILE.mo`.

    From a file, `name` picks the class (default: the last one in it); `path` is searched before MODELICAPATH.
    """
    library = Library(library_directories(path))
    text = str(name_or_path)
    if not text.endswith(".mo"):
        if name is not None:
            raise fail(UsageProblem, "usage.class", "`name` picks a class of a file; give the full name instead")
        return Model(library, library.find(text).path)
    file = Path(text)
    library = Library((*library.directories, *stored_root(file)))
    return Model(library, add_source(library, read_source(file, text), name, file))


def loads(text: str, name: str | None = None, *, path: Sequence[str | Path] = ()) -> Model:
    """A model from Modelica text; `name` picks the class (default: the last one)."""
    library = Library(library_directories(path))
    return Model(library, add_source(library, Source("<string>", text), name, None))


def stored_root(file: Path) -> tuple[Path, ...]:
    """The folder that a file's top-level package lies in, so that its siblings are found."""
    folder = file.resolve().parent
    while (folder / "package.mo").is_file():
        folder = folder.parent
    return (folder,) if folder != file.resolve().parent else ()


def add_source(library: Library, source: Source, name: str | None, file: Path | None) -> str:
    """Add the classes of a text to the library; returns the full name of the chosen one."""
    stored = parse(source)
    if not stored.classes:
        raise fail(SyntaxProblem, "syntax.no-class", f"{source.path} holds no class", hint="a Modelica file starts with `model Name`")
    if stored.within:
        full = ".".join((*stored.within, stored.classes[-1][1].name))
        return library.find(name or full).path
    for _, definition in stored.classes:
        folder = file.resolve().parent if file is not None and file.name == "package.mo" else None
        library.add(definition, folder)
    if name is None:
        return stored.classes[-1][1].name
    return library.find(_qualified(library, name, [d.name for _, d in stored.classes])).path


def _qualified(library: Library, name: str, tops: Sequence[str]) -> str:
    """`name` as given, or below the last class of the file."""
    if name.split(".")[0] in tops:
        return name
    inside = f"{tops[-1]}.{name}"
    try:
        library.find(inside)
    except LookupProblem:
        return name
    return inside


def as_modelica(value: ParameterValue) -> str:
    """A Python value as a Modelica expression; text is taken as it is."""
    if isinstance(value, bool):
        return "true" if value else "false"
    return value if isinstance(value, str) else repr(value)


def checked(model: Model, parameters: Mapping[str, ParameterValue]) -> Compilation:
    """The flat model, proven, with its balance checked."""
    texts = {name: as_modelica(value) for name, value in parameters.items()}
    compilation = compile_model(model.library, model.name, texts, stop_after="flat")
    assert compilation.flat is not None
    check_balance(compilation.flat)
    return compilation


def summary_of(compilation: Compilation) -> dict[str, object]:
    """The JSON of `acausal compile`, as far as the compilation went."""
    summary: dict[str, object] = {"model": compilation.node.path}
    flat, causal = compilation.flat, compilation.causal
    if flat is not None:
        summary |= {"equations": len(flat.equations), "variables": len(flat.unknowns)}
    if causal is not None:
        largest = max(causal.blocks, key=lambda b: b.size, default=None)
        summary |= {
            "aliases": len(causal.aliases),
            "index": causal.index,
            "states": list(causal.states),
            "blocks": {
                "count": len(causal.blocks),
                "largest": largest.size if largest is not None else 0,
                "largest_torn": max((len(b.tearing) for b in causal.blocks), default=0),
            },
            "zero_crossings": len(causal.zero_crossings),
        }
    summary["seconds"] = dict(compilation.seconds)
    return summary
