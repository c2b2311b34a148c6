"""What alias elimination can find wrong: contradictions, nothing new, no derivative."""

from __future__ import annotations

from collections.abc import Sequence

from acausal.errors import BalanceProblem, Diagnostic, ReductionProblem, fail
from acausal.lang.flat import Equation, FlatModel, Origin, Variable
from acausal.symbolic.alias_classes import Classes, Link
from acausal.symbolic.attributes import same_value
from acausal.symbolic.circuit import meeting, part_of
from acausal.symbolic.describe import base_name, equation_with_place, listed, quoted, short_text, shown
from acausal.symbolic.domains import GENERIC, domain_of
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
    why = f"it already follows from {loop}"
    flows = [flat.by_name[name] for name in names if name in flat.by_name]
    if surplus.origin is Origin.FLOW_BALANCE and all(v.flow for v in flows):
        return _no_reference(flat, surplus, flows, why)
    if any(equation.origin is Origin.CONNECTION for equation in (surplus, *around)):
        return _closed_loop(flat, (surplus, *around), tuple(names))
    return _surplus(surplus, tuple(names), why)


def _no_reference(flat: FlatModel, surplus: Equation, flows: Sequence[Variable], why: str) -> BalanceProblem:
    """The flows of a circuit add up to zero by themselves: nothing says how high its potentials are."""
    domain = domain_of(flows[0])
    parts = _parts(flat, [v.name for v in flows])
    ends = {v.name.rpartition(".")[0] for v in flows}
    levels = [v.name for v in flat.unknowns if not v.flow and v.name.rpartition(".")[0] in ends]
    of = f" of {quoted(parts)}" if parts else ""
    story = (
        f"the {domain.through}s{of} balance by themselves, and nothing fixes the level of the "
        f"{domain.across} ({listed(levels)}): "
    )
    hint = (
        f"connect a reference to one of them ({domain.reference.removeprefix('a ')}), "
        "and look for two sources that prescribe the same"
    )
    return _surplus(surplus, tuple(dict.fromkeys([*(v.name for v in flows), *levels])), why, hint, story)


def _closed_loop(flat: FlatModel, loop: Sequence[Equation], names: tuple[str, ...]) -> BalanceProblem:
    """Connections join what is rigid already; the last of them is shown, since it closes the loop."""
    last = max(range(len(loop)), key=lambda i: (loop[i].origin is Origin.CONNECTION, loop[i].span.start))
    others = [equation_with_place(equation) for i, equation in enumerate(loop) if i != last]
    ends = {name.rpartition(".")[0] for name in names}
    flow = next((v for v in flat.unknowns if v.flow and v.name.rpartition(".")[0] in ends), None)
    compliant = GENERIC.compliant if flow is None else domain_of(flow).compliant
    story = f"connections close a loop of {quoted(_parts(flat, names))} in which nothing gives way: "
    hint = f"remove this connection or another one of the loop, or put {compliant} into it"
    return _surplus(loop[last], names, f"it already follows from {listed(others)}", hint, story)


def _parts(flat: FlatModel, names: Sequence[str]) -> list[str]:
    """The components that hold the variables, where they meet."""
    owners = [flat.places.owner(name) for name in names]
    level = meeting(owners)
    if level in owners:
        level = level.rpartition(".")[0]
    return list(dict.fromkeys(part for owner in owners if (part := part_of(owner, level))))


_REMOVE = "remove it, or replace it by the equation that is missing elsewhere"


def _surplus(
    equation: Equation, names: tuple[str, ...], why: str, hint: str = _REMOVE, story: str = ""
) -> BalanceProblem:
    return BalanceProblem(
        Diagnostic(
            "alias.loop",
            f"{story}the equation `{shown(equation)}` determines nothing in the running system: {why}",
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


_NO_SLOPE = (
    "prescribe it by something differentiable (a ramp without jump), or write it as smooth(n, ...), "
    "or put something that gives way behind it (a resistance, spring or orifice)"
)
_NO_SLOPE_OF_INPUT = (
    "an input has no derivative here: prescribe this by a differentiable source inside the model, "
    "or let the input act through something that stores (a filter, an inertia, a volume)"
)


def not_differentiable(
    problem: NotDifferentiable, equation: Equation, needed: Sequence[str] = ()
) -> ReductionProblem:
    """The typed error for an equation that had to be differentiated, for the derivatives `needed`."""
    what = short_text(problem.expr)
    why = f", since it prescribes {quoted(needed)}, differentiated elsewhere" if needed else ""
    error = fail(
        ReductionProblem,
        "reduction.not-differentiable",
        f"in the running system the equation `{shown(equation)}` must be differentiated{why}, "
        f"but `{what}` cannot be: {problem.reason}",
        equation.span,
        names=tuple(dict.fromkeys(base_name(leaf) for leaf in all_leaves([equation.left, equation.right]))),
        hint=_NO_SLOPE_OF_INPUT if problem.reason == INPUT else _NO_SLOPE,
    )
    return ReductionProblem(error.diagnostics)
