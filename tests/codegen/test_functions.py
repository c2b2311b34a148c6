"""Compiled systems: values, exact Jacobians, and linear and nonlinear blocks against NumPy."""

from __future__ import annotations

import gc
import time

import numpy as np
import pytest
from casadi import Function
from numpy.typing import NDArray

from acausal.codegen.functions import Code, generate
from acausal.symbolic.causal import Block, BlockKind, CausalSystem
from acausal.symbolic.expressions import expr as e
from acausal.symbolic.expressions.expr import Expr, const, sym
from tests.codegen.systems import explicit, hand_system, rate, torn

X, Y, Z, W = sym("x"), sym("y"), sym("z"), sym("w")
Array = NDArray[np.float64]


def call(
    function: Function, x: list[float], p: list[float] | None = None, guess: list[float] | None = None
) -> Array:
    return np.array(function(0.0, x, p or [], [], [], [], guess or [])).ravel()


def rates(code: Code, x: list[float], guess: list[float] | None = None) -> Array:
    return np.array(code.ode(0.0, x, [], [], [], [], guess or [])[0]).ravel()


def differences(code: Code, x: list[float], guess: list[float] | None = None) -> Array:
    h = 1e-6
    columns = [
        (
            rates(code, (np.array(x) + h * unit).tolist(), guess)
            - rates(code, (np.array(x) - h * unit).tolist(), guess)
        )
        / (2 * h)
        for unit in np.eye(len(x))
    ]
    return np.array(columns).T


def exact(code: Code, x: list[float], guess: list[float] | None = None) -> Array:
    return np.array(code.jac(0.0, x, [], [], [], [], guess or []).full())


def linear_block(matrix: Array) -> tuple[list[str], Block]:
    n = len(matrix)
    names = [f"z{i}" for i in range(n)]
    rows: list[tuple[Expr, Expr]] = []
    for i in range(n):
        left = e.add(*[e.mul(const(float(matrix[i, j])), sym(names[j])) for j in range(n)])
        rows.append((left, e.mul(const(float(i + 1)), X)))
    return names, torn(BlockKind.LINEAR, names, rows)


@pytest.mark.parametrize("size", [1, 2, 3, 4, 8])
def test_linear_block_agrees_with_numpy(size: int) -> None:
    matrix = np.random.default_rng(size).normal(size=(size, size))
    names, block = linear_block(matrix)
    code = generate(hand_system({"x": 1.0}, [block, rate("x", e.add(*map(sym, names)))]))
    expected = np.linalg.solve(matrix, np.arange(1, size + 1)).sum()
    assert rates(code, [2.0])[0] == pytest.approx(2 * expected, rel=1e-10)
    assert exact(code, [2.0])[0, 0] == pytest.approx(expected, rel=1e-10)
    assert code.ode.is_a("SXFunction") == (size <= 3)


@pytest.mark.parametrize("size", [2, 3])
def test_linear_block_pivots(size: int) -> None:
    matrix = np.eye(size)[::-1].copy()
    names, block = linear_block(matrix)
    code = generate(hand_system({"x": 1.0}, [block, rate("x", sym(names[0]))]))
    assert rates(code, [1.0])[0] == pytest.approx(size)


@pytest.mark.parametrize("scale", [1.0, 1e-9, 1e9])
def test_singular_matrix_is_told_from_a_badly_scaled_one(scale: float) -> None:
    for matrix, singular in (
        (np.array([[1.0, 0.1 * scale], [3.0, 0.1 * 3.0 * scale]]), True),
        (np.array([[1.0, 0.1 * scale], [3.0, 0.4 * scale]]), False),
    ):
        names, block = linear_block(matrix)
        code = generate(hand_system({"x": 1.0}, [block, rate("x", sym(names[1]))]))
        assert np.isfinite(rates(code, [1.0])[0]) != singular


def nonlinear() -> Code:
    """z^2 w = x + y, w = z + 1."""
    block = torn(BlockKind.NONLINEAR, ["z"], [(e.mul(Z, Z, W), e.add(X, Y))], [(W, e.add(Z, e.ONE))])
    return generate(hand_system({"x": 1.0, "y": 1.0}, [block, rate("x", e.neg(e.mul(Z, Y))), rate("y", W)]))


def test_nonlinear_block_and_its_derivative() -> None:
    code = nonlinear()
    z = np.roots([1.0, 1.0, 0.0, -3.5])
    root = float(z[np.isreal(z)][0].real)
    assert rates(code, [2.0, 1.5], [1.0]) == pytest.approx([-root * 1.5, root + 1], rel=1e-10)
    assert exact(code, [2.0, 1.5], [1.0]) == pytest.approx(differences(code, [2.0, 1.5], [1.0]), rel=1e-6)


