"""When a run waits for the C compiler, and that compiled C and the virtual machine settle events alike."""

from __future__ import annotations

import numpy as np
import pytest

import acausal
from acausal.runtime import build
from acausal.simulate import machine
from acausal.simulate.machine import machine_of
from acausal.simulate.simulate import simulate

pytestmark = pytest.mark.skipif(build.compiler() is None, reason="no C compiler")

MODEL = """
model Relay "A lag that a relay with hysteresis holds; the smaller and the larger of two numbers"
  Real x(start = 0, fixed = true);
  Boolean on(start = true, fixed = true);
  Integer n(start = 0, fixed = true);
  Real y = min(x, 0.5) + max(x, 0.5);
equation
  on = x < 0.4 or pre(on) and x < 0.6;
  der(x) = (if on then 1 else 0) - x;
  when change(on) then
    n = pre(n) + 1;
  end when;
end Relay;
"""


def test_compiling_pays_from_a_number_of_steps_on(monkeypatch: pytest.MonkeyPatch) -> None:
    found = machine_of(acausal.loads(MODEL).compile().code)
    monkeypatch.delenv("ACAUSAL_COMPILE")
    assert not found.pays(0.0, 10)
    assert not found.pays(100.0, 10)
    assert found.pays(1e9, 10)
    monkeypatch.setattr(machine, "HOPELESS", 10)
    assert not found.pays(1e9, 10)
    monkeypatch.setenv("ACAUSAL_COMPILE", "never")
    assert not found.pays(1e9, 10)


def test_a_run_waits_where_it_pays(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("ACAUSAL_COMPILE")
    monkeypatch.setattr(machine, "_PER_LINE", 0.0)
    code = acausal.loads(MODEL).compile().code
    simulate(code, stop_time=0.01, max_step=1e-3)
    assert machine_of(code).library is not None


def test_compiled_events_are_those_of_the_virtual_machine() -> None:
    code = acausal.loads(MODEL).compile().code
    virtual = simulate(code, stop_time=5.0, compiled=False)
    native = simulate(code, stop_time=5.0, compiled=True)
    assert virtual.final(["n"])["n"] == native.final(["n"])["n"] > 4
    assert np.array_equal(virtual.time, native.time)
    assert np.array_equal(virtual.data, native.data)


LOOPS = """
model Loops "a function whose loop depends on values at run time is evaluated in Python, at events"
  function up
    input Real u;
    output Integer y;
  algorithm
    y := 0;
    while y*y < u loop
      y := y + 1;
    end while;
  end up;
  Real x(start = 0, fixed = true);
  Integer n(start = 0, fixed = true);
equation
  der(x) = n - x;
  when time > pre(n) then
    n = up(10*time + 1);
  end when;
end Loops;
"""


def test_what_is_evaluated_in_python_is_left_to_it() -> None:
    found = machine_of(acausal.loads(LOOPS).compile().code)
    assert "update.c" not in found.sources.files
    found.compile()
    assert found.library is not None
