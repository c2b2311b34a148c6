"""Operators on connectors: of overconstrained connections, of stream variables, `cardinality`."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from acausal.errors import AcausalError, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.arithmetic import as_value, type_error
from acausal.lang.flat import REAL
from acausal.lang.instance import Connection, Leaf, leaves
from acausal.lang.references import Selection, resolve, selection_value
from acausal.lang.streams import in_stream_symbol
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue, Value, literal
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr

ConnectionCall = Callable[[Translation, ast.Call, Env], AnyValue]


def _argument(node: ast.Call) -> ast.Expression:
    if len(node.arguments) != 1 or node.named:
        name = node.function.text
        raise type_error("call.arguments", f"`{name}` takes 1 argument", node.span, "", (name,))
    return node.arguments[0]


def _is_root(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    return literal(translation.network(node.span).is_root(_argument(node), env))


def _rooted(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    return literal(translation.network(node.span).is_rooted(_argument(node), env))


def _cardinality(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    return literal(translation.network(node.span).cardinality(_argument(node), env))


def _streams(
    translation: Translation, node: ast.Call, env: Env
) -> tuple[Value, Sequence[tuple[Expr, Expr, Leaf]]]:
    """The argument, and for each scalar of it: itself, what stands for its inflow, its flow variable."""
    argument = _argument(node)
    network = translation.network(node.span)
    found = resolve(translation, argument, env) if isinstance(argument, ast.ComponentReference) else None
    if not isinstance(found, Selection):
        raise _no_stream(node, "its argument")
    value = as_value(selection_value(translation, found, node.span), node.span)
    parts: list[tuple[Expr, Expr, Leaf]] = []
    for leaf in [leaf for member in found.members for leaf in leaves(member)]:
        if leaf.prefixes.connection is not Connection.STREAM or leaf.path not in network.flows():
            raise _no_stream(node, f"`{leaf.path}`")
        network.asked[leaf.path] = None
        parts.append((ex.sym(leaf.path), in_stream_symbol(leaf.path), network.flows()[leaf.path]))
    return value, parts


def _no_stream(node: ast.Call, what: str) -> AcausalError:
    name = node.function.text
    message = f"`{name}` needs a stream variable of a connector, but {what} is none"
    return type_error("stream.no-stream", message, node.span, "declare it `stream` in the connector", (name,))


def _in_stream(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    value, parts = _streams(translation, node, env)
    return Value(REAL, value.shape, tuple([inflow for _, inflow, _ in parts]))


def _actual_stream(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    """`if flow > 0 then inStream(x) else x` (15.3)."""
    value, parts = _streams(translation, node, env)
    items = [
        ex.if_then_else(ex.relation("gt", ex.sym(flow.path), ex.ZERO), inflow, own)
        for own, inflow, flow in parts
    ]
    return Value(REAL, value.shape, tuple(items))


def _unsupported(_translation: Translation, node: ast.Call, _env: Env) -> AnyValue:
    name = node.function.text
    message = f"`{name}(...)` is not supported"
    raise fail(UnsupportedProblem, "unsupported.connections", message, node.span, names=[name])


CONNECTION_CALLS: dict[str, ConnectionCall] = {
    "Connections.isRoot": _is_root,
    "Connections.rooted": _rooted,
    "rooted": _rooted,
    "cardinality": _cardinality,
    "inStream": _in_stream,
    "actualStream": _actual_stream,
    "Connections.uniqueRoot": _unsupported,
    "Connections.uniqueRootIndices": _unsupported,
}