def test_unsolvable_block_is_not_a_number() -> None:
    block = torn(BlockKind.NONLINEAR, ["z"], [(e.mul(Z, Z), X)])
    code = generate(hand_system({"x": 1.0}, [block, rate("x", Z)]))
    assert np.isnan(rates(code, [-1.0], [1.0])[0])


@pytest.mark.parametrize("size", [1e-9, 1.0, 1e9])
def test_newton_does_not_depend_on_units(size: float) -> None:
    block = torn(BlockKind.NONLINEAR, ["z"], [(e.div(e.mul(Z, Z), const(size)), e.mul(const(size), X))])
    code = generate(hand_system({"x": 1.0}, [block, rate("x", Z)], nominal={"z": size}))
    assert rates(code, [2.0], [size])[0] == pytest.approx(size * 2**0.5, rel=1e-9)


def test_segments_between_implicit_blocks() -> None:
    """Two nonlinear blocks with assignments before, between and after."""
    u, v, q = sym("u"), sym("v"), sym("q")
    blocks = [
        explicit(u, e.mul(const(2.0), X)),
        torn(BlockKind.NONLINEAR, ["z"], [(e.mul(Z, Z), u)]),
        explicit(v, e.add(Z, u)),
        torn(BlockKind.NONLINEAR, ["q"], [(e.mul(q, q, q), e.add(v, Z))]),
        rate("x", e.add(q, e.mul(v, u))),
    ]
    code = generate(hand_system({"x": 1.0}, blocks))
    z = 4.0**0.5
    expected = (2 * z + 4.0) ** (1 / 3) + (z + 4.0) * 4.0
    assert rates(code, [2.0], [1.0, 1.0])[0] == pytest.approx(expected, rel=1e-10)
    assert exact(code, [2.0], [1.0, 1.0]) == pytest.approx(differences(code, [2.0], [1.0, 1.0]), rel=1e-6)
    solved = np.array(code.ode(0.0, [2.0], [], [], [], [], [1.0, 1.0])[1]).ravel()
    outputs = call(code.outputs, [2.0], guess=solved.tolist())
    assert dict(zip(code.output_leaves, outputs, strict=True))[v] == pytest.approx(z + 4.0)


def test_parameters_follow_overrides() -> None:
    code = generate(hand_system({"x": 1.0}, [rate("x", X)], parameters={"a": 2.0, "b": 3.0}))
    assert np.array(code.parameters([0, 7], [0, 1])).ravel().tolist() == [2.0, 7.0]


def chain_system(cells: int) -> CausalSystem:
    k = sym("k")
    states: dict[str, float] = {}
    blocks: list[Block] = []
    for i in range(cells):
        states |= {f"s{i}": 0.0, f"v{i}": 0.0}
        left = sym(f"s{i - 1}") if i else const(0.0)
        blocks += [explicit(sym(f"f{i}"), e.mul(k, e.sub(sym(f"s{i}"), left))), rate(f"s{i}", sym(f"v{i}"))]
    for i in range(cells):
        right = sym(f"f{i + 1}") if i + 1 < cells else const(0.0)
        blocks.append(rate(f"v{i}", e.sub(right, sym(f"f{i}"))))
    return hand_system(states, blocks, parameters={"k": 100.0})


def test_chain_has_a_sparse_jacobian() -> None:
    assert generate(chain_system(100)).jac.nnz_out(0) == 100 + 3 * 100 - 2


@pytest.mark.slow
def test_code_generation_is_linear() -> None:
    """Time per equation at 10,000 equations over that at 1,000, without the garbage collector's share."""

    def seconds(cells: int) -> float:
        system = chain_system(cells)
        best = float("inf")
        for _ in range(3):
            gc.collect()
            gc.disable()
            began = time.process_time()
            generate(system)
            best = min(best, time.process_time() - began)
            gc.enable()
        return best / cells

    assert seconds(3334) / seconds(334) < 1.5


def test_blocks_are_solved_once_for_all_functions() -> None:
    """Outputs and events come from the solved `z` alone: at another `z` they follow it."""
    code = nonlinear()
    solved = np.array(code.ode(0.0, [2.0, 1.5], [], [], [], [], [1.0])[1]).ravel()
    outputs = dict(
        zip(code.output_leaves, call(code.outputs, [2.0, 1.5], guess=solved.tolist()), strict=True)
    )
    assert outputs[W] == pytest.approx(outputs[Z] + 1.0)
    assert outputs[Z] == solved[0]
    assert code.outputs.is_a("SXFunction")
    assert code.events.is_a("SXFunction")
    assert not code.ode.is_a("SXFunction")


def test_describe_lists_every_function_with_its_sizes() -> None:
    text = nonlinear().describe()
    assert "ode(t[1], x[2], p[0], m[0], u[0], d[0], z[1]) -> (xdot[2], z_out[1])" in text
    assert len(text.splitlines()) == 6
