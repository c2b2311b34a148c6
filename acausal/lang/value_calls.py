"""Calls of functions with values instead of written arguments, as overloaded operators need them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from acausal.errors import Span
from acausal.lang import ast
from acausal.lang.arithmetic import type_error
from acausal.lang.scope import Scope
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue


def call_with(
    translation: Translation,
    function: Scope,
    arguments: Sequence[AnyValue],
    span: Span,
    env: Env,
    named: Mapping[str, AnyValue] | None = None,
) -> AnyValue:
    """The first result of a function of values: they get names that no Modelica text can have."""
    given = {f"#{i}": value for i, value in enumerate(arguments)}
    by_name = {name: f"#{name}" for name in named or {}}
    local = {**given, **{by_name[name]: value for name, value in (named or {}).items()}}
    call = ast.Call(
        reference(function.path, span),
        tuple([reference(key, span) for key in given]),
        tuple([ast.NamedArgument(name, reference(key, span), span) for name, key in by_name.items()]),
        (),
        span,
    )
    around = Env(env.context, local, None, env.depth, at_event=env.at_event)
    results = translation.call(function, call, around)
    if not results:
        raise type_error("function.no-result", f"`{function.path}` has no output", span, "", (function.path,))
    return results[0]


def reference(name: str, span: Span) -> ast.ComponentReference:
    """A reference of one part."""
    return ast.ComponentReference((ast.NamePart(name, None, span),), False, span)
