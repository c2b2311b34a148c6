"""Proof of what every later stage relies on in a flat model: names, types and variability.

`verify(flat)` raises `TypeProblem` with a diagnostic for each wrong declaration and equation:

- every name is declared once and every name used is declared (`flat.duplicate-name`, `flat.unknown-name`);
- every expression has a type (`type.*`, see `expression_types`), both sides of an equation have comparable
  types (`type.equation`), conditions are Boolean, values and attributes fit their variable (`type.value`,
  `type.attribute`), flows are Real;
- values of constants use constants only, those of parameters and all attributes use parameters at most
  (`flat.variability`); equations between discrete types are discrete on both sides (`type.discrete`, Modelica
  3.6, 3.8.5);
- Reals are not compared by `==` or `<>` (3.5: only in functions; the inliner puts those under `noEvent`,
  where it is accepted, as it is between parameters, which can raise no event);
- `pre` stands on discrete variables, except in initial equations and at events (when-clauses), where
  everything is discrete;
- when-clauses determine discrete variables and set continuous states anew (see `verify_when`).

Linear in the size of the model: each node of the shared expressions is typed once.
"""

from __future__ import annotations

from collections.abc import Iterator

from acausal.errors import Diagnostic, TypeProblem
from acausal.lang.expression_types import (
    REAL_CONTINUOUS,
    Kind,
    TypeMistake,
    article,
    assignable,
    comparable,
    short_text,
)
from acausal.lang.flat import (
    BOOLEAN,
    REAL,
    STRING,
    Equation,
    FlatModel,
    Origin,
    StateSelect,
    Variability,
    Variable,
)
from acausal.lang.flat_typing import Typing, mistake_in
from acausal.lang.verify_when import assertion_problems, when_problems
from acausal.symbolic.expressions.expr import TIME, Expr, symbols

_MOST = 20
_ADJECTIVE = {
    Variability.CONSTANT: "constant",
    Variability.PARAMETER: "a parameter",
    Variability.DISCRETE: "discrete",
    Variability.CONTINUOUS: "continuous",
}


def verify(flat: FlatModel) -> None:
    """Raise `TypeProblem` with all diagnostics (at most 20) unless the model is well formed."""
    found = list(_duplicates(flat))
    typing = Typing(flat.by_name)
    for variable in flat.variables:
        found += _variable(typing, variable)
    for equation in flat.equations:
        if equation.origin is not Origin.ALGORITHM:
            found += _equation(typing, equation, initial=False)
    for assertion in flat.assertions:
        found += assertion_problems(typing, assertion)
    typing.at_event = True
    for equation in flat.equations:
        if equation.origin is Origin.ALGORITHM:
            found += _equation(typing, equation, initial=False)
    for when in flat.whens:
        found += when_problems(typing, when)
    for equation in flat.initial_equations:
        found += _equation(typing, equation, initial=True)
    if found:
        raise TypeProblem(found[:_MOST])


# ------------------------------------------------------------------------------ declarations


def _duplicates(flat: FlatModel) -> Iterator[Diagnostic]:
    first: dict[str, Variable] = {}
    for variable in flat.variables:
        other = first.setdefault(variable.name, variable)
        if other is not variable:
            message = f"`{variable.name}` is declared twice"
            hint = f"the other declaration is at {other.span}"
            yield Diagnostic("flat.duplicate-name", message, variable.span, (variable.name,), hint)
        elif variable.name == TIME.name:
            message = "`time` is the simulation time and cannot be declared"
            yield Diagnostic("flat.duplicate-name", message, variable.span, ("time",), "use another name")


def _variable(typing: Typing, variable: Variable) -> Iterator[Diagnostic]:
    problem = _declaration_problem(variable)
    if problem is not None:
        yield Diagnostic(problem[0], problem[1], variable.span, (variable.name,))
    if variable.binding is not None:
        yield from _value(typing, variable, "value", variable.binding, min(variable.variability, 1))
    for attribute, value in (
        ("start", variable.start),
        ("min", variable.min),
        ("max", variable.max),
        ("nominal", variable.nominal),
    ):
        if value is not None:
            yield from _value(typing, variable, attribute, value, Variability.PARAMETER)


