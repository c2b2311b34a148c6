"""Connections: connection sets and the equations they generate (Modelica 3.6, chapter 9).

Potential variables of a set are equal; flow variables of a set sum to zero, those of connectors inside a
component (of its parts) counted positive, those of its own connectors negative. A flow variable of a part
that is connected to nothing is zero; so is one of the model's own connectors.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from acausal.errors import Span
from acausal.lang.connection_errors import (
    constant_clash,
    mismatch,
    not_a_connector,
    two_quantities,
    two_sources,
)
from acausal.lang.flat import Causality, Equation, Origin, Variability
from acausal.lang.instance import Absent, Array, Connection, Instance, Leaf, Member, Outer, leaves
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Constant, Expr

Node = tuple[str, bool]
"""Path of a variable, and whether it is seen from outside its connector's component (an inside connector)."""


@dataclass
class ConnectionSets:
    """Union of connected variables while `connect` equations are collected."""

    parent: dict[Node, Node] = field(default_factory=dict[Node, Node])
    leaf: dict[str, Leaf] = field(default_factory=dict[str, Leaf])
    place: dict[Node, tuple[Span, str]] = field(default_factory=dict[Node, tuple[Span, str]])
    """Where a node was first connected: the connect equation and the component that holds it."""
    constants: list[tuple[Leaf, Leaf, Span]] = field(default_factory=list[tuple[Leaf, Leaf, Span]])
    """Parameters in connected connectors: their values must agree."""
    hidden: set[str] = field(default_factory=set[str])
    """Variables of protected connectors, which nothing outside their component can feed."""

    in_buses: Mapping[str, None] = field(default_factory=dict[str, None])
    """What stands in expandable connectors, which counts as a connector there (9.1.3)."""
    added_flows: Sequence[Leaf] = ()
    """Flow variables that connections added to expandable connectors."""
    overdetermined: Mapping[str, object] = field(default_factory=dict[str, object])
    """Paths of overdetermined records and types (9.4)."""
    broken: Mapping[tuple[str, str], None] = field(default_factory=dict[tuple[str, str], None])
    """Connections of those that the spanning trees leave out."""
    constraints: list[tuple[Member, Member, Span, str]] = field(
        default_factory=list[tuple[Member, Member, Span, str]]
    )
    """Connections replaced by the residue of `equalityConstraint`."""

    def find(self, node: Node) -> Node:
        root = node
        while self.parent.setdefault(root, root) != root:
            root = self.parent[root]
        while self.parent[node] != root:
            self.parent[node], node = root, self.parent[node]
        return root

    def joins(self, path: str) -> bool:
        """Whether a `connect` names the variable, from outside or inside of its component."""
        return (path, True) in self.place or (path, False) in self.place

    def join(self, a: Node, b: Node, span: Span, component: str) -> None:
        for node in (a, b):
            self.place.setdefault(node, (span, component))
        first, second = self.find(a), self.find(b)
        if first != second:
            self.parent[second] = first


def connect(
    sets: ConnectionSets, left: tuple[Member, bool], right: tuple[Member, bool], span: Span, component: str
) -> None:
    """Add `connect(left, right)`; each side is a connector and whether it belongs to a part (inside).

    Raises `TypeProblem` `connect.*` when the connectors do not fit.
    """
    for side in (left[0], right[0]):
        if side.path in sets.in_buses:
            continue
        if (isinstance(side, Instance) and not side.is_connector) or (
            isinstance(side, Leaf) and not side.connector
        ):
            raise not_a_connector(side, span)
    _connect(sets, left, right, span, component)


def _connect(
    sets: ConnectionSets, left: tuple[Member, bool], right: tuple[Member, bool], span: Span, component: str
) -> None:
    (a, a_inside), (b, b_inside) = left, right
    if sets.overdetermined and a.path in sets.overdetermined and (a.path, b.path) in sets.broken:
        sets.constraints.append((a, b, span, component))
    elif isinstance(a, Leaf) and isinstance(b, Leaf):
        _connect_leaves(sets, (a, a_inside), (b, b_inside), span, component)
    elif isinstance(a, Instance) and isinstance(b, Instance):
        names = list(a.members)
        if len(names) != len(b.members) or any(name not in b.members for name in names):
            only = [n for n in names if n not in b.members] + [n for n in b.members if n not in names]
            raise mismatch(a, b, span, f"only one of them has `{'`, `'.join(only)}`")
        for name in names:
            x, y = a.members[name], b.members[name]
            if not isinstance(x, Outer) and not isinstance(y, Outer):
                _check_directions(a, x, y, span)
                _connect(sets, (x, a_inside), (y, b_inside), span, component)
    elif isinstance(a, Absent) or isinstance(b, Absent):
        return
    elif isinstance(a, Array) and isinstance(b, Array) and a.shape == b.shape:
        for x, y in zip(a.items, b.items, strict=True):
            _connect(sets, (x, a_inside), (y, b_inside), span, component)
    elif isinstance(a, Array) or isinstance(b, Array):
        raise mismatch(a, b, span, f"their sizes are {_size(a)} and {_size(b)}")
    else:
        raise mismatch(a, b, span, "one is a scalar, the other has components")


def _size(member: Member) -> str:
    return f"[{', '.join(map(str, member.shape))}]" if isinstance(member, Array) else "scalar"


def _check_directions(a: Instance, x: Member, y: Member, span: Span) -> None:
    """Inputs and outputs meet inputs and outputs (9.3), but in expandable connectors, which have neither."""
    if isinstance(x, Leaf) and isinstance(y, Leaf) and not a.scope.definition.class_prefixes.expandable:
        directed = [leaf for leaf in (x, y) if leaf.prefixes.causality is not Causality.LOCAL]
        if len(directed) == 1:
            raise mismatch(x, y, span, f"only `{directed[0].path}` is an input or output")


