"""`String(...)`: numbers, Booleans and enumeration literals as texts (Modelica 3.6, 3.7.1.2)."""

from __future__ import annotations

import re

from acausal.lang import ast
from acausal.lang.arithmetic import as_scalar, type_error
from acausal.lang.flat import BOOLEAN, INTEGER, REAL, STRING
from acausal.lang.operator_records import text_of as record_text
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue, Value, describe, scalar
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.kernels.texts import text_of

_FORMAT = re.compile(r"[-+ #0]*\d*(?:\.\d*)?[diouxXcfFeEgG]")
_MOST = 10_000
_OPTIONS = ("significantDigits", "minimumLength", "leftJustified", "format")


def string_value(translation: Translation, node: ast.Call, env: Env) -> AnyValue:
    """The text of a scalar; `significantDigits`, `minimumLength`, `leftJustified`, `format` are options.

    That of a record is what its operator says.
    """
    overloaded = record_text(translation, node, env)
    if overloaded is not None:
        return overloaded
    if not node.arguments:
        raise type_error("call.arguments", "`String` needs a value", node.span, "", ("String",))
    value = as_scalar(translation.value(node.arguments[0], env), node.arguments[0].span)
    if value.type.external:
        raise type_error("type.mismatch", f"`String` does not take {describe(value)}", node.span)
    given = _options(translation, node, value, env)
    if value.type == STRING:
        return value
    length = _whole(given.get("minimumLength", 0), "minimumLength", node)
    left = bool(given.get("leftJustified", True))
    kernel = text_of(_format(given, value, node), length, left, value.type.literals)
    return scalar(STRING, ex.apply(kernel, value.item))


def _options(translation: Translation, node: ast.Call, value: Value, env: Env) -> dict[str, object]:
    positional = ["minimumLength", "leftJustified"]
    if value.type == REAL:
        positional.insert(0, "significantDigits")
    rest = node.arguments[1:]
    if len(rest) > len(positional):
        message = f"`String` of {describe(value)} takes at most {len(positional) + 1} arguments"
        raise type_error("call.arguments", message, node.span, "", ("String",))
    written = dict(zip(positional, rest, strict=False))
    for named in node.named:
        allowed = named.name in _OPTIONS and (named.name != "significantDigits" or value.type == REAL)
        if not allowed or named.name in written:
            message = f"`String` of {describe(value)} has no argument `{named.name}` here"
            raise type_error("call.arguments", message, named.span, "", (named.name,))
        written[named.name] = named.value
    if "format" in written and len(written) > 1:
        message = "`format` replaces the other arguments of `String`"
        raise type_error("call.arguments", message, node.span, "", ("format",))
    return {n: translation.evaluate_in(e, env, f"`{n}` of `String`") for n, e in written.items()}


def _format(given: dict[str, object], value: Value, node: ast.Call) -> str:
    """A format of C without its `%`."""
    written = given.get("format")
    if written is not None:
        if (
            not isinstance(written, str)
            or not _FORMAT.fullmatch(written)
            or value.type not in (REAL, INTEGER)
        ):
            message = f"`{written}` is not a format for {describe(value)}"
            raise type_error("call.arguments", message, node.span, 'such as "8.3f" or "-6d"', ("format",))
        for number in re.findall(r"\d+", written):
            _whole(int(number[:20]), "format", node)
        return written
    if value.type == REAL:
        return f".{_whole(given.get('significantDigits', 6), 'significantDigits', node)}g"
    return "s" if value.type == BOOLEAN or value.type.is_enumeration else "d"


def _whole(value: object, name: str, node: ast.Call) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or not 0 <= value <= _MOST:
        message = f"`{name}` of `String` is an Integer from 0 to {_MOST}, not {value}"
        raise type_error("call.arguments", message, node.span, "", (name,))
    return value
