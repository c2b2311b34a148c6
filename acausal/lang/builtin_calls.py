"""Calls of built-in functions of values; some of them take records too."""

from __future__ import annotations

from acausal.lang import ast
from acausal.lang.arithmetic import as_value
from acausal.lang.array_functions import Builtin
from acausal.lang.operations import EVENT_FUNCTIONS, without_events
from acausal.lang.operator_records import sum_of_records
from acausal.lang.record_arrays import REARRANGING, rearranged
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue, Value


def builtin_value(
    translation: Translation, name: str, builtin: Builtin, node: ast.Call, env: Env
) -> AnyValue:
    """A built-in function of values; some take records too."""
    values = [translation.value(arg, env) for arg in node.arguments]
    for value in values:
        translation.counted(value, node.span)
    if all(isinstance(value, Value) for value in values):
        value = builtin(values, node.span)
        return without_events(value) if env.depth and name in EVENT_FUNCTIONS else value
    if name in REARRANGING:
        return rearranged(name, values, node.span)
    if name == "sum" and len(values) == 1:
        return sum_of_records(translation, values[0], node.span, env)
    return builtin(
        [as_value(value, arg.span) for value, arg in zip(values, node.arguments, strict=True)], node.span
    )
