"""Runs that go on where others ended, and results that are written meanwhile."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import acausal
from acausal.errors import UsageProblem
from acausal.results.stored import StoredResult
from acausal.simulate import stream
from acausal.simulate.simulate import simulate
from acausal.simulate.standing import from_text

BALL = """
model Ball "State events, samples, a delay, a solved parameter, a mode that only the past knows"
  Real h(start = 1, fixed = true);
  Real v(start = 0, fixed = true);
  Real w;
  parameter Real p(start = 1, fixed = false);
  discrete Integer n(start = 0, fixed = true);
  discrete Real z(start = 0);
  Boolean high(start = false, fixed = true);
  Real d = delay(h, 0.3);
initial equation
  p^3 = 8;
equation
  der(h) = v;
  der(v) = -9.81;
  w + w^3 = h*p;
  high = h > 0.6 or pre(high) and h > 0.3;
  when h < 0 then
    reinit(v, -0.9*pre(v));
    n = pre(n) + 1;
  end when;
  when sample(0, 0.25) then
    z = pre(z) + h;
  end when;
  annotation(experiment(StopTime = 3, Interval = 0.01));
end Ball;
"""
NAMES = ("h", "v", "w", "n", "z", "high", "d")


@pytest.fixture(scope="module")
def ball() -> acausal.CompiledModel:
    return acausal.loads(BALL).compile()


@pytest.fixture(scope="module")
def whole(ball: acausal.CompiledModel) -> acausal.Result:
    return ball.simulate()


def agree(found: acausal.Result | StoredResult, whole: acausal.Result, since: float = -1.0) -> None:
    """The same rows from an instant on, to the tolerance."""
    first = int(np.searchsorted(whole.time, since, side="right"))
    mine = int(np.searchsorted(found.time, since, side="right"))
    assert found.time[mine:] == pytest.approx(whole.time[first:], abs=1e-5)
    for name in NAMES:
        assert found.values(name)[mine:] == pytest.approx(whole.values(name)[first:], abs=1e-4), name


def test_the_grid_is_that_of_the_first_run(ball: acausal.CompiledModel) -> None:
    first = ball.simulate(stop_time=0.2, interval=0.05)
    assert np.isin([0.25, 0.3, 0.35, 0.4], ball.simulate(after=first, stop_time=0.4).time.round(9)).all()
    assert len(ball.simulate(after=first, stop_time=0.4).time) < 20
    assert len(ball.simulate(after=first, stop_time=0.4, interval=0.01).time) > 20


@pytest.mark.parametrize("solver", ["rodas", "cvode"])
@pytest.mark.parametrize("stop", [0.5, 1.27])
def test_run_goes_on(ball: acausal.CompiledModel, solver: str, stop: float) -> None:
    """At a sample, and in between."""
    full = ball.simulate(solver=solver)
    first = ball.simulate(stop_time=stop, solver=solver)
    agree(ball.simulate(after=first, solver=solver), full, stop)


def test_fixed_steps_go_on_in_the_same_bits(ball: acausal.CompiledModel) -> None:
    full = ball.simulate(solver="heun", step=0.01, events="step")
    first = ball.simulate(stop_time=1.5, solver="heun", step=0.01, events="step")
    rest = ball.simulate(after=first, solver="heun", step=0.01, events="step")
    at = len(full.time) - len(rest.time)
    assert rest.values("h").tolist() == full.values("h")[at:].tolist()


def test_standing_is_text_with_all_digits(ball: acausal.CompiledModel) -> None:
    standing = ball.simulate(stop_time=1.0).standing
    assert standing is not None
    again = from_text(standing.to_text())
    assert again.to_text() == standing.to_text()
    assert again.states == standing.states


@pytest.mark.parametrize("ending", ["csv", "mat", "nc"])
def test_stored_run_goes_on_in_its_file(
    ball: acausal.CompiledModel, whole: acausal.Result, tmp_path: Path, ending: str
) -> None:
    path = tmp_path / f"a.{ending}"
    first = ball.simulate(stop_time=1.275, store=path, variables=NAMES)
    assert first.time.tolist() == [1.275]
    rows = first.standing.rows if first.standing is not None else 0
    assert len(acausal.read_result(path).time) == rows
    store = stream.Store(path, NAMES, rows)
    simulate(ball.code, store=store, after=path)
    found = acausal.read_result(path)
    only = found.time != 1.275  # the end of the first run, which is not on the grid of the other
    agree(replace(found, time=found.time[only], data=found.data[only]), whole)


def test_killed_run_goes_on(
    ball: acausal.CompiledModel, whole: acausal.Result, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What is on the disk at some moment, as a killed run leaves it."""
    monkeypatch.setattr(stream, "_SECONDS", 0.0)
    path, left = tmp_path / "a.mat", tmp_path / "left.mat"

    def copy(time: float) -> None:
        if time > 1.0 and not left.exists():
            shutil.copy(path, left)
            shutil.copy(stream.end_of(path), stream.end_of(left))

    ball.simulate(store=path, variables=NAMES, progress=copy)
    kept = acausal.read_result(left)
    assert 1.0 < kept.time[-1] < 3.0
    agree(ball.simulate(after=left), whole, float(kept.time[-1]))


