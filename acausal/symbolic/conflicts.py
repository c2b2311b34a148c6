"""The over-determined parts of a system, told by the components that fight."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from acausal.errors import Diagnostic, Span
from acausal.lang.flat import Equation, Origin
from acausal.symbolic.circuit import Circuit, connector_of
from acausal.symbolic.describe import (
    SHOWN,
    counted,
    dots,
    equation_with_place,
    equations_with_places,
    listed,
    place,
    quoted,
    shown,
)
from acausal.symbolic.expressions.expr import symbols
from acausal.symbolic.graphs.dulmage_mendelsohn import Part, overdetermined_subset
from acausal.symbolic.graphs.matching import Matching
from acausal.symbolic.graphs.types import Eq
from acausal.symbolic.structure import Structure

PARTS = 3
"""How many over-determined parts are explained."""
LISTED = 3
"""How many equations are listed behind what has been told of the components."""
SEARCHED = 20
"""How many equations too many are looked at, one search each: those that share equations are one part."""


@dataclass(frozen=True)
class Conflict:
    """Equations that are too many for their unknowns, and what they belong to."""

    system: Structure
    part: Part

    @cached_property
    def circuit(self) -> Circuit:
        return Circuit(self.system, self.part.equations, self.part.variables)

    @property
    def connectors(self) -> frozenset[str]:
        return frozenset(self.circuit.connectors)

    @property
    def equations(self) -> list[Equation]:
        return [self.system.equations[eq] for eq in self.part.equations]

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(self.system.unknowns[v].name for v in self.part.variables)

    @property
    def surplus(self) -> int:
        return len(self.part.equations) - len(self.part.variables)

    @cached_property
    def loose(self) -> list[Equation]:
        """`flow = 0` of connectors that are not connected."""
        return [e for e in self.equations if e.origin is Origin.UNCONNECTED]

    @cached_property
    def suspects(self) -> list[Equation]:
        """All equations, the most suspicious one first."""
        order = sorted(self.part.equations, key=lambda eq: _suspicion(self, eq))
        return [self.system.equations[eq] for eq in order]

    @cached_property
    def prescribing(self) -> dict[str, Equation]:
        """The components that prescribe something, each with the equation that does."""
        found: dict[str, Equation] = {}
        for eq in self.part.equations:
            equation = self.system.equations[eq]
            name = self.circuit.part_of_equation(equation)
            prescribes = len(self.system.incidence[eq]) == 1 and equation.origin is not Origin.UNCONNECTED
            if name and prescribes and (name not in found or _is_reference(found[name])):
                found[name] = equation
        return found

    @cached_property
    def sources(self) -> dict[str, Equation]:
        """Those of them that may fight: with connectors, and references only if there is but one other.

        A signal stands for the component that it is led to.
        """
        found = {self._led_to(name): equation for name, equation in self.prescribing.items()}
        near = {name: e for name, e in found.items() if self.circuit.has_connector(name)}
        found = near if len(near) > 1 or self.loose else found
        active = {name: e for name, e in found.items() if not _is_reference(e)}
        return active if len(active) > 1 else active | found

    def _led_to(self, name: str) -> str:
        """The component with connectors that gets the signal of one without, or the component itself."""
        seen = {name: None}
        while not self.circuit.has_connector(name):
            ends = [self._joined(e) for e in self.equations if e.origin is Origin.CONNECTION]
            further = [b for pair in ends for a, b in (pair, pair[::-1]) if a == name and b not in seen]
            if not further:
                return next(iter(seen))
            name = further[0]
            seen[name] = None
        return name

    def _joined(self, equation: Equation) -> tuple[str, str]:
        """The two components that a connection joins."""
        first, second = symbols([equation.left, equation.right])[:2]
        return self.circuit.part_of_variable(first), self.circuit.part_of_variable(second)


def _is_reference(equation: Equation) -> bool:
    return equation.left.is_const or equation.right.is_const


def conflicts(system: Structure, matching: Matching) -> Iterator[Conflict]:
    """The over-determined parts, those that share equations joined; the first `PARTS`."""
    parts: list[Part] = []
    for eq in matching.unmatched_equations()[:SEARCHED]:
        part = overdetermined_subset(system.incidence, matching, eq)
        near = [other for other in parts if not set(other.equations).isdisjoint(part.equations)]
        parts = [other for other in parts if other not in near]
        joined = [part, *near]
        equations = sorted({e for one in joined for e in one.equations})
        variables = sorted({v for one in joined for v in one.variables})
        parts.append(Part(tuple(equations), tuple(variables)))
    for part in parts[:PARTS]:
        yield Conflict(system, part)


def _suspicion(conflict: Conflict, eq: Eq) -> tuple[int, int, int]:
    """What the level itself says first, then what prescribes one quantity, then the rest, connections last.

    Among equals those near the top and late in the source.
    """
    equation = conflict.system.equations[eq]
    own = not conflict.circuit.part_of_equation(equation)
    depth = 0 if own else 1 + dots(equation.component)
    connected = equation.origin in (Origin.CONNECTION, Origin.FLOW_BALANCE, Origin.UNCONNECTED)
    single = len(conflict.system.incidence[eq]) == 1
    return 3 if connected else 0 if own else 1 if single else 2, depth, -eq


def explain_conflict(
    system: Structure, conflict: Conflict, code: str, counts: str, in_turn: str
) -> list[Diagnostic]:
    """What is wrong, and then the equations and connections that may be given up, likeliest first."""
    names = conflict.names
    what = f"{counted(len(names), 'unknown')} ({listed(names)})" if names else "no unknown at all"
    verb = "determine" if len(conflict.equations) > 1 else "determines"
    told = _story(conflict)
    texts = equations_with_places(conflict.suspects, LISTED if told.text else SHOWN)
    so = f"{told.text}, so that " if told.text else ""
    number = counted(len(conflict.equations), "equation")
    why = f"{counts}{conflict.circuit.inside}: {so}{number} {verb} {what}: "
    first = conflict.suspects[0]
    about = (*dict.fromkeys([*symbols([e.left for e in conflict.loose]), *names]),)
    about = about or symbols([first.left, first.right])
    span = told.culprits[0][0] if told.culprits else first.span
    result = [Diagnostic(code, f"{why}{texts}{in_turn}", span, about, told.hint)]
    seen = {(span.file, span.start)}
    for where, text in [*told.culprits[1:], *_others(conflict)]:
        if (where.file, where.start) not in seen and len(result) < SHOWN:
            seen.add((where.file, where.start))
            result.append(Diagnostic(code, text, where, names[:SHOWN], "it may be the one too many"))
    return result


@dataclass(frozen=True)
class _Story:
    """What happened, what to do, and the places to do it, likeliest first."""

    text: str
    hint: str
    culprits: list[tuple[Span, str]]


def _others(conflict: Conflict) -> Iterator[tuple[Span, str]]:
    """The equations and connections of the level, which may be given up as well."""
    number = len(conflict.equations)
    for equation in conflict.suspects:
        if not conflict.circuit.part_of_equation(equation) or not conflict.sources:
            yield equation.span, f"`{shown(equation)}` belongs to the {number} equations in conflict"


def _story(conflict: Conflict) -> _Story:
    same = _repeated(conflict)
    if same is not None:
        return same
    if conflict.loose:
        return _unconnected(conflict)
    own = [
        e for e in conflict.equations
        if e.origin in (Origin.EQUATION, Origin.BINDING) and not conflict.circuit.part_of_equation(e)
    ]  # fmt: skip
    if not own and conflict.circuit.connectors:
        return _fighting(conflict)
    hint = f"remove {'one' if conflict.surplus == 1 else conflict.surplus} of these equations"
    if any(e.origin is Origin.CONNECTION for e in conflict.equations):
        hint += ", or one of the connections: two sources may prescribe the same, and nothing gives way"
    return _Story("", hint, [])


def _repeated(conflict: Conflict) -> _Story | None:
    """Two equations that say the same."""
    known: dict[frozenset[object], Equation] = {}
    for equation in conflict.equations:
        if equation.origin is not Origin.EQUATION:
            continue
        other = known.setdefault(frozenset((equation.left, equation.right)), equation)
        if other is not equation:
            text = f"`{shown(equation)}` stands twice ({place(other.span)} and {place(equation.span)})"
            again = (equation.span, f"`{shown(equation)}`")
            return _Story(
                text, "remove one of the two", [again, (other.span, f"`{shown(other)}` stands here first")]
            )
    return None


def _unconnected(conflict: Conflict) -> _Story:
    """A connector that nothing is connected to lets no flow through."""
    circuit = conflict.circuit
    loose = {connector_of(e.left.name): e for e in reversed(conflict.loose)}
    ends = list(reversed(loose))
    zero = listed([f"`{shown(e)}`" for e in conflict.loose])
    is_, its = ("is", "its") if len(ends) == 1 else ("are", "their")
    text = f"{quoted(ends)} {is_} not connected, which makes {its} {circuit.domain.through} zero ({zero})"
    sources = list(conflict.sources)
    if sources:
        verb = "prescribes" if len(sources) == 1 else "prescribe"
        text += f" while {quoted(sources)} {verb} it"
    culprits: list[tuple[Span, str]] = []
    for end in ends:
        e = loose[end]
        where = circuit.span_of(circuit.part_of_equation(e), e.span)
        culprits.append((where, f"`{end}` is not connected"))
    culprits += _declared(conflict)
    hint = f"connect {quoted(ends)}"
    if sources:
        hint += f", or remove {quoted(sources, 'or')}"
    return _Story(text, hint, culprits)


def _declared(conflict: Conflict) -> list[tuple[Span, str]]:
    """The sources where the model declares them, the last one first."""
    return [
        (conflict.circuit.span_of(name, e.span), f"`{name}` prescribes {equation_with_place(e)}")
        for name, e in reversed(conflict.sources.items())
    ]


def _fighting(conflict: Conflict) -> _Story:
    """Components prescribe more than what is between them leaves free."""
    circuit = conflict.circuit
    sources = list(conflict.sources)
    joined = [
        e
        for e in reversed(conflict.equations)
        if e.origin is Origin.CONNECTION and not circuit.part_of_equation(e)
    ]
    if len(sources) < 2 and joined and not circuit.flowing:
        return _closed(conflict, joined)
    parts = dict.fromkeys(circuit.part_of_equation(e) for e in conflict.equations)
    between = [name for name in parts if name not in conflict.prescribing and circuit.has_connector(name)]
    domain = circuit.domain
    through = f" of what {quoted(between)} {'couples' if len(between) == 1 else 'couple'}" if between else ""
    if circuit.flowing:
        text = _flows_text(sources, between, domain.through)
        hint = f"or let {domain.storage} take up the difference"
        remove = f"remove {quoted(sources, 'or') or 'one of them'}"
        level = f"connect {domain.reference} there"
        hint = f"{remove}, {hint}, or {level}" if len(sources) > 1 else f"{level}, {hint}, or {remove}"
    else:
        verb = "both prescribe" if len(sources) == 2 else "prescribe" if len(sources) > 1 else "prescribes"
        who = quoted(sources) or "rigid connections"
        text = f"{who} {verb if sources else 'prescribe'} the {domain.across}{through}"
        hint = (
            f"remove {quoted(sources, 'or') or 'one of them'}, or one of the connections, or put "
            f"{domain.compliant} between them: nothing there gives way"
        )
    return _Story(text, hint, _declared(conflict))


def _closed(conflict: Conflict, joined: list[Equation]) -> _Story:
    """Connections join what is rigid already: no two sources are needed for that."""
    circuit = conflict.circuit
    parts = dict.fromkeys(circuit.part_of_equation(e) for e in conflict.equations)
    rigid = [name for name in parts if name and name not in conflict.sources] or list(conflict.sources)
    text = f"connections close a loop of {quoted(rigid)} in which nothing gives way"
    culprits = [(e.span, f"this connection closes the loop: `{shown(e)}`") for e in joined]
    hint = f"remove one of the connections, or put {circuit.domain.compliant} into the loop"
    return _Story(text, hint, [*culprits, *_declared(conflict)])


def _flows_text(sources: list[str], between: list[str], through: str) -> str:
    by = f" by way of {quoted(between)}" if between else ""
    if len(sources) > 1:
        both = "both " if len(sources) == 2 else ""
        return f"{quoted(sources)} {both}prescribe the {through} through the same place{by}"
    if sources:
        return (
            f"the {through} that `{sources[0]}` prescribes balances by itself{by}, whatever the level there"
        )
    return f"the {through}s add up{by}"
