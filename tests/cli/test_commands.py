"""What the commands print when all is well: the contract of docs/command-line.md."""

from __future__ import annotations

import csv
import json
import math
from pathlib import Path
from typing import get_args

import pytest

from acausal import __version__
from acausal.cli.app import StageName
from acausal.cli.output import print_json
from acausal.pipeline import STAGES
from tests.cli.calls import Call

COMPILE_KEYS = "model equations variables aliases index states blocks zero_crossings seconds".split()
SIMULATE_KEYS = [
    *"model solver stop_time steps rhs_evaluations jacobian_evaluations events".split(),
    *"cpu_seconds real_time_factor final result rejected phase_seconds event_sources".split(),
]


def test_stages_are_the_pipelines() -> None:
    assert get_args(StageName) == STAGES


def test_version(call: Call) -> None:
    assert call("--version").out == f"acausal {__version__}\n"


@pytest.mark.parametrize("command", ["check", "compile", "explain", "profile", "simulate"])
def test_help_names_every_option(call: Call, command: str) -> None:
    done = call(command, "--help")
    assert done.status == 0
    assert all(option in done.out for option in ("MODEL", "--path", "--class", "--json", "-p"))


def test_check(call: Call) -> None:
    done = call("check", "Tank.mo")
    assert (done.status, done.out, done.err) == (0, "Tank: no errors\n", "")


def test_check_json_is_the_list_of_diagnostics(call: Call) -> None:
    done = call("check", "Tank.mo", "--json")
    assert (done.status, done.json) == (0, [])


def test_check_warns(call: Call, working_directory: Path) -> None:
    (working_directory / "W.mo").write_text('model W Real x(unit = "banana") = time; end W;')
    done = call("check", "W.mo")
    assert done.status == 0
    assert "W.mo:1:" in done.err
    assert "warning: " in done.err
    assert done.out == "W: no errors, 1 warning\n"
    (warning,) = call("check", "W.mo", "--json").problems
    assert (warning["severity"], warning["line"]) == ("warning", 1)


def test_compile_json(call: Call) -> None:
    done = call("compile", "Tank.mo", "--json")
    data = done.data
    assert list(data) == COMPILE_KEYS
    assert (data["model"], data["equations"], data["variables"], data["states"]) == ("Tank", 3, 3, ["h"])
    assert list(done.below("blocks")) == ["count", "largest", "largest_torn"]
    seconds = done.below("seconds")
    assert list(seconds) == ["parse", "flatten", "causalise", "codegen", "total"]
    *steps, total = (spent for spent in seconds.values() if isinstance(spent, float))
    assert steps[0] > 0
    assert total == pytest.approx(sum(steps))


def test_compile_for_people(call: Call) -> None:
    done = call("compile", "Tank.mo")
    assert done.out.startswith("Tank: A tank that empties\n")
    assert "3 in 3 unknowns" in done.out
    assert "Depth" in done.out
    assert all(line == line.rstrip() for line in done.out.splitlines())


@pytest.mark.parametrize(
    ("stage", "text"),
    [
        ("ast", "model Tank"),
        ("instance", "hole"),
        ("flat", "der('h')"),
        ("causal", "causal system Tank"),
        ("code", "ode"),
    ],
)
def test_show_prints_a_stage(call: Call, stage: str, text: str) -> None:
    done = call("compile", "Tank.mo", "--show", stage)
    assert done.status == 0
    assert text in done.out


def test_show_in_json(call: Call) -> None:
    data = call("compile", "Tank.mo", "--show", "flat", "--stop-after", "causal", "--json").data
    assert "der('h')" in str(data["text"])
    assert data["states"] == ["h"]


def test_show_stops_there(call: Call, working_directory: Path) -> None:
    """The flat text of a model that cannot be causalised can be looked at."""
    (working_directory / "S.mo").write_text("model S Real x; Real y; equation x = 1; x = 2; end S;")
    assert call("compile", "S.mo", "--show", "flat").status == 0
    assert call("compile", "S.mo").status == 1


