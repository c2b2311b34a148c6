"""Eigenvalues, clusters and participation against closed forms."""

from __future__ import annotations

from math import inf, pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from acausal.analysis.modes import Modes, modes

Matrix = NDArray[np.float64]


def chain(n: int, c: float, m: float, free: bool = False) -> Matrix:
    """n equal masses and springs; one end held, or none."""
    stiffness = 2 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1)
    stiffness[-1, -1] = 1
    if free:
        stiffness[0, 0] = 1
    zero, one = np.zeros((n, n)), np.eye(n)
    return np.block([[zero, one], [-stiffness * c / m, zero]])


def test_spring_mass_chain() -> None:
    n, c, m = 15, 3e4, 0.02
    found = modes(chain(n, c, m)).eigenvalues
    exact = 2 * np.sqrt(c / m) * np.sin((2 * np.arange(1, n + 1) - 1) * pi / (2 * (2 * n + 1)))
    np.testing.assert_allclose(found.imag[::2], exact, rtol=1e-10)
    np.testing.assert_allclose(found.imag[1::2], -exact, rtol=1e-10)
    np.testing.assert_allclose(found.real, 0, atol=1e-9 * exact.max())


def test_free_body_is_one_defective_mode() -> None:
    found = modes(chain(4, 1e6, 0.1, free=True))
    body = found.modes[0]
    assert (body.multiplicity, body.is_defective) == (2, True)
    assert abs(body.eigenvalue) < 1e-9
    assert found.condition == inf
    np.testing.assert_allclose(body.participation, 1 / 8, atol=1e-9)  # all positions and speeds alike
    np.testing.assert_allclose(np.abs(body.shape[:4, 0]), 0.5, atol=1e-6)  # all positions alike
    np.testing.assert_allclose(body.shape[4:, 0], 0, atol=1e-6)
    assert sum(mode.multiplicity for mode in found.modes) == 8


def test_equal_eigenvalues_with_all_their_vectors_are_not_defective() -> None:
    found = modes(np.diag([-2.0, -2.0, -2.0, -5.0]))
    assert [(m.multiplicity, m.is_defective, m.shape.shape[1]) for m in found.modes] == [
        (3, False, 3),
        (1, False, 1),
    ]
    assert found.condition == pytest.approx(1)
    np.testing.assert_allclose(found.modes[0].participation, [1 / 3, 1 / 3, 1 / 3, 0], atol=1e-12)


def test_jordan_block_of_three() -> None:
    a = -4 * np.eye(3) + np.eye(3, k=1)
    (mode,) = modes(a).modes
    assert (mode.multiplicity, mode.shape.shape[1]) == (3, 1)
    assert mode.eigenvalue == pytest.approx(-4, rel=1e-12)


def test_oscillator_figures() -> None:
    omega, ratio = 2 * pi * 5, 0.2
    found = modes(np.array([[0, 1], [-(omega**2), -2 * ratio * omega]]))
    up, down = found.modes
    assert up.frequency_hz == pytest.approx(5, rel=1e-12)
    assert up.damping_ratio == pytest.approx(ratio, rel=1e-12)
    assert up.time_constant == pytest.approx(1 / (ratio * omega), rel=1e-12)
    assert up.eigenvalue.imag > 0
    assert down.eigenvalue == pytest.approx(up.eigenvalue.conjugate())


def test_units_of_the_states_do_not_matter() -> None:
    rng = np.random.default_rng(3)
    a = rng.normal(size=(6, 6))
    scale = np.array([1e-9, 1e6, 1, 1e-3, 1e4, 1e8])
    plain, scaled = modes(a), modes(a * scale[:, None] / scale, scale)
    np.testing.assert_allclose(plain.eigenvalues, scaled.eigenvalues, rtol=1e-9)
    for one, other in zip(plain.modes, scaled.modes, strict=True):
        np.testing.assert_allclose(one.participation, other.participation, atol=1e-9)


@settings(deadline=None, max_examples=40)
@given(st.integers(1, 9), st.integers(0, 2**32 - 1))
def test_laws_of_random_matrices(n: int, seed: int) -> None:
    a = np.random.default_rng(seed).normal(size=(n, n))
    found: Modes = modes(a)
    assert len(found.eigenvalues) == n
    np.testing.assert_allclose(found.eigenvalues.sum(), np.trace(a), atol=1e-9)
    for mode in found.modes:
        assert mode.participation.sum() == pytest.approx(1)
        if mode.multiplicity == 1:
            np.testing.assert_allclose(a @ mode.shape, mode.eigenvalue * mode.shape, atol=1e-8)


