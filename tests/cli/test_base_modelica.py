"""Files of Base Modelica on the command line."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.calls import Call


def test_a_flattened_model_runs_like_the_model(call: Call, working_directory: Path) -> None:
    text = call("compile", "Tank.mo", "--show", "flat").out
    (working_directory / "Flat.bmo").write_text(text)
    assert call("check", "Flat.bmo").out == "Tank: no errors\n"
    assert call("compile", "Flat.bmo", "--show", "flat").out == text
    keys = ("model", "equations", "variables", "states")
    summaries = [call("compile", file, "--json").data for file in ("Tank.mo", "Flat.bmo")]
    assert [summaries[0][key] for key in keys] == [summaries[1][key] for key in keys]
    runs = [
        call("simulate", file, "-p", "hole=2e-3", "-v", "h", "-v", "hidden", "--json").below("final")
        for file in ("Tank.mo", "Flat.bmo")
    ]
    assert runs[0] == pytest.approx(runs[1])


def test_the_first_line_tells_not_the_name(call: Call, working_directory: Path) -> None:
    (working_directory / "Flat.mo").write_text(call("compile", "Tank.mo", "--show", "flat").out)
    assert call("compile", "Flat.mo", "--json").data["model"] == "Tank"