def _declaration_problem(variable: Variable) -> tuple[str, str] | None:
    """Code and message of what is wrong with the declaration itself."""
    name, its_type = variable.name, variable.type
    if variable.binding is not None and variable.is_unknown:
        return "flat.binding", f"the value of the variable `{name}` must be an equation of the flat model"
    if its_type == REAL:
        return None
    if variable.variability == Variability.CONTINUOUS:
        return "flat.variability", f"`{name}` is {article(its_type)} and so discrete, not continuous"
    if variable.flow:
        return "type.flow", f"the flow variable `{name}` must be a Real, not {article(its_type)}"
    real_only = {
        "unit": variable.unit,
        "displayUnit": variable.display_unit,
        "nominal": variable.nominal,
        "stateSelect": variable.state_select is not StateSelect.DEFAULT,
    }
    if its_type in (BOOLEAN, STRING):
        real_only |= {"min": variable.min, "max": variable.max}
    wrong = [attribute for attribute, value in real_only.items() if value]
    if wrong:
        return "type.attribute", f"`{name}` is {article(its_type)}, which has no attribute {wrong[0]}"
    return None


def _value(typing: Typing, variable: Variable, what: str, value: Expr, most: int) -> Iterator[Diagnostic]:
    """The type and the variability of a binding or an attribute."""
    try:
        found = typing.kind(value)
    except TypeMistake as mistake:
        yield mistake_in(mistake, variable.span, variable.name)
        return
    if not assignable(variable.type, found.type):
        message = (
            f"`{variable.name}` is {article(variable.type)}, but its {what} {short_text(value)} "
            f"is {article(found.type)}"
        )
        code = "type.value" if what == "value" else "type.attribute"
        yield Diagnostic(code, message, variable.span, (variable.name, *symbols([value])))
    if found.raw > most:
        yield _too_variable(typing, variable, what, value, Variability(most))


def _too_variable(
    typing: Typing, variable: Variable, what: str, value: Expr, most: Variability
) -> Diagnostic:
    variabilities = [(name, _variability(typing, name)) for name in symbols([value])]
    causes = [f"`{name}` is {_ADJECTIVE[found]}" for name, found in variabilities if found > most]
    whose = f"the {what} of the {_ADJECTIVE[variable.variability].split()[-1]} `{variable.name}`"
    if what != "value":
        whose = f"the attribute {what} of `{variable.name}`"
    allowed = "constants" if most is Variability.CONSTANT else "parameters and constants"
    reason = ", ".join(causes) or f"{short_text(value)} varies with time"
    message = f"{whose} may use {allowed} only, but {reason}"
    names = (variable.name, *(name for name, found in variabilities if found > most))
    return Diagnostic("flat.variability", message, variable.span, names)


def _variability(typing: Typing, name: str) -> Variability:
    return Variability.CONTINUOUS if name == TIME.name else typing.variables[name].variability


# ------------------------------------------------------------------------------ equations


def _equation(typing: Typing, equation: Equation, *, initial: bool) -> Iterator[Diagnostic]:
    try:
        left, right = typing.kind(equation.left), typing.kind(equation.right)
    except TypeMistake as mistake:
        yield mistake_in(mistake, equation.span)
        return
    if left is right is REAL_CONTINUOUS:
        return
    if not comparable(left.type, right.type):
        yield _different_types(equation, left, right)
    elif equation.origin is Origin.ALGORITHM:
        yield from _assigned(equation, left, right)
    elif not initial:
        yield from _discreteness(equation, ((equation.left, left), (equation.right, right)))


def _assigned(equation: Equation, left: Kind, right: Kind) -> Iterator[Diagnostic]:
    """What is assigned must not vary more than the variable (3.8)."""
    if left.variability is Variability.DISCRETE and right.variability is Variability.CONTINUOUS:
        message = f"{short_text(equation.left)} is discrete, but {short_text(equation.right)} is continuous"
        hint = "assign it in a when-statement, or use a relation outside noEvent"
        names = symbols([equation.left, equation.right])
        yield Diagnostic("type.discrete", message, equation.span, names, hint)


def _different_types(equation: Equation, left: Kind, right: Kind) -> Diagnostic:
    sides = (
        "connected variables" if equation.origin is Origin.CONNECTION else "the two sides of this equation"
    )
    first = f"{short_text(equation.left)} is {article(left.type)}"
    second = f"{short_text(equation.right)} is {article(right.type)}"
    message = f"{sides} have different types: {first}, {second}"
    return Diagnostic("type.equation", message, equation.span, symbols([equation.left, equation.right]))


def _discreteness(
    equation: Equation, sides: tuple[tuple[Expr, Kind], tuple[Expr, Kind]]
) -> Iterator[Diagnostic]:
    """Between discrete types neither side may be continuous; a Real side may always be solved for."""
    if REAL in (sides[0][1].type, sides[1][1].type):
        return
    for part, side in sides:
        if side.variability is Variability.CONTINUOUS:
            message = f"this equation is between discrete values, but {short_text(part)} is continuous"
            hint = "a relation such as `x > 0` is discrete outside noEvent"
            names = symbols([equation.left, equation.right])
            yield Diagnostic("type.discrete", message, equation.span, names, hint)
