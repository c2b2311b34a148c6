"""Stream connectors: `inStream`, `actualStream` and the mixing equations (Modelica 3.6, chapter 15).

What flows into a port is a mixture of what leaves all ports connected with it, each weighted by its flow.
While equations are translated, `inStream(c.h)` stands for itself as a symbol; once all connections are
known, `Streams.resolved` puts the mixtures in. Weights are `max(f, eps)` with a small `eps`: continuous, and
where all flows vanish the mixture is the mean value.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields, is_dataclass
from typing import TypeVar, cast

from acausal.errors import Span
from acausal.lang.arithmetic import as_scalar
from acausal.lang.connections import ConnectionSets, Node
from acausal.lang.flat import Equation, Origin
from acausal.lang.instance import Leaf
from acausal.lang.translation import Translation
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr

SMALL = 1e-8
"""Flows smaller than this times their nominal value count as this much."""
_WORK_OF_TERM = 20
_T = TypeVar("_T")


def in_stream_symbol(path: str) -> Expr:
    """What stands for `inStream` of a stream variable until connections are known."""
    return ex.sym(f"inStream({path})")


@dataclass(slots=True)
class _Term:
    """A port that may feed the mixture: what flows out of it into the connection, and its property."""

    flow: Expr
    value: Expr
    nominal: float


@dataclass(slots=True)
class Streams:
    """The stream variables of a model in their connection sets, with the flow variables beside them."""

    translation: Translation
    sets: ConnectionSets
    flows: Mapping[str, Leaf]
    asked: Sequence[str]
    """The stream variables that `inStream` was applied to."""
    _groups: dict[Node, list[Node]] = field(default_factory=dict[Node, list[Node]])
    _known: dict[str, Expr] = field(default_factory=dict[str, Expr])

    def __post_init__(self) -> None:
        for node in self.sets.place:
            if node[0] in self.flows:
                self._groups.setdefault(self.sets.find(node), []).append(node)

    # ------------------------------------------------------------------ results

    def equations(self) -> list[Equation]:
        """What leaves the outside connectors of components: a mixture of what is connected inside."""
        found: list[Equation] = []
        for group in self._groups.values():
            for node in group:
                if not node[1]:
                    span, component = self.sets.place[node]
                    value = self._mixture(group, node, ex.ZERO)
                    found.append(Equation(ex.sym(node[0]), value, span, component, Origin.CONNECTION))
        return found

    def resolved(self, things: Sequence[_T]) -> tuple[_T, ...]:
        """The same equations, assertions or clauses with mixtures for `inStream`."""
        mapping = {in_stream_symbol(path): self.inflow(path) for path in self.asked}
        if not mapping:
            return tuple(things)
        memo: dict[Expr, Expr] = {}
        return tuple([cast("_T", _rewritten(thing, mapping, memo)) for thing in things])

    def inflow(self, path: str) -> Expr:
        """What would flow into the connector of a stream variable."""
        found = self._known.get(path)
        if found is None:
            node = (path, True)
            group = self._groups.get(self.sets.find(node)) if node in self.sets.place else None
            own = ex.sym(path)
            found = own if group is None else self._mixture(group, node, own)
            self._known[path] = found
        return found

    # ------------------------------------------------------------------ mixtures

    def _mixture(self, group: Sequence[Node], target: Node, otherwise: Expr) -> Expr:
        """What arrives at `target` from the other ports of its set."""
        others = [node for node in group if node != target]
        if len(others) > 1:
            others = [node for node in others if self._may_feed(node)]
        if not others:
            return otherwise
        if len(others) == 1:
            return self._property(others[0])
        self.translation.count_work(_WORK_OF_TERM * len(others), self.sets.place[target][0])
        terms = [self._term(node) for node in others]
        eps = ex.const(SMALL * min(term.nominal for term in terms))
        weights = [ex.function("max", term.flow, eps) for term in terms]
        mixed = [ex.mul(weight, term.value) for weight, term in zip(weights, terms, strict=True)]
        return ex.div(ex.add(*mixed), ex.add(*weights))

    def _property(self, node: Node) -> Expr:
        """What a port feeds into its connection: of an inside connector its variable."""
        path, inside = node
        return ex.sym(path) if inside else self.inflow(path)

    def _term(self, node: Node) -> _Term:
        flow = self.flows[node[0]]
        symbol = ex.sym(flow.path)
        nominal = self._attribute(flow, "nominal")
        size = abs(float(nominal.number)) if nominal is not None and nominal.is_const else 1.0
        return _Term(ex.neg(symbol) if node[1] else symbol, self._property(node), size or 1.0)

    def _may_feed(self, node: Node) -> bool:
        """Whether the bounds of the flow allow it to leave the port (inside) or to enter it (outside)."""
        path, inside = node
        bound = self._attribute(self.flows[path], "min" if inside else "max")
        if bound is None:
            return True
        closed = ex.relation("ge" if inside else "le", bound, ex.ZERO)
        return self.translation.decide(closed) is not True

    def _attribute(self, leaf: Leaf, name: str) -> Expr | None:
        binding = leaf.attributes.get(name)
        if binding is None:
            return None
        return as_scalar(self.translation.binding_value(binding), binding.span).item


def _rewritten(thing: object, mapping: Mapping[Expr, Expr], memo: dict[Expr, Expr]) -> object:
    """Equations and what holds them, with symbols replaced."""
    if isinstance(thing, Expr):
        return ex.substitute(thing, mapping, memo)
    if isinstance(thing, tuple):
        parts = cast("tuple[object, ...]", thing)
        return tuple([_rewritten(part, mapping, memo) for part in parts])
    if is_dataclass(thing) and not isinstance(thing, (type, Span)):
        values = [_rewritten(getattr(thing, item.name), mapping, memo) for item in fields(thing)]
        return type(thing)(*values)
    return thing