def test_stop_after(call: Call) -> None:
    data = call("compile", "Tank.mo", "--stop-after", "flat", "--json").data
    assert list(data) == ["model", "equations", "variables", "seconds"]


def test_class_picks(call: Call, working_directory: Path) -> None:
    (working_directory / "Two.mo").write_text(
        "model A Real x = 1; end A; package P model B Real x = 1; Real y = x; end B; end P;"
    )
    assert call("compile", "Two.mo", "--class", "A", "--json").data["model"] == "A"
    for name in ("P.B", "B"):
        assert call("compile", "Two.mo", "--class", name, "--json").data["equations"] == 2


def test_path_is_searched_first(call: Call, working_directory: Path) -> None:
    folder = working_directory / "mine"
    folder.mkdir()
    (folder / "TenSpeed.mo").write_text("model TenSpeed Real x = 1; end TenSpeed;")
    assert call("compile", "TenSpeed", "--path", "mine", "--json").data["equations"] == 1


def test_simulate_json(call: Call, working_directory: Path) -> None:
    done = call("simulate", "Tank.mo", "-v", "h", "-v", "hidden", "-o", "t.csv", "--plot", "t.svg", "--json")
    data, final = done.data, done.below("final")
    assert list(data) == SIMULATE_KEYS
    depth = (1 - 1e-3 * 2 / 0.5 * math.sqrt(9.81 / 2) * 10) ** 2
    assert final == {"h": pytest.approx(depth, rel=1e-5), "hidden": pytest.approx(2 * depth, rel=1e-5)}
    assert (data["result"], data["stop_time"]) == ("t.csv", 10.0)
    assert data["solver"] in ("rodas", "cvode")
    assert isinstance(data["cpu_seconds"], float)
    assert data["real_time_factor"] == pytest.approx(data["cpu_seconds"] / 10)
    rows = list(csv.reader((working_directory / "t.csv").read_text().splitlines()))
    assert rows[0] == ["time", "h", "hidden"]
    assert final["h"] == float(rows[-1][1])
    assert (working_directory / "t.svg").read_text().startswith("<?xml")


def test_simulate_chooses(call: Call) -> None:
    default = call("simulate", "Tank.mo", "--json")
    assert (default.data["result"], list(default.below("final"))) == (None, ["h", "v"])
    assert set(call("simulate", "Tank.mo", "--all", "--json").below("final")) == {"h", "v", "hidden"}


def test_simulate_for_people(call: Call) -> None:
    done = call("simulate", "Tank.mo", "--stop-time", "5", "-o", "t.csv")
    assert done.out.startswith("Tank at 5 s\n")
    assert "Speed of the jet" in done.out
    assert done.out.endswith("wrote t.csv\n")


def test_parameters_are_modelica(call: Call) -> None:
    def depth(*words: str) -> object:
        return call("simulate", "Tank.mo", *words, "-v", "h", "--json").below("final")["h"]

    assert depth("-p", "open=false") == pytest.approx(1)
    assert depth("-p", "hole=1e-3/2", "-p", "n = 4") == pytest.approx(depth())


def test_settings_reach_the_run(call: Call, working_directory: Path) -> None:
    words = "--stop-time 2 --interval 0.5 --rtol 1e-4 --atol 1e-4 --max-step 0.01 --solver cvode".split()
    data = call("simulate", "Tank.mo", *words, "-o", "t.csv", "--json").data
    assert isinstance(data["steps"], int)
    assert data["steps"] >= 200
    times = [row[0] for row in csv.reader((working_directory / "t.csv").read_text().splitlines())]
    assert times == ["time", "0.0", "0.5", "1.0", "1.5", "2.0"]


def test_not_finite_is_null_in_json(capsys: pytest.CaptureFixture[str]) -> None:
    print_json({"a": [float("nan"), 1.5], "b": float("inf")})
    assert json.loads(capsys.readouterr().out) == {"a": [None, 1.5], "b": None}
