"""Kernels: evaluation, derivatives, identity; and derivatives that an author gives."""

from __future__ import annotations

import pickle
from math import cos, sin

import pytest

from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.diff import NotDifferentiable, partial, time_derivative
from acausal.symbolic.expressions.evaluate import EvaluationFailed, evaluate
from acausal.symbolic.expressions.kernel import Named
from acausal.symbolic.expressions.kernels.patches import patches
from acausal.symbolic.expressions.kernels.piecewise import Piecewise, lookup, piecewise
from acausal.symbolic.expressions.text import to_text

X, Y = ex.sym("x"), ex.sym("y")
HAT = piecewise("hat", [0.0, 1.0, 2.0], [0.0, 0.0, 1.0, 2.0], [[0], [0, 1], [1, -1], [0]], 0)
SQUARE = piecewise("square", [0.0], [0.0, 0.0], [[0, 0, -1], [0, 0, 1]], 1)


def at(root: ex.Expr, **values: float) -> object:
    return evaluate(root, values.get)


@pytest.mark.parametrize(("x", "value"), [(-1, 0), (0, 0), (0.25, 0.25), (1, 1), (1.5, 0.5), (2, 0), (9, 0)])
def test_value_of_the_piece_in_force(x: float, value: float) -> None:
    assert at(ex.call(HAT, X, X), x=x) == value


def test_the_selector_chooses_the_piece() -> None:
    assert at(ex.call(HAT, X, Y), x=0.5, y=3) == 3
    assert at(ex.call(HAT, X, Y), x=1.5, y=3) == -1


def test_period_and_drift() -> None:
    saw = piecewise("saw", [], [0.0], [[0, 1]], -1, (0.0, 2.0), 10.0)
    assert [saw.evaluate(x, x) for x in (0.5, 2.5, -0.5)] == [0.5, 10.5, -8.5]


def test_equal_contents_are_one_node() -> None:
    again = piecewise("hat", HAT.breaks, HAT.origins, HAT.coefficients, 0)
    assert ex.call(HAT, X, X) is ex.call(again, X, X)
    assert ex.call(HAT, X, X) is not ex.call(SQUARE, X, X)


def test_survives_pickling() -> None:
    node = ex.add(ex.call(HAT, X, X), Y)
    assert pickle.loads(pickle.dumps(node)) is node


def test_prints_by_name() -> None:
    assert to_text(ex.call(HAT, X, Y)) == "hat(x, y)"


def test_partial_derivatives() -> None:
    root = ex.call(SQUARE, X, ex.mul(ex.const(3.0), X))
    assert at(partial(root, X), x=2.0) == 2 * 3 * 2.0 * 3
    assert partial(ex.call(HAT, X, Y), X) is ex.ZERO


def test_substitution_keeps_the_kernel() -> None:
    root = ex.substitute(ex.call(HAT, X, X), {X: Y})
    assert root is ex.call(HAT, Y, Y)


def test_time_derivative_follows_continuity() -> None:
    slope = time_derivative(ex.call(SQUARE, X, X), ex.der)
    assert at(ex.substitute(slope, {ex.der(X): Y}), x=-2.0, y=1.0) == 4.0
    twice = time_derivative(ex.call(SQUARE.partial(1) or HAT, X, X), ex.der)
    with pytest.raises(NotDifferentiable, match="jumps"):
        time_derivative(twice, ex.der)
    with pytest.raises(NotDifferentiable, match="jumps"):
        time_derivative(ex.call(lookup("array", [1, 2]), X, X), ex.der)


def test_derivative_of_a_constant_piece_is_no_kernel() -> None:
    assert lookup("array", [1, 2]).partial(1) is None


def test_lookup_counts_from_one_and_holds_its_ends() -> None:
    array = lookup("array", [5, 7, 9], "Integer")
    assert [array.evaluate(i, i) for i in (0, 1, 2, 3, 4)] == [5, 5, 7, 9, 9]
    assert isinstance(array.evaluate(2, 2), int)


def test_a_text_argument_is_refused() -> None:
    with pytest.raises(EvaluationFailed):
        evaluate(ex.call(HAT, ex.const("a"), X), {"x": 1.0}.get)


# ------------------------------------------------------------------------------ two arguments

PLANE = [0.0, 2.0, 10.0, 0.5]  # 2 v + 10 u + 0.5 u v
CORNER = patches("corner", ([1.0], [1.0]), ([0, 1], [0, 1]), (2, 2), [PLANE, [1] * 4, [2] * 4, [3] * 4], -1)


def test_patches() -> None:
    assert CORNER.evaluate(0.5, 0.25) == 2 * 0.25 + 10 * 0.5 + 0.5 * 0.5 * 0.25
    assert [CORNER.evaluate(u, v) for u, v in ((0, 1), (1, 0), (1, 1))] == [1, 2, 3]


def test_patch_derivatives() -> None:
    root = ex.call(patches("plane", ([], []), ([0], [0]), (2, 2), [PLANE], 9), X, Y)
    assert at(partial(root, X), x=3.0, y=4.0) == 10 + 0.5 * 4
    assert at(partial(root, Y), x=3.0, y=4.0) == 2 + 0.5 * 3
    assert at(partial(partial(root, X), Y), x=3.0, y=4.0) == 0.5
    assert partial(partial(root, X), X) is ex.ZERO


def test_periodic_patches() -> None:
    plane = patches("plane", ([], []), ([0], [0]), (2, 2), [PLANE], 0, ((0.0, 1.0), None))
    assert plane.evaluate(2.25, 3.0) == plane.evaluate(0.25, 3.0)


# ------------------------------------------------------------------------------ given derivatives


def test_the_given_derivative_is_taken() -> None:
    position = ex.derived(X, Y)
    assert time_derivative(position, ex.der) is Y
    assert partial(position, X) is ex.ONE
    assert ex.unknown_leaves(position) == (X,)
    assert to_text(position) == "x"
    assert ex.without_derivatives([position])[position] is X


def test_rates_are_found_when_they_are_due() -> None:
    """f(u) = sin(u) with f' = cos(u) u' and f'' = -sin(u) u'^2 + cos(u) u'', each given."""
    u = ex.mul(X, X)
    once = ex.rate(u)
    second = ex.add(
        ex.neg(ex.mul(ex.function("sin", u), once, once)), ex.mul(ex.function("cos", u), ex.rate(once))
    )
    first = ex.derived(ex.mul(ex.function("cos", u), once), second)
    node = ex.derived(ex.function("sin", u), first)

    def slope(leaf: ex.Expr) -> ex.Expr:
        return ex.const(2.0) if leaf is X else ex.ZERO

    derivative = time_derivative(node, slope)
    assert at(derivative, x=3.0) == pytest.approx(cos(9) * 12)
    assert at(time_derivative(derivative, slope), x=3.0) == pytest.approx(-sin(9) * 144 + cos(9) * 8)


def test_an_input_has_no_rate() -> None:
    with pytest.raises(NotDifferentiable, match="input"):
        time_derivative(ex.derived(X, ex.rate(X)), lambda leaf: None)


def test_partial_kernels_are_shared() -> None:
    assert isinstance(HAT.partial(1), Piecewise)
    assert HAT.partial(1) is HAT.partial(1)


def test_a_function_of_which_only_the_name_is_known_has_no_derivative() -> None:
    call = ex.call(Named("tabulated", 1), ex.sym("x"))
    with pytest.raises(NotDifferentiable, match="`tabulated` has no known derivative"):
        partial(call, ex.sym("x"))
    assert partial(ex.call(Named("tabulated", 1), ex.sym("y")), ex.sym("x")) is ex.ZERO
