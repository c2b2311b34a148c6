"""Index reduction: which equations must be differentiated (Pantelides), and their exact derivatives."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from acausal.errors import ReductionProblem, fail
from acausal.lang.flat import StateSelect, Variability
from acausal.symbolic.alias import Simplified
from acausal.symbolic.alias_errors import not_differentiable
from acausal.symbolic.balance import require_complete
from acausal.symbolic.causal import CausalEquation
from acausal.symbolic.describe import base_name, equation_with_place, listed
from acausal.symbolic.expressions.diff import NotDifferentiable, TimeDerivative
from acausal.symbolic.expressions.expr import ZERO, Expr, der, sym, without_derivatives
from acausal.symbolic.graphs.dulmage_mendelsohn import StructurallySingular
from acausal.symbolic.graphs.pantelides import Reduction, TooManyDifferentiations, pantelides
from acausal.symbolic.graphs.types import Eq, Var
from acausal.symbolic.leaves import Chains, value_leaves
from acausal.symbolic.structure import structure


@dataclass(frozen=True)
class Reduced:
    """The system extended by differentiated equations; graph indices and leaves correspond by position."""

    model: Simplified
    chains: Chains
    leaves: tuple[Expr, ...]
    """The leaf of every variable of `reduction`."""
    equations: tuple[CausalEquation, ...]
    """The equation of every equation of `reduction`."""
    reduction: Reduction

    @property
    def index_of(self) -> dict[Expr, Var]:
        return {leaf: Var(i) for i, leaf in enumerate(self.leaves)}


def reduce_index(model: Simplified) -> Reduced:
    """Differentiate equations until every highest derivative has its equation.

    A variable with `stateSelect = always` or `prefer` may be a state though the model never differentiates
    it (Modelica 3.6, 4.9.7.1): its derivative is added as an unknown. If that asks for derivatives that do
    not exist, `prefer` gives way.

    Raises BalanceProblem where no differentiation helps, ReductionProblem `reduction.not-differentiable` and
    `reduction.too-many-differentiations`.
    """
    wanted = _wanted(model, StateSelect.PREFER)
    if wanted:
        try:
            return _reduce(model, wanted)
        except ReductionProblem:
            wanted = _wanted(model, StateSelect.ALWAYS)
    return _reduce(model, wanted)


def _wanted(model: Simplified, least: StateSelect) -> list[str]:
    return [
        v.name
        for v in model.unknowns
        if v.state_select >= least and v.variability is Variability.CONTINUOUS and v.type.name == "Real"
    ]


def _reduce(model: Simplified, wanted: Iterable[str]) -> Reduced:
    chains = model.chains()
    rows = [_unknown(value_leaves([e.left, e.right]), chains) for e in model.equations]
    leaves, derivative_of = _variables(model, chains, rows, wanted)
    index = {leaf: Var(i) for i, leaf in enumerate(leaves)}
    incidence = [[index[leaf] for leaf in row] for row in rows]
    reduction = _pantelides(model, incidence, derivative_of)
    _name_new(leaves, reduction, chains)
    equations = _differentiated(model, chains, reduction, len(derivative_of))
    return _differentiated_for_good(Reduced(model, chains, tuple(leaves), equations, reduction))


def _differentiated_for_good(reduced: Reduced) -> Reduced:
    """Without the derivatives that authors gave (`derived`): what had to be differentiated is."""
    model = reduced.model
    everything = (*reduced.equations, *model.equations, *model.initial_equations)
    roots = [side for e in everything for side in (e.left, e.right)]
    plain = without_derivatives([*roots, *(a.condition for a in model.assertions)])
    if all(before is after for before, after in plain.items()):
        return reduced

    def rewritten(equations: Iterable[CausalEquation]) -> tuple[CausalEquation, ...]:
        return tuple(replace(e, left=plain[e.left], right=plain[e.right]) for e in equations)

    model = replace(
        model,
        equations=rewritten(model.equations),
        initial_equations=rewritten(model.initial_equations),
        assertions=tuple(replace(a, condition=plain[a.condition]) for a in model.assertions),
    )
    return replace(reduced, model=model, equations=rewritten(reduced.equations))


def _unknown(leaves: Iterable[Expr], chains: Chains) -> list[Expr]:
    return [leaf for leaf in leaves if chains.is_unknown(leaf)]


def _variables(
    model: Simplified, chains: Chains, rows: list[list[Expr]], wanted: Iterable[str]
) -> tuple[list[Expr], list[Var | None]]:
    """All leaves, variables in declaration order and then derivatives, and who is whose derivative."""
    leaves = [sym(v.name) for v in model.unknowns]
    index = {leaf: Var(i) for i, leaf in enumerate(leaves)}
    used = [leaf for row in rows for leaf in row if leaf.op == "der"]
    for highest in (*used, *[der(sym(name)) for name in wanted if name not in chains.named]):
        chain: list[Expr] = []
        leaf = highest
        while leaf not in index:
            chain.append(leaf)
            leaf = leaf.args[0]
        for new in reversed(chain):
            index[new] = Var(len(leaves))
            leaves.append(new)
    derivative_of: list[Var | None] = []
    for leaf in leaves:
        higher = chains.derivative(leaf)
        derivative_of.append(None if higher is None else index.get(higher))
    return leaves, derivative_of


def _pantelides(model: Simplified, incidence: list[list[Var]], derivative_of: list[Var | None]) -> Reduction:
    try:
        return pantelides(incidence, len(derivative_of), derivative_of)
    except StructurallySingular:
        system = structure([(e.flat, e.left, e.right) for e in model.equations], model.unknowns)
        system = replace(system, places=model.flat.places)
        require_complete(system, f"{model.flat.name} (after alias elimination)")
        raise
    except TooManyDifferentiations as problem:
        culprits = [model.equations[eq] for eq in problem.equations]
        error = fail(
            ReductionProblem,
            "reduction.too-many-differentiations",
            f"more than {problem.limit} differentiations needed of "
            + listed([equation_with_place(equation.flat) for equation in culprits]),
            culprits[0].flat.span,
            names=[base_name(leaf) for e in culprits for leaf in value_leaves([e.left, e.right])],
            hint="a quantity is prescribed through a very long chain of integrators",
        )
        raise ReductionProblem(error.diagnostics) from None


def _name_new(leaves: list[Expr], reduction: Reduction, chains: Chains) -> None:
    """Append the leaves of the derivatives that Pantelides' algorithm appended, in its order."""
    integral = {d: Var(i) for i, d in enumerate(reduction.derivative_of) if d is not None}
    for i in range(len(leaves), reduction.n_vars):
        lower = leaves[integral[Var(i)]]
        slope = chains.derivative(lower)
        leaves.append(der(lower) if slope is None or slope is ZERO else slope)


