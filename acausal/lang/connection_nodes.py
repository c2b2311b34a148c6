"""What a `connect` equation names: connectors, and the side from which each is seen (Modelica 3.6, 9.1)."""

from __future__ import annotations

from acausal.errors import AcausalError
from acausal.lang import ast
from acausal.lang.arithmetic import type_error
from acausal.lang.instance import Absent, Array, Instance, Leaf, Member
from acausal.lang.light import light_object
from acausal.lang.references import Selection, resolve, select
from acausal.lang.translation import Env, Translation


@light_object
class ConnectorSide:
    """The connectors on one side of a `connect`: `inside` when they belong to a component of the model.

    `hidden` are protected connectors of the model itself, which nothing outside can feed.
    """

    members: tuple[Member, ...]
    inside: bool
    hidden: bool
    shape: tuple[int, ...]


def connector_side(translation: Translation, node: ast.ComponentReference, env: Env) -> ConnectorSide:
    """What one argument of `connect` names. Raises `connect.not-a-connector`, `connect.too-deep`."""
    env = env.with_connecting()
    instance = env.context.instance
    assert instance is not None  # only components have equations
    found = resolve(translation, node, env)
    if not isinstance(found, Selection) or found.constant:
        raise _no_connector(node)
    first = translation.instances.member(instance, node.parts[0].name)
    if first is None:
        raise _no_connector(node)
    own = _is_connector(first)
    hidden = own and instance.scope.table.components[node.parts[0].name].protected
    _check_path(translation, first, node, env)
    if not found.shape and isinstance(found.members[0], Array):
        array = found.members[0]
        return ConnectorSide(array.items, not own, hidden, array.shape)
    return ConnectorSide(found.members, not own, hidden, found.shape)


def _is_connector(member: Member) -> bool:
    kind = member
    while isinstance(kind, Array) and kind.items:
        kind = next((item for item in kind.items if not isinstance(item, Absent)), kind.items[0])
    return isinstance(kind, Leaf) or (isinstance(kind, Instance) and kind.is_connector)


def _check_path(translation: Translation, first: Member, node: ast.ComponentReference, env: Env) -> None:
    """`component.connector.connector`: only the first part may be something else than a connector."""
    for count in range(2, len(node.parts)):
        found = select(translation, first, node.parts[:count], env, constant=False)
        if found.members and not isinstance(found.members[0], Absent) and not _is_connector(found.members[0]):
            name = ".".join(part.name for part in node.parts[:count])
            raise type_error(
                "connect.too-deep",
                f"`{node.text}` reaches into the component `{name}`, which is not one of this model's own",
                node.span,
                "connect connectors of the model and of its direct components only",
                (node.text,),
            )


def _no_connector(node: ast.ComponentReference) -> AcausalError:
    message = f"`{node.text}` is not a connector"
    return type_error("connect.not-a-connector", message, node.span, "", (node.text,))
