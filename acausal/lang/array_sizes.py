"""The sizes of array components: written as expressions, as types, or `:` and taken from the value."""

from __future__ import annotations

from collections.abc import Sequence
from math import prod

from acausal.errors import AcausalError, Span, TypeProblem, fail
from acausal.lang import ast
from acausal.lang.modifiers import Context, Modifier
from acausal.lang.translation import Env, Translation
from acausal.lang.values import shape_of

MAX_ELEMENTS = 100_000
"""Bound on the elements of one array component."""
MAX_DIMENSIONS = 100


def array_shape(
    translation: Translation,
    written: Sequence[tuple[ast.Subscripts, Context]],
    modifier: Modifier,
    path: str,
    span: Span,
    sizes: list[int],
    *,
    growing: bool = False,
) -> tuple[int, ...]:
    """The sizes of a component, outermost first. They are put into `sizes` one by one, so that a later size
    may depend on an earlier one: `Real A[:, size(A, 1)]`. A `growing` array of unknown size starts empty.
    """
    if sum([len(dimensions.items) for dimensions, _ in written]) > MAX_DIMENSIONS:
        message = f"`{path}` has more than {MAX_DIMENSIONS} dimensions"
        raise fail(TypeProblem, "array.dimensions", message, span, names=[path])
    for dimensions, context in written:
        for item in dimensions.items:
            if isinstance(item, ast.Colon) and growing and modifier.binding is None:
                sizes.append(0)
            elif isinstance(item, ast.Colon):
                sizes.append(_from_value(translation, modifier, len(sizes), path, span))
            else:
                sizes.append(_evaluated(translation, item, context, path))
            if prod(sizes) > MAX_ELEMENTS:
                raise bad_size(path, prod(sizes), item.span)
    return tuple(sizes)


def _evaluated(translation: Translation, item: ast.Expression, context: Context, path: str) -> int:
    values = translation.enumerated(item, Env(context))
    if values is not None:
        return len(values)
    size = translation.evaluate(item, context, f"the size of `{path}`")
    if not isinstance(size, int) or isinstance(size, bool) or size < 0:
        raise bad_size(path, size, item.span)
    return size


def _from_value(translation: Translation, modifier: Modifier, position: int, path: str, span: Span) -> int:
    binding = modifier.binding
    if binding is None:
        raise fail(
            TypeProblem,
            "array.unknown-size",
            f"the size of `{path}` is `:` and there is no value to take it from",
            span,
            names=[path],
            hint="give it a value or a size",
        )
    shape = shape_of(translation.binding_value(binding))
    if position >= len(shape):
        raise fail(
            TypeProblem,
            "type.array-size",
            f"`{path}` has more dimensions than its value, which has {len(shape)}",
            binding.span,
            names=[path],
        )
    return shape[position]


def bad_size(path: str, size: object, span: Span) -> AcausalError:
    """The error for a size that is no natural number, or too large."""
    return fail(
        TypeProblem,
        "array.bad-size",
        f"the size of `{path}` is {size}; it must be an Integer from 0 to {MAX_ELEMENTS}",
        span,
        names=[path],
    )
