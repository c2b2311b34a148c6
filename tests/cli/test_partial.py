"""A run that fails leaves what it has in the file that was asked for."""

from __future__ import annotations

import signal
from pathlib import Path

import pytest

import acausal
from acausal.cli.progress import Progress
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


LONG = """model Long
  Real x(start = 1, fixed = true), y(start = 0, fixed = true);
equation
  der(x) = y;
  der(y) = -x;
  annotation(experiment(StopTime = 10, Interval = 0.1));
end Long;
"""


def test_run_goes_on_from_its_file(call: Call, working_directory: Path) -> None:
    (working_directory / "Long.mo").write_text(LONG)
    assert call("simulate", "Long.mo", "-o", "whole.csv").status == 0
    assert call("simulate", "Long.mo", "--stop-time", "4", "-o", "part.mat").status == 0
    copied = call("simulate", "Long.mo", "--continue", "part.mat", "-o", "copy.csv", "--json")
    added = call("simulate", "Long.mo", "--continue", "part.mat", "--json")
    assert (copied.data["result"], added.data["result"]) == ("copy.csv", "part.mat")
    whole = acausal.read_result("whole.csv")
    for name in ("copy.csv", "part.mat"):
        found = acausal.read_result(name)
        assert found.time.tolist() == whole.time.tolist()
        assert found.values("y") == pytest.approx(whole.values("y"), abs=1e-5)
    assert (
        call("simulate", "Long.mo", "--continue", "part.mat", "--json").problems[0]["code"]
        == "usage.continue"
    )
    assert call("simulate", "Long.mo", "--continue", "copy.csv", "-v", "y").status == 2


def test_interrupt_leaves_a_file_to_go_on_from(
    call: Call, working_directory: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (working_directory / "Long.mo").write_text(LONG)

    def interrupted(progress: Progress, time: float) -> None:
        if time > 3:
            signal.raise_signal(signal.SIGINT)  # the second one, as the first was only noted
            signal.raise_signal(signal.SIGINT)

    with monkeypatch.context() as patch:
        patch.setattr(Progress, "__call__", interrupted)
        done = call("simulate", "Long.mo", "-o", "part.nc", "--max-step", "0.01", "--interval", "1e-5")
    assert done.status == 130
    assert "--continue part.nc" in done.err
    end = acausal.read_result("part.nc").time[-1]
    assert 3 < end < 10
    assert call("simulate", "Long.mo", "--continue", "part.nc", "--stop-time", f"{end + 0.5}").status == 0
    assert acausal.read_result("part.nc").time[-1] == end + 0.5


def test_progress_line() -> None:
    line = Progress(1.0, 3.0).line(2.0, 0.5)
    assert line.count("#") == 15
    assert "50%" in line
    assert "2 of 3 s, 0.5 times real time" in line


def test_a_result_that_was_cut_short_is_not_continued(call: Call, working_directory: Path) -> None:
    (working_directory / "Long.mo").write_text(LONG)
    for name in ("part.csv", "part.mat"):
        assert call("simulate", "Long.mo", "--stop-time", "4", "-o", name).status == 0
        file = working_directory / name
        file.write_bytes(file.read_bytes()[: file.stat().st_size * 2 // 3])
        done = call("simulate", "Long.mo", "--continue", name, "--json")
        assert (done.status, done.problems[0]["code"]) == (2, "usage.continue")
        assert "the run wrote 41" in str(done.problems[0]["message"])


def test_jumps_of_blocks_are_in_json(call: Call, working_directory: Path) -> None:
    (working_directory / "Jump.mo").write_text(
        "model Jump Real x(start = -1, fixed = true), z(start = -1.5); equation\n"
        "  der(x) = 1;\n  z ^ 3 / 3 - z = x;\nannotation(experiment(StopTime = 3));\nend Jump;\n"
    )
    told = str(call("simulate", "Jump.mo", "--json").data["warnings"])
    assert told.startswith("[{'severity': 'warning', 'code': 'simulate.jump'")
    assert "'line': 3," in told
