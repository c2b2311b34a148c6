"""From names to values: which column of the rows, with which sign, or which constant; layouts of files."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acausal.errors import LookupProblem, fail
from acausal.results.signals import Layout, Signal
from acausal.simulate.names import NAME_IT_TOO, derivative_of_alias, did_you_mean, left_out
from acausal.symbolic.causal import CausalSystem
from acausal.symbolic.expressions.evaluate import evaluate
from acausal.symbolic.expressions.expr import Constant, Expr, neg
from acausal.symbolic.expressions.text import to_text


@dataclass(frozen=True)
class Place:
    """Where a name's values are: `factor` times a column of the rows, else the constant `value`."""

    column: int | None
    factor: float = 1.0
    value: float = 0.0


def place_of(
    system: CausalSystem, columns: Mapping[str, int], parameters: Mapping[str, float], name: str
) -> Place | None:
    """Follows aliases from a name to a column or to a constant; None where there is no such name."""
    sign, seen = derivative_of_alias(system, name) or (1.0, name)
    for _ in range(len(system.aliases) + 1):
        if seen in columns:
            return Place(columns[seen], sign)
        if seen in parameters:
            return Place(None, value=sign * parameters[seen])
        value = system.alias_values.get(seen)
        if value is None:
            return None
        if value.op == "neg" and value.args[0].op == "sym":
            sign, value = -sign, neg(value)
        if value.op != "sym":
            return Place(None, value=sign * _constant(value, parameters))
        seen = value.name
    return None


def _constant(value: Expr, parameters: Mapping[str, float]) -> float:
    def lookup(name: str) -> Constant | None:
        return parameters.get(name)

    number = evaluate(value, lookup)
    return float(number) if isinstance(number, int | float) else float("nan")


def unknown_name(system: CausalSystem, name: str, known: Iterable[str]) -> LookupProblem:
    """The error about a name that a result does not hold (`result.unknown-name`)."""
    removed = system.removed
    gone = removed is not None and any(v.name == name for v in removed.variables)
    message = left_out(name) if gone else f"the result has no variable `{name}`"
    hint = NAME_IT_TOO if gone else did_you_mean(name, known)
    return fail(LookupProblem, "result.unknown-name", message, names=[name], hint=hint)


def unit_of(system: CausalSystem, name: str) -> str:
    """The declared unit; that of `der(x)` is the unit of `x` per second."""
    variable = system.flat.by_name.get(name)
    if variable is not None:
        return variable.unit
    inner = system.flat.by_name.get(name[4:-1]) if name.startswith("der(") else None
    if inner is None or not inner.unit:
        return ""
    if inner.unit == "1":
        return "1/s"
    return f"({inner.unit})/s" if "/" in inner.unit else f"{inner.unit}/s"


def default_names(system: CausalSystem) -> tuple[str, ...]:
    """States and public variables of the top level (contract.md)."""
    top = [v.name for v in system.flat.unknowns if v.top_level and not v.protected]
    return tuple(dict.fromkeys([*system.states, *top]))


def layout_of(
    system: CausalSystem, leaves: Sequence[Expr], parameters: Mapping[str, float], names: Sequence[str]
) -> tuple[Layout, NDArray[np.int_]]:
    """The layout of a file with these signals, and the columns of the rows that go into it.

    Raises `LookupProblem` (`result.unknown-name`).
    """
    columns = {to_text(leaf): i for i, leaf in enumerate(leaves)}
    chosen: dict[int, int] = {}
    signals: list[Signal] = []
    for name in names:
        place = place_of(system, columns, parameters, name)
        if place is None:
            raise unknown_name(system, name, (*system.flat.by_name, *columns))
        variable = system.flat.by_name.get(name)
        text = variable.description if variable is not None else ""
        at = None if place.column is None else chosen.setdefault(place.column, len(chosen))
        signals.append(Signal(name, unit_of(system, name), text, at, place.factor, place.value))
    return Layout(system.flat.name, tuple(signals), len(chosen)), np.array(list(chosen), dtype=np.int_)
