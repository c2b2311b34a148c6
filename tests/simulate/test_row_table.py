"""The table that results grow in."""

from __future__ import annotations

import numpy as np

from acausal.simulate.rows import Rows


def test_rows_stay_in_order_beyond_what_was_expected() -> None:
    table = Rows(2, expected=3)
    for i in range(100):
        table.add(float(i), np.array([i, -i]))
    block = np.arange(100.0, 400.0)
    table.extend(block, np.column_stack([block, -block]))
    table.drop()
    assert table.times.tolist() == [float(i) for i in range(399)]
    assert np.array_equal(table.data, np.column_stack([table.times, -table.times]))


def test_what_was_taken_is_not_overwritten() -> None:
    table = Rows(1)
    table.extend(np.array([0.0, 1.0]), np.array([[5.0], [6.0]]))
    times, data = table.times, table.data
    table.keep_last()
    table.add(2.0, np.array([7.0]))
    assert (times.tolist(), data.ravel().tolist()) == ([0.0, 1.0], [5.0, 6.0])
    assert (table.times.tolist(), table.data.ravel().tolist()) == ([1.0, 2.0], [6.0, 7.0])


def test_no_columns() -> None:
    table = Rows(0, expected=10)
    table.extend(np.arange(70.0), np.zeros((70, 0)))
    assert table.data.shape == (70, 0)
