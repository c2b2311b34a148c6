"""Attributes of a class of aliases: which member represents it, and what the others pass on to it.

Rules, for members x = s*r with s = +1 or -1:

- Representative: highest stateSelect, then differentiated, then `fixed = true`, then with a start value, then
  fewest dots in the name (a connector's variable yields to its component's own), then declared first.
- `fixed` is true if it is for any member. Two fixed starts of different value are an error.
- `start`: a fixed member's, else the representative's, else that of the member with the fewest dots.
- `nominal`: the representative's, else that of the member with the fewest dots.
- `min`, `max`: the tightest of all members, where they can be computed; a negated alias swaps them.
- `stateSelect`: the highest one given that is not `default`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import inf

from acausal.errors import Diagnostic, InitializationProblem, Span
from acausal.lang.flat import StateSelect, Variable
from acausal.symbolic.describe import dots, place
from acausal.symbolic.expressions.expr import Expr, const, neg
from acausal.symbolic.expressions.text import to_text
from acausal.symbolic.parameters import ParameterValues

Member = tuple[Variable, int]
"""A member of a class and its sign relative to the representative."""

_TOLERANCE = 1e-9


def representative_key(variable: Variable, differentiated: bool, position: int) -> tuple[object, ...]:
    """The smallest key represents the class."""
    return (
        -variable.state_select,
        not differentiated,
        not variable.fixed,
        variable.start is None,
        dots(variable.name),
        position,
    )


def signed(expr: Expr, sign: int) -> Expr:
    """`expr` or its negation."""
    return expr if sign > 0 else neg(expr)


def start_or_default(variable: Variable, values: ParameterValues) -> Expr:
    """The start value, else Modelica's default: 0, false, or the nearest value within min and max."""
    if variable.start is not None:
        return variable.start
    if variable.type.name == "Boolean":
        return const(False)
    if variable.type.name == "String":
        return const("")
    if variable.type.is_enumeration or variable.type.name == "Integer":
        return variable.min if variable.min is not None else const(1 if variable.type.is_enumeration else 0)
    low, high = (None if bound is None else values.number(bound) for bound in (variable.min, variable.max))
    if variable.min is not None and low is not None and low > 0:
        return variable.min
    if variable.max is not None and high is not None and high < 0:
        return variable.max
    return const(0.0)


def same_value(a: Expr, b: Expr, values: ParameterValues) -> bool | None:
    """Whether two parameter expressions are equal to 1e-9; None if that cannot be told yet."""
    if a is b:
        return True
    left, right = values.constant(a), values.constant(b)
    if left is None or right is None:
        return None
    if isinstance(left, int | float) and isinstance(right, int | float):
        return abs(left - right) <= _TOLERANCE * max(abs(left), abs(right))
    return left == right


def merged(members: Sequence[Member], values: ParameterValues) -> Variable:
    """The representative (the first member) with what the others pass on; the rest sorted by nearness.

    Raises InitializationProblem `start.conflict`.
    """
    first = members[0][0]
    if not any(_passes_on(variable) for variable, _ in members[1:]):
        return first
    nearest = [members[0], *sorted(members[1:], key=lambda member: dots(member[0].name))]
    fixed = fixed_start(nearest, values)
    start = fixed if fixed is not None else _first_start(nearest)
    bounds = (
        _bounds(nearest, values) if any(v.min is not None or v.max is not None for v, _ in nearest) else {}
    )
    nominal = next((v.nominal for v, _ in nearest if v.nominal is not None), None)
    given = [v.state_select for v, _ in nearest if v.state_select is not StateSelect.DEFAULT]
    return replace(
        first,
        start=start,
        fixed=True if fixed is not None else first.fixed,
        nominal=nominal,
        state_select=max(given, default=StateSelect.DEFAULT),
        **bounds,
    )


def _passes_on(variable: Variable) -> bool:
    """Whether a member says anything that its representative could take over."""
    return (
        variable.start is not None
        or bool(variable.fixed)
        or variable.nominal is not None
        or variable.min is not None
        or variable.max is not None
        or variable.state_select is not StateSelect.DEFAULT
    )


