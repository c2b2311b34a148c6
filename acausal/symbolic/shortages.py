"""The under-determined parts of a system: unknowns that lack an equation, and what may be forgotten."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from acausal.errors import Diagnostic, Span
from acausal.lang.flat import Origin, Variable
from acausal.symbolic.circuit import Circuit, connector_of
from acausal.symbolic.describe import SHOWN, counted, equations_with_places, listed, quoted
from acausal.symbolic.graphs.dulmage_mendelsohn import Part, decompose
from acausal.symbolic.graphs.matching import Matching
from acausal.symbolic.graphs.types import Eq, Var
from acausal.symbolic.structure import Structure

PARTS = 5
"""How many parts are explained."""


@dataclass(frozen=True)
class Shortage:
    """Unknowns that are too many for their equations."""

    system: Structure
    part: Part

    @cached_property
    def variables(self) -> list[Variable]:
        """The likeliest culprit first: in few equations and not differentiated, so its own was forgotten."""
        system = self.system
        occurrences = dict.fromkeys(self.part.variables, 0)
        for eq in self.part.equations:
            for var in system.incidence[eq]:
                if var in occurrences:
                    occurrences[var] += 1
        order = sorted(self.part.variables, key=lambda v: (v in system.differentiated, occurrences[v], v))
        return [system.unknowns[v] for v in order]

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(v.name for v in self.variables)

    def touches(self, connectors: frozenset[str]) -> bool:
        """Whether some of the unknowns belong to one of the connectors."""
        return any(connector_of(v.name) in connectors for v in self.variables)


def shortages(system: Structure, matching: Matching) -> Iterator[Shortage]:
    """The under-determined part, split into what does not hang together; O(V + E)."""
    under = decompose(system.incidence, matching).under
    parent: dict[Var, Var] = {v: v for v in under.variables}

    def root(var: Var) -> Var:
        while parent[var] != var:
            parent[var] = parent[parent[var]]
            var = parent[var]
        return var

    for eq in under.equations:
        held = [root(v) for v in system.incidence[eq] if v in parent]
        for other in held[1:]:
            parent[root(other)] = root(held[0])
    variables: dict[Var, list[Var]] = {}
    for var in under.variables:
        variables.setdefault(root(var), []).append(var)
    equations: dict[Var, list[Eq]] = {}
    for eq in under.equations:
        equations.setdefault(root(next(v for v in system.incidence[eq] if v in parent)), []).append(eq)
    single = [key for key, held in variables.items() if len(held) == 1]
    if len(variables) > PARTS and len(single) == len(variables):  # declared and never used: one list of them
        yield Shortage(system, under)
        return
    for key, held in variables.items():
        yield Shortage(system, Part(tuple(equations.get(key, ())), tuple(held)))


def explain_shortage(system: Structure, shortage: Shortage, code: str, counts: str) -> list[Diagnostic]:
    """One diagnostic that lists all, then one for each of the next likely variables."""
    variables = shortage.variables
    forgotten = [v for v in variables if v.name in system.open_inputs]
    circuit = Circuit(system, shortage.part.equations, shortage.part.variables)
    if forgotten:
        return _unconnected(circuit, forgotten, code, counts)
    names, part = shortage.names, shortage.part
    texts = equations_with_places([system.equations[eq] for eq in part.equations])
    by = f"only {counted(len(part.equations), 'equation')}: {texts}" if texts else "no equation"
    why = f"{counts}{circuit.inside}: {counted(len(names), 'unknown')} ({listed(names)}) for {by}"
    hint = _hint(system, circuit, variables, len(part.variables) - len(part.equations))
    result = [Diagnostic(code, why, _span(circuit, variables[0]), names, hint)]
    for variable in variables[1:SHOWN]:
        message = f"`{variable.name}` belongs to the unknowns without enough equations"
        span = _span(circuit, variable)
        if all(span != other.span for other in result):
            hint = "it may be the one undetermined"
            result.append(Diagnostic(code, message, span, (variable.name,), hint))
    return result


def _span(circuit: Circuit, variable: Variable) -> Span:
    """Where the level declares the component that holds the variable, or the variable itself."""
    return circuit.span_of(circuit.part_of_variable(variable.name), variable.span)


def _unconnected(circuit: Circuit, inputs: list[Variable], code: str, counts: str) -> list[Diagnostic]:
    """One diagnostic for each input that was forgotten: these say more than all that depends on them."""
    names = tuple(v.name for v in inputs)
    which, them = (f"{len(names)} inputs ({listed(names)}) have", "them")
    if len(names) == 1:
        which, them = f"the input `{names[0]}` has", "it"
    hint = "connect {} to something that sets it, or give it a value"
    first = Diagnostic(
        code,
        f"{counts}: {which} no value, and nothing is connected to {them}",
        _span(circuit, inputs[0]),
        names,
        hint.format(f"`{names[0]}`"),
    )
    more = [
        Diagnostic(
            code,
            f"nothing is connected to `{v.name}`",
            _span(circuit, v),
            (v.name,),
            hint.format(f"`{v.name}`"),
        )
        for v in inputs[1:SHOWN]
    ]
    return [first, *more]


def _hint(system: Structure, circuit: Circuit, variables: list[Variable], number: int) -> str:
    one = "it" if len(variables) == 1 else "one of them"
    add = f"add an equation for {one}" if number == 1 else f"add {number} equations for some of them"
    open_ = {connector_of(e.left.name) for e in system.equations if e.origin is Origin.UNCONNECTED}
    ends = [end for v in variables if (end := connector_of(v.name)) in open_]
    if ends:
        loose = list(dict.fromkeys(ends))
        which = "which is" if len(loose) == 1 else "which are"
        return f"{add}, or connect {quoted(loose)}, {which} connected to nothing"
    flows = [connector_of(v.name) for v in variables if v.flow and connector_of(v.name)]
    if flows:
        return f"{add}, or connect {quoted(list(dict.fromkeys(flows)))}"
    if circuit.connectors:
        domain = circuit.domain
        return f"connect them to {domain.reference}: nothing fixes the level of their {domain.across}"
    them = "it a parameter or an input" if len(variables) == 1 else "them parameters or inputs"
    if any(not v.top_level for v in variables):
        return f"{add}, or make {them}; a connection may be missing"
    return f"{add}, or make {them}"
