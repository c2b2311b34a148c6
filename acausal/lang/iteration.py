"""Iterators of `for`, of array constructors and of reductions (Modelica 3.6, 8.3.2, 10.4.1 and 11.2.2)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from acausal.errors import UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.arithmetic import as_value, type_error
from acausal.lang.references import resolve
from acausal.lang.scope import Scope
from acausal.lang.translation import Env, Translation
from acausal.lang.values import Value, describe, enumeration_literal, literal, scalar

MAX_ITERATIONS = 200_000


def iterate(translation: Translation, iterators: Sequence[ast.Iterator], env: Env) -> Iterator[Env]:
    """One environment per combination of the iterators' values, the last one running fastest."""
    _check_length(translation, iterators, env)
    return _combinations(translation, iterators, env)


def _combinations(translation: Translation, iterators: Sequence[ast.Iterator], env: Env) -> Iterator[Env]:
    if not iterators:
        yield env
        return
    for value in iterator_values(translation, iterators[0], env):
        translation.count_work(10, iterators[0].span)
        yield from _combinations(translation, iterators[1:], env.with_locals({iterators[0].name: value}))


def _check_length(translation: Translation, iterators: Sequence[ast.Iterator], env: Env) -> None:
    """Refuse a loop that would run without end, judged by the first values of its iterators."""
    count = 1
    for iterator in iterators:
        values = iterator_values(translation, iterator, env)
        count *= len(values)
        if count > MAX_ITERATIONS:
            message = f"this loop runs more than {MAX_ITERATIONS} times"
            raise type_error("for.too-long", message, iterator.span, "", (iterator.name,))
        if not values:
            return
        env = env.with_locals({iterator.name: values[0]})


def iterator_values(translation: Translation, iterator: ast.Iterator, env: Env) -> list[Value]:
    """The values a `for` index takes."""
    if iterator.range is None:
        raise fail(
            UnsupportedProblem,
            "unsupported.implicit-range",
            f"the range of `{iterator.name}` is left out, which is not supported yet",
            iterator.span,
            names=[iterator.name],
            hint=f"write `{iterator.name} in 1:n`",
        )
    kind = enumerated(translation, iterator.range, env)
    if kind is not None:
        return kind
    value = as_value(translation.value(iterator.range, env), iterator.range.span)
    if len(value.shape) != 1:
        message = f"`{iterator.name}` runs over a vector, not over {describe(value)}"
        raise type_error("for.range", message, iterator.span, "", (iterator.name,))
    return [scalar(value.type, item) for item in value.items]


def enumerated(translation: Translation, node: ast.Expression, env: Env) -> list[Value] | None:
    """The values of `Boolean` or of an enumeration type; None for anything else."""
    if not isinstance(node, ast.ComponentReference) or node.parts[0].name in env.locals:
        return None
    if node.text == "Boolean":
        return [literal(False), literal(True)]
    resolved = resolve(translation, node, env)
    if not isinstance(resolved, Scope):
        return None
    simple = translation.instances.simple_type(resolved)
    if simple is None or not simple.scalar.is_enumeration:
        return None
    return [enumeration_literal(simple.scalar, i) for i in range(1, len(simple.scalar.literals) + 1)]
