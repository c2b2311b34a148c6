"""Kernels in CasADi.

A piece is chosen in the SX graph itself (bisection by conditions, every branch evaluated) up to `MOST_INLINE`
pieces; beyond that one SX node calls an MX function that looks the interval up and gathers its coefficients.
Both differentiate forward and generate C. Measured, one evaluation of a cubic table: 5 points 0.18 against
0.6 us, 10 points 0.5 against 0.6 us, 50 points 2.7 against 0.6 us, 500 points 30 against 0.9 us, 5,000
points 6 us (called); sums of clamped linear pieces take half the time of bisection and are not better than
the call from 20 points on.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import TypeVar

import casadi as ca
import numpy as np
from casadi import DM, MX, SX, Callback, Function, Sparsity

from acausal.errors import UnsupportedProblem, fail
from acausal.symbolic.expressions.kernel import Guarded, Kernel, Whole
from acausal.symbolic.expressions.kernels.formula import Formula
from acausal.symbolic.expressions.kernels.patches import Patches, Period
from acausal.symbolic.expressions.kernels.piecewise import Piecewise

MOST_INLINE = 10
_Matrix = TypeVar("_Matrix", SX, MX)
_CALLED = {"never_inline": True, "ad_weight": 0.0}


def kernel_sx(kernel: Kernel, args: Sequence[SX]) -> SX:
    """The value of a kernel's call. Raises `UnsupportedProblem` for one without numeric value."""
    if isinstance(kernel, Piecewise):
        return _piecewise_sx(kernel, args[0], args[1])
    if isinstance(kernel, Patches):
        return _patches_sx(kernel, args[0], args[1])
    what = "gives a String, which" if kernel.result == "String" else "is a function that"
    message = f"`{kernel.name}` {what} has no numeric code"
    raise fail(UnsupportedProblem, "codegen.no-code", message, names=[kernel.name])


# ------------------------------------------------------------------------------ one argument


def _piecewise_sx(kernel: Piecewise, selector: SX, x: SX) -> SX:
    if len(kernel.origins) > MOST_INLINE:
        return _piecewise_function(kernel)(selector, x)
    offset = SX(0.0)
    if kernel.period is not None:
        turns, shift = _wrapped(selector, kernel.period)
        selector, x, offset = selector - shift, x - shift, turns * kernel.drift
    rows = [(origin, *piece) for origin, piece in zip(kernel.origins, kernel.coefficients, strict=True)]
    width = max(map(len, rows))
    table = [[*row, *[0.0] * (width - len(row))] for row in rows]
    origin, *coefficients = _choose(table, kernel.breaks, selector)
    return _horner(coefficients, x - origin) + offset


def _wrapped(x: _Matrix, period: Period) -> tuple[_Matrix, _Matrix]:
    """Whole periods before `x`, and their length."""
    turns = (x - period[0]) / period[1]
    below = ca.fmin(ca.floor(turns), 0)
    turns = below + ca.fmax(ca.ceil(turns) - 1, 0)
    return turns, turns * period[1]


def _choose(table: list[list[float]], breaks: Sequence[float], selector: SX) -> list[SX]:
    """The row of the table by bisection over the breaks between its rows."""
    columns = list(zip(*table, strict=True))
    return [
        SX(column[0]) if len(set(column)) == 1 else _bisect(column, breaks, selector) for column in columns
    ]


def _bisect(values: Sequence[float], breaks: Sequence[float], selector: SX) -> SX:
    if len(values) == 1:
        return SX(values[0])
    middle = len(values) // 2
    low = _bisect(values[:middle], breaks[: middle - 1], selector)
    high = _bisect(values[middle:], breaks[middle:], selector)
    return ca.if_else(selector < breaks[middle - 1], low, high)


def _horner(coefficients: Sequence[_Matrix], distance: _Matrix) -> _Matrix:
    value = coefficients[-1]
    for coefficient in reversed(coefficients[:-1]):
        value = value * distance + coefficient
    return value


@lru_cache(maxsize=256)
def _piecewise_function(kernel: Piecewise) -> Function:
    selector, x = MX.sym("s"), MX.sym("x")
    inner_selector, inner_x, offset = selector, x, MX(0.0)
    if kernel.period is not None:
        turns, shift = _wrapped(selector, kernel.period)
        inner_selector, inner_x, offset = selector - shift, x - shift, turns * kernel.drift
    piece = _index(kernel.breaks, inner_selector)
    width = max(map(len, kernel.coefficients))
    data = np.zeros((len(kernel.coefficients), width))
    for row, coefficients in zip(data, kernel.coefficients, strict=True):
        row[: len(coefficients)] = coefficients
    flat = MX(DM(data.reshape(-1)))
    distance = inner_x - MX(DM(np.array(kernel.origins)))[piece]
    value = _horner([flat[width * piece + power] for power in range(width)], distance) + offset
    return Function("table", [selector, x], [value], ["s", "x"], ["y"], _CALLED)


def _index(breaks: Sequence[float], x: MX) -> MX:
    """How many breaks are not above `x`. `low` counts from the second grid point to the last but one."""
    if not breaks:
        return MX(0)
    return ca.low(DM([breaks[0] - 1.0, *breaks, breaks[-1] + 1.0]), x, {"lookup_mode": "binary"})


# ------------------------------------------------------------------------------ two arguments


