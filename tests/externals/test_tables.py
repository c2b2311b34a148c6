"""Tables against closed forms and SciPy."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from scipy.interpolate import Akima1DInterpolator, PchipInterpolator

from acausal.externals.arguments import RoutineFailed, Tensor
from acausal.externals.files import Files
from acausal.externals.hermite import fritsch_butland, modified_akima, steffen
from acausal.externals.objects import TableObject, table_1d, time_table
from acausal.externals.objects2d import SurfaceObject, table_2d
from acausal.externals.table1d import (
    NEVER,
    BadTable,
    Curve,
    Extrapolation,
    Smoothness,
    TimeEvents,
    check_abscissas,
)
from acausal.externals.table2d import Surface
from acausal.symbolic.expressions.kernel import Kernel

X = (0.0, 1.0, 2.5, 3.0, 5.0, 6.0)
Y = (0.0, 1.0, -1.0, 2.0, 2.5, 0.0)
INSIDE = np.linspace(0.0, 6.0, 101)
SMOOTH = [Smoothness.AKIMA, Smoothness.FRITSCH_BUTLAND, Smoothness.STEFFEN, Smoothness.MODIFIED_AKIMA]
HOLD, LAST, PERIODIC, NONE = Extrapolation


def curve(smoothness: Smoothness, outside: Extrapolation = LAST, y: tuple[float, ...] = Y) -> Kernel:
    return Curve(X, y, smoothness, outside).kernel("t")


def value(kernel: Kernel | None, *args: float) -> float:
    assert kernel is not None
    result = kernel.evaluate(*(args * 2 if len(args) == 1 else args))
    assert isinstance(result, float)
    return result


# ------------------------------------------------------------------------------ one argument


def test_linear_segments() -> None:
    kernel = curve(Smoothness.LINEAR)
    assert [value(kernel, x) for x in INSIDE] == pytest.approx(list(np.interp(INSIDE, X, Y)))
    assert value(kernel, -2.0) == -2.0
    assert value(kernel, 8.0) == pytest.approx(-5.0)


def test_constant_segments_hold_from_their_left_end() -> None:
    kernel = curve(Smoothness.CONSTANT)
    assert [value(kernel, x) for x in (0.0, 0.99, 1.0, 2.5, 4.9, 6.0)] == [0.0, 0.0, 1.0, -1.0, 2.0, 0.0]
    assert value(kernel, 7.0) == pytest.approx(-2.5)
    assert value(curve(Smoothness.CONSTANT, HOLD), 7.0) == 0.0


def test_akima_is_scipys() -> None:
    expected = Akima1DInterpolator(np.array(X), np.array(Y))
    kernel = curve(Smoothness.AKIMA)
    assert [value(kernel, x) for x in INSIDE] == pytest.approx(expected(INSIDE).tolist())
    slopes = [value(kernel.partial(1), x) for x in INSIDE[:-1]]
    assert slopes == pytest.approx(expected(INSIDE[:-1], 1).tolist())


def test_modified_akima_is_scipys() -> None:
    expected = Akima1DInterpolator(np.array(X), np.array(Y), method="makima")
    assert [value(curve(Smoothness.MODIFIED_AKIMA), x) for x in INSIDE] == pytest.approx(
        expected(INSIDE).tolist()
    )


def test_fritsch_butland_is_scipys_except_at_the_ends() -> None:
    expected = PchipInterpolator(np.array(X), np.array(Y)).derivative()
    assert fritsch_butland(X, Y)[1:-1] == pytest.approx(expected(np.array(X[1:-1])).tolist())
    assert fritsch_butland(X, Y)[0] == 1.0


def test_steffen_limits_the_parabola() -> None:
    """h = 1 and 1, chords 1 and 10: the parabola's slope 5.5 is cut to 2; chords 2 and 3: 2.5 stays."""
    assert steffen([0, 1, 2], [0, 1, 11]) == [1, 2, 10]
    assert steffen([0, 1, 2], [0, 2, 5]) == [2, 2.5, 3]
    assert steffen([0, 1, 2], [0, 2, 1]) == [2, 0, -1]


