"""Messages about connectors that do not fit."""

from __future__ import annotations

from collections.abc import Mapping

from acausal.errors import AcausalError, Span, TypeProblem, fail
from acausal.lang.instance import Instance, Leaf, Member
from acausal.symbolic.expressions.expr import Constant
from acausal.symbolic.expressions.text import constant_text


def not_a_connector(member: Instance | Leaf, span: Span) -> AcausalError:
    """The error for an argument of `connect` that is no connector."""
    if isinstance(member, Instance):
        what = f"a {member.scope.kind} (`{member.scope.path}`)"
    else:
        what = f"a variable of type {member.type}"
    return fail(
        TypeProblem,
        "connect.not-a-connector",
        f"`{member.path}` is {what}, not a connector",
        span,
        names=[member.path],
        hint="connect connectors of the two components",
    )


def two_quantities(a: str, b: str, quantities: Mapping[str, str], span: Span) -> AcausalError:
    """The error for connected variables of different quantities."""
    return fail(
        TypeProblem,
        "connect.quantity",
        f"`{a}` and `{b}` are connected, but the one is a `{quantities[a]}`, the other a `{quantities[b]}`",
        span,
        names=[a, b],
        hint="connect variables of one quantity, or leave the attribute `quantity` empty (Modelica 3.6, 9.3)",
    )


def mismatch(a: Member, b: Member, span: Span, why: str) -> AcausalError:
    """The error for connectors that differ."""
    return fail(
        TypeProblem,
        "connect.mismatch",
        f"`{a.path}` and `{b.path}` cannot be connected: {why}",
        span,
        names=[a.path, b.path],
        hint="connect connectors with the same variables, or put an adapter component between them",
    )


def different_sizes(
    left: tuple[str, str, tuple[int, ...]], right: tuple[str, str, tuple[int, ...]], span: Span
) -> AcausalError:
    """The error for sides of different sizes; each is its name, its text and its size."""
    (a, a_text, a_shape), (b, b_text, b_shape) = left, right
    hint = "connect one element with one element, in a `for` loop for example"
    for text, shape, other in ((a_text, a_shape, b_shape), (b_text, b_shape, a_shape)):
        if not other and len(shape) == 1 and shape[0] > 0:
            elements = f"`{text}[1]`" if shape[0] == 1 else f"`{text}[1]` to `{text}[{shape[0]}]`"
            hint = f"connect one of its elements: {elements}"
    return fail(
        TypeProblem,
        "connect.mismatch",
        f"`{a_text}` and `{b_text}` have different sizes: {list(a_shape)} and {list(b_shape)}",
        span,
        names=[a, b],
        hint=hint,
    )


def two_sources(first: str, second: str, span: Span) -> AcausalError:
    """The error for a signal that comes from two places."""
    return fail(
        TypeProblem,
        "connect.two-sources",
        f"`{first}` and `{second}` both feed the same connection; a signal has one source",
        span,
        names=[first, second],
        hint="an input can be connected to one output only",
    )


def constant_clash(a: Leaf, b: Leaf, values: Mapping[str, Constant], span: Span) -> AcausalError:
    """The error for connected connectors whose parameters differ."""
    first, second = constant_text(values[a.path]), constant_text(values[b.path])
    return fail(
        TypeProblem,
        "connect.constant",
        f"the connected parameters `{a.path}` = {first} and `{b.path}` = {second} differ",
        span,
        names=[a.path, b.path],
        hint="connected connectors need equal parameters",
    )
