"""Values of the model's inputs over time: constants, functions of time, or tables.

A table is interpolated linearly; the integrator stops at its kinks. Nothing has a silent default: an input
without a value, or a table that ends before the run, is an error.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import SupportsFloat, TypeAlias

import numpy as np
from numpy.typing import NDArray

from acausal.codegen.functions import Code
from acausal.errors import AcausalError, LookupProblem, SimulationProblem, UsageProblem, fail
from acausal.lang.flat import BOOLEAN, REAL, Variable
from acausal.simulate.call import call
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import at, number
from acausal.simulate.names import did_you_mean

Samples: TypeAlias = Sequence[float] | NDArray[np.float64]
InputValue: TypeAlias = float | Callable[[float], float] | tuple[Samples, Samples]
"""A constant, a function of time (s), or `(times, values)`."""

_ROUND = 1e-9


@dataclass(frozen=True)
class Table:
    """Linear interpolation between samples; constant beyond the ends, where rounding may lead."""

    times: tuple[float, ...]
    values: tuple[float, ...]

    def __call__(self, time: float) -> float:
        times, values = self.times, self.values
        i = min(max(bisect_right(times, time) - 1, 0), len(times) - 2)
        share = min(max((time - times[i]) / (times[i + 1] - times[i]), 0.0), 1.0)
        return values[i] + share * (values[i + 1] - values[i])

    @property
    def kinks(self) -> list[float]:
        """The times at which the slope changes."""
        slopes = np.diff(self.values) / np.diff(self.times)
        size = np.maximum(np.abs(slopes[1:]), np.abs(slopes[:-1]))
        return [self.times[i + 1] for i in np.flatnonzero(np.abs(np.diff(slopes)) > _ROUND * size)]


@dataclass(frozen=True)
class _Moving:
    """An input that is a function of time."""

    position: int
    variable: Variable
    of: Callable[[float], float]


class Inputs:
    """The inputs of one run; `fill` is all that the integrator's callbacks need."""

    def __init__(self, constants: Vector, moving: Sequence[_Moving] = ()) -> None:
        self.constants = constants
        self.moving = tuple(moving)
        tables = [m.of for m in moving if isinstance(m.of, Table)]
        self.kinks = tuple(sorted({kink for table in tables for kink in table.kinks}))
        """Where an input's slope jumps."""

    @property
    def tables(self) -> list[tuple[int, Table]] | None:
        """All inputs that change with time, by position, if they are tables; else None."""
        found = [(item.position, item.of) for item in self.moving if isinstance(item.of, Table)]
        return found if len(found) == len(self.moving) else None

    def fill(self, time: float, u: Vector) -> None:
        """Writes the values at `time`; not-a-number where a function of the user's fails."""
        for item in self.moving:
            try:
                u[item.position] = item.of(time)
            except Exception:  # whatever it is, `explain` says so with the input's name
                u[item.position] = math.nan

    def explain(self, time: float, u: Vector) -> None:
        """Raises `SimulationProblem` if an input is not a number at `time`."""
        for item in self.moving:
            if not math.isfinite(u[item.position]):
                raise _bad_function(item, time)

    def next_kink(self, time: float) -> float:
        """The first kink clearly after `time`; infinite if there is none."""
        i = bisect_right(self.kinks, time + 1e-12 * max(1.0, abs(time)))
        return self.kinks[i] if i < len(self.kinks) else math.inf


def _bad_function(item: _Moving, time: float) -> AcausalError:
    name = item.variable.name
    try:
        value = item.of(time)
    except Exception as problem:
        error = fail(
            SimulationProblem,
            "simulate.input-value",
            f"the function given for input `{name}` failed {at(time)}: {type(problem).__name__}: {problem}",
            item.variable.span,
            names=[name],
        )
        error.__cause__ = problem
        return error
    message = f"the function given for input `{name}` returned {value} {at(time)}"
    return fail(SimulationProblem, "simulate.input-value", message, item.variable.span, names=[name])


