"""Is there one equation for every unknown? Counting and structure, before anything is transformed.

The structure is that of Pantelides' solvability condition: x and all its derivatives are one unknown, and an
equation can only determine what it holds outside conditions. Where no complete assignment of equations to
unknowns exists, the Dulmage-Mendelsohn decomposition gives the parts with too many and too few equations.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from acausal.errors import BalanceProblem, Diagnostic
from acausal.lang.flat import Equation, FlatModel, Origin, When
from acausal.symbolic.conflicts import conflicts, explain_conflict
from acausal.symbolic.describe import counted, listed
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.graphs.matching import Matching, maximum_matching
from acausal.symbolic.graphs.types import Var
from acausal.symbolic.leaves import determined
from acausal.symbolic.shortages import Shortage, explain_shortage, shortages
from acausal.symbolic.structure import Structure, structure


def check_balance(flat: FlatModel, *, as_component: bool = False) -> None:
    """Every equation must be able to determine an unknown of its own, and none may be left over.

    A model that is run alone has no flow through its own connectors. `as_component` asks instead whether
    there is anything that could be connected to them: what is outside determines one variable of each pair
    of flow and potential, whichever is needed. O(V E) at worst, near-linear in practice. Raises
    BalanceProblem `balance.too-many-equations`, `balance.too-few-equations` or
    `balance.structurally-singular`.
    """
    system = flat_structure(flat)
    require_complete(_opened(system) if as_component else system, flat.name)


def flat_structure(flat: FlatModel) -> Structure:
    """Which equation of a flat model can determine which unknown; O(nodes)."""
    rows = [(e, e.left, e.right) for e in flat.equations]
    rows += [(e, e.left, e.left) for when in flat.whens for e in determining_equations(when)]
    return replace(structure(rows, determined(flat)), open_inputs=flat.open_inputs, places=flat.places)


def _opened(system: Structure) -> Structure:
    """The equations `flow = 0` of the model's own connectors hold the connector's potentials as well."""
    potentials: dict[str, list[Var]] = {}
    for i, variable in enumerate(system.unknowns):
        connector = variable.name.rpartition(".")[0]
        if variable.top_level and connector and not variable.flow:
            potentials.setdefault(connector, []).append(Var(i))
    rows = list(system.incidence)
    for i, equation in enumerate(system.equations):
        if equation.origin is Origin.UNCONNECTED and not equation.component:
            connector = equation.left.name.rpartition(".")[0]
            rows[i] = (*rows[i], *potentials.get(connector, ()))
    return replace(system, incidence=tuple(rows))


def determining_equations(when: When) -> tuple[Equation, ...]:
    """For each variable that a when-clause determines the first equation that does."""
    first: dict[Expr, Equation] = {}
    for branch in when.branches:
        for equation in branch.equations:
            first.setdefault(equation.left, equation)
    return tuple(first.values())


def require_complete(system: Structure, model: str) -> None:
    """As `check_balance`, for any stage's equations."""
    matching = maximum_matching(system.incidence, len(system.unknowns))
    n_equations, n_unknowns = len(system.equations), len(system.unknowns)
    if matching.size == n_equations == n_unknowns:
        return
    raise BalanceProblem(_diagnostics(system, matching, model))


def _diagnostics(system: Structure, matching: Matching, model: str) -> list[Diagnostic]:
    n_equations, n_unknowns = len(system.equations), len(system.unknowns)
    if n_equations > n_unknowns:
        code = "balance.too-many-equations"
    elif n_equations < n_unknowns:
        code = "balance.too-few-equations"
    else:
        code = "balance.structurally-singular"
    size = f"{counted(n_equations, 'equation')} for {counted(n_unknowns, 'unknown')}"
    counts = f"the running system of {model} has {size}"
    if n_equations == n_unknowns:
        counts += ", but they are structurally singular"
    lacking = list(shortages(system, matching))
    over: list[Diagnostic] = []
    for conflict in conflicts(system, matching):
        caused = [shortage for shortage in lacking if shortage.touches(conflict.connectors)]
        lacking = [shortage for shortage in lacking if shortage not in caused]
        found = explain_conflict(system, conflict, code, counts, _in_turn(caused))
        again = any(found[0].span == known.span for known in over)  # in another element of an array
        over += found[:1] if again else found
    under = [d for shortage in lacking for d in explain_shortage(system, shortage, code, counts)]
    return under + over if n_equations < n_unknowns else over + under


def _in_turn(caused: Sequence[Shortage]) -> str:
    """What a conflict leaves undetermined, since as many equations are missing elsewhere."""
    names = [name for shortage in caused for name in shortage.names]
    return f"; in turn nothing determines {listed(names)}" if names else ""
