"""A run that fails or is interrupted hands over what it has."""

from __future__ import annotations

import numpy as np
import pytest

import acausal
from acausal.errors import SimulationProblem
from acausal.runtime.build import compiler

ROOT = "model M Real x(start = 1, fixed = true), z; equation z = sqrt(0.5 - time); der(x) = -z; end M;"


@pytest.mark.parametrize("solver", ["auto", "cvode", "heun"])
def test_failing_run_keeps_its_rows(solver: str) -> None:
    compiled = acausal.loads(ROOT).compile()
    kept: list[acausal.Result] = []
    with pytest.raises(SimulationProblem):
        compiled.simulate(interval=0.01, solver=solver, step=0.01, keep=kept.append)
    whole = compiled.simulate(stop_time=0.49, interval=0.01, solver=solver, step=0.01)
    assert len(kept) == 1
    assert 0.45 < kept[0].time[-1] <= 0.5
    count = len(kept[0].time)
    assert kept[0].values("x")[: min(count, 45)] == pytest.approx(
        whole.values("x")[: min(count, 45)], abs=1e-6
    )
    assert np.isfinite(kept[0].data).all()


@pytest.mark.parametrize("solver", ["rodas", "heun"])
def test_interrupted_run_keeps_its_rows(solver: str) -> None:
    """Ctrl-C while a function of the user's runs, called from C."""
    if compiler() is None:
        pytest.skip("no C compiler")
    model = "model M input Real u; Real x(start = 0, fixed = true); equation der(x) = u; end M;"
    compiled = acausal.loads(model).compile()
    kept: list[acausal.Result] = []

    def interrupt(time: float) -> float:
        if time > 0.5:
            raise KeyboardInterrupt
        return 1.0

    with pytest.raises(KeyboardInterrupt):
        compiled.simulate(inputs={"u": interrupt}, solver=solver, step=0.01, max_step=0.01, keep=kept.append)
    assert len(kept) == 1
    assert kept[0].time.size > 0
