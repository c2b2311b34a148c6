"""`acausal export`."""

from __future__ import annotations

import json
from pathlib import Path

from acausal.cli.exporting import names_in
from tests.cli.calls import Call


def test_export_to_c(call: Call, working_directory: Path) -> None:
    done = call("export", "Tank.mo", "--to", "c", "-o", "out", "--step", "0.01", "--json")
    assert done.status == 0
    summary = json.loads(done.out)
    assert summary["solver"] == "heun"
    assert summary["step"] == 0.01
    sizes = {path: (working_directory / "out" / path).stat().st_size for path in summary["files"]}
    assert sizes == summary["files"]
    assert summary["states"]
    assert "Makefile" in sizes


def test_export_into_a_file_is_refused(call: Call, working_directory: Path) -> None:
    (working_directory / "taken").write_text("", encoding="utf-8")
    done = call("export", "Tank.mo", "-o", "taken")
    assert done.status == 2
    assert "is a file" in done.err


def test_export_to_casadi(call: Call, working_directory: Path) -> None:
    done = call("export", "Tank.mo", "--to", "casadi", "-o", "tank.casadi", "--json")
    assert done.status == 0
    summary = json.loads(done.out)
    assert summary["functions"][:3] == ["ode", "dae", "jac"]
    assert summary["files"] == {"tank.casadi": (working_directory / "tank.casadi").stat().st_size}


def test_names_by_commas() -> None:
    assert names_in(["a, b[1,2],start(c[3,4])", "'d,e'.f"]) == ("a", "b[1,2]", "start(c[3,4])", "'d,e'.f")
