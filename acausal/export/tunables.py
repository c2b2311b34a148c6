"""Which parameters and start values an exported program takes from its table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from acausal.codegen.functions import Code
from acausal.errors import LookupProblem, UsageProblem, fail
from acausal.lang.flat import BOOLEAN, INTEGER, STRING, Variability, Variable
from acausal.simulate.names import did_you_mean
from acausal.simulate.overrides import check_tunable, unknown_parameter

ALL = "all"
REAL_KIND, INTEGER_KIND, BOOLEAN_KIND, ENUMERATION_KIND = range(4)


@dataclass(frozen=True)
class Tunable:
    """A column of the table: `position` among the parameters, or among the start values if `is_start`."""

    name: str
    unit: str
    kind: int
    position: int
    is_start: bool
    literals: tuple[str, ...] = ()


def tunables(code: Code, names: Sequence[str]) -> tuple[Tunable, ...]:
    """Those named (`R`, `start(x)`); `all` of them; without names the public parameters of the top level.

    Raises `LookupProblem` and `UsageProblem` for what cannot be changed.
    """
    if not names:
        return tuple([t for t in free_parameters(code) if _is_top(code.system.flat.by_name[t.name])])
    found: dict[str, Tunable] = {}
    for name in names:
        chosen = [*free_parameters(code), *_starts(code)] if name == ALL else [_named(code, name)]
        found.update({t.name: t for t in chosen})
    return tuple(found.values())


def _is_top(variable: Variable) -> bool:
    return variable.top_level and not variable.protected


def free_parameters(code: Code) -> list[Tunable]:
    """Every parameter that can be changed without compiling again."""
    found: list[Tunable] = []
    for i, name in enumerate(code.system.parameters):
        variable = code.system.flat.by_name[name]
        free = variable.variability is not Variability.CONSTANT and not variable.final and variable.is_fixed
        known = variable.structural or name in code.system.evaluated
        if free and not known and variable.type != STRING:
            found.append(_tunable(variable, i))
    return found


def _starts(code: Code) -> list[Tunable]:
    return [
        Tunable(f"start({value.name})", variable.unit if variable is not None else "", REAL_KIND, i, True)
        for i, value in enumerate(code.system.initial.values)
        for variable in [code.system.flat.by_name.get(value.name)]
        if value.name not in code.closed_starts
    ]


def _named(code: Code, name: str) -> Tunable:
    if name.startswith("start(") and name.endswith(")"):
        known = {start.name: start for start in _starts(code)}
        if name not in known:
            message = f"the start of the model uses no start value `{name[6:-1]}`, or it depends on others"
            hint = did_you_mean(name, known)
            raise fail(LookupProblem, "export.unknown-start", message, names=[name[6:-1]], hint=hint)
        return known[name]
    if name not in code.system.parameters:
        raise unknown_parameter(code, name)
    variable = code.system.flat.by_name[name]
    check_tunable(variable)
    if name in code.system.evaluated:
        message = f"the value of `{name}` was put into the equations"
        raise fail(UsageProblem, "export.evaluated", message, variable.span, names=[name])
    return _tunable(variable, code.system.parameters.index(name))


def _tunable(variable: Variable, position: int) -> Tunable:
    unit = "" if variable.type.is_enumeration else variable.unit
    return Tunable(variable.name, unit, kind_of(variable), position, False, tuple(variable.type.literals))


def kind_of(variable: Variable) -> int:
    """The number of its type in C."""
    kind = variable.type
    if kind.is_enumeration:
        return ENUMERATION_KIND
    return BOOLEAN_KIND if kind == BOOLEAN else INTEGER_KIND if kind == INTEGER else REAL_KIND
