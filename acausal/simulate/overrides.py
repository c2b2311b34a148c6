"""Parameters and start values that a run changes without compiling again. Nothing is ignored silently."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

import numpy as np

from acausal.codegen.functions import Code
from acausal.errors import AcausalError, Diagnostic, InitializationProblem, LookupProblem, UsageProblem, fail
from acausal.lang.flat import BOOLEAN, INTEGER, STRING, Variability, Variable
from acausal.simulate.call import call
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import some
from acausal.simulate.names import did_you_mean
from acausal.symbolic.expressions.expr import sym
from acausal.symbolic.expressions.text import to_text

Override: TypeAlias = float | bool | str
"""A number, a Boolean, or the literal of an enumeration, as `Mode.open` or `open`."""


def parameter_overrides(code: Code, parameters: Mapping[str, Override]) -> tuple[Vector, Vector]:
    """The arguments `given` and `override` of `Code.parameters`.

    Raises `LookupProblem` for names that are no parameters and `UsageProblem` for parameters and values that
    a run cannot change.
    """
    names = code.system.parameters
    given, override = np.zeros(len(names)), np.zeros(len(names))
    position = {name: i for i, name in enumerate(names)}
    for name, value in parameters.items():
        if name not in position:
            raise unknown_parameter(code, name)
        variable = code.system.flat.by_name[name]
        check_tunable(variable)
        given[position[name]], override[position[name]] = _number(variable, value), 1.0
    return given, override


def unknown_parameter(code: Code, name: str) -> AcausalError:
    """The error for a name that is no parameter."""
    variable = code.system.flat.by_name.get(name)
    if variable is None:
        hint = did_you_mean(name, code.system.parameters)
    elif variable.is_input:
        hint = f"`{name}` is an input: use inputs="
    else:
        hint = f"`{name}` is a variable: its start value can be changed with start="
    message = f"the model has no parameter `{name}`"
    span = variable.span if variable is not None else None
    return fail(LookupProblem, "simulate.unknown-parameter", message, span, names=[name], hint=hint)


def check_tunable(variable: Variable) -> None:
    """Raises `UsageProblem` for a parameter that a run cannot change."""
    name = variable.name
    again = (
        f'compile the model again with it: compile({{"{name}": ...}}), or -p {name}=... on the command line'
    )
    if variable.variability is Variability.CONSTANT:
        why, hint = "is a constant", "declare it as a parameter"
    elif variable.final:
        why, hint = "is final", "its value is part of the model"
    elif not variable.is_fixed:
        why, hint = "is determined by the initial equations (fixed = false)", "change its start value: start="
    elif variable.structural:
        why, hint = "is structural: it shaped the equations", again
    elif variable.type == STRING:
        why, hint = "is a String", again
    else:
        return
    message = f"parameter `{name}` {why} and cannot be changed in a run"
    raise fail(UsageProblem, "simulate.fixed-parameter", message, variable.span, names=[name], hint=hint)


def _number(variable: Variable, value: Override) -> float:
    """The value as code sees it: 0 and 1 for Booleans, positions from 1 for enumerations."""
    kind = variable.type
    if kind.is_enumeration:
        literal = value.rsplit(".", 1)[-1] if isinstance(value, str) else None
        if literal in kind.literals:
            return 1.0 + kind.literals.index(literal)
        if literal is None and not isinstance(value, bool) and value in range(1, len(kind.literals) + 1):
            return float(value)
        raise _ill_typed(variable, value, f"one of {', '.join(kind.literals)}")
    if kind == BOOLEAN:
        if isinstance(value, str) or value not in (0, 1):
            raise _ill_typed(variable, value, "True or False")
        return float(value)
    if isinstance(value, bool | str):
        raise _ill_typed(variable, value, "a number")
    if kind == INTEGER and not float(value).is_integer():
        raise _ill_typed(variable, value, "a whole number")
    return float(value)


def _ill_typed(variable: Variable, value: Override, wanted: str) -> AcausalError:
    return fail(
        UsageProblem,
        "simulate.parameter-type",
        f"parameter `{variable.name}` is a {variable.type} and cannot be {value!r}",
        variable.span,
        names=[variable.name],
        hint=f"give it {wanted}",
    )


def parameter_values(code: Code, given: Vector, override: Vector) -> Vector:
    """All parameters. Raises `InitializationProblem` for those that have no finite value."""
    p = call(code.parameters, given, override)[0].ravel()
    free = {leaf for leaf in code.initial.unknowns if leaf.op == "sym"}
    problems: list[Diagnostic] = []
    for name, value in zip(code.system.parameters, p, strict=True):
        variable = code.system.flat.by_name[name]
        if np.isfinite(value) or variable.type == STRING or sym(name) in free:
            continue
        missing = variable.binding is None and variable.start is None
        message = f"parameter `{name}` has no value" if missing else f"parameter `{name}` is {value}"
        hint = "look for a division by zero or a root of a negative number"
        hint = f"give it one: {name}=…" if missing else hint
        problems.append(Diagnostic("simulate.parameter-value", message, variable.span, (name,), hint))
    if problems:
        raise InitializationProblem(problems)
    return p


def start_values(code: Code, p: Vector, start: Mapping[str, float]) -> Vector:
    """The start values of the initial problem. Raises `LookupProblem` and `UsageProblem`."""
    values = call(code.starts, p)[0].ravel()
    position = {value.name: i for i, value in enumerate(code.system.initial.values)}
    for name, value in start.items():
        if name not in position:
            raise _unused(code, name, list(position))
        if name in code.closed_starts:
            raise _closed(code, name)
        if not np.isfinite(value):
            message = f"{value} is no start value for `{name}`"
            raise fail(UsageProblem, "simulate.start-value", message, names=[name])
        values[position[name]] = value
    return values


def _unused(code: Code, name: str, used: list[str]) -> AcausalError:
    """A start value that nothing would read; an alias is told which name to use."""
    variable = code.system.flat.by_name.get(name)
    alias = code.system.alias_values.get(name)
    if alias is not None:
        hint = f"`{name}` equals `{to_text(alias)}`: change the start value there"
    elif variable is not None and variable.is_parameter and variable.is_fixed:
        hint = f"`{name}` is a parameter: use parameters="
    else:
        hint = did_you_mean(name, used) if variable is None else ""
    hint = hint or f"start values in use: {some(used)}"
    message = f"the initial problem uses no start value of `{name}`"
    span = variable.span if variable is not None else None
    return fail(LookupProblem, "simulate.unused-start", message, span, names=[name], hint=hint)


def _closed(code: Code, name: str) -> AcausalError:
    value = next(v.value for v in code.system.initial.values if v.name == name)
    return fail(
        UsageProblem,
        "simulate.closed-start",
        f"the start value of `{name}` is `{to_text(value)}`, which the initial equations determine",
        code.system.flat.by_name[name].span,
        names=[name],
        hint="change the start value of the parameter in it, or compile again with another start value",
    )
