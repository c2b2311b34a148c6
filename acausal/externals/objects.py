"""External objects: tables made once, at compile time, and the kernels of their columns."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

from acausal.externals.arguments import Argument, RoutineFailed, Tensor, number, numbers, text, whole, wholes
from acausal.externals.files import Files, Rows, read_table
from acausal.externals.table1d import (
    NEVER,
    BadTable,
    Curve,
    Extrapolation,
    Smoothness,
    TimeEvents,
    check_abscissas,
    next_event_kernel,
)
from acausal.symbolic.expressions.kernel import Kernel, digest
from acausal.symbolic.expressions.kernels.piecewise import Piecewise
from acausal.symbolic.expressions.node import Constant


@dataclass(frozen=True, eq=False)
class ExternalObject(Kernel):
    """An object as a kernel without arguments that has no value; `name` is the component's."""

    name: str
    key: str
    arity: int = 0
    result: str = "ExternalObject"
    continuity: int = -1

    def evaluate(self, *args: Constant) -> Constant:
        raise ValueError(f"the external object {self.name} has no value")


@dataclass(frozen=True, eq=False)
class TableObject(ExternalObject):
    """A table of one argument, or over time; `curves` are its chosen columns."""

    curves: tuple[Curve, ...] = ()
    events: TimeEvents | None = None
    """Of a table over time only."""
    start: float = -NEVER
    shift: float = 0.0

    @property
    def domain(self) -> tuple[float, float]:
        """The first and the last abscissa."""
        return self.curves[0].x[0], self.curves[0].x[-1]

    @property
    def extrapolation(self) -> Extrapolation:
        return self.curves[0].extrapolation

    @property
    def chooses_by_event(self) -> bool:
        """Whether a table over time has events at its points, and so chooses its piece by the next one."""
        smoothness = self.curves[0].smoothness
        return smoothness is Smoothness.CONSTANT or (
            smoothness is Smoothness.LINEAR and self.events is not TimeEvents.NEVER
        )

    def column(self, index: int) -> Piecewise:
        """Column `index` (from 1 among the chosen ones). Raises `RoutineFailed`."""
        if not 1 <= index <= len(self.curves):
            raise RoutineFailed(f"`{self.name}` has {len(self.curves)} columns, and no column {index}")
        return _column(self.curves[index - 1], f"{self.name}[{index}]")

    def next_event(self) -> Piecewise:
        """The next time event of a table over time."""
        first = self.curves[0]
        events = self.events or TimeEvents.NEVER
        name = f"{self.name}.nextTimeEvent"
        return next_event_kernel(
            name, first.x, first.smoothness, first.extrapolation, events, self.start, self.shift
        )


@lru_cache(maxsize=512)
def _column(curve: Curve, name: str) -> Piecewise:
    return curve.kernel(name)


def named(found: ExternalObject, name: str) -> ExternalObject:
    """The same object under the name of its component."""
    return replace(found, name=name)


# ------------------------------------------------------------------------------ constructors


def table_1d(args: Sequence[Argument], files: Files) -> ExternalObject:
    """(file, table, matrix, rows, columns, chosen, how many, smoothness, extrapolation, verbose, delimiter,
    header lines)."""  # fmt: skip
    data = rows_of(args, files, delimiter=10)
    curves = _curves(data, wholes(args[5]), args[7], args[8], may_repeat=False)
    return TableObject("table", digest("1D", data, curves), curves=curves)


def time_table(args: Sequence[Argument], files: Files) -> ExternalObject:
    """(file, table, matrix, rows, columns, start, chosen, how many, smoothness, extrapolation, shift, events,
    verbose, delimiter, header lines)."""  # fmt: skip
    data = rows_of(args, files, delimiter=13)
    curves = _curves(data, wholes(args[6]), args[8], args[9], may_repeat=True)
    start, shift = number(args[5]), number(args[10])
    events = TimeEvents(whole(args[11]))
    periodic = curves[0].extrapolation is Extrapolation.PERIODIC
    if periodic and len(data) > 1 and data[0][0] == data[-1][0]:
        raise RoutineFailed("its abscissas span no period")
    key = digest("time", data, curves, start, shift, events)
    return TableObject("table", key, curves=curves, events=events, start=start, shift=shift)


def rows_of(args: Sequence[Argument], files: Files, delimiter: int) -> Rows:
    """The matrix of a table: the third argument, or what stands in its file. Raises `RoutineFailed`.

    Before version 4.1 of the standard library nothing is told about the delimiter and header lines.
    """
    file, table = text(args[0]).strip(), text(args[1]).strip()
    if file not in ("", "NoName"):
        told = (text(args[delimiter]), whole(args[delimiter + 1])) if len(args) > delimiter else (",", 0)
        return read_table(files, text(args[0]), table, *told)
    if table not in ("", "NoName"):
        raise RoutineFailed(f"the table `{table}` is in no file, and tables of C functions are not supported")
    shape = args[2].shape if isinstance(args[2], Tensor) else ()
    cells = numbers(args[2])
    if len(shape) != 2 or not cells:
        raise RoutineFailed("its matrix is empty")
    return [cells[i * shape[1] : (i + 1) * shape[1]] for i in range(shape[0])]


def _curves(
    data: Rows, chosen: Sequence[int], smoothness: Argument, extrapolation: Argument, *, may_repeat: bool
) -> tuple[Curve, ...]:
    kind = Smoothness(whole(smoothness))
    if len(data[0]) < 2:
        raise RoutineFailed(f"a table needs two columns, not {len(data[0])}")
    for column in chosen:
        if not 1 <= column <= len(data[0]):
            raise RoutineFailed(f"it has {len(data[0])} columns, and no column {column}")
    x = [row[0] for row in data]
    try:
        check_abscissas(x, kind, may_repeat=may_repeat)
    except BadTable as problem:
        raise RoutineFailed(str(problem)) from None
    outside = Extrapolation(whole(extrapolation))
    return tuple(
        Curve(tuple(x), tuple([row[column - 1] for row in data]), kind, outside) for column in chosen or (2,)
    )
