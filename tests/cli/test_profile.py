"""`acausal profile` and the solver options of `acausal simulate`."""

from __future__ import annotations

from pathlib import Path

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
