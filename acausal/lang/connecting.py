"""One `connect` equation: both its sides into the connection sets (Modelica 3.6, 9.1)."""

from __future__ import annotations

from acausal.lang import ast
from acausal.lang.arithmetic import type_error
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
        sides = f"`{print_expression(node.left)}` and `{print_expression(node.right)}`"
        message = f"{sides} have different sizes: {list(left.shape)} and {list(right.shape)}"
        raise type_error("connect.mismatch", message, node.span, "", (node.left.text, node.right.text))
    for side in (left, right):
        if side.hidden:
            sets.hidden.update([leaf.path for member in side.members for leaf in leaves(member)])
    component = "" if env.context.instance is None else env.context.instance.path
    for x, y in zip(left.members, right.members, strict=True):
        connect(sets, (x, left.inside), (y, right.inside), node.span, component)
