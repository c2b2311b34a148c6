"""Subscripts that vary at run time: `x[i]` is `if i == 1 then x[1] elseif i == 2 then x[2] ...` (10.5).

That `i` lies between 1 and the size is an assertion. `VariableIndex` is raised where a subscript is
evaluated; who knows the whole reference replaces it by each of the choices. Elsewhere (in `connect`, in
sizes) it is the error it is.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from acausal.errors import Span, TypeProblem, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.arithmetic import choose
from acausal.lang.assertions import add_assertion
from acausal.lang.flat import BOOLEAN, INTEGER, Assertion, ScalarType
from acausal.lang.light import light_object
from acausal.lang.translation import Translation
from acausal.lang.values import AnyValue, RecordArray, RecordValue, Value, zero_of
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import EnumValue, Expr

MOST_CHOICES = 10_000
"""Elements that one varying subscript may choose from."""


@light_object
class Choice:
    """A subscript that varies: its place in the source, its value, and the size of the dimension."""

    node: ast.Expression
    index: Expr
    size: int
    type: ScalarType
    path: str

    def test(self, k: int) -> Expr:
        """Whether the subscript is `k`, from 1."""
        if self.type == BOOLEAN:
            return self.index if k == 2 else ex.logical_not(self.index)
        if self.type == INTEGER:
            return ex.relation("eq", self.index, ex.const(k))
        value = EnumValue(self.type.name, self.type.literals[k - 1], k)
        return ex.relation("eq", self.index, ex.const(value))

    def check(self, translation: Translation, guard: Expr) -> None:
        """Assert that the subscript is one of the choices where `guard` is true."""
        if self.type != INTEGER:
            return
        low = ex.relation("ge", self.index, ex.const(1))
        high = ex.relation("le", self.index, ex.const(self.size))
        text = ex.const(f"the subscript of {self.path} is not between 1 and {self.size}")
        assertion = Assertion(ex.logical_and(low, high), text, "error", self.node.span)
        add_assertion(translation.assertions, assertion, guard)


class VariableIndex(TypeProblem):
    """A subscript is known at run time only; `choice` says which."""

    choice: Choice | None = None


def variable_index(problem: TypeProblem, choice: Choice) -> VariableIndex:
    """The error with the choice that may resolve it."""
    result = VariableIndex(problem.diagnostics)
    result.choice = choice
    return result


def with_index(reference: ast.ComponentReference, choice: Choice, k: int) -> ast.ComponentReference:
    """The reference with the varying subscript replaced by `k`."""
    return replace(reference, parts=tuple([_part(part, choice, k) for part in reference.parts]))


def with_colon(reference: ast.ComponentReference, choice: Choice) -> ast.ComponentReference:
    """The reference with the varying subscript replaced by `:`."""
    return replace(reference, parts=tuple([_part(part, choice, None) for part in reference.parts]))


def element_of_nothing(translation: Translation, value: AnyValue, choice: Choice) -> AnyValue:
    """`x[i]` of an `x` without elements: never to be reached, which is asserted; it only needs a type."""
    if not isinstance(value, Value) or len(value.shape) != 1:
        message = f"`{choice.path}` has no elements"
        raise fail(TypeProblem, "type.index-out-of-range", message, choice.node.span, names=[choice.path])
    text = ex.const(f"{choice.path} has no elements")
    add_assertion(translation.assertions, Assertion(ex.FALSE, text, "error", choice.node.span), ex.TRUE)
    return Value(value.type, (), (zero_of(value.type),))


def _part(part: ast.NamePart, choice: Choice, k: int | None) -> ast.NamePart:
    if part.subscripts is None:
        return part
    return replace(part, subscripts=with_chosen(part.subscripts, choice, k))


def with_chosen(subscripts: ast.Subscripts, choice: Choice, k: int | None) -> ast.Subscripts:
    """The subscripts with the varying one replaced by `k`, or by `:`."""
    at = choice.node.span
    number = ast.Colon(at) if k is None else ast.IntegerLiteral(k, at)
    items = tuple([number if item is choice.node else item for item in subscripts.items])
    return replace(subscripts, items=items)


def holds(reference: ast.ComponentReference, choice: Choice) -> bool:
    """Whether the varying subscript is one of this reference's own."""
    subscripts = [part.subscripts for part in reference.parts if part.subscripts is not None]
    return any(item is choice.node for s in subscripts for item in s.items)


def chosen(choice: Choice, values: Sequence[AnyValue], span: Span) -> AnyValue:
    """The value whose number, from 1, the subscript is."""
    result = values[-1]
    for k in range(len(values) - 1, 0, -1):
        result = choose(choice.test(k), values[k - 1], result, span)
    return result


def with_changes(test: Expr, old: AnyValue, new: AnyValue, result: AnyValue) -> AnyValue:
    """`result`, but where `new` differs from `old` that is taken if `test` is true."""
    if new is old:
        return result
    if isinstance(new, Value) and isinstance(old, Value) and isinstance(result, Value):
        rows = zip(old.items, new.items, result.items, strict=True)
        merged = tuple([r if n is o else ex.if_then_else(test, n, r) for o, n, r in rows])
        return Value(result.type, result.shape, merged)
    if isinstance(new, RecordValue) and isinstance(old, RecordValue) and isinstance(result, RecordValue):
        names = list(result.fields)
        parts = [with_changes(test, old.fields[n], new.fields[n], result.fields[n]) for n in names]
        return result.with_fields(dict(zip(names, parts, strict=True)))
    if isinstance(new, RecordArray) and isinstance(old, RecordArray) and isinstance(result, RecordArray):
        records = zip(old.items, new.items, result.items, strict=True)
        changed = [with_changes(test, o, n, r) for o, n, r in records]
        return RecordArray(
            result.shape, tuple([c for c in changed if isinstance(c, RecordValue)]), result.scope
        )
    return new


def check_size(choice: Choice) -> None:
    """Raise where there is too much to choose from."""
    if choice.size > MOST_CHOICES:
        message = f"a subscript that varies cannot choose from the {choice.size} elements of `{choice.path}`"
        hint = f"the most is {MOST_CHOICES}"
        raise fail(
            UnsupportedProblem,
            "unsupported.variable-subscript",
            message,
            choice.node.span,
            names=[choice.path],
            hint=hint,
        )
