"""Where the declared units of a flat model do not fit together.

- `unit.clash` (error): two parts whose units are certain (see `unit_inference`) meet in an equation, a
  connection, a binding, a start value, a bound, a sum, a comparison or an `if`, and differ. The factor
  counts: `unit = "bar"` equated to `unit = "Pa"` is wrong, for `unit` is what equations compute in; what is
  shown is `displayUnit`. `rad` and `1` are one unit.
- `unit.suspect` (warning): the same, but one part is doubtful, and not even the dimensions agree.
- `unit.argument` (warning): the argument of `exp`, `sin`, ... has a unit (or is an angle that is not in rad).
- `unit.malformed` and `unit.display` (warnings): a text that is no unit; a `displayUnit` of another quantity.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from acausal.errors import Diagnostic, Severity, Span
from acausal.lang.flat import REAL, Equation, FlatModel, Origin, Variable
from acausal.lang.unit_inference import NUMBER, UNKNOWN, Clash, Inference, Measure, compare
from acausal.lang.units import ONE, MalformedUnit, Unit, format_unit, parse_unit, same_dimensions, same_unit
from acausal.symbolic.expressions.expr import Expr, sym, symbols
from acausal.symbolic.expressions.text import beginning

_LONGEST = 60
_MOST_CLASHES = 5
"""Clashes shown of one equation: where there are more, one follows from the other."""
_MOST_NAMES = 6
_ATTRIBUTES = ("binding", "start", "min", "max", "nominal")


@dataclass(frozen=True, slots=True)
class _Place:
    """Where something was found: the source, and how the message begins."""

    span: Span
    context: str
    hint: str


def check_units(flat: FlatModel) -> tuple[Diagnostic, ...]:
    """Everything that can be said about the units of a model, errors and warnings; linear in its size."""
    inference = Inference()
    found = list(_declarations(flat))
    for variable in flat.variables:
        inference.memo[sym(variable.name)] = _declared_measure(variable)
    _declare_results(flat, inference)
    for variable in flat.variables:
        found += _attributes(flat, inference, variable)
    clauses = [equation for when in flat.whens for branch in when.branches for equation in branch.equations]
    for equation in (*flat.equations, *flat.initial_equations, *clauses):
        found += _equation(flat, inference, equation)
    for assertion in flat.assertions:
        inference.measure(assertion.condition)
        found += _noticed(flat, inference, _Place(assertion.span, "in this assertion", _CONVERT))
    return tuple(found)


# ------------------------------------------------------------------------------ declarations


def _declared_measure(variable: Variable) -> Measure:
    if variable.type != REAL:
        return NUMBER if variable.type.is_numeric else UNKNOWN
    unit = parse_unit(variable.unit) if variable.unit else None
    return Measure(unit, certain=True) if isinstance(unit, Unit) else UNKNOWN


def _declare_results(flat: FlatModel, inference: Inference) -> None:
    """What functions declare of their results; a variable handed through becomes doubtful."""
    for result, text in flat.declared_units:
        unit = parse_unit(text)
        inference.declared[result] = unit if isinstance(unit, Unit) else None
        known = inference.memo.get(result)
        if known is not None:
            inference.memo[result] = inference.as_declared(result, known)


def _declarations(flat: FlatModel) -> Iterator[Diagnostic]:
    """Malformed units and display units of another quantity: each pair once, with its users."""
    users: dict[tuple[str, str], list[Variable]] = {}
    for variable in flat.variables:
        if variable.unit or variable.display_unit:
            users.setdefault((variable.unit, variable.display_unit), []).append(variable)
    reported: set[str] = set()
    for (text, display_text), variables in users.items():
        span, names = variables[0].span, tuple(v.name for v in variables[:_MOST_NAMES])
        parsed = {part: parse_unit(part) for part in (text, display_text) if part}
        for part, unit in parsed.items():
            if isinstance(unit, MalformedUnit) and part not in reported:
                reported.add(part)
                message = f'"{part}" is not a unit: {unit.reason}; {_is_are(names)} taken without unit'
                yield Diagnostic("unit.malformed", message, span, names, unit.hint, "warning")
        unit, display = parsed.get(text), parsed.get(display_text)
        if isinstance(unit, Unit) and isinstance(display, Unit) and not same_dimensions(unit, display):
            message = f'displayUnit "{display_text}" cannot show a value in "{text}": another quantity'
            yield Diagnostic("unit.display", message, span, names, severity="warning")


def _is_are(names: tuple[str, ...]) -> str:
    quoted = ", ".join(f"`{name}`" for name in names)
    return f"{quoted} {'is' if len(names) == 1 else 'are'}"


def _attributes(flat: FlatModel, inference: Inference, variable: Variable) -> Iterator[Diagnostic]:
    left = sym(variable.name)
    for attribute in _ATTRIBUTES:
        value: Expr | None = getattr(variable, attribute)
        if value is None or value.is_const:
            continue
        what = "value" if attribute == "binding" else f"attribute {attribute}"
        place = _Place(variable.span, f"`{variable.name}` and its {what} have different units", _CONVERT)
        measure = inference.measure(value)
        yield from _noticed(flat, inference, _Place(variable.span, f"in the {what} of `{variable.name}`", ""))
        clash = compare(left, value, inference.memo[left], measure)
        if clash is not None and clash.certain and same_unit(clash.left_unit, ONE):
            clash = replace(clash, certain=False)  # factors are declared so, and given values with a unit
        if clash is not None:
            yield _diagnostic(flat, clash, place)


# ------------------------------------------------------------------------------ equations

_CONVERT = "declare the unit that is meant, or convert with a parameter that carries the units"
_CONTEXTS = {
    Origin.EQUATION: ("the two sides have different units", "in this equation", _CONVERT),
    Origin.BINDING: ("the declared variable and its value have different units", "in this value", _CONVERT),
    Origin.CONNECTION: (
        "connected variables have different units",
        "in this connection",
        "connect only connectors whose variables declare the same units, or put a converter between them",
    ),
    Origin.FLOW_BALANCE: (
        "a connection adds flows of different units",
        "this connection's flows",
        "connect only connectors whose flow variables declare the same unit",
    ),
    Origin.UNCONNECTED: ("the two sides have different units", "in this equation", _CONVERT),
    Origin.ALGORITHM: ("this variable and its value have different units", "in this algorithm", _CONVERT),
}


def _alternatives(inference: Inference, equation: Equation) -> list[Equation]:
    """`0 = if c then a else b` states `0 = a` or `0 = b`: the branches need no common unit."""
    for zero, other in ((equation.left, equation.right), (equation.right, equation.left)):
        inner = other
        while inner.op in ("noEvent", "smooth", "neg"):
            inner = inner.args[-1]
        if inner.op == "if" and zero.is_const and zero.value == 0:
            inference.measure(inner.args[0])
            return [replace(equation, left=branch, right=zero) for branch in inner.args[1:]]
    return []


def _equation(flat: FlatModel, inference: Inference, equation: Equation) -> Iterator[Diagnostic]:
    sides, inside, hint = _CONTEXTS[equation.origin]
    if equation.left.is_const or equation.right.is_const:
        alternatives = _alternatives(inference, equation)
        for alternative in alternatives:
            yield from _equation(flat, inference, alternative)
        if alternatives:
            return
    left, right = inference.measure(equation.left), inference.measure(equation.right)
    if equation.origin is Origin.FLOW_BALANCE:
        inside = sides
    yield from _noticed(flat, inference, _Place(equation.span, inside, hint))
    clash = compare(equation.left, equation.right, left, right)
    if clash is not None:
        yield _diagnostic(flat, clash, _Place(equation.span, sides, hint))


def _noticed(flat: FlatModel, inference: Inference, place: _Place) -> Iterator[Diagnostic]:
    """What the walk since the last call found inside expressions."""
    for clash in inference.clashes[:_MOST_CLASHES]:
        yield _diagnostic(flat, clash, place)
    for function, argument, unit in inference.arguments:
        text = _described(flat, argument, unit)
        message = f"{place.context}, {function} needs a plain number or an angle in rad, but {text}"
        hint = "divide by a reference value that has the same unit"
        yield Diagnostic("unit.argument", message, place.span, symbols([argument]), hint, "warning")
    inference.clashes.clear()
    inference.arguments.clear()


def _diagnostic(flat: FlatModel, clash: Clash, place: _Place) -> Diagnostic:
    severity: Severity = "error" if clash.certain else "warning"
    left = _described(flat, clash.left, clash.left_unit)
    right = _described(flat, clash.right, clash.right_unit)
    within = "" if clash.node is None else f" within `{_short(clash.node)}`"
    hint = place.hint
    if same_dimensions(clash.left_unit, clash.right_unit):
        hint = _same_quantity(flat, clash)
    elif not clash.certain:
        hint = "if a number stands for a quantity, make it a parameter with a unit"
    return Diagnostic(
        "unit.clash" if clash.certain else "unit.suspect",
        f"{place.context}: {left}, {right}{within}",
        place.span,
        symbols([clash.left, clash.right]),
        hint,
        severity,
    )


def _same_quantity(flat: FlatModel, clash: Clash) -> str:
    left = _unit_text(flat, clash.left, clash.left_unit)
    right = _unit_text(flat, clash.right, clash.right_unit)
    if clash.left_unit.offset == clash.right_unit.offset:
        ratio = clash.left_unit.factor / clash.right_unit.factor
        both = f"1 {left} is {ratio:.10g} {right}"
    else:
        both = f"{left} and {right} have different zero points"
    return f"{both}: convert, or use one unit for both and show the other with displayUnit"


def _described(flat: FlatModel, part: Expr, unit: Unit) -> str:
    return f"`{_short(part)}` is in {_unit_text(flat, part, unit)}"


def _unit_text(flat: FlatModel, part: Expr, unit: Unit) -> str:
    """As declared where the part is a variable."""
    variable = flat.by_name.get(part.name) if part.op == "sym" else None
    return variable.unit if variable is not None else format_unit(unit)


def _short(part: Expr) -> str:
    text = beginning(part, _LONGEST)
    return text if len(text) <= _LONGEST else text[: _LONGEST - 3] + "..."
