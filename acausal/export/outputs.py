"""Which variables an export gives, as one Function of the model's point."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from casadi import SX, Function

from acausal.codegen.casadi_expressions import FORWARD, Converter
from acausal.codegen.functions import Code
from acausal.codegen.scope import column, split
from acausal.errors import LookupProblem, UnsupportedProblem, fail
from acausal.lang.flat import STRING, Variable
from acausal.simulate.names import derivative_of_alias, did_you_mean
from acausal.symbolic.expressions.expr import sym
from acausal.symbolic.expressions.text import to_text


@dataclass(frozen=True)
class Outputs:
    """`run(t, x, p, m, u, d, z) -> y`, the values of `names`."""

    names: tuple[str, ...]
    units: tuple[str, ...]
    run: Function


def chosen_names(code: Code, names: Sequence[str], everything: bool) -> tuple[str, ...]:
    """The names as given, else all that change, else the states and the public variables of the top level."""
    flat = code.system.flat
    if everything:
        return tuple(dict.fromkeys([*names, *(v.name for v in flat.unknowns if v.type != STRING)]))
    top = [v.name for v in flat.unknowns if v.top_level and not v.protected and v.type != STRING]
    return tuple(dict.fromkeys(names)) or tuple(dict.fromkeys([*code.system.states, *top]))


def outputs(code: Code, names: Sequence[str]) -> Outputs:
    """Raises `LookupProblem` for a name that the model does not have, `UnsupportedProblem` for a String."""
    given = code.outputs.sx_in()
    finder = _Finder(code, given)
    values = [finder.value(name) for name in names]
    run = Function("chosen", given, [column(values)], code.outputs.name_in(), ["y"], FORWARD)
    return Outputs(tuple(names), tuple(unit_of(code, name) for name in names), run)


def unit_of(code: Code, name: str) -> str:
    """The declared unit; that of `der(x)` per second."""
    variable = code.system.flat.by_name.get(name)
    if variable is not None:
        return variable.unit
    inner = code.system.flat.by_name.get(name[4:-1]) if name.startswith("der(") else None
    return f"({inner.unit})/s" if inner is not None and inner.unit else ""


class _Finder:
    """Values of variables by name: those of leaves, of aliases, and of what depends on parameters only."""

    def __init__(self, code: Code, given: list[SX]) -> None:
        self._code = code
        self._leaves = dict(
            zip(map(to_text, code.output_leaves), split(code.outputs.call(given)[0]), strict=True)
        )
        position = code.outputs.name_in().index("p")
        parameters = [sym(name) for name in code.system.parameters]
        self._parameters = dict(zip(code.system.parameters, split(given[position]), strict=True))
        self._convert = Converter(dict(zip(parameters, split(given[position]), strict=True)), {})

    def value(self, name: str) -> SX:
        system = self._code.system
        sign, seen = derivative_of_alias(system, name) or (1.0, name)
        self._check(system.flat.by_name.get(name))
        for _ in range(len(system.aliases) + 1):
            found = self._leaves.get(seen)
            if found is None:
                found = self._parameters.get(seen)
            if found is not None:
                return found if sign > 0 else -found
            value = system.alias_values.get(seen)
            if value is None:
                break
            if value.op == "neg" and value.args[0].op == "sym":
                sign, value = -sign, value.args[0]
            if value.op != "sym":
                constant = self._convert(value)
                return constant if sign > 0 else -constant
            seen = value.name
        hint = did_you_mean(name, [v.name for v in system.flat.variables])
        message = f"the model {system.flat.name} has no variable `{name}`"
        raise fail(LookupProblem, "result.unknown-name", message, names=[name], hint=hint)

    def _check(self, variable: Variable | None) -> None:
        if variable is not None and variable.type == STRING:
            message = f"`{variable.name}` is a String, which has no number"
            raise fail(UnsupportedProblem, "export.string", message, variable.span, names=[variable.name])
