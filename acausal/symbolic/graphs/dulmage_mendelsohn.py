"""The coarse Dulmage-Mendelsohn decomposition: where a system has too many or too few equations.

Dulmage and Mendelsohn, "Coverings of bipartite graphs", Canad. J. Math. 10 (1958); as computed by Pothen and
Fan, "Computing the block triangular form of a sparse matrix", ACM TOMS 16 (1990).
"""

from collections.abc import Iterable
from dataclasses import dataclass

from acausal.symbolic.graphs.matching import Matching, maximum_matching
from acausal.symbolic.graphs.types import Eq, Incidence, Var, transpose

REPORTED = 100
"""How many minimal subsets `StructurallySingular` carries at most: one search each."""

_Flags = tuple[bytearray, bytearray]
"""Per equation and per variable 1 for being in, else 0."""


@dataclass(frozen=True)
class Part:
    """Some equations and some variables, each ascending."""

    equations: tuple[Eq, ...]
    variables: tuple[Var, ...]


@dataclass(frozen=True)
class Decomposition:
    """Over-determined (more equations than variables), under-determined and well-determined part."""

    over: Part
    under: Part
    well: Part


class StructurallySingular(Exception):
    """Equations that no assignment of variables can satisfy all.

    `equations` are all those a maximum matching leaves without a variable. `subsets` gives for each of the
    first `REPORTED` of them the smallest set of equations, one more than their variables, that it belongs to:
    dropping any one equation of the set makes the rest of the set solvable.
    """

    def __init__(self, equations: tuple[Eq, ...], subsets: tuple[Part, ...]) -> None:
        super().__init__(f"structurally singular: no variable is left for the equations {list(equations)}")
        self.equations = equations
        self.subsets = subsets


def decompose(incidence: Incidence, matching: Matching) -> Decomposition:
    """Split into the over-, under- and well-determined part, by alternating paths from what is unmatched.

    The result does not depend on which maximum matching is given. Equations of the over-determined part
    contain only its own variables; variables of the under-determined part occur only in its own equations.
    Dulmage and Mendelsohn 1958; O(V + E). Raises ValueError if the matching is not maximum.
    """
    n_vars = len(matching.eq_of_var)
    over_eqs, over_vars = _from_equations(incidence, matching, matching.unmatched_equations())
    under_eqs, under_vars = _from_variables(incidence, matching, matching.unmatched_variables())
    well_eqs = [Eq(i) for i in range(len(incidence)) if not over_eqs[i] and not under_eqs[i]]
    well_vars = [Var(i) for i in range(n_vars) if not over_vars[i] and not under_vars[i]]
    return Decomposition(
        _part(over_eqs, over_vars), _part(under_eqs, under_vars), Part(tuple(well_eqs), tuple(well_vars))
    )


def overdetermined_subset(incidence: Incidence, matching: Matching, eq: Eq) -> Part:
    """The minimal singular subset around the unmatched equation `eq`: k + 1 equations with k variables.

    Any one of its equations may be called the superfluous one: the rest can then be matched completely.
    O(E) over the subset. Raises ValueError if `eq` is matched or the matching not maximum.
    """
    if matching.var_of_eq[eq] is not None:
        raise ValueError(f"equation {eq} is matched")
    reached: dict[Eq, None] = {eq: None}
    seen: dict[Var, None] = {}
    stack = [eq]
    while stack:
        for var in incidence[stack.pop()]:
            if var not in seen:
                seen[var] = None
                owner = _owner(matching, var)
                reached[owner] = None
                stack.append(owner)
    return Part(tuple(sorted(reached)), tuple(sorted(seen)))


def underdetermined_subset(incidence: Incidence, matching: Matching, var: Var) -> Part:
    """The minimal subset around the unmatched variable `var`: k equations with k + 1 variables.

    Any one of its variables may be called the free one: the equations determine the rest once it is given.
    O(V + E). Raises ValueError if `var` is matched or the matching not maximum.
    """
    if matching.eq_of_var[var] is not None:
        raise ValueError(f"variable {var} is matched")
    return _part(*_from_variables(incidence, matching, (var,)))


def require_complete(incidence: Incidence, n_vars: int) -> Matching:
    """A maximum matching that gives every equation a variable; raises StructurallySingular if there is none.

    Cost: one `maximum_matching`, and on failure one search for each subset reported.
    """
    matching = maximum_matching(incidence, n_vars)
    unmatched = matching.unmatched_equations()
    if unmatched:
        subsets = [overdetermined_subset(incidence, matching, eq) for eq in unmatched[:REPORTED]]
        raise StructurallySingular(unmatched, tuple(subsets))
    return matching


def _from_equations(incidence: Incidence, matching: Matching, start: Iterable[Eq]) -> _Flags:
    """Flags of equations and variables on alternating paths from the equations `start`."""
    eqs, seen = bytearray(len(incidence)), bytearray(len(matching.eq_of_var))
    stack = list(start)
    for eq in stack:
        eqs[eq] = 1
    while stack:
        for var in incidence[stack.pop()]:
            if not seen[var]:
                seen[var] = 1
                owner = _owner(matching, var)
                eqs[owner] = 1
                stack.append(owner)
    return eqs, seen


def _from_variables(incidence: Incidence, matching: Matching, start: Iterable[Var]) -> _Flags:
    """Flags of equations and variables on alternating paths from the variables `start`."""
    eqs, seen = bytearray(len(incidence)), bytearray(len(matching.eq_of_var))
    columns = transpose(incidence, len(seen))
    stack = list(start)
    for var in stack:
        seen[var] = 1
    while stack:
        for eq in columns[stack.pop()]:
            if not eqs[eq]:
                eqs[eq] = 1
                var = matching.var_of_eq[eq]
                if var is None:
                    raise ValueError(f"the matching is not maximum: equation {eq} can be matched")
                seen[var] = 1
                stack.append(var)
    return eqs, seen


def _owner(matching: Matching, var: Var) -> Eq:
    """The equation a variable on an alternating path from an unmatched equation is matched with."""
    owner = matching.eq_of_var[var]
    if owner is None:
        raise ValueError(f"the matching is not maximum: variable {var} can be matched")
    return owner


def _part(eqs: bytearray, seen: bytearray) -> Part:
    return Part(
        tuple(Eq(i) for i, flag in enumerate(eqs) if flag),
        tuple(Var(i) for i, flag in enumerate(seen) if flag),
    )