@pytest.mark.parametrize("smoothness", [Smoothness.FRITSCH_BUTLAND, Smoothness.STEFFEN])
def test_monotone_data_stay_monotone(smoothness: Smoothness) -> None:
    rising = Curve((0, 1, 2, 3, 10), (0, 0.1, 5, 5.1, 5.2), smoothness, HOLD).kernel("t")
    values = [value(rising, x) for x in np.linspace(0, 10, 300)]
    assert all(b >= a - 1e-12 for a, b in pairwise(values))


def test_flat_data_have_flat_slopes() -> None:
    assert modified_akima([0, 1, 2, 3], [1, 1, 1, 1]) == [0, 0, 0, 0]


@pytest.mark.parametrize("smoothness", SMOOTH)
def test_smooth_kinds_are_continuously_differentiable_outside_too(smoothness: Smoothness) -> None:
    kernel = curve(smoothness)
    slope = kernel.partial(1)
    for x in X:
        for f in (kernel, slope):
            assert value(f, x - 1e-9) == pytest.approx(value(f, x + 1e-9), abs=1e-6)
    assert value(kernel, 8.0) == pytest.approx(value(kernel, 7.0) + value(slope, 7.0))
    assert kernel.continuity == 1


@pytest.mark.parametrize("smoothness", [Smoothness.LINEAR, *SMOOTH])
def test_hold_and_period(smoothness: Smoothness) -> None:
    held = curve(smoothness, HOLD)
    assert (value(held, -1.0), value(held, 9.0)) == (0.0, 0.0)
    again = curve(smoothness, PERIODIC)
    for x in (0.3, 2.7, 5.9):
        assert value(again, x + 12.0) == pytest.approx(value(again, x))
        assert value(again, x - 6.0) == pytest.approx(value(again, x))
    assert value(curve(smoothness, PERIODIC, (*Y[:-1], 7.0)), 6.0) == 7.0


def test_continuity() -> None:
    assert curve(Smoothness.LINEAR).continuity == 0
    assert curve(Smoothness.CONSTANT).continuity == -1
    assert curve(Smoothness.AKIMA, HOLD).continuity == 0
    assert curve(Smoothness.LINEAR, PERIODIC, (*Y[:-1], 7.0)).continuity == -1


@pytest.mark.parametrize("smoothness", Smoothness)
@pytest.mark.parametrize("outside", Extrapolation)
def test_short_tables(smoothness: Smoothness, outside: Extrapolation) -> None:
    """One row is a constant, two rows are a line (except for constant segments)."""
    assert value(Curve((1.0,), (4.0,), smoothness, outside).kernel("t"), 77.0) == 4.0
    two = Curve((0.0, 2.0), (1.0, 5.0), smoothness, outside).kernel("t")
    assert value(two, 1.0) == (1.0 if smoothness is Smoothness.CONSTANT else 3.0)


@pytest.mark.parametrize(
    ("x", "smoothness", "may_repeat", "word"),
    [
        ([0, 2, 1], Smoothness.LINEAR, True, "monotonically"),
        ([0, 1, 1], Smoothness.LINEAR, False, "strictly"),
        ([0, 1, 1], Smoothness.AKIMA, True, "strictly"),
    ],
)
def test_abscissas_increase(x: list[float], smoothness: Smoothness, may_repeat: bool, word: str) -> None:
    with pytest.raises(BadTable, match=word):
        check_abscissas(x, smoothness, may_repeat=may_repeat)


def test_a_single_jump() -> None:
    kernel = Curve((1.0, 1.0), (10.0, 11.0), Smoothness.CONSTANT, LAST).kernel("t")
    assert [value(kernel, x) for x in (0.0, 1.0, 2.0)] == [10.0, 11.0, 11.0]


# ------------------------------------------------------------------------------ over time


