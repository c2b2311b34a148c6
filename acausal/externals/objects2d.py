"""External objects: tables of two arguments. Apart from the others, because they need NumPy."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

from acausal.externals.arguments import Argument, RoutineFailed, whole
from acausal.externals.files import Files
from acausal.externals.objects import ExternalObject, rows_of
from acausal.externals.table1d import BadTable, Extrapolation, Smoothness, check_abscissas
from acausal.externals.table2d import Surface
from acausal.symbolic.expressions.kernel import digest
from acausal.symbolic.expressions.kernels.patches import Patches

_POINT = Surface((0.0,), (0.0,), ((0.0,),), Smoothness.LINEAR, Extrapolation.HOLD)


@dataclass(frozen=True, eq=False)
class SurfaceObject(ExternalObject):
    """A table of two arguments."""

    surface: Surface = _POINT

    def kernel(self) -> Patches:
        """The surface as a kernel, under the name of the component."""
        return _patches(self.surface, self.name)


@lru_cache(maxsize=64)
def _patches(surface: Surface, name: str) -> Patches:
    return surface.kernel(name)


def table_2d(args: Sequence[Argument], files: Files) -> ExternalObject:
    """(file, table, matrix, rows, columns, smoothness, extrapolation, verbose, delimiter, header lines)."""
    data = rows_of(args, files, delimiter=8)
    if len(data) < 2 or len(data[0]) < 2:
        sizes = f"{len(data)} times {len(data[0])}"
        raise RoutineFailed(f"a table of two arguments needs two rows and columns, not {sizes}")
    u, v = [row[0] for row in data[1:]], data[0][1:]
    smoothness = Smoothness(whole(args[5]))
    for grid, what in ((u, "column"), (v, "row")):
        try:
            check_abscissas(grid, smoothness, may_repeat=False)
        except BadTable as problem:
            raise RoutineFailed(str(problem).replace("column", what)) from None
    values = tuple(tuple(row[1:]) for row in data[1:])
    surface = Surface(tuple(u), tuple(v), values, smoothness, Extrapolation(whole(args[6])))
    try:
        surface.kernel("table")
    except BadTable as problem:
        raise RoutineFailed(str(problem)) from None
    return SurfaceObject("table", digest("2D", surface), surface=surface)
