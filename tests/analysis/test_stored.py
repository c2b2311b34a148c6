"""Instants of a stored result: the modes and discrete values of the run come back."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import acausal
from acausal.analysis.linearize import At
from acausal.analysis.stored import stored_snapshots
from acausal.api import CompiledModel
from acausal.errors import LookupProblem, UsageProblem
from acausal.simulate.result import Result

RELAY = """model Relay "Heating with a hysteresis, its loss by radiation"
  parameter Real k = 1e-3; Real T(start = 15, fixed = true), walls(start = 10, fixed = true);
  discrete Boolean on(start = true, fixed = true);
equation
  der(T) = (if on then 30 - T else 0) - k*T^2 - 0.3*(T - walls); der(walls) = 0.05*(T - walls);
  when {T > 22, T < 18} then on = T < 18; end when;
  annotation(experiment(StopTime = 3, Interval = 0.02));
end Relay;"""

Columns = dict[str, NDArray[np.float64]]


@pytest.fixture(scope="module")
def relay() -> CompiledModel:
    return acausal.loads(RELAY).compile()


@pytest.fixture(scope="module")
def result(relay: CompiledModel) -> Result:
    return relay.simulate()


def columns(result: Result, *names: str) -> Columns:
    return {"time": result.time, **{name: result.values(name) for name in names}}


@pytest.mark.parametrize("names", [("T", "walls"), ("T", "walls", "on")], ids=["states", "all"])
def test_as_in_the_run(relay: CompiledModel, result: Result, names: tuple[str, ...]) -> None:
    instants = [0.4, 1.0, 2.0, 2.6]
    stored = stored_snapshots(relay.code, columns(result, *names), instants)
    heated = [bool(s.point.d[0]) for s in stored]
    assert heated == [bool(result.values("on")[np.searchsorted(result.time, t)]) for t in instants]
    assert set(heated) == {True, False}
    for snapshot, alone in zip(stored, relay.snapshots(instants), strict=True):
        np.testing.assert_allclose(snapshot.a, alone.a, rtol=1e-4)
        assert not snapshot.notes


def test_a_result_in_memory(relay: CompiledModel, result: Result) -> None:
    (snapshot,) = relay.snapshots([2.0], result=result)
    np.testing.assert_allclose(snapshot.a, relay.linearize(2.0).a, rtol=1e-4)


def test_between_rows(relay: CompiledModel, result: Result) -> None:
    (between,) = stored_snapshots(relay.code, columns(result, "T", "walls"), [1.0077])
    alone = relay.linearize(1.0077)
    np.testing.assert_allclose(between.values, alone.values, rtol=1e-5)
    assert not between.notes


def test_rows_that_are_far_apart_are_told(relay: CompiledModel, result: Result) -> None:
    sparse = {name: values[::40] for name, values in columns(result, "T", "walls", "on").items()}
    (between,) = stored_snapshots(relay.code, sparse, [float(sparse["time"][1:3].mean())])
    assert "interpolated between the rows" in between.notes[0]


def test_another_model_s_result_is_told(relay: CompiledModel, result: Result) -> None:
    table = columns(result, "T", "walls", "on", "der(T)")
    table["der(T)"] = table["der(T)"] + 3
    (snapshot,) = stored_snapshots(relay.code, table, [1.0])
    assert "does not agree with the model: der(T)" in snapshot.warnings[-1]


def test_what_a_table_does_not_hold(relay: CompiledModel, result: Result) -> None:
    with pytest.raises(LookupProblem, match="states `walls`"):
        stored_snapshots(relay.code, columns(result, "T"), [1.0])
    outside: tuple[At, ...] = (7.0, "steady")
    for at in outside:
        with pytest.raises(UsageProblem, match="no instant"):
            stored_snapshots(relay.code, columns(result, "T", "walls"), [at])
