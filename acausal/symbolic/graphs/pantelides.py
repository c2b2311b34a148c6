"""Structural index reduction: which equations must be differentiated, and how often.

Pantelides, "The consistent initialization of differential-algebraic systems", SIAM J. Sci. Stat. Comput. 9
(1988). Done here for all unmatched equations at once instead of one after the other. The result is the same:
every equation on an alternating path from any unmatched equation is in a minimal singular subset, hence must
be differentiated once more in every solution, and the smallest solution is unique (Pryce, "A simple
structural analysis method for DAEs", BIT 41 (2001), calls it the canonical offsets).
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from acausal.symbolic.graphs.dulmage_mendelsohn import require_complete
from acausal.symbolic.graphs.matching import Matcher, Matching
from acausal.symbolic.graphs.types import Eq, Incidence, Var, check_incidence, equations

DIFFERENTIATION_LIMIT = 100
"""How often one equation may be differentiated unless the caller says otherwise."""


@dataclass(frozen=True)
class Reduction:
    """A system extended by derivatives until its highest derivatives can be solved for.

    The original equations and variables keep their indices; derivatives are appended. `matching` pairs every
    equation that has no derivative itself with a variable that has no derivative itself.
    """

    n_vars: int
    derivative_of: tuple[Var | None, ...]
    """Per variable the variable that is its time derivative (Pantelides' list A)."""
    equation_derivative: tuple[Eq | None, ...]
    """Per equation the equation that is its time derivative (Pantelides' list B)."""
    incidence: tuple[tuple[Var, ...], ...]
    differentiations: tuple[int, ...]
    """Per original equation how often it was differentiated."""
    matching: Matching


class TooManyDifferentiations(Exception):
    """A solvable system whose `equations` (original indices) need differentiating more than `limit` times."""

    def __init__(self, equations: tuple[Eq, ...], limit: int) -> None:
        super().__init__(f"more than {limit} differentiations of the equations {list(equations)}")
        self.equations = equations
        self.limit = limit


def pantelides(
    incidence: Incidence,
    n_vars: int,
    derivative_of: Sequence[Var | None],
    limit: int = DIFFERENTIATION_LIMIT,
) -> Reduction:
    """Differentiate the fewest equations so that all equations can be matched with highest derivatives.

    `derivative_of[v]` is the variable that is the time derivative of v, or None. The derivative of an
    equation contains its variables and their derivatives; derivatives that do not exist yet are appended, and
    so are the new equations, each time in ascending order of what they are derived from.

    Pantelides 1988, all unmatched equations at once (see the module). O(E) for the first matching plus work
    proportional to the equations added; independent constraints do not disturb each other.

    Raises StructurallySingular where no number of differentiations helps: where the equations cannot be
    matched completely even if every variable stands for all its derivatives; its subsets name the lowest one.
    Raises TooManyDifferentiations beyond `limit`, ValueError for impossible arguments.
    """
    check_incidence(incidence, n_vars)
    require_complete(_collapsed(incidence, _lowest(n_vars, derivative_of)), n_vars)
    system = _System(incidence, derivative_of)
    left = system.matcher.augment(equations(len(incidence)))
    while left:
        derived = system.differentiate(sorted(system.matcher.reached), limit)
        left = system.matcher.augment(derived[eq] for eq in left)
    return system.freeze(len(incidence))


def _lowest(n_vars: int, derivative_of: Sequence[Var | None]) -> list[Var]:
    """Per variable the variable at the low end of its chain of derivatives. O(V)."""
    if len(derivative_of) != n_vars:
        raise ValueError(f"{len(derivative_of)} entries in derivative_of for {n_vars} variables")
    derived = bytearray(n_vars)
    for i, high in enumerate(derivative_of):
        if high is None:
            continue
        if not 0 <= high < n_vars or derived[high]:
            raise ValueError(f"variable {high}, derivative of {i}, does not exist or has two integrals")
        derived[high] = 1
    lowest: list[Var | None] = [None] * n_vars
    for i in range(n_vars):
        var: Var | None = None if derived[i] else Var(i)
        while var is not None:
            lowest[var] = Var(i)
            var = derivative_of[var]
    found = [low for low in lowest if low is not None]
    if len(found) < n_vars:
        raise ValueError("a variable is its own derivative of some order")
    return found


def _collapsed(incidence: Incidence, lowest: list[Var]) -> list[list[Var]]:
    """The incidence with every variable replaced by the low end of its chain."""
    return [list(dict.fromkeys(lowest[var] for var in row)) for row in incidence]


class _System:
    """The growing system of one run: full incidence here, its highest derivatives in the matcher."""

    def __init__(self, incidence: Incidence, derivative_of: Sequence[Var | None]) -> None:
        self.incidence: list[tuple[Var, ...]] = [tuple(dict.fromkeys(row)) for row in incidence]
        self.derivative_of: list[Var | None] = list(derivative_of)
        self.equation_derivative: list[Eq | None] = [None] * len(self.incidence)
        self.origin: list[Eq] = equations(len(self.incidence))
        self.differentiations = [0] * len(self.incidence)
        self.matcher = Matcher((self._highest(row) for row in self.incidence), len(self.derivative_of))

    def differentiate(self, reached: Iterable[Eq], limit: int) -> dict[Eq, Eq]:
        """Differentiate the equations `reached`, and the variables matched with them, keeping the pairs."""
        matcher, eqs = self.matcher, list(reached)
        matched = (matcher.var_of_eq[eq] for eq in eqs)
        for var in sorted(var for var in matched if var is not None):
            self.derivative_of[var] = matcher.add_variable()
            self.derivative_of.append(None)
            matcher.retire(var)
        for eq in eqs:
            self.differentiations[self.origin[eq]] += 1
        over = [self.origin[eq] for eq in eqs if self.differentiations[self.origin[eq]] > limit]
        if over:
            raise TooManyDifferentiations(tuple(sorted(over)), limit)
        return {eq: self._derive(eq) for eq in eqs}

    def freeze(self, n_original: int) -> Reduction:
        """The finished system; only pairs of highest derivatives stay in its matching."""
        eq_d, var_d, matcher = self.equation_derivative, self.derivative_of, self.matcher
        var_of_eq = tuple(v if d is None else None for v, d in zip(matcher.var_of_eq, eq_d, strict=True))
        eq_of_var = tuple(e if d is None else None for e, d in zip(matcher.eq_of_var, var_d, strict=True))
        return Reduction(
            n_vars=len(var_d),
            derivative_of=tuple(var_d),
            equation_derivative=tuple(eq_d),
            incidence=tuple(self.incidence),
            differentiations=tuple(self.differentiations[:n_original]),
            matching=Matching(var_of_eq, eq_of_var, n_original),
        )

    def _highest(self, row: Iterable[Var]) -> list[Var]:
        """The variables of `row` that have no derivative."""
        derivative_of = self.derivative_of
        return [var for var in row if derivative_of[var] is None]

    def _derive(self, eq: Eq) -> Eq:
        """Append the derivative of one equation, matched like the equation itself."""
        row = self.incidence[eq]
        higher = (self.derivative_of[var] for var in row)
        derived_row = tuple(dict.fromkeys((*row, *(var for var in higher if var is not None))))
        derived = self.matcher.add_equation(self._highest(derived_row))
        self.incidence.append(derived_row)
        self.equation_derivative[eq] = derived
        self.equation_derivative.append(None)
        self.origin.append(self.origin[eq])
        var = self.matcher.var_of_eq[eq]
        derived_var = None if var is None else self.derivative_of[var]
        if derived_var is not None:
            self.matcher.pair(derived, derived_var)
        return derived
