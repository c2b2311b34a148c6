"""Which equation can determine which unknown: the structure that counting and matching look at."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from acausal.lang.flat import Equation, Places, Variable
from acausal.symbolic.expressions.expr import Expr, symbols
from acausal.symbolic.graphs.types import Var
from acausal.symbolic.leaves import PresentLeaves
from acausal.symbolic.when_clauses import is_assignment


@dataclass(frozen=True)
class Structure:
    """Which equation holds which unknown, derivatives counted as the variable itself."""

    equations: tuple[Equation, ...]
    unknowns: tuple[Variable, ...]
    incidence: tuple[tuple[Var, ...], ...]
    differentiated: frozenset[Var]
    open_inputs: frozenset[str] = frozenset()
    """Inputs of components that nothing is connected to."""
    places: Places = field(default_factory=Places)


def structure(equations: Sequence[tuple[Equation, Expr, Expr]], unknowns: tuple[Variable, ...]) -> Structure:
    """The collapsed incidence of (flat equation, left, right); O(nodes)."""
    index = {v.name: Var(i) for i, v in enumerate(unknowns)}
    rows: list[tuple[Var, ...]] = []
    derived: list[str] = []
    leaves = PresentLeaves()
    for _, left, right in equations:
        names: dict[str, None] = {}
        for leaf in [left] if is_assignment(left, right) else leaves([left, right]):
            if leaf.op == "sym":
                names[leaf.name] = None
            else:
                inner = symbols([leaf])
                derived += inner
                names.update(dict.fromkeys(inner))
        rows.append(tuple(index[name] for name in names if name in index))
    differentiated = frozenset(index[name] for name in derived if name in index)
    return Structure(tuple(flat for flat, _, _ in equations), unknowns, tuple(rows), differentiated)
