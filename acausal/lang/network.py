"""What the connections of a whole model answer: roots of overconstrained connections, `cardinality`.

The answers are needed while equations are translated, for `if` equations and assertions that use them, but
they depend on all `connect` equations; these are looked at once, when the first question comes.
"""

from __future__ import annotations

from collections.abc import Mapping

from acausal.errors import Span
from acausal.lang import ast
from acausal.lang.arithmetic import type_error
from acausal.lang.connection_errors import not_a_connector
from acausal.lang.connection_nodes import connector_side
from acausal.lang.expandable import Expansion, expand
from acausal.lang.instance import Absent, Instance, Leaf
from acausal.lang.links import Link, links_of
from acausal.lang.scope import Scope
from acausal.lang.stream_flows import stream_flows
from acausal.lang.translation import Env, Translation
from acausal.lang.virtual_graph import VirtualGraph, graph_node, virtual_graph


class Network:
    """The connections of one model. `overdetermined` holds `equalityConstraint` of records by path."""

    def __init__(
        self, translation: Translation, root: Instance, overdetermined: Mapping[str, Scope], has_streams: bool
    ) -> None:
        self._translation = translation
        self._root = root
        self.overdetermined = overdetermined
        self._links: list[Link] | None = None
        self._graph: VirtualGraph | None = None
        self._counts: dict[str, int] | None = None
        self._busy = False
        self.expansion = Expansion()
        self._has_streams = has_streams
        self._flows: dict[str, Leaf] | None = None
        self.asked: dict[str, None] = {}
        """Stream variables that `inStream` is applied to."""

    def links(self, span: Span) -> list[Link]:
        """All links. Raises `connections.cyclic` when a condition around one of them depends on them."""
        if self._links is None:
            if self._busy:
                message = "whether this `connect` exists depends on the connections themselves"
                raise type_error("connections.cyclic", message, span)
            self._busy = True
            self._links = links_of(self._translation, self._root)
            self._busy = False
        return self._links

    def expand(self, span: Span) -> None:
        """Elaborate the expandable connectors."""
        self.expansion = expand(self._translation, self._root, self.links(span))

    def graph(self, span: Span) -> VirtualGraph:
        """The spanning trees of overconstrained connections."""
        if self._graph is None:
            links = self.links(span)
            self._graph, warnings = virtual_graph(self._translation, links, self.overdetermined)
            self._translation.warnings.extend(warnings)
        return self._graph

    def is_root(self, argument: ast.Expression, env: Env) -> bool:
        """`Connections.isRoot`."""
        node = graph_node(self._translation, argument, env, self.overdetermined)
        return self.graph(argument.span).is_root(node)

    def is_rooted(self, argument: ast.Expression, env: Env) -> bool:
        """`Connections.rooted`."""
        node = graph_node(self._translation, argument, env, self.overdetermined)
        return self.graph(argument.span).is_rooted(node, argument.span)

    def flows(self) -> dict[str, Leaf]:
        """The flow variable beside each stream variable, by its path."""
        if self._flows is None:
            self._flows = stream_flows(self._root) if self._has_streams else {}
        return self._flows

    def cardinality(self, argument: ast.Expression, env: Env) -> int:
        """How often a connector stands in a `connect` equation (3.7.4.3)."""
        if not isinstance(argument, ast.ComponentReference):
            message = "`cardinality` needs a connector"
            raise type_error("call.arguments", message, argument.span, "", ("cardinality",))
        members = connector_side(self._translation, argument, env).members
        if members and isinstance(members[0], Leaf) and not members[0].connector:
            raise not_a_connector(members[0], argument.span)
        if self._counts is None:
            self._counts = self._count(argument.span)
        return self._counts.get(members[0].path, 0) if len(members) == 1 else 0

    def _count(self, span: Span) -> dict[str, int]:
        """A connection with a component that is not there counts for none of its sides (4.4.5)."""
        counts: dict[str, int] = {}
        for link in self.links(span):
            if isinstance(link.node, ast.ConnectEquation):
                left, right = (
                    connector_side(self._translation, node, link.env).members
                    for node in (link.node.left, link.node.right)
                )
                for pair in zip(left, right, strict=False):  # sizes are compared where it is connected
                    if not any(isinstance(member, Absent) and not member.potential for member in pair):
                        for member in pair:
                            counts[member.path] = counts.get(member.path, 0) + 1
        return counts
