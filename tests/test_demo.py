"""`make run`: small, and that it notices what is wrong."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from acausal.demo.__main__ import main
from acausal.demo.systems import GEARS, GearTrial, RegulatorTrial, gear_trials, problems, regulator_trials
from tests.models.reference_kinematics import GEARS as REFERENCE


@pytest.fixture(scope="module")
def gears() -> tuple[GearTrial, ...]:
    return gear_trials((1, 10, -1))


@pytest.fixture(scope="module")
def regulators() -> tuple[RegulatorTrial, ...]:
    return regulator_trials()


def test_table_is_the_published_one() -> None:
    assert GEARS == REFERENCE


def test_all_is_well(gears: tuple[GearTrial, ...], regulators: tuple[RegulatorTrial, ...]) -> None:
    assert list(problems(gears, regulators)) == []
    assert [len(trial.compiled.states) for trial in regulators] == [5, 4, 4]


def test_a_wrong_ratio_is_noticed(gears: tuple[GearTrial, ...]) -> None:
    first, *_ = gears
    wrong = replace(first, gear=2)
    assert list(problems((wrong,), ())) == ["gear 2: ratio 5.2439 instead of 3.271 within 0.003"]


def test_a_wrong_number_of_states_is_noticed(
    gears: tuple[GearTrial, ...], regulators: tuple[RegulatorTrial, ...]
) -> None:
    flow, pressure, _ = regulators
    wrong = replace(flow, compiled=pressure.compiled)
    assert list(problems((), (wrong,))) == ["MainRegulatorFlow: 4 states instead of 5"]
    assert "gear 1: 5 states instead of 2" in list(problems((replace(gears[0], compiled=flow.compiled),), ()))


def test_report_and_plots(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--out", str(tmp_path / "new" / "out")]) == 0
    printed = capsys.readouterr().out
    written = {path.name: path.stat().st_size for path in (tmp_path / "new" / "out").iterdir()}
    assert set(written) == {"gears.png", "gears.svg", "regulator.png", "regulator.svg", "report.txt"}
    assert all(size > 1000 for size in written.values())
    report = (tmp_path / "new" / "out" / "report.txt").read_text()
    assert report.splitlines() == [line.rstrip() for line in printed.splitlines()]
    assert all(f"\n{'R' if gear < 0 else gear:>4}  " in report for gear in GEARS)
    assert "no state: line.p" in report
    assert "PressureSource.mo:" in report


def test_a_folder_that_cannot_be_made(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").write_text("")
    assert main(["--out", str(tmp_path / "file" / "out")]) == 1
    assert "Traceback" not in capsys.readouterr().err