def timed(
    smoothness: int = 1, outside: int = 2, events: int = 1, start: float = 0.0, shift: float = 0.0
) -> TableObject:
    data = Tensor((6, 2), (0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 2.0, 4.0, 3.0, 9.0, 4.0, 16.0))
    args = ["NoName", "NoName", data, 6, 2, start, Tensor((1,), (2,)), 1, smoothness, outside, shift, events]
    found = time_table([*args, False, ",", 0], NO_FILES)
    assert isinstance(found, TableObject)
    return found


def events_of(table: TableObject, count: int, time: float = -5.0) -> list[float]:
    found: list[float] = []
    for _ in range(count):
        time = value(table.next_event(), time)
        found.append(time)
    return found


def test_repeated_points_jump() -> None:
    kernel = timed().column(1)
    assert [value(kernel, t) for t in (0.5, 1.0, 1.5, 5.0)] == [0.0, 1.0, 2.5, 23.0]
    assert value(kernel, 0.99, 1.0) == 0.0
    assert kernel.continuity == -1


@pytest.mark.parametrize(
    ("events", "expected"),
    [(1, [0.0, 1.0, 2.0, 3.0, 4.0, NEVER]), (2, [0.0, 1.0, 4.0, NEVER]), (3, [0.0, 4.0, NEVER])],
)
def test_events_in_time(events: int, expected: list[float]) -> None:
    assert events_of(timed(events=events), len(expected)) == expected


def test_events_after_start_and_shifted() -> None:
    assert events_of(timed(start=1.5, shift=1.0), 5) == [1.5, 2.0, 3.0, 4.0, 5.0]


def test_events_repeat_with_the_period() -> None:
    assert events_of(timed(outside=3), 8, time=0.5) == [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]


def test_smooth_tables_over_time_need_strictly_increasing_times() -> None:
    with pytest.raises(RoutineFailed, match="strictly"):
        timed(smoothness=2)


# ------------------------------------------------------------------------------ two arguments

U, V = (0.0, 1.0, 2.0, 4.0), (0.0, 1.0, 3.0)


def surface(
    function: Callable[[float, float], float], smoothness: Smoothness, outside: Extrapolation = LAST
) -> Kernel:
    z = tuple(tuple(function(u, v) for v in V) for u in U)
    return Surface(U, V, z, smoothness, outside).kernel("s")


def plane(u: float, v: float) -> float:
    return 1.0 + 2.0 * u - 3.0 * v


POINTS = [(0.5, 0.5), (1.0, 1.0), (3.9, 2.9), (-1.0, 0.2), (5.0, 4.0), (2.0, -3.0)]


@pytest.mark.parametrize("smoothness", [Smoothness.LINEAR, Smoothness.AKIMA])
def test_planes_are_exact_also_outside(smoothness: Smoothness) -> None:
    kernel = surface(plane, smoothness)
    for u, v in POINTS:
        assert value(kernel, u, v) == pytest.approx(plane(u, v))
        assert value(kernel.partial(0), u, v) == pytest.approx(2.0)
        assert value(kernel.partial(1), u, v) == pytest.approx(-3.0)


def test_bilinear() -> None:
    kernel = surface(lambda u, v: u * v, Smoothness.LINEAR)
    assert value(kernel, 3.0, 2.0) == pytest.approx(6.0)


def test_bicubic_meets_the_points_and_is_smooth() -> None:
    kernel = surface(lambda u, v: np.sin(u) * np.cos(v), Smoothness.AKIMA)
    for u in U:
        for v in V:
            assert value(kernel, u, v) == pytest.approx(np.sin(u) * np.cos(v))
    for argument in (0, 1):
        slope = kernel.partial(argument)
        for w in (0.3, 1.7, 2.9):
            assert value(slope, 1.0 - 1e-9, w) == pytest.approx(value(slope, 1.0 + 1e-9, w), abs=1e-6)
            assert value(slope, w, 1.0 - 1e-9) == pytest.approx(value(slope, w, 1.0 + 1e-9), abs=1e-6)


