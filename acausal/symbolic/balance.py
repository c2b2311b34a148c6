"""Is there one equation for every unknown? Counting and structure, before anything is transformed.

The structure is that of Pantelides' solvability condition: x and all its derivatives are one unknown, and an
equation can only determine what it holds outside conditions. Where no complete assignment of equations to
unknowns exists, the Dulmage-Mendelsohn decomposition gives the parts with too many and too few equations.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from acausal.errors import BalanceProblem, Diagnostic
from acausal.lang.flat import Equation, FlatModel, Origin, Variable, When
from acausal.symbolic.describe import SHOWN, dots, equation_with_place, listed, shown
from acausal.symbolic.expressions.expr import Expr, symbols
from acausal.symbolic.graphs.dulmage_mendelsohn import Part, decompose, overdetermined_subset
from acausal.symbolic.graphs.matching import Matching, maximum_matching
from acausal.symbolic.graphs.types import Eq, Var
from acausal.symbolic.leaves import PresentLeaves, determined


@dataclass(frozen=True)
class Structure:
    """Which equation holds which unknown, derivatives counted as the variable itself."""

    equations: tuple[Equation, ...]
    unknowns: tuple[Variable, ...]
    incidence: tuple[tuple[Var, ...], ...]
    differentiated: frozenset[Var]
    open_inputs: frozenset[str] = frozenset()
    """Inputs of components that nothing is connected to."""


def structure(equations: Sequence[tuple[Equation, Expr, Expr]], unknowns: tuple[Variable, ...]) -> Structure:
    """The collapsed incidence of (flat equation, left, right); O(nodes)."""
    index = {v.name: Var(i) for i, v in enumerate(unknowns)}
    rows: list[tuple[Var, ...]] = []
    derived: list[str] = []
    leaves = PresentLeaves()
    for _, left, right in equations:
        names: dict[str, None] = {}
        for leaf in leaves([left, right]):
            if leaf.op == "sym":
                names[leaf.name] = None
            else:
                inner = symbols([leaf])
                derived += inner
                names.update(dict.fromkeys(inner))
        rows.append(tuple(index[name] for name in names if name in index))
    differentiated = frozenset(index[name] for name in derived if name in index)
    return Structure(tuple(flat for flat, _, _ in equations), unknowns, tuple(rows), differentiated)


def check_balance(flat: FlatModel, *, as_component: bool = False) -> None:
    """Every equation must be able to determine an unknown of its own, and none may be left over.

    A model that is run alone has no flow through its own connectors. `as_component` asks instead whether
    there is anything that could be connected to them: what is outside determines one variable of each pair
    of flow and potential, whichever is needed. O(V E) at worst, near-linear in practice. Raises
    BalanceProblem `balance.too-many-equations`, `balance.too-few-equations` or
    `balance.structurally-singular`.
    """
    rows = [(e, e.left, e.right) for e in flat.equations]
    rows += [(e, e.left, e.left) for when in flat.whens for e in determining_equations(when)]
    system = replace(structure(rows, determined(flat)), open_inputs=flat.open_inputs)
    require_complete(_opened(system) if as_component else system, flat.name)


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
    over: list[Diagnostic] = []
    for eq in matching.unmatched_equations()[:PARTS]:
        over += _over(system, overdetermined_subset(system.incidence, matching, eq), code, counts)
    under: list[Diagnostic] = []
    part = decompose(system.incidence, matching).under
    if part.variables:
        under = _under(system, part, code, counts)
    return under + over if n_equations < n_unknowns else over + under


PARTS = 3
"""How many over-determined parts are explained; each costs one search."""


def counted(number: int, noun: str) -> str:
    """`1 equation`, `3 equations`."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def _texts(system: Structure, equations: Sequence[Eq]) -> str:
    """The first ones with their places."""
    texts = [equation_with_place(system.equations[eq]) for eq in equations[:SHOWN]]
    return listed([*texts, *[""] * (len(equations) - len(texts))])


def _over(system: Structure, part: Part, code: str, counts: str) -> list[Diagnostic]:
    """One diagnostic for each equation of an over-determined part, the most suspicious one first."""
    suspects = sorted(part.equations, key=lambda eq: _suspicion(system, eq))
    names = tuple(system.unknowns[v].name for v in part.variables)
    number = len(suspects)
    what = f"{counted(len(names), 'unknown')} ({listed(names)})" if names else "no unknown at all"
    verb = "determine" if number > 1 else "determines"
    why = f"{counts}: {counted(number, 'equation')} {verb} {what}: {_texts(system, suspects)}"
    first = system.equations[suspects[0]]
    about = names or symbols([first.left, first.right])
    result = [Diagnostic(code, why, first.span, about, _hint_over(system, part))]
    for eq in suspects[1:SHOWN]:
        equation = system.equations[eq]
        message = f"`{shown(equation)}` belongs to the {len(part.equations)} equations in conflict"
        result.append(Diagnostic(code, message, equation.span, names[:SHOWN], "it may be the one too many"))
    return result


def _suspicion(system: Structure, eq: Eq) -> tuple[int, int, int]:
    """What the model itself says first, then what prescribes one quantity, then the rest, connections last.

    Among equals those near the top and late in the source.
    """
    equation = system.equations[eq]
    depth = 0 if not equation.component else 1 + dots(equation.component)
    connected = equation.origin in (Origin.CONNECTION, Origin.FLOW_BALANCE, Origin.UNCONNECTED)
    rank = 3 if connected else 0 if not depth else 1 if len(system.incidence[eq]) == 1 else 2
    return rank, depth, -eq


