"""Iterators of `for`, of array constructors and of reductions (Modelica 3.6, 8.3.2, 10.4.1 and 11.2.2)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from acausal.lang import ast
from acausal.lang.arithmetic import as_value, type_error
from acausal.lang.flat import BOOLEAN, ScalarType, Variability
from acausal.lang.implicit_ranges import implicit_values
from acausal.lang.references import resolve
from acausal.lang.scope import Scope
from acausal.lang.translation import Env, Translation
from acausal.lang.values import Value, describe, enumeration_literal, literal, scalar
from acausal.symbolic.expressions import expr as ex

MAX_ITERATIONS = 200_000


def iterate(
    translation: Translation, iterators: Sequence[ast.Iterator], env: Env, body: object
) -> Iterator[Env]:
    """One environment per combination of the iterators' values, the last one running fastest.

    `body` is what is repeated: it gives the ranges that are left out.
    """
    _check_length(translation, iterators, env, body)
    return _combinations(translation, iterators, env, body)


def _combinations(
    translation: Translation, iterators: Sequence[ast.Iterator], env: Env, body: object
) -> Iterator[Env]:
    if not iterators:
        yield env
        return
    first, rest = iterators[0], iterators[1:]
    for value in translation.turns(iterator_values(translation, first, env, body), first.span):
        yield from _combinations(translation, rest, env.with_locals({first.name: value}), body)


def _check_length(
    translation: Translation, iterators: Sequence[ast.Iterator], env: Env, body: object
) -> None:
    """Refuse a loop that would run without end, judged by the first values of its iterators."""
    count = 1
    for iterator in iterators:
        values = iterator_values(translation, iterator, env, body)
        count *= len(values)
        if count > MAX_ITERATIONS:
            message = f"this loop runs more than {MAX_ITERATIONS} times"
            raise type_error("for.too-long", message, iterator.span, "", (iterator.name,))
        if not values:
            return
        env = env.with_locals({iterator.name: values[0]})


def require_parameters(translation: Translation, iterators: Sequence[ast.Iterator], env: Env) -> None:
    """The range of a `for` in an equation section depends on parameters only (8.3.2.1)."""
    for iterator in iterators:
        if iterator.range is None or not isinstance(
            iterator.range, (ast.ComponentReference, ast.ArrayConstructor)
        ):
            continue  # others are evaluated at compile time
        if enumerated(translation, iterator.range, env) is not None:
            continue
        value = translation.value(iterator.range, env)
        names = ex.symbols(value.items) if isinstance(value, Value) else ()
        for name in names:
            leaf = translation.leaf(name)
            if leaf is None or leaf.prefixes.variability > Variability.PARAMETER:
                message = (
                    f"the range of `{iterator.name}` may use parameters and constants only, not `{name}`"
                )
                raise type_error("for.range", message, iterator.range.span, "", (name,))


def iterator_values(translation: Translation, iterator: ast.Iterator, env: Env, body: object) -> list[Value]:
    """The values a `for` index takes."""
    if iterator.range is None:
        return implicit_values(translation, iterator, body, env)
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
    type_ = enumerated_type(translation, node, env)
    if type_ is None:
        return None
    if type_ == BOOLEAN:
        return [literal(False), literal(True)]
    return [enumeration_literal(type_, i) for i in range(1, len(type_.literals) + 1)]


def enumerated_type(translation: Translation, node: ast.Expression, env: Env) -> ScalarType | None:
    """`Boolean` or the enumeration that a name stands for; None for anything else."""
    if not isinstance(node, ast.ComponentReference) or node.parts[0].name in env.locals:
        return None
    if node.text == "Boolean":
        return BOOLEAN
    resolved = resolve(translation, node, env)
    if not isinstance(resolved, Scope):
        return None
    simple = translation.instances.simple_type(resolved)
    if simple is None or not (simple.scalar == BOOLEAN or simple.scalar.is_enumeration):
        return None
    return simple.scalar
