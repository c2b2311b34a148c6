"""The virtual connection graph of overconstrained connections (Modelica 3.6, 9.4).

Its nodes are the overdetermined records (and types) of connectors, its edges `Connections.branch` (required)
and `connect` (optional). Optional edges outside the spanning trees are broken: there the residue of
`equalityConstraint` stands for the equality.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from acausal.errors import AcausalError, Diagnostic, Span
from acausal.lang import ast
from acausal.lang.arithmetic import type_error
from acausal.lang.connection_nodes import connector_side
from acausal.lang.instance import Array, Instance, Member, Outer
from acausal.lang.links import Link, call_name
from acausal.lang.references import Selection, resolve
from acausal.lang.scope import Scope
from acausal.lang.translation import Env, Translation
from acausal.symbolic.graphs.spanning_forest import Edge, Forest, spanning_forest


@dataclass(slots=True)
class VirtualGraph:
    """The spanning trees: which nodes are roots, how far each is from its own, and which edges are broken."""

    depth: dict[str, int] = field(default_factory=dict[str, int])
    branches: dict[str, list[str]] = field(default_factory=dict[str, list[str]])
    """The second arguments of `Connections.branch` by the first."""
    broken: dict[tuple[str, str], None] = field(default_factory=dict[tuple[str, str], None])

    def is_root(self, node: str) -> bool:
        return self.depth.get(node) == 0

    def is_rooted(self, node: str, span: Span) -> bool:
        """Whether a node is nearer to its root than the node it has its one branch to."""
        others = self.branches.get(node, [])
        if len(others) != 1:
            raise type_error(
                "connections.rooted",
                f"`{node}` is the first argument of {len(others)} `Connections.branch`, not of exactly one",
                span,
                "",
                (node,),
            )
        return self.depth[node] < self.depth[others[0]]


@dataclass(slots=True)
class _Builder:
    numbers: dict[str, int] = field(default_factory=dict[str, int])
    places: list[Span] = field(default_factory=list[Span])
    required: list[Edge] = field(default_factory=list[Edge])
    required_at: dict[Edge, Span] = field(default_factory=dict[Edge, Span])
    optional: list[Edge] = field(default_factory=list[Edge])
    definite: list[int] = field(default_factory=list[int])
    potential: dict[int, int] = field(default_factory=dict[int, int])

    def number(self, path: str, span: Span) -> int:
        found = self.numbers.setdefault(path, len(self.numbers))
        if found == len(self.places):
            self.places.append(span)
        return found


def virtual_graph(
    translation: Translation, links: Sequence[Link], overdetermined: Mapping[str, Scope]
) -> tuple[VirtualGraph, list[Diagnostic]]:
    """The graph of a model, and a warning for every part of it that has no root.

    Raises `connections.circle` where branches alone close a circle or join two roots.
    """
    builder = _Builder()
    graph = VirtualGraph()
    for link in links:
        if isinstance(link.node, ast.ConnectEquation):
            _optional(translation, builder, link, link.node, overdetermined)
        else:
            _operator(translation, builder, graph, link.node, link.env, overdetermined)
    names = list(builder.numbers)
    forest = spanning_forest(
        len(names), builder.required, builder.optional, builder.definite, builder.potential
    )
    if forest.circles:
        raise _circle(names, forest.circles[0], builder)
    graph.depth.update(zip(names, forest.depth, strict=True))
    for (a, b), kept in zip(builder.optional, forest.kept, strict=True):
        if not kept:
            graph.broken[names[a], names[b]] = None
    return graph, _rootless(names, builder, forest)


def _optional(
    translation: Translation,
    builder: _Builder,
    link: Link,
    node: ast.ConnectEquation,
    overdetermined: Mapping[str, Scope],
) -> None:
    left = connector_side(translation, node.left, link.env)
    right = connector_side(translation, node.right, link.env)
    for x, y in zip(left.members, right.members, strict=False):
        for a, b in _pairs(x, y, overdetermined):
            builder.optional.append((builder.number(a, node.span), builder.number(b, node.span)))


def _pairs(a: Member | Outer, b: Member | Outer, nodes: Mapping[str, Scope]) -> Iterator[tuple[str, str]]:
    """The overdetermined parts that a connection of two connectors makes equal."""
    if a.path in nodes and b.path in nodes:
        yield a.path, b.path
    elif isinstance(a, Instance) and isinstance(b, Instance):
        for name, part in a.members.items():
            if name in b.members:
                yield from _pairs(part, b.members[name], nodes)
    elif isinstance(a, Array) and isinstance(b, Array) and a.type is None:
        for x, y in zip(a.items, b.items, strict=False):
            yield from _pairs(x, y, nodes)


def _operator(
    translation: Translation,
    builder: _Builder,
    graph: VirtualGraph,
    node: ast.Call,
    env: Env,
    overdetermined: Mapping[str, Scope],
) -> None:
    name = call_name(node)
    count = 2 if name == "Connections.branch" else 1
    most = count + (name == "Connections.potentialRoot")
    if not count <= len(node.arguments) <= most or len(node.arguments) + len(node.named) > most:
        raise type_error("call.arguments", f"`{name}` takes {count} argument(s)", node.span, "", (name,))
    paths = [graph_node(translation, arg, env, overdetermined) for arg in node.arguments[:count]]
    numbers = [builder.number(path, node.span) for path in paths]
    if name == "Connections.branch":
        edge = (numbers[0], numbers[1])
        builder.required.append(edge)
        builder.required_at.setdefault(edge, node.span)
        graph.branches.setdefault(paths[0], []).append(paths[1])
    elif name == "Connections.root":
        builder.definite.append(numbers[0])
    else:
        builder.potential.setdefault(numbers[0], _priority(translation, node, env))


def _priority(translation: Translation, node: ast.Call, env: Env) -> int:
    given = [*node.arguments[1:], *[named.value for named in node.named if named.name == "priority"]]
    if len(node.named) > 1 or any(named.name != "priority" for named in node.named):
        message = "`Connections.potentialRoot` takes a connector's record and a priority"
        raise type_error("call.arguments", message, node.span, "", ("Connections.potentialRoot",))
    if not given:
        return 0
    priority = translation.evaluate_in(given[0], env, "the priority of a potential root")
    if not isinstance(priority, int) or isinstance(priority, bool) or priority < 0:
        message = f"the priority of a potential root is an Integer from 0, not {priority}"
        raise type_error("connections.priority", message, given[0].span)
    return priority


def graph_node(
    translation: Translation, argument: ast.Expression, env: Env, overdetermined: Mapping[str, Scope]
) -> str:
    """The path of a node. Raises `connections.not-overdetermined`."""
    if isinstance(argument, ast.ComponentReference):
        found = resolve(translation, argument, env)
        if isinstance(found, Selection) and found.members:
            path = found.members[0].path
            whole = path if not found.shape else path.rpartition("[")[0]
            for candidate in (path, whole):
                if candidate in overdetermined:
                    return candidate
        text = argument.text
    else:
        text = "this expression"
    raise type_error(
        "connections.not-overdetermined",
        f"`{text}` is not an overdetermined record or type of a connector",
        argument.span,
        "name a part of a connector whose class has a function `equalityConstraint`",
        (text,),
    )


def _circle(names: Sequence[str], edge: Edge, builder: _Builder) -> AcausalError:
    a, b = names[edge[0]], names[edge[1]]
    return type_error(
        "connections.circle",
        f"`Connections.branch` from `{a}` to `{b}` closes a circle of branches, or joins two roots",
        builder.required_at[edge],
        "break the circle with a `connect`, or take one `Connections.root` away",
        (a, b),
    )


def _rootless(names: Sequence[str], builder: _Builder, forest: Forest) -> list[Diagnostic]:
    return [
        Diagnostic(
            "connections.no-root",
            f"no root is declared for the overdetermined connection of `{names[node]}`; it is taken as root",
            builder.places[node],
            (names[node],),
            "connect a component that declares `Connections.root` or `Connections.potentialRoot`",
            "warning",
        )
        for node in forest.rootless
    ]
