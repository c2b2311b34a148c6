"""The initial problem: nonlinear and far starts, modes, checks, parameters, and messages."""

from __future__ import annotations

import numpy as np
import pytest

from acausal.codegen.functions import generate
from acausal.errors import InitializationProblem, UsageProblem
from acausal.simulate.initialize import UsedStart, initialize
from acausal.simulate.matrices import Vector
from acausal.simulate.newton import null_rows, solve
from acausal.simulate.simulate import simulate
from acausal.symbolic.causal import BlockKind, Residual
from acausal.symbolic.expressions import expr as e
from acausal.symbolic.expressions.expr import TIME, const, sym
from tests.codegen.systems import equation, explicit, hand_system, rate, torn

X, Y, Z = sym("x"), sym("y"), sym("z")


def test_start_values_and_their_reasons_are_reported() -> None:
    block = torn(BlockKind.NONLINEAR, ["z"], [(e.mul(Z, Z), X)])
    code = generate(hand_system({"x": 4.0}, [block, rate("x", Z)], guesses={"z": 1.0}))
    point = initialize(code, 0.0)
    assert point.used == (UsedStart("x", 4.0, "fixed"), UsedStart("z", 1.0, "guess"))
    assert point.x.tolist() == [4.0]
    assert point.evaluator.guess == pytest.approx([2.0])


def test_guess_chooses_the_solution() -> None:
    block = torn(BlockKind.NONLINEAR, ["z"], [(e.mul(Z, Z), X)])
    code = generate(hand_system({"x": 4.0}, [block, rate("x", Z)], guesses={"z": 1.0}))
    assert simulate(code, stop_time=0.0, start={"z": -1.0}).final(["z"])["z"] == pytest.approx(-2.0)


def test_far_start_is_damped() -> None:
    """atan(z) = 0.5 from 50: undamped Newton diverges."""
    block = torn(BlockKind.NONLINEAR, ["z"], [(e.function("atan", Z), X)])
    code = generate(hand_system({"x": 0.5}, [block, rate("x", Z)], guesses={"z": 50.0}))
    assert initialize(code, 0.0).evaluator.guess == pytest.approx([np.tan(0.5)])


def test_initial_equations_other_than_starts() -> None:
    """Steady state: der(x) = 0 gives x = y/2."""
    dynamics = [explicit(Y, const(3.0)), rate("x", e.sub(e.mul(const(2.0), X), Y))]
    initial = [
        explicit(Y, const(3.0)),
        torn(BlockKind.LINEAR, ["x"], [(e.mul(const(2.0), X), Y)]),
        rate("x", e.sub(e.mul(const(2.0), X), Y)),
    ]
    code = generate(hand_system({"x": 0.0}, dynamics, initial=initial))
    assert initialize(code, 0.0).x == pytest.approx([1.5])


def test_contradicting_start_values_name_equation_and_values() -> None:
    check = Residual(e.sub(X, Y), equation(X, Y))
    code = generate(hand_system({"x": 1.0, "y": 2.0}, [rate("x", Y), rate("y", X)], checks=[check]))
    with pytest.raises(InitializationProblem, match=r"`x = y` \(hand.mo:2\).*x = 1, y = 2") as caught:
        initialize(code, 0.0)
    assert caught.value.codes == ("initialize.inconsistent",)


@pytest.mark.parametrize("size", [1e-8, 1.0, 1e8])
def test_checks_are_relative(size: float) -> None:
    check = Residual(e.sub(X, Y), equation(X, Y))
    code = generate(
        hand_system(
            {"x": size, "y": size * (1 + 1e-9)},
            [rate("x", Y), rate("y", X)],
            checks=[check],
            nominal={"x": size, "y": size},
        )
    )
    initialize(code, 0.0)
    with pytest.raises(InitializationProblem):
        initialize(code, 0.0, start={"y": size * 1.01})


def test_modes_agree_with_the_initial_point() -> None:
    relation = e.relation("gt", Z, const(1.0))
    value = e.if_then_else(relation, const(5.0), const(2.0))
    code = generate(
        hand_system({"x": 1.0}, [explicit(Z, e.add(X, X)), rate("x", value)], relations=[relation])
    )
    assert initialize(code, 0.0).evaluator.m.tolist() == [1.0]


def test_modes_without_fixed_point_name_the_condition() -> None:
    relation = e.relation("gt", Z, const(1.0))
    value = e.if_then_else(relation, const(0.0), const(2.0))
    code = generate(hand_system({"x": 1.0}, [explicit(Z, value), rate("x", Z)], relations=[relation]))
    with pytest.raises(InitializationProblem, match=r"`z > 1.0` \(hand.mo:2\)") as caught:
        initialize(code, 0.0)
    assert caught.value.codes == ("initialize.mode-cycle",)


def test_no_solution_names_block_and_guess() -> None:
    block = torn(BlockKind.NONLINEAR, ["z"], [(e.add(e.mul(Z, Z), const(1.0)), X)])
    code = generate(hand_system({"x": 0.0}, [block, rate("x", Z)], guesses={"z": 3.0}))
    with pytest.raises(InitializationProblem, match=r"z \* z \+ 1.0 = x.*(\n.*)*began at z = 3"):
        initialize(code, 0.0)


def test_singular_linear_block_names_its_equations() -> None:
    total = e.add(Y, Z)
    block = torn(BlockKind.LINEAR, ["y", "z"], [(total, X), (e.mul(const(2.0), total), TIME)])
    code = generate(hand_system({"x": 1.0}, [block, rate("x", Z)]))
    with pytest.raises(InitializationProblem, match=r"singular.*y, z") as caught:
        initialize(code, 0.0)
    assert set(caught.value.codes) == {"simulate.singular-block"}


def test_not_a_number_at_the_start() -> None:
    code = generate(hand_system({"x": -1.0}, [explicit(Z, e.function("log", X)), rate("x", Z)]))
    with pytest.raises(InitializationProblem, match=r"z is not a number.*log\(x\)"):
        initialize(code, 0.0)


def test_parameter_that_is_infinite() -> None:
    code = generate(hand_system({"x": 1.0}, [rate("x", X)], parameters={"a": 1.0}))
    with pytest.raises(InitializationProblem, match="parameter `a`"):
        initialize(code, 0.0, {"a": float("inf")})


def test_numbers_only() -> None:
    code = generate(hand_system({"x": 1.0}, [rate("x", X)]))
    with pytest.raises(UsageProblem):
        simulate(code, stop_time=float("nan"))


def test_newton_reports_dependent_rows() -> None:
    matrix = np.array([[1.0, 1.0, 0.0], [2.0, 2.0, 0.0], [0.0, 0.0, 1.0]])
    assert null_rows(matrix, np.zeros(3), np.ones(3)) == (0, 1)
    assert null_rows(np.diag([1.0, 1e-12, 1e12]), np.zeros(3), np.ones(3)) is None


def test_newton_solves_rosenbrock_like_systems() -> None:
    def system(z: Vector) -> tuple[Vector, Vector]:
        return (
            np.array([10 * (z[1] - z[0] ** 2), 1 - z[0]]),
            np.array([[-20 * z[0], 10.0], [-1.0, 0.0]]),
        )

    solution = solve(system, np.array([-1.2, 1.0]), np.ones(2))
    assert solution.converged
    assert solution.z == pytest.approx([1.0, 1.0])
