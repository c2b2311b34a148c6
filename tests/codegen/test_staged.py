"""Functions that take what was computed before give the same bits as those that compute it themselves."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

import acausal
from acausal.codegen.c_text import run_functions
from acausal.codegen.staged import STAGES, Staged, staged
from acausal.runtime.build import compiler
from acausal.simulate import machine

RAMPS = """
model Ramps "A mass that ramps of the time push, with much that parameters decide"
  parameter Real a = 0.3, b = 2.5, c = 1.7, d = 0.2;
  parameter Real k = a*exp(b)/sqrt(c) + sin(d);
  Real x(start = 0.1, fixed = true), v(start = 0, fixed = true), f, g;
  Boolean on(start = false, fixed = true);
equation
  f = exp(-c*(time - 1)^2)*sin(b*time)^3 + (a + b*exp(-time))*cos(c*time)/(1 + d*time^2);
  g = (a*b + c/d)*x - exp(a - b)*v - k*(a + b)*x^3;
  der(x) = v;
  der(v) = f*(1 + 0.1*x) - g/(a*c + b*d) - (if on then v else 0);
  when {x > 0.3, x < -0.3} then
    on = x > 0.3;
  end when;
end Ramps;
"""


@pytest.fixture(scope="module")
def ramps() -> acausal.CompiledModel:
    return acausal.loads(RAMPS).compile()


def test_the_same_bits_at_any_point(ramps: acausal.CompiledModel) -> None:
    whole = run_functions(ramps.code)
    parts = staged(whole)
    assert parts.held is not None
    rng = np.random.default_rng(1)
    for name in ("ode", "jac", "output"):
        f, small = whole[name], parts.functions[name]
        assert small.name_in() == [*f.name_in(), *STAGES]
        assert small.n_instructions() < 0.8 * f.n_instructions()
        for _ in range(5):
            given = {key: rng.uniform(0.1, 2.0, f.size_in(key)) for key in f.name_in()}
            held = parts.held(given["p"])
            timed = {
                key: stage(given["t"], given["p"], held) if stage is not None else ca.DM(0, 1)
                for key in STAGES[1:]
                for stage in [parts.functions.get(key)]
            }
            mine = small(*given.values(), held, *timed.values())
            theirs = f(*given.values())
            for one, other in zip(_all(mine), _all(theirs), strict=True):
                assert np.array_equal(np.array(one), np.array(other))


def _all(results: ca.DM | tuple[ca.DM, ...]) -> tuple[ca.DM, ...]:
    return results if isinstance(results, tuple) else (results,)


def test_what_gains_nothing_stays() -> None:
    model = acausal.loads("model M Real x(start = 1); equation der(x) = -sin(x)*x^2; end M;").compile()
    whole = run_functions(model.code)
    assert staged(whole) == Staged(dict(whole))


def unstaged(functions: dict[str, ca.Function]) -> Staged:
    """Every function as it was."""
    return Staged(dict(functions))


@pytest.mark.skipif(compiler() is None, reason="no C compiler")
@pytest.mark.parametrize("solver", ["rodas", "heun", "rosenbrock"])
def test_runs_are_the_same(
    ramps: acausal.CompiledModel, solver: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def run(model: acausal.CompiledModel) -> acausal.Result:
        return model.simulate(
            stop_time=5.0, interval=0.01, step=2e-3, max_step=0.02, solver=solver, compiled=False
        )

    mine = run(ramps)
    monkeypatch.setattr(machine, "staged", unstaged)
    theirs = run(acausal.loads(RAMPS).compile())
    assert mine.statistics.events > 1
    assert np.array_equal(mine.data, theirs.data)
