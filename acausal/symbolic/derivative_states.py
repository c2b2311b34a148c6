"""States that are derivatives: where `der(x)` is a state itself, it becomes a variable named `der(x)`.

A model that writes `der(der(x))`, or whose constraints need more derivatives than it names, may keep both x
and der(x) as states. A state is a variable, so such a derivative gets one; no Modelica name has
parentheses, so the name is free. The causal system then says `der(x) := 'der(x)'` as for every derivative
that an equation of the model names.
"""

from __future__ import annotations

from dataclasses import replace

from acausal.lang.flat import Equation, Variable
from acausal.symbolic.alias import NamedDerivative
from acausal.symbolic.causal import CausalEquation
from acausal.symbolic.describe import base_name
from acausal.symbolic.expressions.expr import Expr, der, fold, rebuild, sym
from acausal.symbolic.expressions.text import to_text
from acausal.symbolic.index_reduction import Reduced
from acausal.symbolic.state_selection import SelectedStates


def name_derivative_states(reduced: Reduced, selected: SelectedStates) -> tuple[Reduced, SelectedStates]:
    """Both with a symbol in place of every state that is a derivative; as they are where there is none."""
    derivatives = [leaf for leaf in selected.states if leaf.op == "der"]
    if not derivatives:
        return reduced, selected
    memo: dict[Expr, Expr] = {leaf: sym(to_text(leaf)) for leaf in derivatives}

    def visit(node: Expr, args: list[Expr]) -> Expr:
        new = tuple(args)
        return node if new == node.args else rebuild(node, new)

    def rewrite(expr: Expr) -> Expr:
        return fold([expr], visit, memo)[expr]

    def rewritten(equation: CausalEquation) -> CausalEquation:
        return replace(equation, left=rewrite(equation.left), right=rewrite(equation.right))

    model = reduced.model
    variables = [_variable(leaf, reduced) for leaf in derivatives]
    named = [_named(leaf, memo, reduced) for leaf in derivatives]
    model = replace(
        model,
        flat=replace(model.flat, variables=(*model.flat.variables, *variables)),
        unknowns=(*model.unknowns, *variables),
        equations=tuple(rewritten(e) for e in model.equations),
        initial_equations=tuple(rewritten(e) for e in model.initial_equations),
        assertions=tuple(replace(a, condition=rewrite(a.condition)) for a in model.assertions),
        named=(*model.named, *named),
    )
    return replace(
        reduced,
        model=model,
        chains=model.chains(),
        leaves=tuple(rewrite(leaf) for leaf in reduced.leaves),
        equations=tuple(rewritten(e) for e in reduced.equations),
    ), replace(
        selected,
        states=tuple(rewrite(leaf) for leaf in selected.states),
        dummies=tuple(rewrite(leaf) for leaf in selected.dummies),
        monitors=tuple(replace(m, relation=rewrite(m.relation)) for m in selected.monitors),
    )


def _variable(leaf: Expr, reduced: Reduced) -> Variable:
    base = reduced.model.flat.by_name[base_name(leaf)]
    return Variable(
        to_text(leaf), base.type, base.variability, base.span, description=f"derivative of {base.name}"
    )


def _named(leaf: Expr, memo: dict[Expr, Expr], reduced: Reduced) -> NamedDerivative:
    integral = memo.get(leaf.args[0], leaf.args[0])
    span = reduced.model.flat.by_name[base_name(leaf)].span
    equation = Equation(sym(to_text(leaf)), leaf, span)
    return NamedDerivative(
        integral.name, to_text(leaf), CausalEquation(equation.left, der(integral), equation)
    )
