"""Messages about values that are needed at compile time, and their bounds."""

from __future__ import annotations

from collections.abc import Sequence

from acausal.errors import AcausalError, LookupProblem, Span, TypeProblem, fail
from acausal.lang.arithmetic import type_error
from acausal.lang.instance import Leaf
from acausal.lang.modifiers import Binding, Selector
from acausal.lang.values import AnyValue, describe, first_size


def not_constant(name: str, span: Span, purpose: str) -> AcausalError:
    """The error for a compile-time value that depends on a variable."""
    return type_error(
        "structural.not-constant",
        f"{purpose} must be known at compile time, but it depends on `{name}`",
        span,
        "make it depend on parameters and constants only",
        (name,),
    )


def no_value(leaf: Leaf) -> AcausalError:
    """The error for a parameter or constant without a value."""
    return type_error(
        "parameter.no-value",
        f"`{leaf.path}` is needed at compile time but has no value",
        leaf.span,
        f"give it one: `{leaf.path} = ...` in a modification or `-p {leaf.path}=...`",
        (leaf.path,),
    )


def cyclic_parameter(cycle: Sequence[Leaf]) -> AcausalError:
    """The error for parameters that need each other's values; `cycle` is in the order of need."""
    first, names = cycle[0], [leaf.path for leaf in cycle]
    lines = ", ".join(f"`{leaf.path}` at {leaf.span}" for leaf in cycle)
    return fail(
        LookupProblem,
        "parameter.cyclic",
        f"the value of `{first.path}` depends on itself: {' -> '.join([*names, first.path])}",
        first.span,
        names=names,
        hint=f"give one of them a value of its own: {lines}",
    )


def bad_part(binding: Binding, value: AnyValue, selector: Selector) -> AcausalError:
    """The error for a value that has no part for an element or field it is given to."""
    if isinstance(selector, str):
        message = f"{describe(value)} has no field `{selector}`"
        return type_error("type.mismatch", message, binding.span, "", (selector,))
    if first_size(value) is not None:
        message = f"{describe(value)} is given to an array of {selector[1]} element(s)"
        return type_error("type.array-size", message, binding.span)
    return type_error(
        "modification.missing-each",
        f"{describe(value)} is given to every element of an array",
        binding.span,
        "write `each` in front of the modification, or give an array",
    )


def too_deep_calls(function: str, most: int, span: Span) -> AcausalError:
    """The error for a recursion without end."""
    return type_error(
        "function.recursion",
        f"functions call each other more than {most} deep, in a call of `{function}`",
        span,
        "a recursion must end by a condition that is known at compile time",
        (function,),
    )


def too_much_work(most: int, span: Span) -> AcausalError:
    """The error for a model whose loops and arrays come to more than can be compiled in a sensible time."""
    return fail(
        TypeProblem,
        "model.too-much-work",
        f"the loops and arrays of this model come to more than {most} elements; here the last of them",
        span,
        hint="are the sizes and ranges meant as they are?",
    )


def too_many_steps(function: str, most: int, span: Span) -> AcausalError:
    """The error for functions that run too long to be inlined."""
    return type_error(
        "function.too-long",
        f"functions run more than {most} statements at compile time, the last one in `{function}`",
        span,
        "check the loops of the function",
        (function,),
    )