def bind_inputs(code: Code, p: Vector, given: Mapping[str, InputValue], start: float, stop: float) -> Inputs:
    """The inputs' values from `given`, else from their `start` attributes.

    Raises `UsageProblem` (no value, or a value that cannot be) and `LookupProblem` (no such input).
    """
    variables = code.system.flat.inputs
    _check_names(code, given)
    constants = call(code.given_inputs, p)[0].ravel()
    moving: list[_Moving] = []
    for i, variable in enumerate(variables):
        if variable.name not in given:
            continue
        value = _function(variable, given[variable.name], start, stop)
        if callable(value):
            constants[i] = 0.0
            moving.append(_Moving(i, variable, value))
        else:
            constants[i] = value
    missing = [v for v, constant in zip(variables, constants, strict=True) if not np.isfinite(constant)]
    if missing:
        raise _missing(missing)
    return Inputs(constants, moving)


def _missing(variables: Sequence[Variable]) -> AcausalError:
    names = [variable.name for variable in variables]
    first = names[0]
    what = f"input `{first}` has" if len(names) == 1 else f"inputs {', '.join(names)} have"
    return fail(
        UsageProblem,
        "simulate.input-missing",
        f"{what} no value",
        variables[0].span,
        names=names,
        hint=f'in Python: simulate(inputs={{"{first}": 1.0}}), a function of time, or (times, values); '
        f"on the command line: a constant through its start attribute, -p {first}.start=1",
    )


def _check_names(code: Code, given: Mapping[str, InputValue]) -> None:
    flat = code.system.flat
    known = [variable.name for variable in flat.inputs]
    for name in given:
        if name in known:
            continue
        other = flat.by_name.get(name)
        if other is not None:
            what = "a parameter: use parameters=" if other.is_parameter else "determined by the equations"
            hint = f"`{name}` is {what}"
        else:
            hint = did_you_mean(name, known) or (f"inputs: {', '.join(known)}" if known else "it has none")
        message = f"the model has no input `{name}`"
        span = other.span if other is not None else None
        raise fail(LookupProblem, "simulate.unknown-input", message, span, names=[name], hint=hint)


def _function(
    variable: Variable, value: InputValue, start: float, stop: float
) -> float | Callable[[float], float]:
    """A constant as a float, anything else as a function of time. Raises `UsageProblem`."""
    if isinstance(value, SupportsFloat):
        constant = _as_float(variable, value)
        if not math.isfinite(constant):
            raise _wrong(variable, f"{constant} is no value")
        if variable.type == BOOLEAN and constant not in (0.0, 1.0):
            raise _wrong(variable, f"it is a Boolean, and {constant:g} is neither true nor false")
        if variable.type != REAL and not constant.is_integer():
            raise _wrong(variable, f"it is a {variable.type}, and {constant:g} is no whole number")
        if variable.type.is_enumeration and not 1 <= constant <= len(variable.type.literals):
            raise _wrong(variable, f"{constant:g} is the number of no literal of {variable.type}")
        return constant
    if variable.type != REAL:
        raise _wrong(variable, f"it is a {variable.type}, and only a constant can be given for it")
    return value if callable(value) else _table(variable, value, start, stop)


def _as_float(variable: Variable, value: SupportsFloat) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        raise _wrong(variable, f"{value!r} is no number, function or table") from None


def _table(variable: Variable, value: tuple[Samples, Samples], start: float, stop: float) -> Table:
    try:
        times, values = (np.asarray(part, dtype=float).ravel() for part in value)
    except (TypeError, ValueError):
        raise _wrong(variable, f"{value!r} is no number, function or table (times, values)") from None
    if len(times) != len(values) or len(times) < 2:
        raise _wrong(variable, f"its table has {len(times)} times and {len(values)} values")
    if not (np.isfinite(times).all() and np.isfinite(values).all()):
        raise _wrong(variable, "its table holds a value that is not finite")
    if np.any(np.diff(times) <= 0):
        raise _wrong(variable, "the times of its table must increase; make a jump a short ramp")
    slack = _ROUND * max(stop - start, abs(start), abs(stop))
    if times[0] > start + slack or times[-1] < stop - slack:
        covered = f"its table covers {number(times[0])} s to {number(times[-1])} s"
        raise _wrong(variable, f"{covered}, the run {number(start)} s to {number(stop)} s")
    return Table(tuple(times.tolist()), tuple(values.tolist()))


def _wrong(variable: Variable, why: str) -> AcausalError:
    message = f"wrong value for input `{variable.name}`: {why}"
    return fail(UsageProblem, "simulate.input-value", message, variable.span, names=[variable.name])
