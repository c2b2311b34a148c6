"""The flow variable that goes with each stream variable (Modelica 3.6, 15.1)."""

from __future__ import annotations

from acausal.lang.arithmetic import type_error
from acausal.lang.component_plan import Plan
from acausal.lang.flat import REAL, ScalarType
from acausal.lang.instance import Array, Connection, Instance, Leaf, Member, Outer
from acausal.lang.links import components


def stream_flows(root: Instance) -> dict[str, Leaf]:
    """The flow variable beside every stream variable, by its path. Raises `stream.flow-variable`."""
    found: dict[str, Leaf] = {}
    for instance in components(root):
        if instance.is_connector:
            own = _own_leaves(instance)
            streams = [leaf for leaf in own if leaf.prefixes.connection is Connection.STREAM]
            if streams:
                flow = _the_flow(instance, own)
                found |= {leaf.path: flow for leaf in streams}
    return found


def _own_leaves(connector: Instance) -> list[Leaf]:
    """Scalars of a connector, those of the connectors inside it left out."""
    found: list[Leaf] = []
    stack: list[Member | Outer] = list(reversed(connector.members.values()))
    while stack:
        member = stack.pop()
        if isinstance(member, Leaf):
            found.append(member)
        elif isinstance(member, Array):
            stack.extend(reversed(member.items))
        elif isinstance(member, Instance) and not member.is_connector:
            stack.extend(reversed(member.members.values()))
    return found


def _the_flow(connector: Instance, own: list[Leaf]) -> Leaf:
    flows = [leaf for leaf in own if leaf.prefixes.connection is Connection.FLOW]
    if len(flows) != 1:
        raise type_error(
            "stream.flow-variable",
            f"the connector `{connector.path}` has stream variables and {len(flows)} flow variables; "
            "it must have exactly one",
            connector.span,
            "the flow variable says how much of what the stream variables describe flows",
            (connector.path,),
        )
    return flows[0]


def check_stream(path: str, type_: ScalarType, plan: Plan) -> None:
    """Stream variables are Reals in connectors (4.4.2.2, 15.1). Raises `stream.type`, `stream.place`."""
    if type_ != REAL:
        message = f"the stream variable `{path}` must be a Real, not {type_}"
        raise type_error("stream.type", message, plan.declaration.span, "", (path,))
    around = plan.context.instance
    if around is None or around.scope.kind not in ("connector", "record"):
        message = f"the stream variable `{path}` stands outside a connector"
        raise type_error("stream.place", message, plan.declaration.span, "", (path,))
