"""What is doubtful about a solved initial problem: more solutions than one, values outside their range."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from acausal.codegen.functions import Code
from acausal.codegen.program import ImplicitCode
from acausal.errors import Diagnostic
from acausal.lang.flat import REAL, Variable
from acausal.simulate.call import residual_and_jacobian
from acausal.simulate.matrices import Vector, dependent_rows, row_sums, scaled, transposed
from acausal.simulate.messages import leaf_name, number
from acausal.symbolic.attributes import start_place
from acausal.symbolic.describe import equations_with_places, listed, place, quoted
from acausal.symbolic.expressions.evaluate import number_of
from acausal.symbolic.expressions.expr import Expr, sym
from acausal.symbolic.user_lines import moved_to_user

OUTSIDE = 1e-6
"""How far outside its range a value may be, relative to the bound and the nominal value (1 where none is)."""
_MOST = 5


def initial_warnings(code: Code, values: Vector, p: Vector) -> Iterator[Diagnostic]:
    """Warnings about the solution `values` (of all slots) with the parameters `p`."""
    for block in code.start_blocks:
        found = _many_solutions(code, block, values)
        if found is not None:
            yield moved_to_user(code.system.flat, found, code.system.equations)
    outside = _out_of_range(code, values, p)
    if outside is not None:
        yield moved_to_user(code.system.flat, outside)


def _many_solutions(code: Code, block: ImplicitCode, values: Vector) -> Diagnostic | None:
    """The warning for a block that is singular where it was solved."""
    slots, unknowns = code.initial.slots, block.block.tearing
    known = values[[slots[leaf] for leaf in block.reads]]
    _, jacobian = residual_and_jacobian(block.residual, values[[slots[leaf] for leaf in unknowns]], known)
    ones = np.ones(len(unknowns))
    sums = row_sums(jacobian, ones)
    matrix = scaled(jacobian, np.where(sums > 0, sums, 1.0), ones)
    rows, columns = dependent_rows(matrix), dependent_rows(transposed(matrix))
    if not rows or not columns:
        return None
    names = tuple(leaf_name(unknowns[i]) for i in columns)
    equations = [block.block.residuals[i].equation.flat for i in rows]
    texts = equations_with_places(equations)
    one = sorted(set(names) & set(code.system.states))[:1] or list(names[:1])
    return Diagnostic(
        "initialize.not-unique",
        f"the initial system has more solutions than one: with the others {texts} "
        f"do not say what {quoted(names)} is; one of them was taken",
        equations[0].span,
        names,
        f"replace one of the initial equations by a value, such as `{one[0]}` = ...",
        "warning",
    )


def _out_of_range(code: Code, values: Vector, p: Vector) -> Diagnostic | None:
    """The warning about all variables that start outside their `min` and `max`."""
    system = code.system
    parameters = dict(zip(system.parameters, p.tolist(), strict=True))
    found: list[tuple[Variable, str]] = []
    for variable in system.flat.unknowns:
        slot = code.initial.slots.get(sym(variable.name)) if variable.min or variable.max else None
        if slot is not None and variable.type == REAL:
            text = _beyond(variable, float(values[slot]), parameters)
            found += [(variable, text)] if text else []
    if not found:
        return None
    texts = [f"`{v.name}` {text} ({place(start_place(v))})" for v, text in found]
    return Diagnostic(
        "initialize.out-of-range",
        f"at the start, outside the range that is declared: {listed(texts)}",
        start_place(found[0][0]),
        tuple(v.name for v, _ in found[:_MOST]),
        "look for a wrong start value or sign, or for something that cannot be supplied",
        "warning",
    )


def _beyond(variable: Variable, value: float, parameters: dict[str, float]) -> str:
    """`= -3 is below 0`; "" for a value within its range."""
    low, high = (_bound(bound, parameters) for bound in (variable.min, variable.max))
    nominal = _bound(variable.nominal, parameters) or 1.0
    for bound, sign, word in ((low, 1, "below"), (high, -1, "above")):
        if bound is not None and sign * (bound - value) > OUTSIDE * max(abs(nominal), abs(bound)):
            return f"= {number(value)} is {word} {number(bound)}"
    return ""


def _bound(bound: Expr | None, parameters: dict[str, float]) -> float | None:
    return None if bound is None else number_of(bound, parameters.get)
