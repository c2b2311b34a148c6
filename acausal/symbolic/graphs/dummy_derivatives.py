"""State selection by dummy derivatives: which derivatives become mere algebraic unknowns.

Mattsson and Soederlind, "Index reduction in differential-algebraic equations using dummy derivatives", SIAM
J. Sci. Comput. 14 (1993), section 3.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TypeVar

from acausal.symbolic.graphs.blt import Component, strong_components
from acausal.symbolic.graphs.matching import Matcher, maximum_matching
from acausal.symbolic.graphs.pantelides import Reduction
from acausal.symbolic.graphs.types import Eq, Var

Choose = Callable[[Sequence[Eq], Sequence[Var]], Sequence[Var]]
"""Of the candidates, as many as there are equations, so that the equations can be solved for them."""


_Index = TypeVar("_Index", bound=int)


@dataclass(frozen=True)
class Selection:
    """The dummy derivatives and the states, each ascending."""

    dummies: tuple[Var, ...]
    states: tuple[Var, ...]


class BadChoice(Exception):
    """The `equations` cannot be solved, even structurally, for what the caller's `choose` returned."""

    def __init__(
        self, equations: tuple[Eq, ...], candidates: tuple[Var, ...], chosen: tuple[Var, ...]
    ) -> None:
        super().__init__(f"equations {equations} cannot be solved for {chosen}, chosen from {candidates}")
        self.equations = equations
        self.candidates = candidates
        self.chosen = chosen


def select_dummies(reduction: Reduction, choose: Choose) -> Selection:
    """For every differentiated equation make one derivative a dummy, an algebraic unknown.

    Works through the strong components of the highest derivatives and within each from the highest level of
    differentiation down, as in Mattsson and Soederlind 1993: of the block's equations that are derivatives,
    `choose` picks as many highest derivatives; then equations and picks are replaced by their integrals. So
    `choose(equations, candidates)` sees derived equations of one block and one level, ascending, and the
    derivatives occurring in them, ascending; it is asked only where there is a choice. The Jacobian it needs
    is that of the equations with respect to the candidates, the same on every level.

    A state is a variable whose derivative is not a dummy (a dummy's own derivative is always a dummy too).
    O(V + E) times the levels, besides `choose`. Raises BadChoice if `choose` does not do what it should.
    """
    var_integral = _inverse(reduction.derivative_of, [Var(i) for i in range(reduction.n_vars)])
    eq_integral = _inverse(reduction.equation_derivative, [Eq(i) for i in range(len(reduction.incidence))])
    dummy = bytearray(reduction.n_vars)
    for block in strong_components(reduction.incidence, reduction.matching):
        for var in _block_dummies(block, reduction, choose, var_integral, eq_integral):
            dummy[var] = 1
    dummies = tuple(Var(i) for i, flag in enumerate(dummy) if flag)
    if len(dummies) != sum(reduction.differentiations):
        raise AssertionError(f"{len(dummies)} dummies for {sum(reduction.differentiations)} differentiations")
    derivative_of = enumerate(reduction.derivative_of)
    states = tuple(Var(i) for i, high in derivative_of if high is not None and not dummy[high])
    return Selection(dummies, states)


def structural_choice(reduction: Reduction, preference: Callable[[Var], int]) -> Choose:
    """A `choose` without numbers: the candidates of least `preference` that can be matched structurally.

    Greedy in the transversal matroid (Edmonds and Fulkerson, "Transversals and matroid partition", 1965),
    hence of least total preference; equal preference in ascending order. O(candidates * E) over the block at
    worst.
    """

    def choose(equations: Sequence[Eq], candidates: Sequence[Var]) -> Sequence[Var]:
        local = {var: i for i, var in enumerate(candidates)}
        columns: list[list[Var]] = [[] for _ in candidates]
        for position, eq in enumerate(equations):
            for var in reduction.incidence[eq]:
                if var in local:
                    columns[local[var]].append(Var(position))
        matcher = Matcher(columns, len(equations))
        chosen: list[Var] = []
        for var in sorted(candidates, key=lambda var: (preference(var), var)):
            if len(chosen) < len(equations) and not matcher.augment([Eq(local[var])]):
                chosen.append(var)
        return chosen

    return choose


def _block_dummies(
    block: Component,
    reduction: Reduction,
    choose: Choose,
    var_integral: Sequence[Var | None],
    eq_integral: Sequence[Eq | None],
) -> list[Var]:
    """The dummies of one block, level by level."""
    dummies: list[Var] = []
    eqs, candidates = list(block.equations), list(block.variables)
    while True:
        eqs = [eq for eq in eqs if eq_integral[eq] is not None]
        if not eqs:
            return dummies
        occurring = {var for eq in eqs for var in reduction.incidence[eq]}
        candidates = sorted(var for var in candidates if var in occurring)
        chosen = _checked_choice(eqs, candidates, reduction, choose)
        dummies += chosen
        lower_eqs = (eq_integral[eq] for eq in eqs)
        eqs = sorted(eq for eq in lower_eqs if eq is not None)
        lower_vars = (var_integral[var] for var in chosen)
        candidates = [var for var in lower_vars if var is not None]


def _checked_choice(eqs: list[Eq], candidates: list[Var], reduction: Reduction, choose: Choose) -> list[Var]:
    """Ask `choose` where there is a choice, and check that the equations can be solved for the answer."""
    chosen = candidates if len(candidates) == len(eqs) else list(choose(tuple(eqs), tuple(candidates)))
    local = {var: Var(i) for i, var in enumerate(chosen)}
    rows = [[local[var] for var in reduction.incidence[eq] if var in local] for eq in eqs]
    fits = len(local) == len(chosen) == len(eqs) and local.keys() <= set(candidates)
    if not fits or maximum_matching(rows, len(local)).size < len(eqs):
        raise BadChoice(tuple(eqs), tuple(candidates), tuple(chosen))
    return chosen


def _inverse(derivative: Sequence[_Index | None], indices: Sequence[_Index]) -> list[_Index | None]:
    """Per derivative what it is the derivative of."""
    integral: list[_Index | None] = [None] * len(indices)
    for low, high in zip(indices, derivative, strict=True):
        if high is not None:
            integral[high] = low
    return integral
