"""External objects in expressions, and the table functions applied to them (Modelica 3.6, 12.9.7)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from acausal.errors import Span
from acausal.externals.arguments import Argument, RoutineFailed
from acausal.externals.files import Files
from acausal.externals.objects import ExternalObject, TableObject, table_1d, time_table
from acausal.externals.table1d import Extrapolation
from acausal.lang.arithmetic import as_scalar, as_value, type_error
from acausal.lang.flat import Assertion
from acausal.lang.translation import Translation
from acausal.lang.values import AnyValue, Value, real
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.diff import partial
from acausal.symbolic.expressions.expr import Expr

if TYPE_CHECKING:  # tables of two arguments load NumPy
    from acausal.externals.objects2d import SurfaceObject

Constructor = Callable[[Sequence[Argument], Files], ExternalObject]


def _table_2d(args: Sequence[Argument], files: Files) -> ExternalObject:
    from acausal.externals.objects2d import table_2d

    return table_2d(args, files)


_TABLES: dict[str, Constructor] = {
    "CombiTable1D": table_1d,
    "CombiTimeTable": time_table,
    "CombiTable2D": _table_2d,
}
CONSTRUCTORS: dict[str, Constructor] = {
    f"ModelicaStandardTables_{name}_{version}": build
    for name, build in _TABLES.items()
    for version in ("init2", "init3")
}
_ROUNDING = 1e-12


class Application:
    """One call of a function of an external object: `args` are its arguments behind the object."""

    def __init__(
        self, translation: Translation, found: ExternalObject, args: Sequence[AnyValue], span: Span
    ) -> None:
        self.translation = translation
        self.found = found
        self.args = args
        self.span = span

    @property
    def table(self) -> TableObject:
        if not isinstance(self.found, TableObject):
            raise RoutineFailed(f"`{self.found.name}` is not a table of this kind")
        return self.found

    @property
    def surface(self) -> SurfaceObject:
        from acausal.externals.objects2d import SurfaceObject

        if not isinstance(self.found, SurfaceObject):
            raise RoutineFailed(f"`{self.found.name}` is not a table of this kind")
        return self.found

    def item(self, position: int) -> Expr:
        """A scalar argument. Raises `RoutineFailed` when there are too few."""
        if position >= len(self.args):
            raise RoutineFailed(f"an external call with {len(self.args) + 1} arguments needs more of them")
        return as_scalar(as_value(self.args[position], self.span), self.span).item

    def index(self) -> int:
        """The first argument, a number of a column."""
        value = self.translation.evaluate_expr(self.item(0), self.span, "the column of a table")
        return int(value) if isinstance(value, (int, float)) else 0

    def inside(self, value: Expr, low: float, high: float) -> None:
        """Assert that an argument lies in the table, where it must."""
        below = ex.no_event(ex.relation("ge", value, ex.const(low)))
        above = ex.no_event(ex.relation("le", value, ex.const(high)))
        text = ex.const(f"the argument of {self.found.name} lies outside the table, from {low} to {high}")
        condition = ex.logical_and(below, above)
        self.translation.assertions.append(Assertion(condition, text, "error", self.span))


def object_of(translation: Translation, value: AnyValue, span: Span) -> ExternalObject:
    """The object that an expression stands for. Raises `TypeProblem`."""
    item = as_scalar(as_value(value, span), span).item
    if item.op == "sym":
        leaf = translation.leaf(item.name)
        if leaf is not None and leaf.type.external:
            return translation.externals.object(leaf)
    elif item.op == "call" and isinstance(item.kernel, ExternalObject):
        return item.kernel
    raise type_error("external.object", "this is not an external object known at compile time", span)


# ------------------------------------------------------------------------------ tables of one argument


def _curve(call: Application, u: Expr) -> Expr:
    kernel = call.table.column(call.index())
    if call.table.extrapolation is Extrapolation.NONE:
        call.inside(u, *call.table.domain)
    return ex.apply(kernel, u, u)


def _value_1d(call: Application) -> AnyValue:
    return real(_curve(call, call.item(1)))


def _slope_1d(call: Application) -> AnyValue:
    """(column, u, der u)."""
    return real(_slope(_curve(call, ex.sym("u")), {"u": (call.item(1), call.item(2))}))


def _second_1d(call: Application) -> AnyValue:
    """(column, u, der u, second derivative of u)."""
    u = (call.item(1), call.item(2), call.item(3))
    return real(_slope(_curve(call, ex.sym("u")), {"u": u}))


def _minimum(call: Application) -> AnyValue:
    return real(ex.const(call.table.domain[0]))


def _maximum(call: Application) -> AnyValue:
    return real(ex.const(call.table.domain[1]))


# ------------------------------------------------------------------------------ tables over time


def _over_time(call: Application, time: Expr, next_event: Expr) -> Expr:
    """The piece is that left of `next_event` from there on, else the one right of `time`."""
    table = call.table
    kernel = table.column(call.index())
    selector = time
    if table.chooses_by_event:
        selector = ex.no_event(
            ex.if_then_else(
                ex.relation("ge", time, next_event), _moved(table, next_event, -1), _moved(table, time, 1)
            )
        )
    if table.extrapolation is Extrapolation.NONE:
        call.inside(time, table.domain[0] + table.shift, table.domain[1] + table.shift)
    shift = ex.const(table.shift)
    value = ex.apply(kernel, ex.sub(selector, shift), ex.sub(time, shift))
    before = ex.relation("lt", selector, ex.const(table.start))
    begun = ex.if_then_else(before, ex.ZERO, value)
    return ex.smooth(kernel.continuity + 1, begun) if kernel.continuity >= 0 else ex.no_event(begun)


def _moved(table: TableObject, time: Expr, sign: int) -> Expr:
    """A little before or after: more than the rounding of event times, less than any interval."""
    low, high = table.domain
    size = ex.add(ex.const((high - low) * _ROUNDING), ex.mul(ex.const(_ROUNDING), ex.function("abs", time)))
    return ex.add(time, size if sign > 0 else ex.neg(size))


def _value_time(call: Application) -> AnyValue:
    """(column, time, next event, next event before)."""
    return real(_over_time(call, call.item(1), call.item(2)))


def _slope_time(call: Application) -> AnyValue:
    """(column, time, next event, next event before, der time)."""
    value = _over_time(call, ex.sym("u"), call.item(2))
    return real(_slope(value, {"u": (call.item(1), call.item(4))}))


def _second_time(call: Application) -> AnyValue:
    """(column, time, next event, next event before, der time, second derivative of time)."""
    value = _over_time(call, ex.sym("u"), call.item(2))
    return real(_slope(value, {"u": (call.item(1), call.item(4), call.item(5))}))


def _next_event(call: Application) -> AnyValue:
    """The first event beyond the time; before the start of a periodic table that is its start."""
    time = _moved(call.table, call.item(0), 1)
    start = ex.const(call.table.start)
    following = ex.apply(call.table.next_event(), time, time)
    if call.table.extrapolation is Extrapolation.PERIODIC:
        following = ex.no_event(ex.if_then_else(ex.relation("lt", time, start), start, following))
    return real(following)


# ------------------------------------------------------------------------------ tables of two arguments


def _on_surface(call: Application, u: Expr, v: Expr) -> Expr:
    surface = call.surface.surface
    if surface.extrapolation is Extrapolation.NONE:
        for value, grid in ((u, surface.u), (v, surface.v)):
            if len(grid) > 1:
                call.inside(value, grid[0], grid[-1])
    return ex.apply(call.surface.kernel(), u, v)


def _value_2d(call: Application) -> AnyValue:
    return real(_on_surface(call, call.item(0), call.item(1)))


def _slope_2d(call: Application) -> AnyValue:
    """(u, v, der u, der v)."""
    value = _on_surface(call, ex.sym("u"), ex.sym("v"))
    return real(_slope(value, {"u": (call.item(0), call.item(2)), "v": (call.item(1), call.item(3))}))


def _second_2d(call: Application) -> AnyValue:
    """(u, v, der u, der v, second derivatives of u and v)."""
    value = _on_surface(call, ex.sym("u"), ex.sym("v"))
    u, v = ((call.item(i), call.item(i + 2), call.item(i + 4)) for i in (0, 1))
    return real(_slope(value, {"u": u, "v": v}))


def _corner(index: int) -> Callable[[Application], AnyValue]:
    def corner(call: Application) -> AnyValue:
        surface = call.surface.surface
        items = tuple([ex.const(grid[index]) for grid in (surface.u, surface.v)])
        return Value(real(ex.ZERO).type, (2,), items)

    return corner


# ------------------------------------------------------------------------------ derivatives


def _slope(root: Expr, arguments: dict[str, tuple[Expr, ...]]) -> Expr:
    """The time derivative of `root`, as often as there are derivatives of its arguments."""
    order = len(next(iter(arguments.values()))) - 1
    chain: dict[Expr, Expr] = {}
    for name, values in arguments.items():
        symbols = [ex.sym(f"{name}{'_' * i}") for i in range(len(values))]
        chain |= dict(pairwise(symbols))
    result = root
    for _ in range(order):
        result = ex.add(
            *[
                ex.mul(partial(result, symbol), slope)
                for symbol, slope in chain.items()
                if symbol in ex.unknown_leaves(result)
            ],
            ex.ZERO,
        )
    actual = {
        ex.sym(f"{name}{'_' * i}"): value
        for name, values in arguments.items()
        for i, value in enumerate(values)
    }
    return ex.substitute(result, actual)


Applied = Callable[[Application], AnyValue]
APPLICATIONS: dict[str, Applied] = {
    "CombiTable1D_getValue": _value_1d,
    "CombiTable1D_getDerValue": _slope_1d,
    "CombiTable1D_getDer2Value": _second_1d,
    "CombiTable1D_minimumAbscissa": _minimum,
    "CombiTable1D_maximumAbscissa": _maximum,
    "CombiTimeTable_getValue": _value_time,
    "CombiTimeTable_getDerValue": _slope_time,
    "CombiTimeTable_getDer2Value": _second_time,
    "CombiTimeTable_minimumTime": _minimum,
    "CombiTimeTable_maximumTime": _maximum,
    "CombiTimeTable_nextTimeEvent": _next_event,
    "CombiTable2D_getValue": _value_2d,
    "CombiTable2D_getDerValue": _slope_2d,
    "CombiTable2D_getDer2Value": _second_2d,
    "CombiTable2D_minimumAbscissa": _corner(0),
    "CombiTable2D_maximumAbscissa": _corner(-1),
}
"""What follows `ModelicaStandardTables_` in the functions' names."""
