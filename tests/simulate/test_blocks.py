"""Blocks in every mode: singular ones with a solution, contradictions, pivoting, and runs through them."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import acausal
from acausal.codegen.functions import Code, generate
from acausal.errors import InitializationProblem, SimulationProblem
from acausal.simulate.initialize import initialize
from acausal.simulate.matrices import dependent_rows, minimum_norm, solve_regular
from acausal.simulate.simulate import simulate
from acausal.symbolic.causal import BlockKind
from acausal.symbolic.expressions import expr as e
from acausal.symbolic.expressions.expr import Expr, const, sym
from tests.codegen.systems import hand_system, rate, torn

X = sym("x")
Array = NDArray[np.float64]


def switching(matrix: Array, right: Array, nominal: dict[str, float] | None = None) -> Code:
    """A(x) z = b with every entry inside `if x > 0`, so that the block counts as switching."""
    n = len(right)
    names = [f"z{i}" for i in range(n)]
    relation = e.relation("gt", X, const(-1e9))

    def entry(value: float) -> Expr:
        return e.if_then_else(relation, const(value), const(value + 1.0))

    pairs = [
        (e.add(*[e.mul(entry(float(matrix[i, j])), sym(names[j])) for j in range(n)]), const(float(right[i])))
        for i in range(n)
    ]
    blocks = [torn(BlockKind.LINEAR, names, pairs), rate("x", e.add(*map(sym, names)))]
    return generate(hand_system({"x": 1.0}, blocks, relations=[relation], nominal=nominal))


def fast(code: Code) -> Array:
    """`z` as the integrator's Function solves it."""
    return np.array(code.ode(0.0, [1.0], [], [1.0], [], [], np.zeros(len(code.dynamic.guesses)))[1]).ravel()


@pytest.mark.parametrize("size", [2, 3, 5, 8])
@pytest.mark.parametrize("scale", [1e-9, 1.0, 1e9])
@pytest.mark.parametrize("deficiency", [1, 2])
def test_singular_consistent_block_has_its_minimum_norm_solution(
    size: int, scale: float, deficiency: int
) -> None:
    random = np.random.default_rng(size)
    rank = max(size - deficiency, 1)
    matrix = scale * random.normal(size=(size, rank)) @ random.normal(size=(rank, size))
    right = matrix @ random.normal(size=size)
    code = switching(matrix, right)
    expected = np.linalg.pinv(matrix, rcond=1e-10) @ right
    assert fast(code) == pytest.approx(expected, rel=1e-6, abs=1e-8)
    evaluator = initialize(code, 0.0).evaluator
    assert evaluator.guess == pytest.approx(expected, rel=1e-6, abs=1e-8)


def test_minimum_norm_counts_in_nominal_values() -> None:
    code = switching(np.ones((2, 2)), np.ones(2), nominal={"z0": 3.0, "z1": 1.0})
    assert fast(code) == pytest.approx([0.9, 0.1])


@pytest.mark.parametrize("size", [2, 3, 6])
def test_regular_block_pivots(size: int) -> None:
    matrix = np.eye(size)[::-1] + 1e-20
    assert fast(switching(matrix, np.arange(1.0, size + 1))) == pytest.approx(np.arange(size, 0.0, -1.0))


@pytest.mark.parametrize("ratio", [1e-6, 1e-9, 1e-11])
def test_ill_conditioned_is_not_singular(ratio: float) -> None:
    """Two nodes tied by a closed switch, each leaking to ground: conductances far apart."""
    matrix = np.array([[1 + ratio, -1.0], [-1.0, 1 + ratio]])
    z = fast(switching(matrix, np.array([ratio, ratio])))
    assert z == pytest.approx([1.0, 1.0], rel=1e-15 / ratio + 1e-12)


@pytest.mark.parametrize("size", [2, 4])
def test_contradiction_names_block_equations_and_time(size: int) -> None:
    matrix = np.ones((size, size))
    right = np.ones(size)
    right[0] = 2.0
    code = switching(matrix, right)
    assert np.isnan(fast(code)).any()
    with pytest.raises(
        InitializationProblem, match=r"singular at time 0 s.*z0, z1.*(\n.*)*contradict"
    ) as caught:
        initialize(code, 0.0)
    assert caught.value.codes[0] == "simulate.singular-block"


def test_jacobian_in_a_singular_mode_is_that_of_the_minimum_norm_solution() -> None:
    """z0 + z1 = x twice: z = x/2 each, so d(z0 + z1)/dx = 1."""
    names = ["z0", "z1", "z2", "z3"]
    relation = e.relation("gt", X, const(-1e9))
    one = e.if_then_else(relation, e.ONE, e.ZERO)
    total = e.mul(one, e.add(sym("z0"), sym("z1")))
    rows = [(total, X), (total, X), (sym("z2"), X), (sym("z3"), sym("z2"))]
    blocks = [torn(BlockKind.LINEAR, names, rows), rate("x", e.sub(sym("z3"), sym("z0")))]
    code = generate(hand_system({"x": 1.0}, blocks, relations=[relation]))
    guess = [0.0] * 4
    assert float(code.ode(0.0, [3.0], [], [1.0], [], [], guess)[0]) == pytest.approx(1.5)
    assert float(code.jac(0.0, [3.0], [], [1.0], [], [], guess)) == pytest.approx(0.5, rel=1e-6)


