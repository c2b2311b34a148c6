"""The tube lets pass what it should, and nothing else."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.reference.published import Reference, references
from tests.reference.tube import SHARE, Curve, deviation, half_width

TIME = np.linspace(0.0, 10.0, 501)
SINE = Curve(TIME, np.sin(TIME))


def step_at(instant: float, high: float = 1.0) -> Curve:
    """Zero, then `high` from an instant on; both sides of it are there."""
    count = int(np.searchsorted(TIME, instant))
    time = np.insert(TIME, count, [instant, instant])
    return Curve(time, np.where(np.arange(len(time)) > count, high, 0.0))


def test_same_curve_on_another_grid() -> None:
    fine = np.linspace(0.0, 10.0, 5001)
    assert deviation(SINE, SINE) is None
    assert deviation(SINE, Curve(fine, np.sin(fine))) is None


@pytest.mark.parametrize("share", [0.9, 1.5])
def test_offset_of_the_half_width(share: float) -> None:
    off = deviation(SINE, Curve(TIME, SINE.values + share * half_width(SINE.values)))
    assert (off is None) == (share < 1)


def test_half_width_is_a_share_of_the_range() -> None:
    assert half_width(np.array([1.0, 3.0])) == pytest.approx(2 * SHARE, rel=1e-2)
    assert half_width(np.full(3, 5.0)) == pytest.approx(5e-6, rel=1e-2)


def test_a_shift_where_there_is_no_event_counts() -> None:
    late = deviation(SINE, Curve(TIME, np.sin(TIME - 0.01)))
    assert late is not None
    assert abs(np.cos(late.time)) > 0.9  # where it is steepest


@pytest.mark.parametrize(("instant", "fine"), [(5.001, True), (4.9985, True), (5.0071, False), (4.99, False)])
def test_event_may_be_a_little_off(instant: float, fine: bool) -> None:
    assert (deviation(step_at(5.0), step_at(instant)) is None) == fine


@pytest.mark.parametrize(("instant", "fine"), [(9.9995, True), (10.0, True), (9.99, False)])
def test_event_at_the_end_may_come_after_it(instant: float, fine: bool) -> None:
    assert (deviation(Curve(TIME, np.zeros(len(TIME))), step_at(instant)) is None) == fine


def test_event_that_is_missed() -> None:
    off = deviation(step_at(5.0), Curve(TIME, np.zeros(len(TIME))))
    assert off is not None
    assert off.expected == pytest.approx(1.0)
    assert off.found == pytest.approx(0.0)


def test_spike_of_its_own_is_found() -> None:
    time = np.concatenate([TIME[TIME <= 5], [5.0, 5.0], TIME[TIME > 5]])
    spike = np.where((time == 5.0) & (np.arange(len(time)) == np.searchsorted(time, 5.0) + 1), 1.0, 0.0)
    assert deviation(Curve(TIME, np.zeros(len(TIME))), Curve(time, spike)) is not None
    assert deviation(Curve(time, spike), Curve(TIME, np.zeros(len(TIME)))) is None, "a pass of an iteration"


def test_pass_at_the_start_need_not_be_there() -> None:
    time = np.insert(TIME, 0, 0.0)
    first = Curve(time, np.where(np.arange(len(time)) == 0, 1.0, 0.0))
    assert deviation(first, Curve(TIME, np.zeros(len(TIME)))) is None
    assert deviation(Curve(TIME, np.zeros(len(TIME))), first) is not None


def test_value_that_is_no_number() -> None:
    values = SINE.values.copy()
    values[100] = np.nan
    assert deviation(SINE, Curve(TIME, values)) is not None


def test_run_that_ends_too_early() -> None:
    off = deviation(SINE, Curve(TIME[:400], SINE.values[:400]))
    assert off is not None
    assert off.widths == np.inf


def test_folder_is_read(tmp_path: Path) -> None:
    folder = tmp_path / "Library" / "Examples" / "Swing"
    folder.mkdir(parents=True)
    (folder / "comparisonSignals.txt").write_text("time\nx\nbody.v\n\n")
    (folder / "Swing.csv").write_text('"time","x","body.v","more"\n0,1,2,0\n0.5,1.5,2.5,0\n')
    (found,) = references(tmp_path)
    assert found == Reference("Library.Examples.Swing", folder)
    assert found.signals == ("x", "body.v")
    assert found.curves()["body.v"].values.tolist() == [2.0, 2.5]
