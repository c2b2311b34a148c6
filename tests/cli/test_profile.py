"""`acausal profile` and the solver options of `acausal simulate`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from acausal.runtime.build import compiler
from tests.cli.calls import Call

pytestmark = pytest.mark.skipif(compiler() is None, reason="no C compiler")

KEYS = ["state", "influence", "error_failures", "convergence_failures"]


def test_profile(call: Call, working_directory: Path) -> None:
    done = call("profile", "Tank.mo", "--plot", "p.svg")
    assert done.status == 0
    assert "influence" in done.out
    assert (working_directory / "p.svg").read_text().startswith("<?xml")
    states = call("profile", "Tank.mo", "--json").problems
    assert [list(state) for state in states] == [KEYS]
    assert (states[0]["state"], states[0]["influence"]) == ("h", 1.0)


def test_profile_refuses_what_cannot_be_drawn(call: Call) -> None:
    assert call("profile", "Tank.mo", "--plot", "p.doc").status != 0


def test_fixed_steps_on_the_command_line(call: Call) -> None:
    data = call("simulate", "Tank.mo", "--solver", "heun", "--step", "0.1", "--events", "step", "--json").data
    assert (data["solver"], data["steps"]) == ("heun", 100)
    assert isinstance(data["max_step_seconds"], float)
    assert call("simulate", "Tank.mo", "--solver", "heun", "--step", "-1", "--json").status != 0
    assert call("simulate", "Tank.mo", "--solver", "hoin", "--json").status != 0


HOPPER = """model Hopper "Every bounce is counted, and every other tick of a clock"
  Real s(start = 1, fixed = true), v(start = 0, fixed = true);
  discrete Integer bounces(start = 0, fixed = true), ticks(start = 0, fixed = true);
equation
  der(s) = v; der(v) = -9.81;
  when s < 0 then reinit(v, -v); bounces = pre(bounces) + 1; end when;
  when sample(0.1, 0.25) then ticks = pre(ticks) + 1; end when;
  annotation(experiment(StopTime = 2));
end Hopper;"""


def test_events_by_line(call: Call, working_directory: Path) -> None:
    """Bounces at 0.45, 1.35 (the line of the condition and of what it sets), ticks at 0.1, 0.35 ... 1.85."""
    (working_directory / "Hopper.mo").write_text(HOPPER)
    for solver in ("rodas", "cvode", "dopri5"):
        data: dict[str, Any] = call(
            "simulate", "Hopper.mo", "--solver", solver, "--step", "0.01", "--json"
        ).data
        found = {one["source"]: (one["line"], one["events"]) for one in data["event_sources"]}
        assert found["bounces"] == (6, 2), solver
        assert found["ticks"] == (7, 8), solver
        assert found["s < 0"][0] == 6, solver
        assert found["s < 0"][1] >= 2, solver
        assert set(data["phase_seconds"]) == {"start", "compile_c", "select_states", "run", "store"}
        assert data["phase_seconds"]["run"] == data["cpu_seconds"]
    out = call("profile", "Hopper.mo").out
    assert "Hopper.mo:7" in out
    assert "CPU time by phase: start" in out
