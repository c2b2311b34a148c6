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
- `pre` stands on discrete variables, except in initial equations, where everything is discrete.

Linear in the size of the model: each node of the shared expressions is typed once.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from difflib import get_close_matches

from acausal.errors import Diagnostic, Span, TypeProblem
from acausal.lang.expression_types import (
    EQUALITIES,
    REAL_CONTINUOUS,
    Kind,
    TypeMistake,
    article,
    assignable,
    comparable,
    kind,
    kind_of,
    short_text,
)
from acausal.lang.flat import (
    BOOLEAN,
    REAL,
    STRING,
    Assertion,
    Equation,
    FlatModel,
    Origin,
    StateSelect,
    Variability,
    Variable,
)
from acausal.symbolic.expressions.expr import TIME, Expr, fold, symbols

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
    typing = _Typing(flat.by_name)
    for variable in flat.variables:
        found += _variable(typing, variable)
    for equation in flat.equations:
        found += _equation(typing, equation, initial=False)
    for assertion in flat.assertions:
        found += _assertion(typing, assertion)
    typing.initial = True
    for equation in flat.initial_equations:
        found += _equation(typing, equation, initial=True)
    if found:
        raise TypeProblem(found[:_MOST])


# ------------------------------------------------------------------------------ expressions


@dataclass
class _Typing:
    """Kinds of the nodes met so far, for one run."""

    variables: dict[str, Variable]
    initial: bool = False
    memo: dict[Expr, Kind] = field(default_factory=lambda: {TIME: REAL_CONTINUOUS})
    equalities: dict[Expr, None] = field(default_factory=dict[Expr, None])
    """Comparisons of Reals by `==` or `<>` that may raise events."""
    searched: set[Expr] = field(default_factory=set[Expr])

    def kind(self, root: Expr) -> Kind:
        """The kind of an expression that stands in the model; raises `TypeMistake`."""
        found = self.memo.get(root)
        if found is None:
            found = fold([root], self.visit, self.memo)[root]
        if self.equalities:
            self.refuse_equalities(root)
        return found

    def visit(self, node: Expr, args: list[Kind]) -> Kind:
        if node.op == "sym":
            return self.symbol(node)
        result = kind_of(node, args)
        if node.op in EQUALITIES and REAL in (args[0].type, args[1].type):
            if result.raw > Variability.PARAMETER:
                self.equalities[node] = None
        elif node.op == "pre" and args[0].variability > Variability.DISCRETE and not self.initial:
            message = f"pre needs a discrete variable, but {short_text(node.args[0])} is continuous"
            raise TypeMistake("type.pre", message, node)
        return result

    def symbol(self, node: Expr) -> Kind:
        variable = self.variables.get(node.name)
        if variable is None:
            near = get_close_matches(node.name, self.variables, 1)
            hint = f"did you mean `{near[0]}`?" if near else ""
            raise TypeMistake("flat.unknown-name", f"`{node.name}` is not declared", node, hint)
        return kind(variable.type, variable.variability)

    def refuse_equalities(self, root: Expr) -> None:
        """Look for them outside `noEvent`; what was searched without finding any is not searched again."""
        stack = [root]
        while stack:
            node = stack.pop()
            if node in self.equalities:
                message = (
                    f"{short_text(node)} compares Reals for equality, which is allowed in functions only"
                )
                hint = "use `<` or `>`, or a tolerance: `abs(a - b) < eps`"
                raise TypeMistake("type.real-equality", message, node, hint)
            if node not in self.searched and node.op != "noEvent":
                self.searched.add(node)
                stack.extend(node.args)


def _mistake(mistake: TypeMistake, span: Span, *names: str) -> Diagnostic:
    all_names = tuple(dict.fromkeys([*names, *symbols([mistake.node])]))
    return Diagnostic(mistake.code, mistake.message, span, all_names, mistake.hint)


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


def _variable(typing: _Typing, variable: Variable) -> Iterator[Diagnostic]:
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


def _value(typing: _Typing, variable: Variable, what: str, value: Expr, most: int) -> Iterator[Diagnostic]:
    """The type and the variability of a binding or an attribute."""
    try:
        found = typing.kind(value)
    except TypeMistake as mistake:
        yield _mistake(mistake, variable.span, variable.name)
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
    typing: _Typing, variable: Variable, what: str, value: Expr, most: Variability
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


def _variability(typing: _Typing, name: str) -> Variability:
    return Variability.CONTINUOUS if name == TIME.name else typing.variables[name].variability


# ------------------------------------------------------------------------------ equations


def _equation(typing: _Typing, equation: Equation, *, initial: bool) -> Iterator[Diagnostic]:
    try:
        left, right = typing.kind(equation.left), typing.kind(equation.right)
    except TypeMistake as mistake:
        yield _mistake(mistake, equation.span)
        return
    if left is right is REAL_CONTINUOUS:
        return
    if not comparable(left.type, right.type):
        yield _different_types(equation, left, right)
    elif not initial:
        yield from _discreteness(equation, ((equation.left, left), (equation.right, right)))


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


def _assertion(typing: _Typing, assertion: Assertion) -> Iterator[Diagnostic]:
    parts = (("condition", assertion.condition, BOOLEAN), ("message", assertion.message, STRING))
    for what, part, needed in parts:
        try:
            found = typing.kind(part)
        except TypeMistake as mistake:
            yield _mistake(mistake, assertion.span)
            continue
        if found.type != needed:
            text = f"{short_text(part)} is {article(found.type)}"
            message = f"the {what} of an assert must be {article(needed)}, but {text}"
            yield Diagnostic("type.assertion", message, assertion.span, symbols([part]))
