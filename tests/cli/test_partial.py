"""A run that fails leaves what it has in the file that was asked for."""

from __future__ import annotations

from pathlib import Path

from tests.cli.calls import Call

MODEL = """model Fails
  Real x(start = 1, fixed = true);
equation
  der(x) = -sqrt(0.5 - time);
end Fails;
"""


def test_failing_run_writes_its_rows(call: Call, working_directory: Path) -> None:
    (working_directory / "Fails.mo").write_text(MODEL)
    done = call("simulate", "Fails.mo", "-o", "part.csv")
    assert done.status == 1
    assert "simulate.partial" in done.err
    assert "simulate.not-finite" in done.err
    lines = (working_directory / "part.csv").read_text().splitlines()
    assert lines[0] == "time,x"
    assert 0.4 < float(lines[-1].split(",")[0]) <= 0.5