def _connect_leaves(
    sets: ConnectionSets, left: tuple[Leaf, bool], right: tuple[Leaf, bool], span: Span, component: str
) -> None:
    (a, a_inside), (b, b_inside) = left, right
    if a.type != b.type:
        raise mismatch(a, b, span, f"their types are {a.type} and {b.type}")
    if a.prefixes.connection is not b.prefixes.connection:
        kind = "stream" if Connection.STREAM in (a.prefixes.connection, b.prefixes.connection) else "flow"
        raise mismatch(a, b, span, f"one is a {kind} variable, the other is not")
    parameters = [x for x in (a, b) if x.prefixes.variability <= Variability.PARAMETER]
    if a.prefixes.variability is not b.prefixes.variability and parameters:
        kinds = " and ".join([x.prefixes.variability.name.lower() for x in (a, b)])
        raise mismatch(a, b, span, f"their variabilities are {kinds}")
    if len(parameters) == 2:
        sets.constants.append((a, b, span))
        return
    sets.leaf[a.path], sets.leaf[b.path] = a, b
    sets.join((a.path, a_inside), (b.path, b_inside), span, component)


def check_constants(sets: ConnectionSets, values: dict[str, Constant]) -> None:
    """Parameters of connected connectors must have equal values (9.2). Raises `connect.constant`."""
    for a, b, span in sets.constants:
        if values[a.path] != values[b.path]:
            raise constant_clash(a, b, values, span)


def check_quantities(sets: ConnectionSets, quantities: Mapping[str, str]) -> None:
    """What is connected is of one quantity, where it has any (9.3). Raises `connect.quantity`."""
    first: dict[Node, str] = {}
    for node in sets.place:
        quantity = quantities.get(node[0])
        if quantity:
            other = first.setdefault(sets.find(node), node[0])
            if quantities[other] != quantity:
                raise two_quantities(other, node[0], quantities, sets.place[node][0])


# --------------------------------------------------------------------------- equations


def connection_equations(sets: ConnectionSets, root: Instance) -> list[Equation]:
    """The equations of all sets, then `0 = flow` for the unconnected ones, in order of the model."""
    groups: dict[Node, list[Node]] = {}
    for node in sets.place:
        groups.setdefault(sets.find(node), []).append(node)
    equations: list[Equation] = []
    for members in groups.values():
        span, component = sets.place[members[0]]
        leaf = sets.leaf[members[0][0]]
        if leaf.prefixes.connection is Connection.STREAM:
            continue  # see streams
        if leaf.prefixes.connection is Connection.FLOW:
            equations.append(_flow_balance(members, span, component))
        else:
            _check_sources(members, sets)
            equations += _equalities(members, sets)
    equations += _unconnected(sets, root)
    return equations


def _flow_balance(members: list[Node], span: Span, component: str) -> Equation:
    terms: list[Expr] = [ex.sym(path) if inside else ex.neg(ex.sym(path)) for path, inside in members]
    return Equation(ex.add(*terms), ex.ZERO, span, component, Origin.FLOW_BALANCE)


def _check_sources(members: list[Node], sets: ConnectionSets) -> None:
    """At most one output of a part or public input of the component itself may feed a set (9.3)."""
    sources: list[Node] = []
    for path, inside in members:
        source = Causality.OUTPUT if inside else Causality.INPUT
        if sets.leaf[path].prefixes.causality is source and (inside or path not in sets.hidden):
            sources.append((path, inside))
    if len(sources) > 1:
        raise two_sources(sources[0][0], sources[1][0], sets.place[sources[1]][0])


def _equalities(members: list[Node], sets: ConnectionSets) -> list[Equation]:
    first = members[0][0]
    places = {node[0]: sets.place[node] for node in reversed(members[1:]) if node[0] != first}
    return [
        Equation(ex.sym(first), ex.sym(path), *places[path], Origin.CONNECTION)
        for path in dict.fromkeys([path for path, _ in members[1:] if path != first])
    ]


def _unconnected(sets: ConnectionSets, root: Instance) -> list[Equation]:
    return [
        Equation(ex.sym(leaf.path), ex.ZERO, leaf.span, component, Origin.UNCONNECTED)
        for leaf, component in _flow_leaves(root)
        if (leaf.path, True) not in sets.place
    ] + [
        Equation(ex.sym(leaf.path), ex.ZERO, leaf.span, "", Origin.UNCONNECTED)
        for leaf in sets.added_flows
        if (leaf.path, False) not in sets.place
    ]


def _flow_leaves(root: Instance) -> list[tuple[Leaf, str]]:
    """Flow variables of all connectors, with the component that owns the connector."""
    found: list[tuple[Leaf, str]] = []
    stack: list[tuple[Member | Outer, str]] = [(root, "")]
    while stack:
        member, owner = stack.pop()
        if isinstance(member, Array):
            if member.type is None:
                stack.extend([(item, owner) for item in reversed(member.items)])
        elif isinstance(member, Instance) and member.is_connector:
            found += [(x, owner) for x in leaves(member) if x.prefixes.connection is Connection.FLOW]
        elif isinstance(member, Instance):
            parts = reversed(member.members.values())
            stack.extend([(part, member.path) for part in parts if not isinstance(part, Leaf)])
        elif isinstance(member, Outer) and member.own is not None:
            stack.append((member.own, owner))
    return found
