"""Solves the initial problem: states, all other unknowns, free parameters and modes at the start time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from acausal.codegen.functions import Code
from acausal.errors import AcausalError, Diagnostic, InitializationProblem, LookupProblem, UsageProblem, fail
from acausal.lang.flat import STRING
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.events import MAX_ITERATIONS, literal_modes, operators
from acausal.simulate.messages import crossing_text, equation_text, number, place, some
from acausal.simulate.names import did_you_mean
from acausal.simulate.newton import Vector
from acausal.simulate.walk import Walk, call, walk
from acausal.symbolic.expressions.expr import Expr, sym, symbols

CHECK_TOLERANCE = 1e-6
"""Largest residual of a redundant initial equation, relative to the size of its terms."""


@dataclass(frozen=True)
class UsedStart:
    """A start value that decided the initial state: which, its value, and why (`fixed`, `assumed`, `guess`)."""

    name: str
    value: float
    reason: str


@dataclass(frozen=True)
class InitialPoint:
    """The solved initial problem. `evaluator` holds the parameters, modes and guesses that belong to it."""

    evaluator: Evaluator
    time: float
    x: Vector
    used: tuple[UsedStart, ...]


def initialize(
    code: Code, time: float, parameters: Mapping[str, float] | None = None, start: Mapping[str, float] | None = None
) -> InitialPoint:
    """The consistent initial point at `time`.

    `parameters` override bindings, `start` override start values. Raises `InitializationProblem`, and
    `UsageProblem` or `LookupProblem` for overrides that cannot be.
    """
    given, override = _overrides(code, parameters or {})
    p = _parameter_values(code, given, override)
    starts = _start_values(code, p, start or {})
    values, modes = _modes_and_values(code, time, p, starts)
    slots = code.initial.slots
    for i, name in enumerate(code.system.parameters):
        if sym(name) in code.initial.unknowns:
            given[i], override[i] = values[slots[sym(name)]], 1.0
    p = _parameter_values(code, given, override)
    evaluator = Evaluator(code, p)
    evaluator.m[:] = modes
    known = dict(zip(slots, values.tolist(), strict=True))
    evaluator.guess[:] = [known.get(leaf, 0.0) for leaf in code.dynamic.guesses]
    _check(code, values)
    x = np.array([known[sym(name)] for name in code.system.states])
    reasons = code.system.initial.values
    used = tuple(UsedStart(v.name, float(s), v.reason) for v, s in zip(reasons, starts, strict=True))
    return InitialPoint(evaluator, time, x, used)


def _overrides(code: Code, parameters: Mapping[str, float]) -> tuple[Vector, Vector]:
    names = code.system.parameters
    given, override = np.zeros(len(names)), np.zeros(len(names))
    position = {name: i for i, name in enumerate(names)}
    for name, value in parameters.items():
        if name not in position:
            raise fail(
                LookupProblem,
                "simulate.unknown-parameter",
                f"the model has no parameter '{name}'",
                names=[name],
                hint=did_you_mean(name, names),
            )
        variable = code.system.flat.by_name[name]
        if variable.final or variable.structural or not variable.type.is_numeric:
            why = "final" if variable.final else "structural" if variable.structural else f"a {variable.type}"
            raise fail(
                UsageProblem,
                "simulate.fixed-parameter",
                f"parameter '{name}' is {why} and cannot be changed without compiling again",
                variable.span,
                names=[name],
            )
        given[position[name]], override[position[name]] = value, 1.0
    return given, override


def _parameter_values(code: Code, given: Vector, override: Vector) -> Vector:
    p = call(code.parameters, given, override)[0].ravel()
    free = {leaf for leaf in code.initial.unknowns if leaf.op == "sym"}
    problems: list[Diagnostic] = []
    for name, value in zip(code.system.parameters, p, strict=True):
        variable = code.system.flat.by_name[name]
        if np.isfinite(value) or variable.type == STRING or sym(name) in free:
            continue
        missing = variable.binding is None and variable.start is None
        message = f"parameter '{name}' has no value" if missing else f"parameter '{name}' is {value}"
        hint = f"give it one: {name}=…" if missing else "look for a division by zero or a root of a negative number"
        problems.append(Diagnostic("simulate.parameter-value", message, variable.span, (name,), hint))
    if problems:
        raise InitializationProblem(problems)
    return p


def _start_values(code: Code, p: Vector, start: Mapping[str, float]) -> Vector:
    values = call(code.starts, p)[0].ravel()
    names = [value.name for value in code.system.initial.values]
    for name, value in start.items():
        if name not in names:
            raise fail(
                LookupProblem,
                "simulate.unused-start",
                f"the initial problem uses no start value of '{name}'",
                names=[name],
                hint=f"start values in use: {some(names)}",
            )
        values[names.index(name)] = value
    return values


def _modes_and_values(code: Code, time: float, p: Vector, starts: Vector) -> tuple[Vector, Vector]:
    """Solves the blocks with modes that agree with the solution, found by iteration from all false."""
    ops = operators(code.system)
    modes = np.zeros(len(ops))
    history: list[Vector] = []
    for _ in range(MAX_ITERATIONS):
        values = _walk(code, time, p, modes, starts)
        if not ops:
            return values, modes
        wanted = literal_modes(ops, _roots(code, time, p, modes, values))
        if np.array_equal(wanted, modes):
            return values, modes
        history.append(modes)
        if any(np.array_equal(wanted, seen) for seen in history):
            break
        modes = wanted
    raise _cycle(code, history)


def _walk(code: Code, time: float, p: Vector, modes: Vector, starts: Vector) -> Vector:
    nominal = _nominals(code, p)
    names = [value.name for value in code.system.initial.values]
    guess = {n: float(s) for n, s in zip(names, starts, strict=True)}
    how = Walk(InitializationProblem, time, nominal, guess)
    return walk(code.initial, np.concatenate([[time], p, modes, starts]), how)


def _nominals(code: Code, p: Vector) -> dict[Expr, float]:
    states, guesses = (column.ravel().tolist() for column in call(code.nominals, p))
    known = dict(zip((sym(name) for name in code.system.states), states, strict=True))
    return known | dict(zip(code.dynamic.guesses, guesses, strict=True))


def _roots(code: Code, time: float, p: Vector, modes: Vector, values: Vector) -> Vector:
    slots = code.initial.slots
    x = values[[slots[sym(name)] for name in code.system.states]]
    guess = np.array([values[slots[leaf]] if leaf in slots else 0.0 for leaf in code.dynamic.guesses])
    return call(code.events, np.array([time]), x, p, modes, guess)[0].ravel()


def _cycle(code: Code, history: list[Vector]) -> AcausalError:
    changing = np.ptp(np.array(history), axis=0) > 0 if len(history) > 1 else history[0] >= 0
    crossings = [c for c, changes in zip(code.system.zero_crossings, changing, strict=True) if changes]
    texts = some([crossing_text(crossing) for crossing in crossings])
    return fail(
        InitializationProblem,
        "initialize.mode-cycle",
        f"no consistent initial modes: the conditions {texts} switch back and forth",
        crossings[0].span,
        names=symbols([crossing.relation for crossing in crossings]),
        hint="change start values so that the conditions are decided, or add a hysteresis",
    )


def _check(code: Code, values: Vector) -> None:
    """Redundant initial equations must hold at the result."""
    checks = code.system.initial.checks
    if not checks:
        return
    known = values[[code.initial.slots[leaf] for leaf in code.checks.reads]]
    residuals, sizes = (column.ravel() for column in call(code.checks.run, known))
    problems: list[Diagnostic] = []
    for check, residual, size in zip(checks, residuals, sizes, strict=True):
        if abs(residual) <= CHECK_TOLERANCE * max(size, 1e-300):
            continue
        names = symbols([check.value])
        shown = some([f"{n} = {number(values[code.initial.slots[sym(n)]])}" for n in names if sym(n) in code.initial.slots])
        message = (
            f"the initial values contradict '{equation_text(check.equation)}' ({place(check.equation.flat.span)}): "
            f"it is off by {number(residual)}, with {shown}"
        )
        hint = "fewer start values may be fixed: remove 'fixed = true' from one of these, or make them agree"
        problems.append(Diagnostic("initialize.inconsistent", message, check.equation.flat.span, names, hint))
    if problems:
        raise InitializationProblem(problems)
