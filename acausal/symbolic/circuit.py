"""The components and connectors behind some equations and unknowns: where a user looks for a culprit.

Components are named at one level: the one at which the equations concerned meet. Two sources that fight are
named as the model declares them, however deep in them the equations stand.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import reduce

from acausal.errors import Span
from acausal.lang.flat import Equation, Origin, Places, Variable
from acausal.symbolic.describe import place
from acausal.symbolic.domains import GENERIC, Domain, domain_of
from acausal.symbolic.graphs.types import Eq, Var
from acausal.symbolic.structure import Structure


def connector_of(name: str) -> str:
    """The path of the connector, if it is one, that a variable is part of."""
    return name.rpartition(".")[0]


class Circuit:
    """What some equations and unknowns of a system belong to."""

    def __init__(self, system: Structure, equations: Iterable[Eq], variables: Iterable[Var]) -> None:
        self.places: Places = system.places
        written = [system.equations[eq] for eq in equations]
        self.variables: list[Variable] = [system.unknowns[var] for var in variables]
        paths = [self._writer(e) for e in written] + [self.places.owner(v.name) for v in self.variables]
        self.level = meeting(paths)
        """The innermost component that holds all of it."""
        flows = [v for v in system.unknowns if v.flow]
        self._flow_of = {connector_of(v.name): v for v in flows}
        names = [v.name for v in self.variables]
        self.connectors = {connector_of(n): None for n in names if connector_of(n) in self._flow_of}

    def _writer(self, equation: Equation) -> str:
        """The component that an equation stands in; that no flow passes a connector is said around it."""
        if equation.origin is Origin.UNCONNECTED:
            return self.places.owner(equation.left.name).rpartition(".")[0]
        return equation.component

    @property
    def domain(self) -> Domain:
        """That of the connectors, if they have but one."""
        found = {domain_of(self._flow_of[connector]): None for connector in self.connectors}
        return next(iter(found)) if len(found) == 1 else GENERIC

    @property
    def flowing(self) -> bool:
        """Whether the unknowns of the connectors are all flows."""
        held = [v for v in self.variables if connector_of(v.name) in self.connectors]
        return bool(held) and all(v.flow for v in held)

    def part(self, path: str) -> str:
        """The component of the level that holds `path`; "" for the level itself."""
        return part_of(path, self.level)

    def part_of_equation(self, equation: Equation) -> str:
        """As `part`, of the component that wrote an equation."""
        if equation.origin is Origin.UNCONNECTED:
            return self.part(self.places.owner(equation.left.name))
        return self.part(equation.component)

    def part_of_variable(self, name: str) -> str:
        """As `part`, of the component that declares a variable."""
        return self.part(self.places.owner(name))

    def span_of(self, part: str, default: Span) -> Span:
        """Where the component is declared."""
        return self.places.components.get(part, default)

    def has_connector(self, part: str) -> bool:
        """Whether the component has a connector with a flow."""
        return any(connector.startswith(f"{part}.") for connector in self._flow_of)

    @property
    def inside(self) -> str:
        """` inside `stage` (Drive.mo:7)` where all of it is in one component."""
        span = self.places.components.get(self.level)
        return f" inside `{self.level}` ({place(span)})" if span is not None else ""


def meeting(paths: Sequence[str]) -> str:
    """The innermost component that holds all of the paths."""
    return reduce(_common, paths) if paths else ""


def part_of(path: str, level: str) -> str:
    """The component of the level that holds `path`; "" for the level itself."""
    if path == level or not path:
        return ""
    end = path.find(".", len(level) + 1 if level else 0)
    return path if end < 0 else path[:end]


def _common(first: str, second: str) -> str:
    parts: list[str] = []
    for a, b in zip(first.split("."), second.split("."), strict=False):
        if a != b:
            break
        parts.append(a)
    return ".".join(parts)
