"""What a variable is worth as a state, and why it became one or not."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass

from acausal.errors import Diagnostic, ReductionProblem
from acausal.lang.flat import StateSelect, Variable
from acausal.symbolic.causal import CausalEquation, StateChoice
from acausal.symbolic.describe import base_name, dots, equation_with_place, listed
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.expressions.text import to_text
from acausal.symbolic.graphs.types import Var
from acausal.symbolic.index_reduction import Reduced

Worth = tuple[int, bool, bool, int]
"""stateSelect, fixed, with a start value, minus the number of dots: larger is better as a state."""


def worth(chain: Sequence[Expr], reduced: Reduced) -> Worth:
    """How much a variable and its integrals (a speed and its angle) are worth as states.

    What is given for any of them counts: the highest stateSelect above default, else the lowest.
    """
    variables = [
        variable
        for leaf in chain
        if leaf.op == "sym" and (variable := reduced.model.flat.by_name.get(leaf.name)) is not None
    ]
    selects = [v.state_select for v in variables]
    highest = max(selects, default=StateSelect.DEFAULT)
    select = highest if highest > StateSelect.DEFAULT else min(selects, default=StateSelect.DEFAULT)
    fixed = any(v.fixed is True for v in variables)
    start = any(v.start is not None for v in variables)
    return select, fixed, start, -dots(base_name(chain[-1]))


@dataclass(frozen=True)
class Decision:
    """Why a variable is no state: `constraint` gives it, if `kept` are known."""

    kept: tuple[Expr, ...]
    constraint: CausalEquation


def integral_of(reduced: Reduced) -> dict[Var, Var]:
    """Per derivative the variable it is the derivative of."""
    return {high: Var(i) for i, high in enumerate(reduced.reduction.derivative_of) if high is not None}


def integrals(var: Var, integral: Mapping[Var, Var], reduced: Reduced) -> list[Expr]:
    """A variable's leaf and those of its integrals, down to the lowest."""
    chain = [reduced.leaves[var]]
    while (lower := integral.get(var)) is not None:
        chain.append(reduced.leaves[lower])
        var = lower
    return chain


def check_always(reduced: Reduced, states: tuple[Expr, ...], decisions: Mapping[Expr, Decision]) -> None:
    """A variable with `stateSelect = always` must be a state, or an alias of one; one with `never` must not.

    Raises ReductionProblem `states.always-impossible`, `states.never-impossible` (Modelica 3.6, 4.9.7.1).
    """
    chosen = {to_text(leaf) for leaf in states}
    members = {a.name: a for a in reduced.model.aliases}
    problems: list[Diagnostic] = []
    for variable in reduced.model.flat.variables:
        if (
            variable.state_select is not StateSelect.ALWAYS
            or variable.name in chosen
            or not variable.is_unknown
        ):
            continue
        alias = members.get(variable.name)
        if alias is not None and alias.value.op != "const" and _is_signed_state(alias.value, chosen):
            continue
        problems.append(_always_impossible(variable, reduced, decisions))
    problems += [_never_impossible(v) for v in _unwanted(reduced, chosen)]
    if problems:
        raise ReductionProblem(problems)


def _unwanted(reduced: Reduced, states: Collection[str]) -> list[Variable]:
    """States that are not to be states, nor any variable that equals them: `x` beside `x = der(y)` is none,
    since the derivative itself is a state then.
    """
    flat = reduced.model.flat
    found = {v.name: v for v in flat.variables if v.name in states and v.state_select is StateSelect.NEVER}
    equal: dict[str, str] = {}
    for alias in reduced.model.aliases if found else ():
        inner = alias.value.args[0] if alias.value.op == "neg" else alias.value
        if inner.op == "sym" and inner.name in found:
            if flat.by_name[alias.name].state_select is not StateSelect.NEVER:
                found.pop(inner.name)
            else:
                equal[alias.name] = inner.name
    for equation in flat.equations if found else ():
        for side, other in ((equation.left, equation.right), (equation.right, equation.left)):
            if side.op == "sym" and other.op == "der":
                found.pop(equal.get(side.name, side.name), None)
    return list(found.values())