def test_a_matrix_that_is_not_finite_is_refused() -> None:
    with pytest.raises(ValueError, match="finite"):
        modes(np.array([[np.nan]]))


def test_no_states() -> None:
    assert modes(np.zeros((0, 0))).modes == ()


def test_slow_modes_of_a_stiff_system_stay_apart() -> None:
    slow = [-1e-4, -2e-4, -1.0, -2.0]
    found = modes(np.diag([*slow, -1e9]))
    np.testing.assert_allclose(np.sort(found.eigenvalues.real)[::-1][:4], slow, rtol=1e-12)
    assert [mode.kind for mode in found.modes] == ["decays"] * 5


def test_an_angle_against_little_drag_is_no_rigid_body() -> None:
    stiff = chain(2, 1e8, 0.1, free=True)
    stiff[2, 2] = stiff[3, 3] = -1e-3
    free, drag = modes(stiff).modes[:2]
    assert (free.eigenvalue, free.kind) == (0, "free")
    assert (drag.eigenvalue, drag.kind) == (pytest.approx(-1e-3, rel=1e-7), "decays")


@pytest.mark.parametrize("order", [2, 3, 4])
@pytest.mark.parametrize("value", [0.0, -3.0])
def test_jordan_blocks_in_general_position(order: int, value: float) -> None:
    others = [-10.0, -20.0, -50.0]
    jordan = np.diag([value] * order + others) + np.diag([1.0] * (order - 1) + [0.0] * 3, k=1)
    basis = np.random.default_rng(order).normal(size=jordan.shape)
    found = modes(basis @ jordan @ np.linalg.inv(basis))
    block = next(mode for mode in found.modes if mode.multiplicity > 1)
    assert (block.multiplicity, block.is_defective) == (order, True)
    assert block.eigenvalue == pytest.approx(value, abs=1e-7 * 50)
    assert block.participation.sum() == pytest.approx(1)
    np.testing.assert_allclose(
        sorted(m.eigenvalue.real for m in found.modes if m is not block), sorted(others), rtol=1e-6
    )


def test_kinds() -> None:
    swing = np.array([[0.0, 1.0], [-4.0, 0.2]])
    assert [m.kind for m in modes(swing).modes] == ["grows oscillating"] * 2
    assert [m.kind for m in modes(np.diag([0.0, 3.0])).modes] == ["free", "grows"]
    assert modes(np.array([[0.0, 1.0], [0.0, 0.0]])).modes[0].kind == "rigid body"


def test_leading_states_are_those_that_take_part() -> None:
    found = modes(np.array([[-1.0, 1e-3], [0.0, -2.0]]))
    assert found.modes[0].leading(("x", "y")) == ("x",)


def test_bodies_in_play_beside_a_shaft_that_turns() -> None:
    """Angles first: a driven pair with drag, and two free bodies that touch nothing."""
    a = np.zeros((8, 8))
    a[:4, 4:] = np.eye(4)
    a[4, :2], a[5, :2] = [-1e7, 2e7], [5e6, -1e7]  # a pair that turns at a ratio of 2
    a[4, 4] = -0.3
    rotated = np.eye(8)
    rotated[:4, :4] = np.linalg.qr(np.random.default_rng(1).normal(size=(4, 4)))[0]
    for matrix in (a, rotated @ a @ rotated.T):
        found = modes(matrix)
        zero = found.modes[0]
        assert (zero.eigenvalue, zero.multiplicity, zero.shape.shape[1]) == (0, 5, 3)
        assert found.modes[1].eigenvalue == pytest.approx(-0.15, rel=1e-6)


@pytest.mark.parametrize("fast", [0.0, -1e6])
def test_lags_in_a_row_are_one_mode_for_each_speed(fast: float) -> None:
    lags = np.diag([-1.0] * 3 + [-5.0] * 3 + [fast]) + np.diag([1.0, 1, 0, 5, 5, 0], k=-1)
    for basis in (np.eye(7), np.linalg.qr(np.random.default_rng(2).normal(size=(7, 7)))[0]):
        found = modes(basis @ lags @ basis.T)
        several = [(round(m.eigenvalue.real, 6), m.multiplicity, m.is_defective) for m in found.modes]
        assert sorted(several) == sorted([(-5.0, 3, True), (-1.0, 3, True), (fast, 1, False)])
