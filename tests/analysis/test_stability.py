"""Step limits against the textbook's, and confirmed by running each method on both sides of its limit."""

from __future__ import annotations

from math import inf, sqrt

import numpy as np
import pytest

from acausal.simulate.stability import GROWTH, step_limit


@pytest.mark.parametrize(
    ("method", "limit"),
    [("euler", 2.0), ("ab2", 1.0), ("heun", 2.0), ("rk3", 2.5127453266), ("dopri5", 3.3065678)],
)
def test_on_the_negative_axis(method: str, limit: float) -> None:
    assert step_limit(method, [-4 + 0j]) == pytest.approx(limit / 4, rel=1e-7)


@pytest.mark.parametrize(("method", "limit"), [("euler", 0.0), ("ab2", 0.0), ("heun", 0.0), ("rk3", sqrt(3))])
def test_on_the_imaginary_axis(method: str, limit: float) -> None:
    assert step_limit(method, [10j, -10j]) == pytest.approx(limit / 10, rel=1e-6)


def test_the_fastest_stable_mode_counts() -> None:
    assert step_limit("euler", [-1, -100, -10 + 30j, 5, 0]) == pytest.approx(2 * 10 / 1000)
    assert step_limit("euler", [5 + 2j, 0]) == inf


def one_step(method: str, h: float, a: complex, x: complex, before: complex) -> complex:
    if method == "ab2":
        return x + h * (1.5 * a * x - 0.5 * a * before)
    stages = {"euler": 1, "heun": 2, "rk3": 3}[method]
    total = term = 1 + 0j
    for k in range(1, stages + 1):
        term *= h * a / k
        total += term
    return total * x


@pytest.mark.parametrize("method", ["euler", "ab2", "heun", "rk3"])
@pytest.mark.parametrize("eigenvalue", [-3 + 0j, -3 + 4j, -0.5 + 7j])
def test_stable_below_and_unstable_above(method: str, eigenvalue: complex) -> None:
    limit = step_limit(method, [eigenvalue])
    ends: list[float] = []
    for h in (0.99 * limit, 1.05 * limit):
        before, x = 1 + 0j, 1 + 0j
        for _ in range(20_000):
            before, x = x, one_step(method, h, eigenvalue, x, before)
            if abs(x) > 1e20:
                break
        ends.append(abs(x))
    assert ends[0] < 1
    assert ends[1] > 1e3


def test_growth_starts_at_one() -> None:
    for growth in GROWTH.values():
        np.testing.assert_allclose(growth(np.zeros(1, complex)), 1)
