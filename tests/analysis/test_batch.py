"""Many variants at once: the same as one by one, and hardly slower than NumPy's eigenvalues."""

from __future__ import annotations

from time import process_time

import numpy as np
import pytest

import acausal
from acausal.analysis.batch import Variants
from acausal.api import CompiledModel
from acausal.errors import LookupProblem, UsageProblem
from benchmarks.eigenvalues import CHAIN


@pytest.fixture(scope="module", params=[True, False], ids=["held", "free"])
def chain(request: pytest.FixtureRequest) -> CompiledModel:
    return acausal.loads(CHAIN).compile(held=bool(request.param))


def table(count: int) -> dict[str, list[float]]:
    rng = np.random.default_rng(5)
    ranges = {"c": (300, 800), "m": (0.3, 1.5), "d": (0, 0.5), "s0": (0, 0.4)}
    return {name: rng.uniform(low, high, count).tolist() for name, (low, high) in ranges.items()}


def same_as_alone(compiled: CompiledModel, found: Variants, i: int) -> None:
    alone = compiled.linearize(parameters=found.values_of(i))
    np.testing.assert_allclose(found.matrices[i], alone.a, rtol=1e-12, atol=1e-12)
    got, wanted = np.sort_complex(found.eigenvalues[i]), np.sort_complex(alone.eigenvalues)
    np.testing.assert_allclose(got, wanted, atol=1e-9 * np.abs(wanted).max())


def test_as_one_by_one(chain: CompiledModel) -> None:
    found = chain.variants(table(40))
    assert found.eigenvalues.shape == (40, 30)
    for i in (0, 7, 39):
        same_as_alone(chain, found, i)
        assert found.modes(i).modes[0].participation.sum() == pytest.approx(1)


def test_cost_beside_numpy(chain: CompiledModel) -> None:
    values = table(250)
    chain.variants(table(2)).eigenvalues  # noqa: B018  # functions are made once

    def taken(work: object) -> float:
        assert callable(work)
        began = process_time()
        work()
        return process_time() - began

    matrices = chain.variants(values).matrices
    ratio = min(
        taken(lambda: chain.variants(values).eigenvalues) / taken(lambda: np.linalg.eig(matrices))
        for _ in range(2)
    )
    assert ratio < 3


def test_implicit_blocks_and_relations() -> None:
    text = """model Mixed parameter Real a = 2, b = 1; Real x(start = b, fixed = true), y, z;
      equation der(x) = -x*y - (if x > 2 then 10*(x - 2) else 0);
      y + sin(y)/2 = a*x; z^3 + z = y + x; end Mixed;"""
    compiled = acausal.loads(text).compile()
    found = compiled.variants({"a": [1.0, 2.0, 3.0, 2.5], "b": [1.0, 1.5, 2.5, 0.3]})
    for i in range(4):
        same_as_alone(compiled, found, i)


def test_steady_states_and_start_values() -> None:
    text = """model Tank parameter Real q = 1; Real h(start = 1, fixed = true); equation
      der(h) = q - sqrt(h); end Tank;"""
    compiled = acausal.loads(text).compile()
    steady = compiled.variants({"q": [1.0, 2.0, 4.0]}, "steady")
    np.testing.assert_allclose(steady.eigenvalues[:, 0], [-0.5, -0.25, -0.125], rtol=1e-8)
    started = compiled.variants({}, start={"h": [1.0, 4.0]})
    np.testing.assert_allclose(started.eigenvalues[:, 0], [-0.5, -0.25], rtol=1e-12)


def test_what_cannot_be() -> None:
    compiled = acausal.loads(
        "model D Real x(start = 1); parameter Real a = 1; equation der(x) = -a*x; end D;"
    )
    tank = compiled.compile()
    with pytest.raises(UsageProblem, match="2 values of `x`"):
        tank.variants({"a": [1.0, 2.0, 3.0]}, start={"x": [1.0, 2.0]})
    with pytest.raises(LookupProblem, match="no parameter `b`"):
        tank.variants({"b": [1.0]})


def test_discrete_values_at_the_start() -> None:
    text = """model Relay parameter Real T0 = 15, k = 1; Real T(start = T0, fixed = true);
      Boolean on(start = true, fixed = true); discrete Real seen(start = 0, fixed = true);
      equation der(T) = (if on then 30 - T else 0) - k*T^2/100;
      on = not (T > 22 or pre(on) == false and T > 18); when T > 20 then seen = T; end when; end Relay;"""
    compiled = acausal.loads(text).compile()
    found = compiled.variants({"T0": [15.0, 25.0, 19.0], "k": [1.0, 2.0, 3.0]})
    for i in range(3):
        same_as_alone(compiled, found, i)
