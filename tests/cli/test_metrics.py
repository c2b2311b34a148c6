"""`acausal metrics` on a constructed result of two shifts."""

from __future__ import annotations

from pathlib import Path
from typing import cast

import numpy as np
import pytest

from tests.cli.calls import Call

NAMES = "time,gear,outputTorque,slip_C1,slip_B2,torque_C1,torque_B2"


@pytest.fixture
def sweep(working_directory: Path) -> Path:
    """First to second and back; the elements C1 and B2 change places each time."""
    time = np.arange(0, 6, 1e-3)
    gear = np.where(time < 1, 1, np.where(time < 3, 2, 1))
    up, down = (time - 1.5) / 0.5, (time - 3.5) / 0.5
    share = np.clip(up, 0, 1) - np.clip(down, 0, 1)
    hole = np.interp(time, [0, 1.2, 1.4, 2, 6], [400, 400, 100, 300, 300])
    columns = (time, gear, hole, 90 * (1 - share), 60 * share, 200 * share, 150 * (1 - share))
    file = working_directory / "sweep.csv"
    np.savetxt(file, np.column_stack(columns), delimiter=",", header=NAMES, comments="")
    return file


def test_json(call: Call, sweep: Path) -> None:
    done = call("metrics", str(sweep), "--kind", "shift", "--json")
    shifts = cast("list[dict[str, object]]", done.data["shifts"])
    first, second = shifts
    assert (first["from_gear"], first["to_gear"], first["oncoming"], first["offgoing"]) == (1, 2, "C1", "B2")
    assert first["torque_hole"] == pytest.approx(-200, rel=1e-3)
    assert first["inertia_phase"] == pytest.approx(0.5, abs=1e-3)
    assert (second["oncoming"], second["torque_hole"]) == ("B2", 0)
    means = done.below("averages")
    assert means["torque_hole"] == pytest.approx(-100, rel=1e-3)
    assert means["torque_phase"] == first["torque_phase"]  # the other shift has none


def test_a_shift_ends_where_the_drive_changes(call: Call, sweep: Path) -> None:
    lines = sweep.read_text().splitlines()
    drive = ["inputTorque"] + ["150" if float(row.split(",")[0]) < 4.2 else "0" for row in lines[1:]]
    sweep.write_text("\n".join(f"{row},{value}" for row, value in zip(lines, drive, strict=True)) + "\n")
    shifts = cast("list[dict[str, float]]", call("metrics", str(sweep), "--json").data["shifts"])
    assert [one["end"] for one in shifts] == [pytest.approx(3), pytest.approx(4.2)]


def test_table_and_drawing(call: Call, sweep: Path) -> None:
    done = call("metrics", str(sweep), "--plot", "shifts.svg")
    assert "1 to 2" in done.out
    assert "average" in done.out
    assert sweep.with_name("shifts.svg").read_text().startswith("<?xml")


def test_wrong_results(call: Call, sweep: Path) -> None:
    text = sweep.read_text()
    broken = sweep.with_name("broken.csv")
    for content, code in (
        ("", "metrics.not-a-result"),
        (text.replace("time,", "t,", 1), "metrics.not-a-result"),
        (text.replace("gear,", "gears,", 1), "metrics.missing-signal"),
        ("\n".join(text.splitlines()[:500]), "metrics.no-shift"),
    ):
        broken.write_text(content)
        done = call("metrics", str(broken), "--json")
        assert (done.status, done.problems[0]["code"]) == (2, code)
    assert call("metrics", "nothing.csv", "--json").problems[0]["code"] == "metrics.not-a-result"
    assert call("metrics", str(sweep), "--kind", "colour", "--json").problems[0]["code"] == "usage.kind"


def test_other_kinds(call: Call, working_directory: Path) -> None:
    ratio = np.linspace(0, 1, 101)
    rows = np.column_stack([ratio, ratio, np.maximum(2 - 1.25 * ratio, 1), 150 + ratio])
    names = "time,speedRatio,torqueRatio,capacityFactor"
    np.savetxt(working_directory / "map.csv", rows, delimiter=",", header=names, comments="")
    converter = ("metrics", "map.csv", "--kind", "converter")
    found = call(*converter, "--reference", "map.csv", "--plot", "map.svg", "--json").data
    assert (found["kind"], found["coupling_speed_ratio"]) == ("converter", pytest.approx(0.8))
    assert found["capacity_rms_error"] == pytest.approx(0, abs=1e-12)
    assert (working_directory / "map.svg").read_text().startswith("<?xml")
    assert "coupling speed ratio" in call(*converter).out
    assert call(*converter, "--stop", "1", "--json").problems[0]["code"] == "usage.metrics-option"
    time = np.arange(0, 2, 1e-3)
    rows = np.column_stack(
        [time, np.interp(time, [0.1, 0.6], [0, 1]), np.interp(time, [0.3, 0.8], [1e5, 11e5])]
    )
    names = "time,current,pressure"
    np.savetxt(working_directory / "fill.csv", rows, delimiter=",", header=names, comments="")
    engagement = ("metrics", "fill.csv", "--kind", "engagement")
    (one,) = cast("list[dict[str, object]]", call(*engagement, "--json").data["engagements"])
    assert (one["delay"], one["corner_time"]) == (pytest.approx(0.2, abs=1e-6), None)
    assert "overshoot" in call(*engagement).out
    assert call(*engagement, "--from", "3", "--to", "4", "--json").problems[0]["code"] == "metrics.no-window"
