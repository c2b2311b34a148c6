"""A compiled system as CasADi Functions with names, labels and a start: for integrators, `nlpsol`, `Opti`."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path

import casadi as ca
import numpy as np
from casadi import DM, MX, Function

from acausal.codegen.casadi_expressions import FORWARD
from acausal.codegen.functions import Code
from acausal.codegen.named import SIGNATURE, named_functions
from acausal.errors import LookupProblem, UsageProblem, fail
from acausal.export.outputs import chosen_names, outputs, unit_of
from acausal.export.tunables import free_parameters
from acausal.lang.flat import Variable
from acausal.simulate.call import call
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.initialize import InitialPoint, initialize
from acausal.simulate.inputs import InputValue
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import leaf_name
from acausal.simulate.names import did_you_mean
from acausal.simulate.overrides import Override
from acausal.simulate.settle import Settling
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.expressions.text import to_text

_AHEAD = 1e-9
FORMAT = "acausal-casadi-1"


@dataclass(frozen=True)
class Label:
    """One entry of a vector: its name, and what the model declares. None where it declares nothing."""

    name: str
    unit: str = ""
    nominal: float | None = None
    start: float | None = None
    description: str = ""


@dataclass(frozen=True)
class CasadiModel:
    """Functions by name (`ode`, `dae`, `jac`, `events`, `update`, `outputs`, `initial`, `parameters`).

    All but the last two take `(t, x, z, u, p, m, d)`; `labels` tells what the entries of these vectors, of
    the outputs `y` and of the start values `s` are, and which parameters are `tunable`. `start` are their
    values at the start of a run with all defaults (not-a-number where nothing is given).
    """

    name: str
    functions: Mapping[str, Function]
    labels: Mapping[str, tuple[Label, ...]]
    start: Mapping[str, DM] = field(repr=False)

    def __getitem__(self, name: str) -> Function:
        if name not in self.functions:
            hint = did_you_mean(name, self.functions) or f"there is {', '.join(self.functions)}"
            raise fail(LookupProblem, "casadi.function", f"there is no function `{name}`", hint=hint)
        return self.functions[name]

    @property
    def ode(self) -> Function:
        """`-> (xdot, z_out)`: the derivatives, with the blocks solved from the guess `z`."""
        return self["ode"]

    @property
    def dae(self) -> Function:
        """`-> (ode, alg)`: derivatives and residuals, both explicit."""
        return self["dae"]

    @property
    def jac(self) -> Function:
        """`-> J`, the sparse d xdot / d x."""
        return self["jac"]

    @property
    def events(self) -> Function:
        """`-> (root, holds)`: left minus right side of every relation, and what it says."""
        return self["events"]

    @property
    def update(self) -> Function:
        """`-> (m_new, d_new, d_next, x_new)`: one pass over an event."""
        return self["update"]

    @property
    def outputs(self) -> Function:
        """`-> y`."""
        return self["outputs"]

    @property
    def initial(self) -> Function:
        """`(t, u, p, m, d, s, guess) -> (x0, z0, p0, found)`: the start from start values `s`."""
        return self["initial"]

    def names(self, vector: str) -> tuple[str, ...]:
        """The names of the entries of `x`, `z`, `u`, `p`, `m`, `d`, `y` or `s`. Raises `LookupProblem`."""
        if vector not in self.labels:
            hint = f"there is {', '.join(self.labels)}"
            raise fail(LookupProblem, "casadi.vector", f"there is no vector `{vector}`", hint=hint)
        return tuple(label.name for label in self.labels[vector])

    def index(self, vector: str, name: str) -> int:
        """Where `name` is in a vector. Raises `LookupProblem`."""
        names = self.names(vector)
        if name not in names:
            message = f"`{name}` is not among the labels of {vector}"
            raise fail(LookupProblem, "casadi.label", message, names=[name], hint=did_you_mean(name, names))
        return names.index(name)

    def tuned(self, *names: str) -> Function:
        """`values -> p`: all parameters, where those named and what depends on them have other values.

        Raises `LookupProblem` for what is no parameter that can be changed.
        """
        function = self["parameters"]
        values = MX.sym("values", len(names))
        given, override = MX.zeros(function.size1_in(0)), np.zeros(function.size1_in(0))
        for i, name in enumerate(names):
            self.index("tunable", name)
            position = self.index("p", name)
            given[position] = values[i]
            override[position] = 1.0
        p = function(given, DM(override))
        return Function("tuned", [values], [p], ["values"], ["p"], FORWARD)

    def problem(self, *free: str) -> dict[str, MX]:
        """What `casadi.integrator` takes: `t`, `x`, `u`, `ode`, with loops `z`, `alg`, and `p` (`free`).

        All else is as at the start: other parameters, modes and frozen values.
        """
        symbols = {name: MX.sym(name, self.start[name].shape[0]) for name in ("t", "x", "z", "u")}
        p = MX.sym("p", len(free))
        known = {**symbols, "p": self.tuned(*free)(p) if free else MX(self.start["p"])}
        known |= {name: MX(self.start[name]) for name in ("m", "d")}
        ode, alg = self.dae.call([known[name] for name in SIGNATURE])
        found = {"t": symbols["t"], "x": symbols["x"], "u": symbols["u"], "p": p, "ode": ode}
        return found | ({"z": symbols["z"], "alg": alg} if symbols["z"].shape[0] else {})

    def save(self, path: str | Path) -> None:
        """Writes all of it to one file: `load_casadi` reads it, as does `casadi.FileDeserializer`.

        The file holds the Functions, their names, and the labels and the start as JSON.
        """
        try:
            writer = ca.FileSerializer(str(path))
            writer.pack(list(self.functions.values()))
            writer.pack(json.dumps(self._text(), sort_keys=True))
            del writer
        except (OSError, RuntimeError) as problem:
            reason = (str(problem).strip().splitlines() or ["no reason given"])[-1]
            raise fail(UsageProblem, "usage.output", f"cannot write `{path}`: {reason[:200]}") from None

    def _text(self) -> dict[str, object]:
        labels = {vector: [asdict(label) for label in labels] for vector, labels in self.labels.items()}
        start = {name: [_plain(v) for v in np.asarray(value).ravel()] for name, value in self.start.items()}
        functions = list(self.functions)
        return {"format": FORMAT, "name": self.name, "functions": functions, "labels": labels, "start": start}

    def __repr__(self) -> str:
        return f"<CasadiModel {self.name}: {', '.join(self.functions)}>"


def _plain(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None


def load_casadi(path: str | Path) -> CasadiModel:
    """What `CasadiModel.save` wrote. Raises `UsageProblem` for any other file."""
    try:
        reader = ca.FileDeserializer(str(path))
        functions, text = reader.unpack(), json.loads(reader.unpack())
        if text["format"] != FORMAT:
            raise ValueError("another format")
    except (OSError, RuntimeError, ValueError, KeyError, TypeError):
        raise fail(
            UsageProblem, "usage.file", f"`{path}` is no file of `acausal export --to casadi`"
        ) from None
    labels = {v: tuple(Label(**label) for label in labels) for v, labels in text["labels"].items()}
    numbers = {n: [np.nan if v is None else v for v in values] for n, values in text["start"].items()}
    start = {name: DM(values) for name, values in numbers.items()}
    return CasadiModel(text["name"], dict(zip(text["functions"], functions, strict=True)), labels, start)


def to_casadi(
    code: Code,
    *,
    variables: Sequence[str] = (),
    everything: bool = False,
    parameters: Mapping[str, Override] | None = None,
    start: Mapping[str, float] | None = None,
    inputs: Mapping[str, InputValue] | None = None,
) -> CasadiModel:
    """The system for CasADi; the other arguments are those of `simulate`, for the start.

    Raises `UnsupportedProblem` for what has no numeric code, and `InitializationProblem`.
    """
    chosen = outputs(code, chosen_names(code, variables, everything))
    time = code.system.flat.experiment.start_time or 0.0
    missing = {v.name: float("nan") for v in code.system.flat.inputs if v.name not in (inputs or {})}
    point = initialize(code, time, parameters, start, {**_defaults(code, missing), **(inputs or {})})
    evaluator, x = _settled(point)
    begin = {
        "t": DM(time),
        "x": DM(x),
        "z": DM(evaluator.guess),
        "u": DM(evaluator.u),
        "p": DM(evaluator.p),
        "m": DM(evaluator.m),
        "d": DM(evaluator.d),
        "s": DM([used.value for used in point.used]),
    }
    functions = named_functions(code, chosen.run)
    return CasadiModel(code.system.flat.name, functions, _labels(code, chosen.names, begin), begin)


def _settled(point: InitialPoint) -> tuple[Evaluator, Vector]:
    """The start with its first event behind it, as a run begins."""
    evaluator = point.evaluator
    settling = Settling(evaluator, _AHEAD)
    evaluator.at(point.time, point.x)
    evaluator.settle()
    evaluator.keep_past(_AHEAD)
    settling.remember()
    if "initial" in settling.phases:
        evaluator.d[settling.phases["initial"]] = 0.0
    return evaluator, settling.settle(point.time, point.x)


def _defaults(code: Code, missing: Mapping[str, float]) -> dict[str, float]:
    """Inputs without a value are zero at the start."""
    given = call(code.given_inputs, call(code.parameters, *_unchanged(code))[0].ravel())[0].ravel()
    names = [variable.name for variable in code.system.flat.inputs]
    return {n: 0.0 for n, v in zip(names, given, strict=True) if n in missing and not np.isfinite(v)}


def _unchanged(code: Code) -> tuple[Vector, Vector]:
    size = len(code.system.parameters)
    return np.zeros(size), np.zeros(size)


def _labels(code: Code, names: Sequence[str], start: Mapping[str, DM]) -> dict[str, tuple[Label, ...]]:
    system = code.system
    nominal = [np.asarray(column.full()).ravel() for column in code.nominals(start["p"])]
    by_name = system.flat.by_name

    def declared(names: Sequence[str], values: DM | None, sizes: Sequence[float] = ()) -> tuple[Label, ...]:
        numbers = [None] * len(names) if values is None else [_plain(v) for v in np.asarray(values).ravel()]
        nominals = [*map(float, sizes), *[None] * (len(names) - len(sizes))]
        return tuple(
            Label(name, unit_of(code, name), size, number, _description(by_name.get(name)))
            for name, number, size in zip(names, numbers, nominals, strict=True)
        )

    def leaves(found: Sequence[Expr], values: DM) -> tuple[Label, ...]:
        return declared([leaf_name(leaf) for leaf in found], values)

    inputs = [*(variable.name for variable in system.flat.inputs), *map(to_text, system.delays)]
    return {
        "x": declared(system.states, start["x"], nominal[0].tolist()),
        "z": declared([leaf_name(z) for z in code.dynamic.guesses], start["z"], nominal[1].tolist()),
        "u": declared(inputs, start["u"]),
        "p": declared(system.parameters, start["p"]),
        "tunable": declared([t.name for t in free_parameters(code)], None),
        "m": leaves(code.relations, start["m"]),
        "d": leaves(system.discrete.frozen, start["d"]),
        "y": declared(names, None),
        "s": declared([value.name for value in system.initial.values], start["s"]),
    }


def _description(variable: Variable | None) -> str:
    return variable.description if variable is not None else ""
