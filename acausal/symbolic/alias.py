"""Alias elimination: variables that equal another one, its negation or a parameter expression disappear.

`a = b`, `a = -b`, `a + b = 0`, `2*a = 2*b`, `a = 3*p`, `2*a + p = 0` are aliases (p parameters). `v = der(x)`
is no alias but gives the derivative of x the name v: later stages use v wherever they need der(x), so that
neither a second unknown nor a second equation is carried along. `Simplified.named` says so, and the causal
system ends with the assignment `der(x) := v` for every such state x.

Work is done in rounds: collect aliases, substitute in the equations they touch, look again at those. Every
equation is looked at once, and again only when one of its variables was replaced: near-linear in the model.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from acausal.errors import Diagnostic, InitializationProblem, fail
from acausal.lang.flat import Assertion, Equation, FlatModel, Variable
from acausal.symbolic.alias_search import AliasSearch
from acausal.symbolic.attributes import (
    Member,
    contradictions,
    fixed_start,
    merged,
    same_value,
    start_or_default,
    start_place,
)
from acausal.symbolic.causal import Alias, CausalEquation
from acausal.symbolic.describe import equation_with_place
from acausal.symbolic.expressions.expr import Expr, const, sym
from acausal.symbolic.expressions.simplify import collect_terms
from acausal.symbolic.expressions.text import to_text
from acausal.symbolic.leaves import Chains, Rewriter
from acausal.symbolic.parameters import ParameterValues


@dataclass(frozen=True)
class NamedDerivative:
    """`equation` says that `derivative` is the time derivative of `of` (both symbols' names)."""

    of: str
    derivative: str
    equation: CausalEquation


@dataclass(frozen=True)
class Simplified:
    """The flat model without aliases; `flat` is the model with the representatives' merged attributes."""

    flat: FlatModel
    values: ParameterValues
    unknowns: tuple[Variable, ...]
    """What is left of the variables, with merged attributes, in declaration order."""
    equations: tuple[CausalEquation, ...]
    initial_equations: tuple[CausalEquation, ...]
    """The model's own, and `value = start` for a variable that is fixed though it has a constant value."""
    assertions: tuple[Assertion, ...]
    aliases: tuple[Alias, ...]
    named: tuple[NamedDerivative, ...]
    constrained: tuple[str, ...]
    """Eliminated variables whose derivative the model uses: not states because of their alias equation."""
    differentiations: int
    """How often an alias equation counts as differentiated because its members' derivatives became one."""
    has_homotopy: bool = False
    """Whether an equation of the model holds the operator `homotopy`; here its actual value is left."""

    def chains(self) -> Chains:
        """Derivative chains of what is left."""
        return Chains(self.flat.by_name, {entry.of: entry.derivative for entry in self.named})


def eliminate_aliases(flat: FlatModel, values: ParameterValues) -> Simplified:
    """Remove aliases, name derivatives, expand `der(expression)`. Near-linear in the size of the model.

    Raises BalanceProblem `alias.contradiction` and `alias.loop`, InitializationProblem `start.conflict`,
    ReductionProblem `reduction.not-differentiable`.
    """
    search = AliasSearch(flat, values)
    search.run()
    roots = search.roots()
    aliases = _aliases(flat, search, roots)
    flat, fixed = _with_merged_attributes(flat, search, roots, values)
    eliminated = {alias.name for alias in aliases}
    named = tuple(
        NamedDerivative(x, v, _named_equation(search, x, v))
        for x, v in sorted(search.named.items(), key=lambda entry: search.position(entry[0]))
    )
    simplified = Simplified(
        flat=flat,
        values=values,
        unknowns=tuple(v for v in search.determined(flat) if v.name not in eliminated),
        equations=tuple(
            CausalEquation(_collected(search.left[i]), _collected(search.right[i]), equation)
            for i, equation in enumerate(flat.equations)
            if search.live[i]
        ),
        initial_equations=(),
        assertions=(),
        aliases=aliases,
        named=named,
        constrained=tuple(a.name for a in aliases if a.name in search.differentiated),
        differentiations=max(search.level, default=0),
    )
    return _with_rest(simplified, search, fixed)


def _collected(side: Expr) -> Expr:
    """A sum without what cancels in it once aliases are replaced: nothing depends on that."""
    found = collect_terms(side)
    same = found.op == "add" and len(found.args) == len(side.args)
    return side if same else found


def _named_equation(search: AliasSearch, x: str, v: str) -> CausalEquation:
    flat = search.flat.equations[search.named_by[x]]
    return CausalEquation(sym(v), search.derivative_leaf(x), flat)


def _with_rest(model: Simplified, search: AliasSearch, fixed: list[CausalEquation]) -> Simplified:
    """Initial equations and assertions in the variables that are left."""
    mapping = {sym(name): const(value) for name, value in model.values.evaluated.items()}
    mapping |= {sym(alias.name): alias.value for alias in model.aliases}
    rewrite = Rewriter(mapping, model.chains(), model.values.lookup)
    initial = [
        CausalEquation(*search.rewritten(rewrite, equation.left, equation.right, equation), equation)
        for equation in model.flat.initial_equations
    ]
    assertions = tuple(
        _rewritten_assertion(assertion, rewrite, search) for assertion in model.flat.assertions
    )
    return replace(
        model,
        initial_equations=(*initial, *fixed),
        assertions=assertions,
        has_homotopy=search.has_homotopy or rewrite.met_homotopy,
    )


def _rewritten_assertion(assertion: Assertion, rewrite: Rewriter, search: AliasSearch) -> Assertion:
    as_equation = Equation(assertion.condition, assertion.message, assertion.span, assertion.component)
    condition, message = search.rewritten(rewrite, assertion.condition, assertion.message, as_equation)
    return replace(assertion, condition=condition, message=message)


def _aliases(flat: FlatModel, search: AliasSearch, roots: Sequence[str]) -> tuple[Alias, ...]:
    """Every eliminated variable with the equation that eliminates it, in declaration order."""
    found: dict[str, Alias] = {}
    for root in roots:
        pinned = search.classes.of(root).pinned
        start = root if pinned is None else pinned.name
        by = search.classes.eliminated_by(start)
        if pinned is not None:
            by[start] = pinned.equation
        for name, equation in by.items():
            found[name] = Alias(name, search.current[name], flat.equations[equation])
    return tuple(found[v.name] for v in flat.variables if v.name in found)


def _with_merged_attributes(
    flat: FlatModel, search: AliasSearch, roots: Sequence[str], values: ParameterValues
) -> tuple[FlatModel, list[CausalEquation]]:
    """The model with the representatives' new attributes, and `value = start` for fixed constants."""
    changed: dict[str, Variable] = {}
    fixed: list[CausalEquation] = []
    warnings: list[Diagnostic] = []
    for root in roots:
        members = _members(root, search, flat)
        if search.classes.of(root).pinned is None:
            changed[root] = merged(members, values)
            warnings += contradictions(members, values)
        else:
            fixed += _fixed_constant(members, search, values)
    variables = tuple(changed.get(v.name, v) for v in flat.variables)
    return replace(flat, variables=variables, warnings=(*flat.warnings, *values.warnings, *warnings)), fixed


def _members(representative: str, search: AliasSearch, flat: FlatModel) -> list[Member]:
    signs = search.classes.of(representative).signs
    own_sign, by_name = signs[representative], flat.by_name
    others = [name for name in signs if name != representative]
    others.sort(key=search.position)
    return [(by_name[name], own_sign * signs[name]) for name in (representative, *others)]


def _fixed_constant(
    members: list[Member], search: AliasSearch, values: ParameterValues
) -> list[CausalEquation]:
    """`value = start` for the first member with `fixed = true`; a provable contradiction is an error."""
    fixed_start(members, values)
    variable = next((v for v, _ in members if v.fixed), None)
    if variable is None:
        return []
    value, start = search.current[variable.name], start_or_default(variable, values)
    agrees = same_value(value, start, values)
    if agrees is False:
        raise _start_against_value(variable, value, search)
    condition = CausalEquation(value, start, Equation(sym(variable.name), start, start_place(variable)))
    return [] if agrees else [condition]


def _start_against_value(variable: Variable, value: Expr, search: AliasSearch) -> InitializationProblem:
    pinned = search.classes.of(variable.name).pinned
    source = None if pinned is None else search.flat.equations[pinned.equation]
    because = "" if source is None else f" by {equation_with_place(source)}"
    start = "0" if variable.start is None else to_text(variable.start)
    problem = fail(
        InitializationProblem,
        "start.conflict",
        f"in the initial system `{variable.name}` is fixed at {start}, "
        f"but its value is {to_text(value)}{because}",
        start_place(variable),
        names=(variable.name,),
        hint=f"remove `fixed = true` from `{variable.name}`",
    )
    return InitializationProblem(problem.diagnostics)
