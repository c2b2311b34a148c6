"""Derivatives and slopes in one graph, against the robust functions, which take over where they must."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from acausal.codegen.functions import Code, generate
from acausal.simulate.evaluator import Evaluator
from acausal.symbolic.causal import Block, BlockKind
from acausal.symbolic.expressions import expr as e
from acausal.symbolic.expressions.expr import TIME, Expr, const, sym
from tests.codegen.systems import hand_system, rate, torn

X = sym("x")


def linear_block(matrix: NDArray[np.float64], rights: list[Expr]) -> tuple[list[Expr], Block]:
    """The unknowns and the block `matrix z = rights`."""
    names = [f"z{i}" for i in range(len(matrix))]
    rows: list[tuple[Expr, Expr]] = [
        (e.add(*[e.mul(const(float(a)), sym(name)) for a, name in zip(row, names, strict=True)]), right)
        for row, right in zip(matrix, rights, strict=True)
    ]
    return [sym(name) for name in names], torn(BlockKind.LINEAR, names, rows)


def switched(a: float, size: int = 4) -> Code:
    """A regular matrix, but for its last row `a z_last = 0`; x multiplies the right side."""
    matrix = np.eye(size) + np.diag(np.full(size - 1, 0.5), 1) + np.diag(np.full(size - 1, 0.25), -1)
    matrix[-1] = 0.0
    matrix[-1, -1] = a
    rights = [e.mul(const(float(i + 1)), X) for i in range(size - 1)]
    unknowns, block = linear_block(matrix, [*rights, const(0.0)])
    return generate(hand_system({"x": 1.0}, [block, rate("x", e.add(*unknowns, TIME))]))


@pytest.mark.parametrize("size", [2, 5, 9])
def test_the_graph_agrees_with_the_solver(size: int) -> None:
    code = switched(1.0, size)
    point = [0.5, [2.0], [], [], [], [], np.zeros(len(code.dynamic.guesses))]
    derivative = code.quick.ode or code.ode
    assert derivative.is_a("SXFunction")
    found, wanted = derivative(*point), code.ode(*point)
    assert float(found[0]) == pytest.approx(float(wanted[0]), rel=1e-12)
    slopes = code.quick.slopes
    assert slopes is not None
    jacobian, rate_by_time = slopes(*point[:-1], wanted[1])
    assert float(jacobian) == pytest.approx(float(code.jac(*point)), rel=1e-12)
    assert float(rate_by_time) == 1.0


def test_a_singular_block_goes_to_the_solver() -> None:
    """The last unknown is free: the solver takes 0, and the graph says that it does not know."""
    code = switched(0.0)
    assert code.quick.ode is not None
    assert np.isnan(float(code.quick.ode(0.0, [2.0], [], [], [], [], np.zeros(4))[0]))
    evaluator = Evaluator(code, np.zeros(0))
    evaluator.at(0.0, np.array([2.0]))
    assert evaluator.evaluate()
    expected = float(code.ode(0.0, [2.0], [], [], [], [], np.zeros(4))[0])
    assert evaluator.xdot[0] == expected
    evaluator.jac()
    assert evaluator.jacobian[0] == pytest.approx(expected / 2.0, rel=1e-6)


def test_slopes_through_a_nonlinear_block() -> None:
    """`z^3 + z = x`, `der(x) = z + t^2`: dz/dx = 1 / (3 z^2 + 1)."""
    z = sym("z")
    block = torn(BlockKind.NONLINEAR, ["z"], [(e.add(e.mul(z, z, z), z), X)])
    code = generate(hand_system({"x": 1.0}, [block, rate("x", e.add(z, e.mul(TIME, TIME)))]))
    assert code.quick.ode is None
    slopes = code.quick.slopes
    assert slopes is not None
    jacobian, rate_by_time = slopes(3.0, [10.0], [], [], [], [], [2.0])
    assert float(jacobian) == pytest.approx(1 / 13)
    assert float(rate_by_time) == pytest.approx(6.0)