def _patches_sx(kernel: Patches, u: SX, v: SX) -> SX:
    if len(kernel.coefficients) > MOST_INLINE:
        return _patches_function(kernel)(u, v)
    points: list[SX] = []
    for x, period in zip((u, v), kernel.periods, strict=True):
        points.append(x if period is None else x - _wrapped(x, period)[1])
    rows, columns = (len(origins) for origins in kernel.origins)
    chosen = [
        _choose([list(patch) for patch in kernel.coefficients[i * columns : (i + 1) * columns]],
                kernel.breaks[1], points[1])
        for i in range(rows)
    ]  # fmt: skip
    picked = [
        _bisect_sx([row[k] for row in chosen], kernel.breaks[0], points[0]) for k in range(len(chosen[0]))
    ]
    distances = [
        x - _bisect(origins, breaks, x)
        for x, origins, breaks in zip(points, kernel.origins, kernel.breaks, strict=True)
    ]
    return _surface(picked, kernel.powers, distances[0], distances[1])


def _bisect_sx(values: Sequence[SX], breaks: Sequence[float], selector: SX) -> SX:
    if len(values) == 1:
        return values[0]
    middle = len(values) // 2
    low = _bisect_sx(values[:middle], breaks[: middle - 1], selector)
    high = _bisect_sx(values[middle:], breaks[middle:], selector)
    return ca.if_else(selector < breaks[middle - 1], low, high)


def _surface(coefficients: Sequence[_Matrix], powers: tuple[int, int], du: _Matrix, dv: _Matrix) -> _Matrix:
    rows, columns = powers
    lines = [_horner(coefficients[p * columns : (p + 1) * columns], dv) for p in range(rows)]
    return _horner(lines, du)


@lru_cache(maxsize=256)
def _patches_function(kernel: Patches) -> Function:
    u, v = MX.sym("u"), MX.sym("v")
    cells: list[MX] = []
    distances: list[MX] = []
    for x, breaks, origins, period in zip((u, v), kernel.breaks, kernel.origins, kernel.periods, strict=True):
        inner = x if period is None else x - _wrapped(x, period)[1]
        cells.append(_index(breaks, inner))
        distances.append(inner - MX(DM(np.array(origins)))[cells[-1]])
    width = kernel.powers[0] * kernel.powers[1]
    flat = MX(DM(np.array(kernel.coefficients).reshape(-1)))
    start = width * (cells[0] * len(kernel.origins[1]) + cells[1])
    picked = [flat[start + k] for k in range(width)]
    value = _surface(picked, kernel.powers, distances[0], distances[1])
    return Function("table", [u, v], [value], ["u", "v"], ["y"], _CALLED)


# ------------------------------------------------------------------------------ evaluated at events


def whole_sx(whole: Whole, args: SX, inner: Callable[[Formula, SX], SX]) -> SX:
    """All results of a function evaluated at events, as one column; `inner` converts what it computes."""
    return _whole_function(whole, inner)(args)


def _whole_function(whole: Whole, inner: Callable[[Formula, SX], SX]) -> Function:
    known = _functions.get(whole)
    if known is None:
        if len(_functions) >= _MOST_KEPT:
            _functions.clear()
        known = _functions[whole] = _made(whole, inner)
    return known


_functions: dict[Whole, Function] = {}
_MOST_KEPT = 256


def _made(whole: Whole, inner: Callable[[Formula, SX], SX]) -> Function:
    if isinstance(whole, Guarded) and isinstance(whole.inner, Formula):
        return _only_if(_whole_function(whole.inner, inner))
    if isinstance(whole, Formula):
        formals = SX.sym("u", whole.arity)
        return Function("formula", [formals], [inner(whole, formals)], ["u"], ["y"], _CALLED)
    return _Evaluated(whole)


def _only_if(function: Function) -> Function:
    """`(c, u)`: the function of `u` where `c` is true; it is not evaluated where it is not."""
    u = MX.sym("u", function.nnz_in(0))
    zero = Function("nothing", [u], [MX(DM.zeros(function.nnz_out(0)))])
    choice = Function.if_else("choice", function, zero, _CALLED)
    guarded = MX.sym("u", function.nnz_in(0) + 1)
    return Function("guarded", [guarded], [choice(guarded[0], guarded[1:])], ["u"], ["y"], _CALLED)


def is_evaluated_in_python(function: Function) -> bool:
    """Whether a function calls one that has no C."""
    return any(inner.class_name() == "CallbackInternal" for inner in function.find_functions())


class _Evaluated(Callback):
    """Results that are evaluated in Python; their derivatives are zero."""

    def __init__(self, whole: Whole) -> None:
        super().__init__()
        self._whole = whole
        self._zeros: list[Function] = []
        self.construct("kernel", {"never_inline": True})

    def get_n_in(self) -> int:
        return 1

    def get_n_out(self) -> int:
        return 1

    def get_sparsity_in(self, i: int) -> Sparsity:
        return Sparsity.dense(self._whole.arity, 1)

    def get_sparsity_out(self, i: int) -> Sparsity:
        return Sparsity.dense(self._whole.count, 1)

    def eval(self, arg: Sequence[DM]) -> list[DM]:
        return [DM(self._values(tuple(arg[0].nonzeros())))]

    def _values(self, args: tuple[float, ...]) -> list[float]:
        try:
            values = self._whole.values(args)
        except Exception:  # else CasADi prints all arguments; variables that are not numbers are named
            return [float("nan")] * self._whole.count
        return [float(value) if isinstance(value, (int, float)) else float("nan") for value in values]

    def has_forward(self, nfwd: int) -> bool:
        return True

    def get_forward(
        self, nfwd: int, name: str, inames: Sequence[str], onames: Sequence[str], opts: object
    ) -> Function:
        n, m = self._whole.arity, self._whole.count
        inputs = [MX.sym("u", n), MX.sym("y", m), MX.sym("d", n, nfwd)]
        zero = Function(name, inputs, [MX(DM.zeros(m, nfwd))], inames, onames)
        self._zeros.append(zero)
        return zero