def _first_start(members: Sequence[Member]) -> Expr | None:
    return next((signed(v.start, sign) for v, sign in members if v.start is not None), None)


def fixed_start(members: Sequence[Member], values: ParameterValues) -> Expr | None:
    """The start value the class is fixed at, None if it is not; two different ones are an error."""
    fixed = [(v, signed(start_or_default(v, values), sign), sign) for v, sign in members if v.fixed]
    for variable, start, sign in fixed[1:]:
        if same_value(fixed[0][1], start, values) is False:
            raise start_conflict(fixed[0][0], variable, opposite=sign != fixed[0][2])
    return fixed[0][1] if fixed else None


def start_place(variable: Variable) -> Span:
    """Where the start value is given, or else the variable declared."""
    return variable.start_span or variable.span


def start_conflict(a: Variable, b: Variable, *, opposite: bool = False) -> InitializationProblem:
    """Two variables that are always equal (or opposite) are fixed at different start values."""
    relation = "the negative" if opposite else "an alias"

    def diagnostic(variable: Variable, other: Variable) -> Diagnostic:
        own, its = (to_text(v.start) if v.start is not None else "0" for v in (variable, other))
        return Diagnostic(
            "start.conflict",
            f"in the initial system `{variable.name}` is fixed at {own}, "
            f"but it is {relation} of `{other.name}` ({place(start_place(other))}), which is fixed at {its}",
            start_place(variable),
            (variable.name, other.name),
            "remove `fixed = true` from one of them, or make their start values agree",
        )

    return InitializationProblem([diagnostic(a, b), diagnostic(b, a)])


def contradictions(members: Sequence[Member], values: ParameterValues) -> Iterator[Diagnostic]:
    """Warnings about attributes of aliases that do not fit together."""
    selects = {v.state_select: v for v, _ in reversed(members)}
    always, never = selects.get(StateSelect.ALWAYS), selects.get(StateSelect.NEVER)
    if always is not None and never is not None:
        yield Diagnostic(
            "alias.state-select",
            f"`{never.name}` has stateSelect = StateSelect.never, but it is an alias of `{always.name}` "
            f"({place(always.span)}), which has StateSelect.always: that counts",
            never.span,
            (never.name, always.name),
            "give both the same stateSelect",
            "warning",
        )
    lows, highs = [(-inf, members[0][0])], [(inf, members[0][0])]
    for variable, sign in members:
        for bound, own in ((variable.min, lows), (variable.max, highs)):
            number = None if bound is None else values.number(bound)
            if number is not None:
                (own if sign > 0 else highs if own is lows else lows).append((sign * number, variable))
    (low, lowest), (high, highest) = max(lows, key=_number), min(highs, key=_number)
    if low > high:
        yield Diagnostic(
            "alias.range",
            f"no value is in the range of `{lowest.name}`, at least {low:g}, and in that of its alias "
            f"`{highest.name}` ({place(highest.span)}), at most {high:g}",
            lowest.span,
            (lowest.name, highest.name),
            "correct one of `min` and `max`, or the equation that makes them equal",
            "warning",
        )


def _number(bound: tuple[float, Variable]) -> float:
    return bound[0]


def _bounds(members: Sequence[Member], values: ParameterValues) -> dict[str, Expr | None]:
    """The tightest min and max."""
    lows: list[Expr] = []
    highs: list[Expr] = []
    for variable, sign in members:
        low, high = (variable.min, variable.max) if sign > 0 else (variable.max, variable.min)
        lows += [] if low is None else [signed(low, sign)]
        highs += [] if high is None else [signed(high, sign)]
    return {"min": _tightest(lows, 1, values), "max": _tightest(highs, -1, values)}


def _tightest(bounds: list[Expr], direction: int, values: ParameterValues) -> Expr | None:
    known = [
        (direction * number, -i) for i, e in enumerate(bounds) if (number := values.number(e)) is not None
    ]
    if not known:
        return bounds[0] if bounds else None
    return bounds[-max(known)[1]]
