"""Exported programs settle events as runs inside Python do, to the last bit."""

from __future__ import annotations

from pathlib import Path

import pytest

from acausal.errors import SimulationProblem
from acausal.export.c_export import export_c
from tests.export.packages import compiled, differences, exported, needs_compiler
from tests.simulate.test_converters import LEG, LIBRARY
from tests.simulate.test_events_in_c import SLIDER
from tests.simulate.test_jumps import OSCILLATOR
from tests.simulate.test_simultaneous_events import SAMPLED, TOGETHER

SWITCHES = f"{LIBRARY}{LEG}end P; model Leg extends P.Leg; end Leg;"
BALL = """
model Ball "Comes to rest"
  Real h(start = 1, fixed = true), v(start = 0, fixed = true);
equation
  der(h) = v;
  der(v) = -9.81;
  when h <= 0 then
    reinit(v, -0.6*pre(v));
  end when;
end Ball;
"""
FALLS = """
model Falls "An integer that falls with its argument"
  Integer down;
  Real x(start = 0, fixed = true);
equation
  down = integer(-37*x);
  der(x) = 1;
end Falls;
"""
CASES = {
    "a crossing at a sample": (SAMPLED, "heun", 0.01, 9.7),
    "two crossings at once": (TOGETHER, "heun", 0.01, 20.25),
    "ideal switches": (SWITCHES, "heun", 1e-4, 0.04),
    "dry friction in a stiff loop": (SLIDER, "rosenbrock", 2e-3, 5.0),
    "steps from row to row": (FALLS, "heun", 0.02, 4.0),
}


@needs_compiler
@pytest.mark.parametrize("case", CASES)
def test_events_come_out_as_in_python(case: str, tmp_path: Path) -> None:
    text, solver, step, stop = CASES[case]
    model = compiled(text)
    package = exported(model, tmp_path, solver=solver, step=step)
    assert differences(model, package, solver, step, stop=stop, interval=stop / 200) == 0.0


@needs_compiler
def test_branches_are_kept_to_their_end_and_a_jump_is_told(tmp_path: Path) -> None:
    model = compiled(OSCILLATOR)
    flags = ("-O0", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
    package = exported(model, tmp_path, *flags, solver="heun", step=1e-3)
    assert differences(model, package, "heun", 1e-3, stop=2.5, interval=0.01) < 1e-9
    said = package.run("--stop", "2.5").stderr
    assert said.count("warning: ") == 1
    assert "another one was taken: z from 1.0" in said


@needs_compiler
def test_accumulation_is_told_before_it_is_passed(tmp_path: Path) -> None:
    model = compiled(BALL)
    package = exported(model, tmp_path, solver="rk3", step=0.01)
    said = package.run("--stop", "5", code=1).stderr
    with pytest.raises(SimulationProblem) as caught:
        model.simulate(stop_time=5.0, solver="rk3", step=0.01)
    assert caught.value.codes == ("simulate.zeno",)
    for text in ("events accumulate at time 1.80609455", "s apart"):
        assert text in said
        assert text in str(caught.value)


def test_files_that_only_python_needs_stay_there() -> None:
    files = export_c(compiled(BALL).code, step=0.01).files
    assert "runtime/fixed.c" in files
    assert not [
        path for path in files if path.split("/")[-1].split(".")[0] in ("event", "iterate", "judge", "cruise")
    ]