def _never_impossible(variable: Variable) -> Diagnostic:
    return Diagnostic(
        "states.never-impossible",
        f"`{variable.name}` has stateSelect = StateSelect.never, but nothing else can be the state",
        variable.span,
        (variable.name,),
        "use StateSelect.avoid",
    )


def _is_signed_state(value: Expr, states: set[str]) -> bool:
    inner = value.args[0] if value.op == "neg" else value
    return inner.op == "sym" and inner.name in states


def _always_impossible(
    variable: Variable, reduced: Reduced, decisions: Mapping[Expr, Decision]
) -> Diagnostic:
    decision = next((d for leaf, d in decisions.items() if to_text(leaf) == variable.name), None)
    alias = next((a for a in reduced.model.aliases if a.name == variable.name), None)
    if alias is not None:
        because = f"it equals {to_text(alias.value)} by {equation_with_place(alias.equation)}"
    elif decision is not None:
        because = f"it is constrained by {equation_with_place(decision.constraint.flat)}"
    else:
        because = "the equations determine it at every instant"
    return Diagnostic(
        "states.always-impossible",
        f"in the running system `{variable.name}` has stateSelect = StateSelect.always "
        f"but cannot be a state: {because}",
        variable.span,
        (variable.name,),
        "use StateSelect.prefer, or remove the constraint",
    )


def explain_states(
    reduced: Reduced, states: tuple[Expr, ...], decisions: Mapping[Expr, Decision]
) -> tuple[StateChoice, ...]:
    """One reason for every variable that could have been a state."""
    chosen = set(states)
    integral = integral_of(reduced)
    position = {leaf: Var(i) for i, leaf in enumerate(reduced.leaves)}
    given_up: dict[Expr, list[Expr]] = {}
    for leaf, decision in decisions.items():
        for kept in decision.kept:
            given_up.setdefault(kept, []).append(leaf)

    def value(leaf: Expr) -> Worth:
        return worth(integrals(position[leaf], integral, reduced), reduced)

    result: list[StateChoice] = []
    for i, higher in enumerate(reduced.reduction.derivative_of):
        leaf = reduced.leaves[i]
        if higher is None:
            continue
        if leaf in chosen:
            reason = _why_state(leaf, given_up.get(leaf, []), value)
        else:
            reason = _why_not(decisions.get(leaf))
        result.append(StateChoice(to_text(leaf), leaf in chosen, reason))
    return (*result, *_constrained_by_aliases(reduced))


_REASONS = ("its stateSelect", "its fixed start value", "its start value", "its place in the component tree")


def _why_state(leaf: Expr, given_up: list[Expr], value: Callable[[Expr], Worth]) -> str:
    """The first difference in worth to the first variable given up for this one."""
    if not given_up:
        return "its derivative appears, and no constraint takes it away"
    own, other = value(leaf), value(given_up[0])
    better = next((why for why, a, b in zip(_REASONS, own, other, strict=True) if a != b), "")
    if own > other:
        reason = f"for {better}"
    elif own == other:
        reason = "by declaration order or the size of the constraint's coefficients"
    else:
        reason = "because the constraints are solved for the others more safely"
    return f"kept over {listed([to_text(leaf) for leaf in given_up])} {reason}"


def _why_not(decision: Decision | None) -> str:
    if decision is None:
        return "the constraints determine it"
    by = equation_with_place(decision.constraint.flat)
    if decision.kept:
        return f"follows from {listed([to_text(other) for other in decision.kept])} through {by}"
    return f"constrained by {by}"


def _constrained_by_aliases(reduced: Reduced) -> list[StateChoice]:
    aliases = {a.name: a for a in reduced.model.aliases}
    return [
        StateChoice(
            name,
            False,
            f"equals {to_text(aliases[name].value)} by {equation_with_place(aliases[name].equation)}",
        )
        for name in reduced.model.constrained
    ]
