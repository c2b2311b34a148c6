"""The start of many variants at once: parameters, initial values and Jacobians as mapped functions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from casadi import Function
from numpy.typing import NDArray

from acausal.analysis.linear import Matrix
from acausal.analysis.points import Point
from acausal.analysis.snapshot import Snapshot
from acausal.codegen.functions import Code, state_leaves
from acausal.codegen.solvers import Nominals
from acausal.codegen.stitch import Goal, Stitching
from acausal.errors import UsageProblem, fail
from acausal.lang.flat import REAL
from acausal.simulate.events import literal_modes, operators
from acausal.simulate.initialize import initialize
from acausal.simulate.inputs import InputValue
from acausal.simulate.overrides import Override, parameter_overrides, start_values
from acausal.symbolic.expressions.expr import ZERO, sym

Vector = NDArray[np.float64]
Column = Sequence[float] | NDArray[np.float64] | float

_ROUNDING = 1e-12


def columns(
    parameters: Mapping[str, Column], start: Mapping[str, Column]
) -> tuple[dict[str, tuple[float, ...]], dict[str, tuple[float, ...]], int]:
    """Both with one value for each variant, and their number. Raises UsageProblem `variants.shape`."""
    lengths = {
        name: np.size(values)
        for table in (parameters, start)
        for name, values in table.items()
        if np.ndim(values)
    }
    count = max(lengths.values(), default=1)
    wrong = [name for name, length in lengths.items() if length != count]
    if wrong or not count:
        message = (
            f"there are {count} variants, but {lengths[wrong[0]]} values of `{wrong[0]}`" if wrong else ""
        )
        hint = "give every parameter one number, or as many as there are variants"
        raise fail(UsageProblem, "variants.shape", message or "there are no variants", names=wrong, hint=hint)

    def filled(table: Mapping[str, Column]) -> dict[str, tuple[float, ...]]:
        return {name: tuple(np.broadcast_to(np.ravel(v), count).tolist()) for name, v in table.items()}

    return filled(parameters), filled(start), count


def mapped_start(
    code: Code,
    first: Snapshot,
    parameters: Mapping[str, tuple[float, ...]],
    start: Mapping[str, tuple[float, ...]],
    inputs: Mapping[str, InputValue],
) -> Matrix | None:
    """Jacobians (k, n, n) at the start; not-a-number for variants that have to be looked at by themselves.

    None for models whose start a past decides (delays), whose states change, or whose first event resets
    states. The first variant's modes and discrete values are taken for all, and those kept that agree.
    """
    system = code.system
    names = frozenset(system.parameters)
    is_free = any(leaf.op == "sym" and leaf.name in names for leaf in code.initial.unknowns)
    if system.delays or system.dynamic is not None or is_free:
        return None
    point = first.point
    setting = [{name: values[0] for name, values in table.items()} for table in (parameters, start)]
    before = initialize(code, point.time, setting[0], setting[1], inputs, point.time)
    if not np.array_equal(before.x, point.x):
        return None
    count = max((len(values) for values in (*parameters.values(), *start.values())), default=1)
    p = _parameters(code, parameters, count)
    known = {
        "t": np.full((1, count), point.time),
        "p": p,
        "m": _same(before.evaluator.m, count),
        "u": _inputs(code, point, p, inputs),
        "d": _same(before.evaluator.d, count),
        "s": _starts(code, p, start),
    }
    initial, guess = _initial(code, first)
    known["z"] = _same(guess, count)
    x, z = _mapped(initial, known)[:2]
    known |= {"x": x, "z": z}
    fits = _agree(code, known, before.evaluator.m, before.evaluator.d)
    known |= {"m": _same(point.m, count), "d": _same(point.d, count)}
    jacobian = code.jac.map(count).call([known[name] for name in code.jac.name_in()])[0]
    result = _stacked(code, np.array(jacobian.nonzeros(), dtype=np.float64), count)
    result[~(fits & _agree(code, known, point.m, point.d))] = np.nan
    return result


def _same(values: Vector, count: int) -> Vector:
    return np.repeat(values[:, None], count, axis=1)


def _mapped(function: Function, known: Mapping[str, Vector]) -> list[Vector]:
    count = known["t"].shape[1]
    values = function.map(count).call([known[name] for name in function.name_in()])
    return [np.asarray(value.full(), dtype=np.float64) for value in values]


def _parameters(code: Code, table: Mapping[str, tuple[float, ...]], count: int) -> Vector:
    """All parameters (p, k). Raises what a run raises for the first variant, or a value that cannot be."""
    first: dict[str, Override] = {name: values[0] for name, values in table.items()}
    given, override = parameter_overrides(code, first)
    many = np.repeat(given[:, None], count, axis=1)
    position = {name: i for i, name in enumerate(code.system.parameters)}
    for name, values in table.items():
        if code.system.flat.by_name[name].type == REAL:
            many[position[name]] = values
        else:
            many[position[name]] = [parameter_overrides(code, {name: v})[0][position[name]] for v in values]
    p = code.parameters.map(count).call([many, np.repeat(override[:, None], count, axis=1)])[0]
    return np.asarray(p.full(), dtype=np.float64)


def _starts(code: Code, p: Vector, table: Mapping[str, tuple[float, ...]]) -> Vector:
    """Start values (s, k) of the initial problem."""
    found = np.asarray(code.starts.map(p.shape[1]).call([p])[0].full(), dtype=np.float64)
    start_values(code, p[:, 0], {name: values[0] for name, values in table.items()})
    position = {value.name: i for i, value in enumerate(code.system.initial.values)}
    for name, values in table.items():
        found[position[name]] = values
    return found


def _inputs(code: Code, point: Point, p: Vector, given: Mapping[str, InputValue]) -> Vector:
    """Inputs (u, k): as in the first variant where they are given, else their start attributes."""
    u = np.repeat(point.u[:, None], p.shape[1], axis=1)
    free = [i for i, variable in enumerate(code.system.flat.inputs) if variable.name not in given]
    if free:
        found = code.given_inputs.map(p.shape[1]).call([p])[0]
        u[free] = np.asarray(found.full(), dtype=np.float64)[free]
    return u


def _initial(code: Code, first: Snapshot) -> tuple[Function, Vector]:
    """`(t, p, m, u, d, s, z) -> (x, z_dynamic, ..)`: the initial problem, and a guess of its own `z`."""
    nominals = Nominals({sym(v.name): v.nominal for v in code.system.flat.unknowns if v.nominal is not None})
    slots = code.initial.slots
    guesses = tuple(leaf if leaf in slots else ZERO for leaf in code.dynamic.guesses)
    goals = [Goal("x", state_leaves(code.system)), Goal("z_dynamic", guesses)]
    function = Stitching(code.initial, nominals).closed("start", goals)
    evaluator = first.point.evaluator()
    evaluator.output()
    known = dict(zip(code.output_leaves, evaluator.output.outputs[0].tolist(), strict=True))
    return function, np.array([known.get(leaf, 0.0) for leaf in code.initial.guesses])


def _stacked(code: Code, nonzeros: Vector, count: int) -> Matrix:
    """Dense matrices (k, n, n) from the nonzeros of their row of sparse ones."""
    pattern = code.jac.sparsity_out(0)
    n = len(code.system.states)
    result = np.zeros((count, n, n))
    result[:, pattern.row(), pattern.get_col()] = nonzeros.reshape(count, -1)
    return result


def _agree(code: Code, known: Mapping[str, Vector], modes: Vector, discrete: Vector) -> NDArray[np.bool_]:
    """Which variants have the modes and the discrete values that were taken for them."""
    ops, count = operators(code.system), len(known["t"][0])
    agree = np.full(count, True)
    if ops:
        roots, sizes = (_mapped(function, known)[0] for function in (code.events, code.sizes))
        clear: NDArray[np.bool_] = np.abs(roots) > _ROUNDING * sizes
        wanted: Vector = np.array([literal_modes(ops, column) for column in roots.T], dtype=np.float64).T
        agree &= np.all(np.logical_or(np.equal(wanted, modes[:, None]), np.logical_not(clear)), axis=0)
    unknowns = len(code.system.discrete.unknowns)
    if unknowns:
        found = _mapped(code.discrete.update, known)[0]
        agree &= np.all(found == discrete[:unknowns, None], axis=0)
    return agree
