"""One `connect` equation: both its sides into the connection sets (Modelica 3.6, 9.1)."""

from __future__ import annotations

from acausal.lang import ast
from acausal.lang.connection_errors import different_sizes
from acausal.lang.connection_nodes import connector_side
from acausal.lang.connections import ConnectionSets, connect
from acausal.lang.instance import Absent, leaves
from acausal.lang.printer import print_expression
from acausal.lang.translation import Env, Translation


def add_connection(
    translation: Translation, sets: ConnectionSets, node: ast.ConnectEquation, env: Env
) -> None:
    """Add what a `connect` joins. Raises `connect.*`."""
    left = connector_side(translation, node.left, env)
    right = connector_side(translation, node.right, env)
    if any(isinstance(member, Absent) for side in (left, right) for member in side.members):
        return  # a conditional component that is not there takes its connections along (4.4.5)
    if left.shape != right.shape:
        if left.members and right.members:  # if connectors differ in kind, that comes first
            trial = ConnectionSets(in_buses=sets.in_buses)
            connect(trial, (left.members[0], left.inside), (right.members[0], right.inside), node.span, "")
        raise different_sizes(
            (node.left.text, print_expression(node.left), left.shape),
            (node.right.text, print_expression(node.right), right.shape),
            node.span,
        )
    for side in (left, right):
        if side.hidden:
            sets.hidden.update([leaf.path for member in side.members for leaf in leaves(member)])
    component = "" if env.context.instance is None else env.context.instance.path
    for x, y in zip(left.members, right.members, strict=True):
        connect(sets, (x, left.inside), (y, right.inside), node.span, component)
