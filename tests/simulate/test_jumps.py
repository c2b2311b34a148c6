"""Blocks of one unknown whose branch of solutions ends: followed to its end, and the jump is told once."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

import acausal
from acausal.errors import SimulationProblem
from acausal.simulate.walks import Walks

OSCILLATOR = """model R "Relaxation: x follows z, which jumps where its curve turns"
  Real x(start = -0.3, fixed = true), z(start = 1.5);
equation
  der(x) = z;
  z - z ^ 3 / 3 - x = 0;
end R;"""


def _exact(time: float) -> float:
    """z of the oscillator: dt = (1 - z^2) / z dz on a branch, and jumps from 1 to -2 and back."""

    def spent(z: float) -> float:
        return 0.5 * z * z - np.log(abs(z))

    first = brentq(lambda z: z - z**3 / 3 + 0.3, 1.0, 3.0)
    half = 1.5 - np.log(2.0)
    count, rest = divmod(time - (spent(first) - spent(1.0)), half)
    size = brentq(lambda z: spent(2.0) - spent(z) - rest, 1.0, 2.0)
    return float(size if count % 2 else -size)


@pytest.fixture(scope="module")
def oscillator() -> acausal.CompiledModel:
    return acausal.loads(OSCILLATOR).compile()


@pytest.mark.parametrize(
    ("solver", "error"), [("rodas", 1e-5), ("cvode", 1e-3), ("cvode-adams", 1e-3), ("heun", 0.01)]
)
def test_jumps_come_where_the_branch_ends(
    oscillator: acausal.CompiledModel, solver: str, error: float
) -> None:
    run = oscillator.simulate(stop_time=5.0, solver=solver, step=1e-3, interval=0.01, compiled=False)
    assert run.values("z")[-1] == pytest.approx(_exact(5.0), abs=error)
    told = [w for w in run.warnings if w.code == "simulate.jump"]
    assert len(told) == 1
    assert "another one was taken: z from 1" in told[0].message
    assert "0.61" in told[0].message
    assert told[0].names == ("z",)
    assert told[0].span is not None


def test_ida_names_the_block_whose_solution_ends(oscillator: acausal.CompiledModel) -> None:
    with pytest.raises(SimulationProblem, match="the block of z is close to singular there") as caught:
        oscillator.simulate(stop_time=5.0, solver="ida", compiled=False)
    assert caught.value.diagnostics[0].span is not None


@pytest.mark.parametrize("solver", ["rodas", "cvode", "rk3"])
def test_rows_inside_a_long_step_stay_on_their_branch(solver: str) -> None:
    """The state is a line, so that one step reaches over the fold."""
    text = """model S Real x(start = -1, fixed = true), z(start = -1.5);
      equation der(x) = 1; z ^ 3 / 3 - z = x; end S;"""
    run = acausal.loads(text).compile().simulate(stop_time=3.0, solver=solver, interval=0.01, compiled=False)
    x, z = run.values("x"), run.values("z")
    assert z[x < 0.66].max() < -0.99
    assert z[x > 0.68].min() > 1.99
    assert [w.code for w in run.warnings] == ["simulate.jump"]


def test_a_steep_characteristic_is_no_jump() -> None:
    text = """model C Real x(start = -1, fixed = true), z(start = -1);
      equation der(x) = 1; z + 20 * tanh(30 * z) = 60 * x; end C;"""
    for solver in ("rodas", "heun"):
        run = acausal.loads(text).compile().simulate(stop_time=2.0, solver=solver, compiled=False)
        assert run.warnings == ()


def test_switches_of_the_model_are_no_jumps() -> None:
    text = """model E Real x(start = 0, fixed = true), z(start = 1); equation der(x) = 1;
      z ^ 3 + z = (if x > 0.5 then 10 else 1); end E;"""
    for solver in ("rodas", "cvode"):
        assert acausal.loads(text).compile().simulate(solver=solver, compiled=False).warnings == ()


def test_a_run_that_creeps_along_a_fold_is_stopped() -> None:
    """So many walks within so little time lead nowhere; jumps far from each other do no harm."""
    walks = Walks(span=10.0)
    assert all(walks.begin(1.0 + 0.01 * i) for i in range(1000))
    assert not all(walks.begin(5.0 + 1e-9 * i) for i in range(1000))
    assert walks.is_stuck
    text = """model T Real x(start = 1, fixed = true), z(start = 1), w(start = 1); equation
      z * z + w * w = 1.5 - time; z - w = 0.1 * x; der(x) = -z; end T;"""
    compiled = acausal.loads(text).compile()
    for solver in ("rodas", "cvode", "ida", "heun"):
        with pytest.raises(SimulationProblem) as caught:
            compiled.simulate(stop_time=3.0, solver=solver, compiled=False)
        found = caught.value.diagnostics[0]
        assert {"z", "w"} <= set(found.names)
        assert "at time 1." in found.message
        assert found.span is not None
