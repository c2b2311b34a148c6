"""Operators on connectors: of overconstrained connections, of stream variables, `cardinality`."""

from __future__ import annotations

from collections.abc import Callable

from acausal.errors import UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.arithmetic import type_error
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue, literal

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


def _unsupported(_translation: Translation, node: ast.Call, _env: Env) -> AnyValue:
    name = node.function.text
    message = f"`{name}(...)` is not supported"
    raise fail(UnsupportedProblem, "unsupported.connections", message, node.span, names=[name])


CONNECTION_CALLS: dict[str, ConnectionCall] = {
    "Connections.isRoot": _is_root,
    "Connections.rooted": _rooted,
    "rooted": _rooted,
    "cardinality": _cardinality,
    "Connections.uniqueRoot": _unsupported,
    "Connections.uniqueRootIndices": _unsupported,
}