def test_interrupted_run_goes_on(ball: acausal.CompiledModel, whole: acausal.Result) -> None:
    kept: list[acausal.Result] = []

    def stop(time: float) -> None:
        if time > 1.1:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        ball.simulate(progress=stop, keep=kept.append)
    agree(ball.simulate(after=kept[0]), whole, float(kept[0].time[-1]))


def test_states_chosen_anew_go_on() -> None:
    pendulum = """
    model Pendulum
      Real x(start = 1, fixed = true), y(start = 0), vx, vy(start = 0, fixed = true), f;
    equation
      der(x) = vx; der(y) = vy; der(vx) = -f*x; der(vy) = -f*y - 9.81; x^2 + y^2 = 1;
    end Pendulum;
    """
    compiled = acausal.loads(pendulum).compile()
    full = compiled.simulate(stop_time=4.0, rtol=1e-8)
    assert full.statistics.state_selections > 0
    first = compiled.simulate(stop_time=2.0, rtol=1e-8)
    rest = compiled.simulate(after=first, stop_time=4.0, rtol=1e-8)
    for name in ("x", "y", "vx"):
        assert rest.values(name)[-1] == pytest.approx(full.values(name)[-1], abs=1e-4)


def test_what_cannot_go_on_is_refused(ball: acausal.CompiledModel, tmp_path: Path) -> None:
    other = acausal.loads("model M Real x(start = 1, fixed = true); equation der(x) = -x; end M;").compile()
    ended = acausal.loads('model T equation when time > 0.5 then terminate(""); end when; end T;').compile()
    first = ball.simulate(stop_time=1.0)
    (tmp_path / "a.csv").write_text("time,x\n0,1\n")
    wrong = tmp_path / "b.csv"
    stream.end_of(wrong).write_text('{"form": 1}')
    for call in (
        lambda: other.simulate(after=first),
        lambda: ball.simulate(after=first, stop_time=0.9),
        lambda: ball.simulate(after=first, start={"h": 2.0}),
        lambda: ended.simulate(after=ended.simulate()),
        lambda: other.simulate(after=tmp_path / "a.csv"),
        lambda: other.simulate(after=wrong),
    ):
        with pytest.raises(UsageProblem, match=r"usage\.continue"):
            call()


def test_memory_does_not_grow_with_the_rows(tmp_path: Path) -> None:
    """All rows but the last leave the recorder whenever they are written."""
    decay = acausal.loads("model M Real x(start = 1, fixed = true); equation der(x) = -x; end M;").compile()
    result = decay.simulate(interval=1e-5, store=tmp_path / "a.nc")
    assert len(result.time) == 1
    assert len(acausal.read_result(tmp_path / "a.nc").time) > 100_000