VALVES = """
model Valves "two ideal valves in series; the node between them floats when they close"
  Real p(start = 1, fixed = true, nominal = 1), node, q1, q2, s1, s2;
  Boolean closed = time > 0.5;
equation
  der(p) = q2;
  q1 = if closed then 0 else s1;
  q2 = if closed then 0 else s2;
  s1 = 3 - node;
  s2 = node - p;
  (if closed then 0 else 1) * (q1 - q2) = 0;
end Valves;
"""


CLUTCH = """
model Clutch "slipping gives the torque, sticking equal accelerations"
  parameter Real J1 = 1, J2 = 2, tau_max = 1;
  Real w1(start = 4, fixed = true), w2(start = 0, fixed = true), tau;
  Boolean slipping;
equation
  J1 * der(w1) = 0.1 - tau;
  J2 * der(w2) = tau;
  slipping = w1 - w2 > 1e-6;
  0 = if slipping then tau - tau_max else der(w1) - der(w2);
end Clutch;
"""


def test_stick_and_slip_in_one_block() -> None:
    result = simulate(acausal.loads(CLUTCH).compile().code, stop_time=5.0, rtol=1e-8)
    tau, time = result.values("tau"), result.values("w1")
    slip_end = (4.0 - 1e-6) / (0.9 + 0.5)
    before, after = result.time < slip_end - 1e-3, result.time > slip_end + 1e-3
    assert tau[before] == pytest.approx(1.0)
    assert tau[after] == pytest.approx(0.1 * 2 / 3)
    assert time[-1] - result.values("w2")[-1] == pytest.approx(0.0, abs=1e-5)


CLOSED = """
model Closed "the position of a closed valve's flow source is undetermined: 0 * q = 0"
  Real x(start = 0, fixed = true), q;
  Real open = if time < 0.5 then 1 else 0;
equation
  der(x) = q;
  (if time < 0.5 then 1 else 0) * q = open * 2;
end Closed;
"""


def test_closed_valve_in_a_scalar_block() -> None:
    result = simulate(acausal.loads(CLOSED).compile().code, stop_time=1.0)
    assert result.final(["x", "q"]) == pytest.approx({"x": 1.0, "q": 0.0}, abs=1e-6)


def test_valve_closed_against_a_flow_is_a_contradiction_at_its_time() -> None:
    text = CLOSED.replace("open * 2", "2")
    with pytest.raises(SimulationProblem, match=r"singular at time 0\.5.* q;") as caught:
        simulate(acausal.loads(text).compile().code, stop_time=1.0)
    assert caught.value.codes[0] == "simulate.singular-block"


def test_valves_that_close_leave_their_node_where_the_norm_is_smallest() -> None:
    result = simulate(acausal.loads(VALVES).compile().code, stop_time=1.0, rtol=1e-8)
    assert result.final(["q1", "q2"]) == pytest.approx({"q1": 0.0, "q2": 0.0}, abs=1e-12)
    exact = 3 - 2 * np.exp(-0.5 * np.minimum(result.time, 0.5))
    assert result.values("p") == pytest.approx(exact, abs=1e-6)


@pytest.mark.parametrize("sparse", [False, True])
def test_matrices_dense_and_sparse(sparse: bool) -> None:
    from scipy.sparse import csc_array

    dense = np.array([[2.0, 1.0, 0.0], [1.0, 3.0, 0.0], [0.0, 0.0, 1.0]])
    singular = np.array([[1.0, 2.0, 0.0], [2.0, 4.0, 0.0], [0.0, 0.0, 1.0]])
    right = np.array([1.0, 2.0, 3.0])
    a, b = (csc_array(dense), csc_array(singular)) if sparse else (dense, singular)
    assert solve_regular(a, right) == pytest.approx(np.linalg.solve(dense, right))
    assert solve_regular(b, right) is None
    assert minimum_norm(b, right) == pytest.approx(np.linalg.pinv(singular) @ right)
    assert dependent_rows(b) == (0, 1)
    assert dependent_rows(a) is None


def test_large_nonlinear_blocks_are_solved_sparse() -> None:
    """300 coupled cubic equations in one block: more than the dense limit."""
    n = 300
    names = [f"z{i}" for i in range(n)]
    z = [sym(name) for name in names]
    rows = [
        (e.add(e.mul(z[i], z[i], z[i]), e.mul(const(2.0), z[i])), e.add(X, z[(i + 1) % n])) for i in range(n)
    ]
    code = generate(hand_system({"x": 4.0}, [torn(BlockKind.NONLINEAR, names, rows), rate("x", e.neg(z[0]))]))
    guess = initialize(code, 0.0).evaluator.guess
    assert guess**3 + guess == pytest.approx(np.full(n, 4.0))


def test_a_switch_finds_its_other_branch() -> None:
    """An amplifier with positive feedback and no state: where one branch ends, only the other is left."""
    text = """
    model Schmitt
      Real u = 10*sin(6.2831853*time);
      Real e(start = 1);
      Real y = smooth(0, noEvent(if 15000*e > 15 then 15 else if 15000*e < -15 then -15 else 15000*e));
    equation
      e = (15*u + y)/16;
    end Schmitt;
    """
    result = acausal.loads(text).compile().simulate(stop_time=1.0)
    u, y = result.values("u"), result.values("y")
    assert set(np.round(y, 9)) == {15.0, -15.0}
    falls = u[1:][np.diff(y) < -1]
    rises = u[1:][np.diff(y) > 1]
    assert len(falls) == 1
    assert -1.2 < falls[0] < -1.0
    assert (rises <= 1.2).all()
