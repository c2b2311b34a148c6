"""Events in C and in Python: the same bytes, the same messages; Python is asked only for what needs it."""

from __future__ import annotations

import ctypes

import numpy as np
import pytest

import acausal
from acausal.errors import AcausalError
from acausal.runtime import binding, event_binding
from acausal.runtime.build import compiler
from acausal.simulate import native
from acausal.simulate.settle import Settling

pytestmark = pytest.mark.skipif(compiler() is None, reason="no C compiler")

SAW = """
model Saw "Turns round at both ends, counts, and samples on the way"
  Real x(start = 0, fixed = true);
  Boolean up(start = true, fixed = true);
  Integer n(start = 0, fixed = true);
  discrete Real held(start = 0, fixed = true), last(start = 0, fixed = true);
equation
  der(x) = if up then 1 else -2;
  when {x > 1, x < 0} then
    up = not pre(up);
    n = pre(n) + 1;
    last = time;
  end when;
  when sample(0.05, 0.1301) then
    held = x;
  end when;
end Saw;
"""
SLIDER = """
model Slider "Dry friction with a path parameter, driven through a spring that a nonlinear equation stiffens"
  Real s(start = 0, fixed = true), v(start = 0, fixed = true), a, path, f(start = 0);
  Boolean forward(start = false, fixed = true), backward(start = false, fixed = true), stuck(start = false);
  Boolean startForward(start = false, fixed = true), startBackward(start = false, fixed = true);
equation
  der(s) = v;
  der(v) = a;
  f + 0.01*f^3 = 8*sin(3*time) - s;
  f = a + (if stuck then path elseif forward or startForward then 2 else -2);
  0 = if stuck then a else path - a;
  startForward = pre(stuck) and path > 2.5;
  startBackward = pre(stuck) and path < -2.5;
  forward = (pre(forward) or pre(startForward)) and v > 0;
  backward = (pre(backward) or pre(startBackward)) and v < 0;
  stuck = not (forward or backward or startForward or startBackward);
end Slider;
"""
BALL = """
model Ball "Bounces; says so at the third bounce, and ends at the sixth"
  parameter Integer most = 6;
  Real h(start = 1, fixed = true), v(start = 0, fixed = true);
  Integer n(start = 0, fixed = true);
equation
  der(h) = v;
  der(v) = -9.81;
  when h < 0 then
    reinit(v, -0.8*pre(v));
    n = pre(n) + 1;
    assert(n <> 3, "third", AssertionLevel.warning);
  end when;
  when n >= most then
    terminate("enough");
  end when;
end Ball;
"""
MODELS = {"saw": SAW, "slider": SLIDER, "ball": BALL}


def run(
    model: acausal.CompiledModel, in_c: bool, monkeypatch: pytest.MonkeyPatch, **how: float | bool | str
) -> tuple[acausal.Result, int]:
    """A run and how many events Python settled."""
    asked: list[float] = []
    with monkeypatch.context() as patch:
        settle = Settling.settle

        def counted(self: Settling, time: float, *rest: object) -> object:
            asked.append(time)
            return settle(self, time, *rest)  # pyright: ignore[reportArgumentType]

        patch.setattr(Settling, "settle", counted)
        if not in_c:
            patch.setattr(native, "is_possible", lambda code: False)  # pyright: ignore[reportUnknownLambdaType, reportUnknownArgumentType]
        return model.simulate(**how), len(asked)  # pyright: ignore[reportArgumentType]


@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("solver", ["rodas", "heun"])
def test_the_same_bytes(name: str, solver: str, monkeypatch: pytest.MonkeyPatch) -> None:
    model = acausal.loads(MODELS[name]).compile()
    how = {"stop_time": 10.0, "interval": 0.01, "solver": solver, "step": 2e-3, "compiled": False}
    (mine, few), (theirs, many) = (run(model, in_c, monkeypatch, **how) for in_c in (True, False))
    assert mine.time.tobytes() == theirs.time.tobytes()
    assert mine.data.tobytes() == theirs.data.tobytes()
    assert mine.statistics.events == theirs.statistics.events > 4
    assert mine.warnings == theirs.warnings
    assert mine.ended == theirs.ended
    assert few <= 4 < many  # the start and what has to be said


def test_accumulation_is_named_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    model = acausal.loads(BALL).compile()
    said: list[str] = []
    for in_c in (True, False):
        with pytest.raises(AcausalError) as caught:
            run(model, in_c, monkeypatch, stop_time=10.0, parameters={"most": 1000})  # pyright: ignore[reportArgumentType]
        said.append(str(caught.value))
    assert said[0] == said[1]
    assert "accumulate" in said[0]


def test_rows_of_narrow_blocks_are_complete(monkeypatch: pytest.MonkeyPatch) -> None:
    model = acausal.loads(SAW).compile()
    whole = model.simulate(stop_time=10.0, interval=0.01)
    monkeypatch.setattr(native, "_CHUNK", 1)
    parts = model.simulate(stop_time=10.0, interval=0.01)
    assert np.array_equal(whole.time, parts.time)
    assert np.array_equal(whole.data, parts.data)
    assert (np.diff(parts.time) >= 0).all()


def test_structures_and_counts_are_those_of_the_headers() -> None:
    """Python's arrays have `RECENT` places: C would write past them if it counted on more."""
    sizes = (ctypes.c_int * 4)()
    event_binding.EventRunTime(binding.RunTime().library).sizes(ctypes.addressof(sizes))
    mirrored = (event_binding.EventStructure, event_binding.CruiseStructure)
    counts = [event_binding.RECENT, event_binding.SHRINKING]
    assert list(sizes) == [*(ctypes.sizeof(structure) for structure in mirrored), *counts]