def test_bicubic_of_a_product_of_lines_along_one_axis_is_akimas_curve() -> None:
    """A table that does not depend on v is the curve over u."""
    line = Curve(U, (0.0, 1.0, 0.0, 3.0), Smoothness.AKIMA, LAST).kernel("c")
    z = tuple((y,) * 3 for y in (0.0, 1.0, 0.0, 3.0))
    single = Surface(U, (0.0,), tuple((row[0],) for row in z), Smoothness.AKIMA, LAST).kernel("s")
    for u in (-0.5, 0.2, 1.5, 3.3, 5.0):
        assert value(single, u, 9.0) == pytest.approx(value(line, u))


def test_constant_patches() -> None:
    kernel = surface(plane, Smoothness.CONSTANT, HOLD)
    assert value(kernel, 1.9, 2.9) == plane(1.0, 1.0)
    assert value(kernel, 99.0, 99.0) == plane(4.0, 3.0)
    assert value(surface(plane, Smoothness.CONSTANT, LAST), 5.0, 1.0) == pytest.approx(plane(5.0, 1.0))


def test_hold_outside_of_a_surface() -> None:
    for smoothness in (Smoothness.LINEAR, Smoothness.AKIMA):
        kernel = surface(plane, smoothness, HOLD)
        assert value(kernel, 9.0, 9.0) == pytest.approx(plane(4.0, 3.0))
        assert value(kernel, -9.0, 1.5) == pytest.approx(plane(0.0, 1.5))


def test_other_kinds_are_refused_for_two_arguments() -> None:
    with pytest.raises(BadTable, match="two arguments"):
        surface(plane, Smoothness.STEFFEN)


# ------------------------------------------------------------------------------ construction

NO_FILES = Files((), Path.cwd(), lambda name: None)


def one_dimensional(
    rows: list[list[float]], columns: tuple[int, ...] = (2,), table: str = "NoName"
) -> object:
    data = Tensor((len(rows), len(rows[0])), tuple([cell for row in rows for cell in row]))
    return table_1d(
        ["NoName", table, data, 0, 0, Tensor((len(columns),), columns), 1, 1, 1, True, ",", 0], NO_FILES
    )


@pytest.mark.parametrize(
    ("rows", "columns", "word"),
    [
        ([[0.0], [1.0]], (2,), "two columns"),
        ([[0.0, 1.0], [1.0, 2.0]], (3,), "no column 3"),
        ([[1.0, 1.0], [1.0, 2.0]], (2,), "strictly"),
    ],
)
def test_bad_tables_are_refused(rows: list[list[float]], columns: tuple[int, ...], word: str) -> None:
    with pytest.raises(RoutineFailed, match=word):
        one_dimensional(rows, columns)


def test_tables_of_c_functions_are_refused() -> None:
    with pytest.raises(RoutineFailed, match="C functions"):
        one_dimensional([[0.0, 1.0]], table="mine")


def test_two_dimensional_table() -> None:
    data = Tensor((3, 3), (0.0, 1.0, 2.0, 10.0, 1.0, 2.0, 20.0, 3.0, 4.0))
    found = table_2d(["NoName", "NoName", data, 3, 3, 1, 2, True, ",", 0], NO_FILES)
    assert isinstance(found, SurfaceObject)
    assert value(found.kernel(), 15.0, 1.5) == 2.5


def test_constructors_without_delimiter() -> None:
    data = Tensor((2, 2), (0.0, 1.0, 1.0, 3.0))
    found = table_1d(["NoName", "NoName", data, 2, 2, Tensor((1,), (2,)), 1, 1, 1, False], NO_FILES)
    assert isinstance(found, TableObject)
    assert value(found.column(1), 0.5) == 2.0


def test_equal_tables_are_one_kernel() -> None:
    assert timed().column(1) == timed().column(1)
    assert timed().column(1) != timed(events=1, outside=1).column(1)
    assert TimeEvents(2) is TimeEvents.AT_DISCONTINUITIES
