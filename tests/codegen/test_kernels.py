"""Kernels in CasADi: the same values and derivatives as in Python, inlined or called."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np
import pytest
from casadi import SX, Function

from acausal.codegen.casadi_expressions import jacobian, to_casadi
from acausal.codegen.kernels import MOST_INLINE, is_evaluated_in_python, kernel_sx
from acausal.codegen.lazy import guarded_values
from acausal.errors import UnsupportedProblem
from acausal.symbolic.expressions.expr import (
    ONE,
    ZERO,
    Expr,
    add,
    call,
    div,
    if_then_else,
    logical_and,
    logical_not,
    logical_or,
    mul,
    relation,
    sym,
)
from acausal.symbolic.expressions.kernel import Kernel, Part, Whole
from acausal.symbolic.expressions.kernels.formula import Formula
from acausal.symbolic.expressions.kernels.patches import Patches, patches
from acausal.symbolic.expressions.kernels.piecewise import Piecewise, piecewise
from acausal.symbolic.expressions.kernels.texts import TextOf
from acausal.symbolic.expressions.node import Constant

SIZES = [1, 2, 7, MOST_INLINE + 1, 60]
PERIODS = [None, (-0.5, 3.0)]


def random_pieces(count: int, period: tuple[float, float] | None, seed: int = 1) -> Piecewise:
    rng = np.random.default_rng(seed + count)
    breaks = np.sort(rng.uniform(-0.5, 2.5, count - 1))
    coefficients = [list(rng.normal(size=1 + k % 4)) for k in range(count)]
    return piecewise("random", list(breaks), list(rng.normal(size=count)), coefficients, 0, period, 2.5)


def random_patches(rows: int, columns: int, period: tuple[float, float] | None) -> Patches:
    rng = np.random.default_rng(rows * 100 + columns)
    breaks = [list(np.sort(rng.uniform(-0.5, 2.5, n - 1))) for n in (rows, columns)]
    origins = [list(rng.normal(size=n)) for n in (rows, columns)]
    data = rng.normal(size=(rows * columns, 6))
    return patches(
        "random", (breaks[0], breaks[1]), (origins[0], origins[1]), (3, 2), data.tolist(), 0, (None, period)
    )


def points(kernel: Kernel, breaks: tuple[float, ...]) -> list[tuple[float, ...]]:
    rng = np.random.default_rng(3)
    inside = [tuple(rng.uniform(-4, 4, kernel.arity)) for _ in range(40)]
    return [*inside, *[(b, b) for b in breaks[:5]]]


def number(value: Constant) -> float:
    assert isinstance(value, (int, float))
    return float(value)


def check(kernel: Kernel, breaks: tuple[float, ...]) -> None:
    x = SX.sym("x", 2)
    run = Function(
        "run", [x], [kernel_sx(kernel, [x[0], x[1]]), jacobian(kernel_sx(kernel, [x[0], x[1]]), x)]
    )
    slopes = [kernel.partial(0), kernel.partial(1)]
    for point in points(kernel, breaks):
        value, slope = run(point)
        assert float(value) == pytest.approx(number(kernel.evaluate(*point)), rel=1e-9, abs=1e-9)
        expected = [0.0 if part is None else number(part.evaluate(*point)) for part in slopes]
        assert np.array(ca.densify(slope))[0] == pytest.approx(expected, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("period", PERIODS)
@pytest.mark.parametrize("size", SIZES)
def test_piecewise(size: int, period: tuple[float, float] | None) -> None:
    kernel = random_pieces(size, period)
    check(kernel, kernel.breaks)


@pytest.mark.parametrize("period", PERIODS)
@pytest.mark.parametrize(("rows", "columns"), [(1, 1), (2, 3), (3, 1), (4, 5), (12, 2)])
def test_patches(rows: int, columns: int, period: tuple[float, float] | None) -> None:
    check(random_patches(rows, columns, period), ())


@pytest.mark.parametrize("size", SIZES)
def test_generates_c(size: int) -> None:
    x = SX.sym("x")
    generator = ca.CodeGenerator("table.c")
    generator.add(Function("run", [x], [kernel_sx(random_pieces(size, None), [x, x])]))
    assert "run" in generator.dump()


class Counter(Whole):
    """What only Python knows."""

    name = "count"
    key = "count"
    arity = 1
    count = 2

    def __init__(self) -> None:
        self.calls = 0

    def values(self, args: tuple[Constant, ...]) -> Sequence[Constant | None]:
        self.calls += 1
        return (round(number(args[0]) * 10), None)


def _part(whole: Whole, index: int) -> Expr:
    return call(Part(whole, index, "count", "Integer"), sym("x"))


def test_functions_of_python_are_called_once_for_all_results_and_have_no_derivative() -> None:
    x, whole = SX.sym("x"), Counter()
    first, second, again = to_casadi([_part(whole, 0), _part(whole, 1), _part(whole, 0)], {sym("x"): x})
    run = Function("run", [x], [first * x, jacobian(first * x, x), second, again])
    assert [float(r) for r in run(2.0)] == pytest.approx([40.0, 20.0, float("nan"), 20.0], nan_ok=True)
    assert whole.calls == 1


SQUARE = Formula("square", "square", (sym("y"),), (mul(sym("y"), sym("y")), div(ONE, sym("y"))))


@pytest.mark.parametrize("formula", [True, False])
def test_functions_are_evaluated_where_their_values_are_used(formula: bool) -> None:
    x, z, whole = sym("x"), sym("z"), Counter()
    inside, positive = _part(SQUARE if formula else whole, 0), relation("gt", x, ZERO)
    values = [
        if_then_else(positive, add(inside, z), z),
        logical_or(relation("gt", inside, ONE), logical_not(positive)),
        logical_and(positive, relation("gt", inside, ONE)),
    ]
    of = {x: SX.sym("x"), z: SX.sym("z")}
    run = Function("run", list(of.values()), to_casadi(guarded_values(values), of))
    assert [float(v) for v in run(0.0, 3.0)] == [3, 1, 0]
    assert whole.calls == 0
    assert [float(v) for v in run(2.0, 3.0)] == [7 if formula else 23, 1, 1]
    assert whole.calls == (0 if formula else 1)


def test_formulas_have_c_and_functions_of_python_have_none() -> None:
    x = SX.sym("x")
    for whole, python in ((SQUARE, False), (Counter(), True)):
        (value,) = to_casadi([_part(whole, 0)], {sym("x"): x})
        assert is_evaluated_in_python(Function("run", [x], [value])) == python


def test_texts_have_no_numeric_code() -> None:
    with pytest.raises(UnsupportedProblem):
        kernel_sx(TextOf("d", 0, True, (), "text"), [SX.sym("x")])
