"""What alias elimination can find wrong: contradictions, nothing new, no derivative."""

from __future__ import annotations

from collections.abc import Sequence

from acausal.errors import BalanceProblem, Diagnostic, ReductionProblem, fail
from acausal.lang.flat import Equation, FlatModel, Origin
from acausal.symbolic.alias_classes import Classes, Link
from acausal.symbolic.attributes import same_value
from acausal.symbolic.describe import base_name, equation_with_place, listed, short_text, shown
from acausal.symbolic.expressions.diff import INPUT, NotDifferentiable
from acausal.symbolic.expressions.expr import ZERO, Expr, add, neg
from acausal.symbolic.expressions.simplify import split_factor
from acausal.symbolic.leaves import all_leaves
from acausal.symbolic.parameters import ParameterValues


def redundant_link(flat: FlatModel, classes: Classes, link: Link) -> BalanceProblem:
    """An alias equation between two variables that are aliases already: name the loop."""
    around = [flat.equations[other.equation] for other in classes.path(link.a, link.b)]
    names = [link.a]
    for other in classes.path(link.a, link.b):
        names.append(other.b if other.a == names[-1] else other.a)
    loop = listed([equation_with_place(equation) for equation in around])
    surplus = flat.equations[link.equation]
    flows = all(flat.by_name[name].flow for name in names if name in flat.by_name)
    hint = _NO_REFERENCE if flows and surplus.origin is Origin.FLOW_BALANCE else _REMOVE
    return _surplus(surplus, tuple(names), f"it already follows from {loop}", hint)


_REMOVE = "remove it, or replace it by the equation that is missing elsewhere"
_NO_REFERENCE = (
    "these flows balance by themselves, so nothing fixes the level of the potential they belong to: "
    "connect a reference (ground, fixed flange, tank), and look for two sources that prescribe the same"
)


def _surplus(equation: Equation, names: tuple[str, ...], why: str, hint: str = _REMOVE) -> BalanceProblem:
    return BalanceProblem(
        Diagnostic(
            "alias.loop",
            f"the equation `{shown(equation)}` determines nothing in the running system: {why}",
            equation.span,
            names,
            hint,
        )
    )


Value = tuple[Equation, Expr]
"""An equation and the value that it gives."""


def two_values(
    values: ParameterValues, name: str, new: Value, known: Value, between: Sequence[Equation]
) -> BalanceProblem:
    """`name` gets one value from one equation and another from another one, by way of those `between`."""
    (first, value), (second, other) = new, known
    through = f" through {listed([equation_with_place(equation) for equation in between])}" if between else ""
    if same_value(value, other, values):
        why = f"`{name}` = {short_text(value)} already follows from {equation_with_place(second)}{through}"
        return _surplus(first, _names(first), why)
    connected = any(equation.origin is Origin.CONNECTION for equation in (first, second, *between))
    remove = "remove one of these equations"
    hint = f"{remove}, or one of the connections between them" if connected else remove
    return BalanceProblem(
        [
            Diagnostic(
                "alias.contradiction",
                f"in the running system the equation `{shown(one)}` contradicts "
                f"{equation_with_place(two)}{through}: "
                f"`{name}` would be both {short_text(mine)} and {short_text(its)}",
                one.span,
                tuple(dict.fromkeys((name, *_names(one)))),
                hint,
            )
            for one, mine, two, its in ((first, value, second, other), (second, other, first, value))
        ]
    )


def no_unknown_left(
    flat: FlatModel, values: ParameterValues, equation: int, left: Expr, right: Expr
) -> BalanceProblem:
    """After elimination both sides are known: the equation is either false or says nothing."""
    source = flat.equations[equation]
    reduced = f"{short_text(left)} = {short_text(right)}"
    if same_value(left, right, values) is not False:
        return _surplus(source, _names(source), f"with the other equations it reads {reduced}")
    return BalanceProblem(
        Diagnostic(
            "alias.contradiction",
            f"in the running system `{shown(source)}` cannot hold: with the others it reads {reduced}",
            source.span,
            _names(source),
            "correct this equation; no values of its variables satisfy it",
        )
    )


def balanced(rest: Expr) -> tuple[Expr, Expr]:
    """`rest = 0` as an equation a person reads at a glance: positive terms left, negative ones right."""
    terms = rest.args if rest.op == "add" else (rest,)
    negative = [term for term in terms if split_factor(term)[0] < 0]
    positive = [term for term in terms if split_factor(term)[0] >= 0]
    return (
        add(*positive) if positive else ZERO,
        add(*[neg(term) for term in negative]) if negative else ZERO,
    )


def _names(equation: Equation) -> tuple[str, ...]:
    return tuple(dict.fromkeys(base_name(leaf) for leaf in all_leaves([equation.left, equation.right])))


_NO_SLOPE = "prescribe it by something differentiable (a ramp without jump), or write it as smooth(n, ...)"
_NO_SLOPE_OF_INPUT = (
    "an input has no derivative here: prescribe this by a differentiable source inside the model, "
    "or let the input act through something that stores (a filter, an inertia, a volume)"
)


def not_differentiable(problem: NotDifferentiable, equation: Equation) -> ReductionProblem:
    """The typed error for an equation that had to be differentiated."""
    what = short_text(problem.expr)
    error = fail(
        ReductionProblem,
        "reduction.not-differentiable",
        f"the equation `{shown(equation)}` must be differentiated, but `{what}` cannot be: {problem.reason}",
        equation.span,
        names=tuple(dict.fromkeys(base_name(leaf) for leaf in all_leaves([equation.left, equation.right]))),
        hint=_NO_SLOPE_OF_INPUT if problem.reason == INPUT else _NO_SLOPE,
    )
    return ReductionProblem(error.diagnostics)