def _tied(reduction: Reduction, eq: int, model: Simplified, given: int) -> list[str]:
    """The variables whose derivatives the model uses, tied to equation `eq` by what is differentiated.

    Variables from number `given` on came with the reduction.
    """
    held: dict[Var, list[Eq]] = {}
    for other, higher in enumerate(reduction.equation_derivative):
        for var in reduction.incidence[other] if higher is not None else ():
            held.setdefault(var, []).append(Eq(other))
    equations, variables, stack = {Eq(eq): None}, dict[Var, None](), [Eq(eq)]
    while stack:
        for var in reduction.incidence[stack.pop()]:
            if var not in variables:
                variables[var] = None
                new = [other for other in held[var] if other not in equations]
                equations.update(dict.fromkeys(new))
                stack += new
    slopes = {var: reduction.derivative_of[var] for var in sorted(variables) if var < len(model.unknowns)}
    return [model.unknowns[v].name for v, slope in slopes.items() if slope is not None and slope < given]


def _differentiated(
    model: Simplified, chains: Chains, reduction: Reduction, given: int
) -> tuple[CausalEquation, ...]:
    """The equations, and the derivatives of those that `reduction` differentiates, in its order."""
    equations = list(model.equations)
    derive = TimeDerivative(chains.derivative, model.values.lookup)
    source = {d: i for i, d in enumerate(reduction.equation_derivative) if d is not None}
    for i in range(len(equations), len(reduction.incidence)):
        base = equations[source[Eq(i)]]
        try:
            left, right = derive(base.left), derive(base.right)
        except NotDifferentiable as problem:
            needed = _tied(reduction, source[Eq(i)], model, given)
            raise not_differentiable(problem, base.flat, needed) from None
        equations.append(CausalEquation(left, right, base.flat, base.differentiations + 1))
    return tuple(equations)