def _hint_over(system: Structure, part: Part) -> str:
    number = len(part.equations) - len(part.variables)
    remove = f"remove {'one' if number == 1 else number} of these equations"
    zero = [
        system.equations[eq] for eq in part.equations if system.equations[eq].origin is Origin.UNCONNECTED
    ]
    if zero:
        return (
            f"{remove}, or connect what is not connected: "
            + listed([f"`{shown(equation)}`" for equation in zero])
            + " stands for an unconnected connector"
        )
    return remove + _prescribed_twice(system, part)


def _prescribed_twice(system: Structure, part: Part) -> str:
    """Which components prescribe what is joined in the part, and what may be missing between them."""
    origins = {system.equations[eq].origin for eq in part.equations}
    if not origins & {Origin.CONNECTION, Origin.FLOW_BALANCE}:
        return ""
    sources = [
        equation.component
        for eq in part.equations
        if len(system.incidence[eq]) == 1 and (equation := system.equations[eq]).component
    ]
    who = listed([f"`{name}`" for name in dict.fromkeys(sources)])
    if Origin.CONNECTION in origins:
        named = f"{who} prescribe" if len(sources) > 1 else "two sources may prescribe"
        return (
            f", or one of the connections: {named} the same quantity, with nothing in between that gives way"
        )
    flows = (
        "two components prescribe the flow through the same place"
        if len(sources) > 1
        else "these flows add up"
    )
    return f": {flows}, or a reference (ground, tank, fixed flange) or a storage is missing there"


def _under(system: Structure, part: Part, code: str, counts: str) -> list[Diagnostic]:
    """One diagnostic for each variable of the under-determined part, the likeliest culprit first.

    That is a variable in few equations which is not differentiated: its equation was forgotten.
    """
    occurrences = dict.fromkeys(part.variables, 0)
    for eq in part.equations:
        for var in system.incidence[eq]:
            if var in occurrences:
                occurrences[var] += 1
    ordered = sorted(part.variables, key=lambda v: (v in system.differentiated, occurrences[v], v))
    variables = [system.unknowns[v] for v in ordered]
    forgotten = [v for v in variables if v.name in system.open_inputs]
    if forgotten:
        return _unconnected(forgotten, code, counts)
    names = tuple(v.name for v in variables)
    texts = _texts(system, part.equations)
    by = f"only {counted(len(part.equations), 'equation')}: {texts}" if texts else "no equation"
    why = f"{counts}: {counted(len(names), 'unknown')} ({listed(names)}) for {by}"
    hint = _hint_under(system, variables, len(part.variables) - len(part.equations))
    result = [Diagnostic(code, why, variables[0].span, names, hint)]
    for variable in variables[1:SHOWN]:
        message = f"`{variable.name}` belongs to the unknowns without enough equations"
        result.append(
            Diagnostic(code, message, variable.span, (variable.name,), "it may be the one undetermined")
        )
    return result


def _unconnected(inputs: list[Variable], code: str, counts: str) -> list[Diagnostic]:
    """One diagnostic for each input that was forgotten: these say more than all that depends on them."""
    names = tuple(v.name for v in inputs)
    which, them = (f"{len(names)} inputs ({listed(names)}) have", "them")
    if len(names) == 1:
        which, them = f"the input `{names[0]}` has", "it"
    hint = "connect {} to something that sets it, or give it a value"
    first = Diagnostic(
        code,
        f"{counts}: {which} no value, and nothing is connected to {them}",
        inputs[0].span,
        names,
        hint.format(f"`{names[0]}`"),
    )
    more = [
        Diagnostic(code, f"nothing is connected to `{v.name}`", v.span, (v.name,), hint.format(f"`{v.name}`"))
        for v in inputs[1:SHOWN]
    ]
    return [first, *more]


def _connectors(system: Structure) -> frozenset[str]:
    """The connectors that have flows."""
    return frozenset(v.name.rpartition(".")[0] for v in system.unknowns if v.flow)


def _hint_under(system: Structure, variables: list[Variable], number: int) -> str:
    add = "add an equation for one of them" if number == 1 else f"add {number} equations for some of them"
    connectors = [v.name.rsplit(".", 1)[0] for v in variables if v.flow and "." in v.name]
    if connectors:
        return f"{add}, or connect {listed(list(dict.fromkeys(connectors)))}"
    open_ = {e.left.name.rpartition(".")[0] for e in system.equations if e.origin is Origin.UNCONNECTED}
    ends = [end for v in variables if (end := v.name.rpartition(".")[0]) in open_]
    if ends:
        return f"{add}, or connect {listed(list(dict.fromkeys(ends)))}"
    with_flows = _connectors(system)
    if any(v.name.rpartition(".")[0] in with_flows for v in variables):
        return (
            f"{add}, or connect them to a reference (ground, tank, fixed flange): nothing fixes their level"
        )
    if any(not v.top_level for v in variables):
        return f"{add}, or make them parameters or inputs; a connection may be missing"
    return f"{add}, or make them parameters or inputs"
