"""Strings have no numbers: those of parameters are put into the equations, others no run can compute."""

from __future__ import annotations

from dataclasses import replace

from acausal.errors import Diagnostic, UnsupportedProblem, fail
from acausal.lang.flat import STRING, FlatModel, Variable
from acausal.symbolic.alias import Simplified
from acausal.symbolic.expressions.expr import Expr, symbols
from acausal.symbolic.parameters import definition


def refuse_strings(model: Simplified) -> None:
    """Raises `UnsupportedProblem` where a variable of type String changes, or follows from an equation."""
    eliminated = {alias.name for alias in model.aliases}
    found = [v for v in model.flat.unknowns if v.type == STRING and v.name not in eliminated]
    if found:
        hint = "make it a parameter or a constant, or use an enumeration and write its text with String(...)"
        raise UnsupportedProblem(
            [
                Diagnostic(
                    "unsupported.string-variable",
                    f"the String `{variable.name}` would have to be computed during the run",
                    variable.span,
                    (variable.name,),
                    hint,
                )
                for variable in found
            ]
        )


def with_decided_strings(flat: FlatModel) -> FlatModel:
    """Parameters become structural that the Strings need which equations and other parameters read.

    Raises `UnsupportedProblem` where one of them is determined by the initial equations.
    """
    texts = dict.fromkeys(v.name for v in flat.parameters if v.type == STRING)
    if not any(symbols([value]) for name in texts if (value := definition(flat.by_name[name])) is not None):
        return flat
    pending = [name for name in symbols(_read(flat)) if name in texts]
    found: set[str] = set()
    while pending:
        name = pending.pop()
        variable = flat.by_name.get(name)
        if name in found or variable is None or not variable.is_parameter:
            continue
        if not variable.is_fixed:
            raise _determined_late(variable)
        found.add(name)
        value = definition(variable)
        pending += symbols([value]) if value is not None else ()
    if not found:
        return flat
    variables = [replace(v, structural=True) if v.name in found else v for v in flat.variables]
    return replace(flat, variables=tuple(variables))


def _determined_late(variable: Variable) -> UnsupportedProblem:
    message = f"a String depends on `{variable.name}`, which the initial equations determine"
    hint = "give it a value that is known before the run"
    name = variable.name
    code, span = "unsupported.string-variable", variable.span
    return fail(UnsupportedProblem, code, message, span, names=[name], hint=hint)


def _read(flat: FlatModel) -> list[Expr]:
    """All expressions whose values are numbers."""
    sides = [side for e in (*flat.equations, *flat.initial_equations) for side in (e.left, e.right)]
    sides += [assertion.condition for assertion in flat.assertions]
    for branch in (branch for when in flat.whens for branch in when.branches):
        sides += branch.conditions
        sides += [side for e in branch.equations for side in (e.left, e.right)]
        sides += [reset.value for reset in branch.reinits]
        sides += [assertion.condition for assertion in branch.assertions]
    values = [definition(v) for v in flat.parameters if v.type != STRING]
    values += [v.start for v in flat.unknowns]
    return [*sides, *(value for value in values if value is not None)]
