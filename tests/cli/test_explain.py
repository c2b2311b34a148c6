"""`acausal explain`: what it prints, what it writes, what it refuses."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.calls import Call


def test_explain(call: Call) -> None:
    done = call("explain", "Tank.mo")
    assert (done.status, done.err) == (0, "")
    assert done.out.startswith("Tank: A tank that empties\n\nFlat model\n")
    assert "h  its derivative appears" in done.out


def test_parameters_are_applied(call: Call) -> None:
    assert call("explain", "Tank.mo", "-p", "n=3").status == 0
    assert call("explain", "Tank.mo", "-p", "nothing=3").status == 1


def test_json(call: Call) -> None:
    data = call("explain", "Tank.mo", "--json").data
    assert data["model"] == "Tank"
    assert data["states"] == ["h"]


def test_block(call: Call) -> None:
    done = call("explain", "Tank.mo", "--block", "1")
    assert done.out.startswith("block 1 of ")
    assert r"\sqrt{" not in done.out
    data = call("explain", "Tank.mo", "--block", "1", "--json", "--latex").data
    assert data["number"] == 1
    assert "latex" in str(data["equations"])


def test_files(call: Call, working_directory: Path) -> None:
    done = call("explain", "Tank.mo", "--plot", "a.svg", "--html", "a.html")
    assert done.out.endswith("wrote a.svg\nwrote a.html\n")
    assert "<svg" in (working_directory / "a.svg").read_text()
    assert (working_directory / "a.html").read_text().startswith("<!DOCTYPE html>")


@pytest.mark.parametrize(
    ("words", "code"),
    [
        (["--block", "99"], "usage.block"),
        (["--latex"], "usage.latex"),
        (["--plot", "a.bmp"], "usage.plot"),
        (["--html", "nowhere/a.html"], "usage.output"),
    ],
)
def test_wrong_usage(call: Call, working_directory: Path, words: list[str], code: str) -> None:
    done = call("explain", "Tank.mo", *words, "--json")
    assert done.status == 2
    assert [problem["code"] for problem in done.problems] == [code]
    assert sorted(file.name for file in working_directory.iterdir()) == ["Tank.mo"]


def test_a_wrong_model(call: Call, working_directory: Path) -> None:
    (working_directory / "W.mo").write_text("model W Real x; equation x = y; end W;")
    assert call("explain", "W.mo").status == 1
    assert call("explain", "W.mo", "--json").problems
