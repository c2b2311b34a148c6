"""`assert` and `terminate`, wherever they stand: equations, algorithms and functions (8.3.7, 8.3.8)."""

from __future__ import annotations

from acausal.errors import UnsupportedProblem
from acausal.lang import ast
from acausal.lang.arithmetic import as_boolean, as_scalar, type_error
from acausal.lang.flat import STRING, Assertion
from acausal.lang.printer import print_expression
from acausal.lang.translation import Env, Translation
from acausal.lang.values import describe
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import EnumValue, Expr


def assertion_of(translation: Translation, call: ast.Call, env: Env, component: str) -> Assertion:
    """`assert(condition, message, level)` as written at `call`."""
    arguments = dict(zip(("condition", "message", "level"), call.arguments, strict=False))
    arguments |= {named.name: named.value for named in call.named}
    known = {"condition", "message", "level"}
    if not {"condition", "message"} <= arguments.keys() <= known or len(call.arguments) > len(known):
        message = "`assert` takes a condition, a message and, optionally, a level"
        raise type_error("call.arguments", message, call.span, "", ("assert",))
    condition = as_boolean(translation.value(arguments["condition"], env), arguments["condition"].span)
    level = "error"
    if "level" in arguments:
        level = _level(translation, arguments["level"], env)
    text = _text(translation, arguments["message"], env, "an assertion")
    return Assertion(condition, text, level, call.span, component)


def termination_text(translation: Translation, call: ast.Call, env: Env) -> Expr:
    """The message of `terminate(message)`."""
    arguments = [*call.arguments, *[named.value for named in call.named if named.name == "message"]]
    if len(arguments) != 1 or len(call.arguments) + len(call.named) != 1:
        message = "`terminate` takes a message"
        raise type_error("call.arguments", message, call.span, "", ("terminate",))
    return _text(translation, arguments[0], env, "`terminate`")


def _level(translation: Translation, node: ast.Expression, env: Env) -> str:
    found = translation.evaluate_in(node, env, "the level of an assertion")
    if not isinstance(found, EnumValue) or found.type_name != "AssertionLevel":
        message = "the level of an assertion is AssertionLevel.error or AssertionLevel.warning"
        raise type_error("type.mismatch", message, node.span)
    return found.literal


def _text(translation: Translation, node: ast.Expression, env: Env, what: str) -> Expr:
    """The text of a message; one that cannot be computed is shown as it is written."""
    start = len(translation.assertions)
    try:
        value = as_scalar(translation.value(node, env), node.span)
    except UnsupportedProblem:
        return ex.const(print_expression(node))
    finally:
        del translation.assertions[start:]  # a message is evaluated when it is needed (8.3.7)
    if value.type != STRING:
        message = f"the message of {what} is a String, not {describe(value)}"
        raise type_error("type.mismatch", message, node.span)
    return value.item


def guard_assertions(found: list[Assertion], start: int, guard: Expr) -> None:
    """Those from `start` on hold only where `guard` is true."""
    otherwise = ex.logical_not(guard)
    for k in range(start, len(found)):
        old = found[k]
        condition = ex.logical_or(otherwise, old.condition)
        found[k] = Assertion(condition, old.message, old.level, old.span, old.component)


def add_assertion(found: list[Assertion], assertion: Assertion, guard: Expr) -> None:
    """Add an assertion that holds where `guard` is true, unless it always does."""
    condition = ex.logical_or(ex.logical_not(guard), assertion.condition)
    if not (condition.is_const and condition.value):
        a = assertion
        found.append(Assertion(condition, a.message, a.level, a.span, a.component))


def without_repetitions(found: list[Assertion]) -> tuple[Assertion, ...]:
    """Each once: a function may be called many times with the same arguments.

    Raises `assertion.failed` for an error that every simulation would end in.
    """
    for assertion in found:
        if assertion.condition is ex.FALSE and assertion.level == "error":
            message = f"this assertion is never true: {assertion.message.value}"
            names = (assertion.component,) if assertion.component else ()
            raise type_error("assertion.failed", message, assertion.span, "", names)
    return tuple({(a.condition, a.message, a.level, a.component): a for a in found}.values())
