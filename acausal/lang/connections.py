"""Connections: connection sets and the equations they generate (Modelica 3.6, chapter 9).

Potential variables of a set are equal; flow variables of a set sum to zero, those of connectors inside a
component (of its parts) counted positive, those of its own connectors negative. A flow variable of a part
that is connected to nothing is zero; so is one of the model's own connectors.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from acausal.errors import Span, TypeProblem, fail
from acausal.lang.flat import Equation, Origin
from acausal.lang.instance import Absent, Array, Connection, Instance, Leaf, Member, leaves
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr

_Node = tuple[str, bool]
"""Path of a variable, and whether it is seen from outside its connector's component (an inside connector)."""


@dataclass
class ConnectionSets:
    """Union of connected variables while `connect` equations are collected."""

    parent: dict[_Node, _Node] = field(default_factory=lambda: {})
    leaf: dict[str, Leaf] = field(default_factory=lambda: {})
    place: dict[_Node, tuple[Span, str]] = field(default_factory=lambda: {})
    """Where a node was first connected: the connect equation and the component that holds it."""

    def find(self, node: _Node) -> _Node:
        root = node
        while self.parent.setdefault(root, root) != root:
            root = self.parent[root]
        while self.parent[node] != root:
            self.parent[node], node = root, self.parent[node]
        return root

    def join(self, a: _Node, b: _Node, span: Span, component: str) -> None:
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
    (a, a_inside), (b, b_inside) = left, right
    if isinstance(a, Absent) or isinstance(b, Absent):
        return
    if isinstance(a, Array) or isinstance(b, Array):
        _connect_arrays(sets, left, right, span, component)
        return
    if isinstance(a, Instance) and isinstance(b, Instance):
        _connect_instances(sets, (a, a_inside), (b, b_inside), span, component)
        return
    if not isinstance(a, Leaf) or not isinstance(b, Leaf):
        raise _mismatch(a, b, span, "one is a scalar, the other has components")
    _connect_leaves(sets, (a, a_inside), (b, b_inside), span, component)


def _connect_arrays(
    sets: ConnectionSets, left: tuple[Member, bool], right: tuple[Member, bool], span: Span, component: str
) -> None:
    (a, a_inside), (b, b_inside) = left, right
    if not isinstance(a, Array) or not isinstance(b, Array) or a.shape != b.shape:
        raise _mismatch(a, b, span, f"their sizes are {_size(a)} and {_size(b)}")
    for x, y in zip(a.items, b.items, strict=True):
        connect(sets, (x, a_inside), (y, b_inside), span, component)


def _size(member: Member) -> str:
    return f"[{', '.join(map(str, member.shape))}]" if isinstance(member, Array) else "scalar"


def _connect_instances(
    sets: ConnectionSets, left: tuple[Instance, bool], right: tuple[Instance, bool], span: Span, component: str
) -> None:
    (a, a_inside), (b, b_inside) = left, right
    for connector in (a, b):
        if not connector.is_connector and not connector.is_record:
            raise fail(
                TypeProblem,
                "connect.not-a-connector",
                f"`{connector.path}` is a {connector.scope.kind} (`{connector.scope.path}`), not a connector",
                span,
                names=[connector.path],
                hint="connect connectors of the two components",
            )
    names, others = list(a.members), list(b.members)
    if sorted(names) != sorted(others):
        only = [n for n in names if n not in others] + [n for n in others if n not in names]
        raise _mismatch(a, b, span, f"only one of them has `{'`, `'.join(only)}`")
    for name in names:
        connect(sets, (a.members[name], a_inside), (b.members[name], b_inside), span, component)


def _connect_leaves(
    sets: ConnectionSets, left: tuple[Leaf, bool], right: tuple[Leaf, bool], span: Span, component: str
) -> None:
    (a, a_inside), (b, b_inside) = left, right
    if a.type != b.type:
        raise _mismatch(a, b, span, f"their types are {a.type} and {b.type}")
    if a.prefixes.connection is not b.prefixes.connection:
        raise _mismatch(a, b, span, "one is a flow variable, the other is not")
    sets.leaf[a.path], sets.leaf[b.path] = a, b
    sets.join((a.path, a_inside), (b.path, b_inside), span, component)


def _mismatch(a: Member, b: Member, span: Span, why: str) -> TypeProblem:
    error = fail(
        TypeProblem,
        "connect.mismatch",
        f"`{a.path}` and `{b.path}` cannot be connected: {why}",
        span,
        names=[a.path, b.path],
        hint="connect connectors with the same variables; an adapter component converts between different ones",
    )
    assert isinstance(error, TypeProblem)
    return error


def connection_equations(sets: ConnectionSets, root: Instance) -> list[Equation]:
    """The equations of all sets, then `0 = flow` for the unconnected ones, in order of the model."""
    groups: dict[_Node, list[_Node]] = {}
    for node in sets.place:
        groups.setdefault(sets.find(node), []).append(node)
    equations: list[Equation] = []
    for members in groups.values():
        span, component = sets.place[members[0]]
        leaf = sets.leaf[members[0][0]]
        if leaf.prefixes.connection is Connection.FLOW:
            equations.append(_flow_balance(members, span, component))
        else:
            equations += _equalities(members, sets, component)
    equations += _unconnected(sets, root)
    return equations


def _flow_balance(members: list[_Node], span: Span, component: str) -> Equation:
    terms: list[Expr] = [ex.sym(path) if inside else ex.neg(ex.sym(path)) for path, inside in members]
    return Equation(ex.add(*terms), ex.ZERO, span, component, Origin.FLOW_BALANCE)


def _equalities(members: list[_Node], sets: ConnectionSets, component: str) -> list[Equation]:
    first = ex.sym(members[0][0])
    paths = list(dict.fromkeys(path for path, _ in members[1:] if path != members[0][0]))
    return [
        Equation(first, ex.sym(path), _place(sets, path)[0], _place(sets, path)[1], Origin.CONNECTION)
        for path in paths
    ]


def _place(sets: ConnectionSets, path: str) -> tuple[Span, str]:
    return sets.place.get((path, True)) or sets.place[(path, False)]


def _unconnected(sets: ConnectionSets, root: Instance) -> list[Equation]:
    return [
        Equation(ex.sym(leaf.path), ex.ZERO, leaf.span, component, Origin.UNCONNECTED)
        for leaf, component in _flow_leaves(root)
        if (leaf.path, True) not in sets.place
    ]


def _flow_leaves(root: Instance) -> list[tuple[Leaf, str]]:
    """Flow variables of all connectors, with the component that owns the connector."""
    found: list[tuple[Leaf, str]] = []
    stack: list[tuple[Member, str]] = [(root, "")]
    while stack:
        member, owner = stack.pop()
        if isinstance(member, Array):
            stack.extend((item, owner) for item in reversed(member.items))
        elif isinstance(member, Instance) and member.is_connector:
            found += [(x, owner) for x in leaves(member) if x.prefixes.connection is Connection.FLOW]
        elif isinstance(member, Instance):
            stack.extend((part, member.path) for part in reversed(member.members.values()))
    return found
