"""Block lower triangular form: which equations must be solved together, and in which order.

Tarjan, "Depth-first search and linear graph algorithms", SIAM J. Comput. 1 (1972); its use on a matched
incidence: Duff and Reid, "An implementation of Tarjan's algorithm for the block triangularization of a
matrix", ACM TOMS 4 (1978).
"""

from collections.abc import Iterator
from dataclasses import dataclass

from acausal.symbolic.graphs.matching import Matching
from acausal.symbolic.graphs.types import Eq, Incidence, Var


@dataclass(frozen=True)
class Component:
    """Equations to be solved together, ascending, and the variable matched with each, in the same order."""

    equations: tuple[Eq, ...]
    variables: tuple[Var, ...]


def strong_components(incidence: Incidence, matching: Matching) -> tuple[Component, ...]:
    """The strong components of a matched incidence in solving order.

    Equation e depends on equation f if e contains the variable matched with f. Every component comes after
    all components it depends on. Equations without a variable take no part, and variables without an
    equation count as known. Depth-first from the equations in ascending order, so that of two components
    neither of which is needed by the other, the one reached from the smaller equation comes first.

    Tarjan 1972, without recursion; O(V + E). Raises ValueError if the matching has another size.
    """
    if len(matching.var_of_eq) != len(incidence):
        raise ValueError(f"matching of {len(matching.var_of_eq)} equations for {len(incidence)} equations")
    walk = _Walk(incidence, matching)
    for i, var in enumerate(matching.var_of_eq):
        if var is not None and walk.number[i] == 0:
            walk.visit(Eq(i))
    return tuple(walk.components)


class _Walk:
    """The working memory of one run of Tarjan's algorithm."""

    def __init__(self, incidence: Incidence, matching: Matching) -> None:
        self.components: list[Component] = []
        self.number = [0] * len(incidence)
        """Position in order of first visit, from 1; 0 before the visit."""
        self._incidence = incidence
        self._matching = matching
        self._low = [0] * len(incidence)
        self._closed = bytearray(len(incidence))
        self._open: list[Eq] = []
        self._visited = 0

    def visit(self, root: Eq) -> None:
        """Emit all components reachable from `root` that are not emitted yet."""
        number, low, closed = self.number, self._low, self._closed
        incidence, owner = self._incidence, self._matching.eq_of_var
        path: list[tuple[Eq, Iterator[Var]]] = []
        pending: Eq | None = root
        while pending is not None or path:
            if pending is not None:
                self._enter(pending)
                path.append((pending, iter(incidence[pending])))
                pending = None
            eq, rest = path[-1]
            for var in rest:
                other = owner[var]
                if other is None or closed[other]:
                    continue
                if number[other] == 0:
                    pending = other
                    break
                low[eq] = min(low[eq], number[other])
            else:
                path.pop()
                if path:
                    parent = path[-1][0]
                    low[parent] = min(low[parent], low[eq])
                if low[eq] == number[eq]:
                    self._emit(eq)

    def _enter(self, eq: Eq) -> None:
        self._visited += 1
        self.number[eq] = self._low[eq] = self._visited
        self._open.append(eq)

    def _emit(self, first: Eq) -> None:
        """Close the component whose first visited equation is `first`: the top of the open stack."""
        members: list[Eq] = []
        while True:
            eq = self._open.pop()
            self._closed[eq] = 1
            members.append(eq)
            if eq == first:
                break
        members.sort()
        matched = [self._matching.var_of_eq[eq] for eq in members]
        self.components.append(Component(tuple(members), tuple(var for var in matched if var is not None)))
