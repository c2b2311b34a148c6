"""State selection by dummy derivatives: which derivatives become mere algebraic unknowns.

Mattsson and Soederlind, "Index reduction in differential-algebraic equations using dummy derivatives", SIAM
J. Sci. Comput. 14 (1993), section 3. They choose within the strong components of the highest derivatives;
here the choice is among all derivatives that a connected set of constraints holds, which allows more: with
m = rho(p)*V either the mass or the pressure can be the state, though der(m) follows from the flows alone. It
is enough that on every level the constraints can be solved for the chosen variables, since their derivatives
are unknown anyway.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import TypeVar

from acausal.symbolic.graphs.matching import maximum_matching
from acausal.symbolic.graphs.pantelides import Reduction
from acausal.symbolic.graphs.types import Eq, Var, variables
from acausal.symbolic.graphs.types import equations as all_equations

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

    Works through the constraint sets and within each from the highest level of differentiation down, as in
    Mattsson and Soederlind 1993: of the highest derivatives in the set's equations `choose` picks as many as
    there are equations; then equations and picks are replaced by their integrals. So
    `choose(equations, candidates)` sees derived equations of one set and one level, ascending, and the
    derivatives occurring in them, ascending. The Jacobian it needs is that of the equations with respect to
    the candidates, the same on every level.

    A state is a variable whose derivative is not a dummy (a dummy's own derivative is always a dummy too).
    O(V + E) times the levels, besides `choose`. Raises BadChoice if `choose` does not do what it should.
    """
    var_integral = inverse(reduction.derivative_of, variables(reduction.n_vars))
    eq_integral = inverse(reduction.equation_derivative, all_equations(len(reduction.incidence)))
    dummy = bytearray(reduction.n_vars)
    for equations in constraint_sets(reduction):
        for var in _dummies(equations, reduction, choose, var_integral, eq_integral):
            dummy[var] = 1
    dummies = tuple(var for var in variables(reduction.n_vars) if dummy[var])
    if len(dummies) != sum(reduction.differentiations):
        raise AssertionError(f"{len(dummies)} dummies for {sum(reduction.differentiations)} differentiations")
    derivative_of = enumerate(reduction.derivative_of)
    states = tuple(Var(i) for i, high in derivative_of if high is not None and not dummy[high])
    return Selection(dummies, states)


def constraint_sets(reduction: Reduction) -> list[list[Eq]]:
    """The highest derivatives of the differentiated equations, those together that share highest derivatives.

    Each set ascending, the sets in order of their first equation. Union-find (Tarjan, "Efficiency of a good
    but not linear set union algorithm", J. ACM 22 (1975)); near-linear.
    """
    original = len(reduction.differentiations)
    derivative = reduction.equation_derivative
    derived = [Eq(i) for i in range(original, len(derivative)) if derivative[i] is None]
    parent = {eq: eq for eq in derived}

    def find(eq: Eq) -> Eq:
        while parent[eq] != eq:
            parent[eq] = eq = parent[parent[eq]]
        return eq

    first: dict[Var, Eq] = {}
    for eq in derived:
        for var in reduction.incidence[eq]:
            if reduction.derivative_of[var] is None:
                parent[find(eq)] = find(first.setdefault(var, eq))
    sets: dict[Eq, list[Eq]] = {}
    for eq in derived:
        sets.setdefault(find(eq), []).append(eq)
    return list(sets.values())


def inverse(derivative: Sequence[_Index | None], indices: Sequence[_Index]) -> list[_Index | None]:
    """Per derivative what it is the derivative of; None for what is none."""
    integral: list[_Index | None] = [None] * len(indices)
    for low, high in zip(indices, derivative, strict=True):
        if high is not None:
            integral[high] = low
    return integral


def _dummies(
    equations: list[Eq],
    reduction: Reduction,
    choose: Choose,
    var_integral: Sequence[Var | None],
    eq_integral: Sequence[Eq | None],
) -> list[Var]:
    """The dummies of one constraint set, level by level."""
    dummies: list[Var] = []
    highest = _held(equations, reduction)
    candidates = [var for var in highest if reduction.derivative_of[var] is None]
    while equations:
        held = _held(equations, reduction)
        candidates = sorted(var for var in candidates if var in held)
        chosen = _checked_choice(equations, candidates, reduction, choose)
        dummies += chosen
        lower = _present(eq_integral[eq] for eq in equations)
        equations = sorted(eq for eq in lower if eq_integral[eq] is not None)
        candidates = _present(var_integral[var] for var in chosen)
    return dummies


def _held(equations: Iterable[Eq], reduction: Reduction) -> dict[Var, None]:
    """The variables in any of the equations, each once."""
    return {var: None for eq in equations for var in reduction.incidence[eq]}


def _present(items: Iterable[_Index | None]) -> list[_Index]:
    return [item for item in items if item is not None]


def _checked_choice(eqs: list[Eq], candidates: list[Var], reduction: Reduction, choose: Choose) -> list[Var]:
    """Ask `choose`, and check that the equations can be solved, at least structurally, for the answer."""
    chosen = list(choose(tuple(eqs), tuple(candidates)))
    local = {var: Var(i) for i, var in enumerate(chosen)}
    rows = [[local[var] for var in reduction.incidence[eq] if var in local] for eq in eqs]
    fits = len(local) == len(chosen) == len(eqs) and local.keys() <= set(candidates)
    if not fits or maximum_matching(rows, len(local)).size < len(eqs):
        raise BadChoice(tuple(eqs), tuple(candidates), tuple(chosen))
    return chosen
