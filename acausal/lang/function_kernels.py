"""Functions that cannot be inlined, because their loops depend on run-time values: run as a unit at events.

Such a function becomes a kernel with a part for each scalar it computes. Evaluating it runs the function's
algorithm on constants, with the same bounds on its statements as at compile time, so that it cannot run
without end.
Between events, where integration needs derivatives, these functions are refused.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice
from math import prod

from acausal.errors import AcausalError
from acausal.lang import ast
from acausal.lang.arithmetic import type_error
from acausal.lang.flat import BOOLEAN, INTEGER, REAL, STRING, ScalarType
from acausal.lang.modifiers import Context
from acausal.lang.scope import Scope
from acausal.lang.translation import Env, Translation
from acausal.lang.value_calls import reference
from acausal.lang.values import AnyValue, Value
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Constant, EnumValue, Expr
from acausal.symbolic.expressions.kernel import Part, Whole

_MOST_KEPT = 64


@dataclass(eq=False)
class Body(Whole):
    """A function with the types and sizes of the arguments it is called with; `results` of its last calls."""

    name: str
    key: str
    arity: int
    count: int
    translation: Translation
    scope: Scope
    node: ast.Call
    inputs: tuple[tuple[str, ScalarType, tuple[int, ...]], ...]
    results: dict[tuple[Constant, ...], list[Constant | None]] = field(
        default_factory=dict[tuple[Constant, ...], list["Constant | None"]]
    )

    def values(self, args: tuple[Constant, ...]) -> Sequence[Constant | None]:
        known = self.results.get(args)
        if known is None:
            if len(self.results) >= _MOST_KEPT:
                self.results.clear()
            try:
                found = self._run(args)
            except AcausalError as problem:
                raise ValueError(problem.diagnostics[0].message) from None
            items = [item for value in found if isinstance(value, Value) for item in value.items]
            known = self.results[args] = [item.value if item.is_const else None for item in items]
        return known

    def _run(self, args: tuple[Constant, ...]) -> list[AnyValue]:
        rest = iter(args)
        span = self.node.span
        local: dict[str, AnyValue] = {}
        named: list[ast.NamedArgument] = []
        for name, type_, shape in self.inputs:
            items = [ex.const(_of_type(value, type_)) for value in islice(rest, prod(shape))]
            local[f"#{name}"] = Value(type_, shape, tuple(items))
            named.append(ast.NamedArgument(name, reference(f"#{name}", span), span))
        call = ast.Call(self.node.function, (), tuple(named), (), span)
        env = Env(Context(self.scope, None), local)
        checks = len(self.translation.assertions)
        try:
            results = self.translation.call(self.scope, call, env)
            for assertion in self.translation.assertions[checks:]:
                if assertion.condition is ex.FALSE and assertion.level == "error":
                    raise type_error("function.assertion", str(assertion.message.value), assertion.span)
            return results
        finally:
            del self.translation.assertions[checks:]


def at_events(
    translation: Translation,
    scope: Scope,
    given: Mapping[str, AnyValue],
    outputs: Sequence[tuple[str, AnyValue]],
    node: ast.Call,
) -> list[AnyValue] | None:
    """The results as kernels; `outputs` have their types and sizes. None where there are records."""
    inputs: list[tuple[str, ScalarType, tuple[int, ...]]] = []
    args: list[Expr] = []
    for name, value in given.items():
        if not isinstance(value, Value) or value.type.external:
            return None
        inputs.append((name, value.type, value.shape))
        args += value.items
    values = [value for _, value in outputs if isinstance(value, Value)]
    if len(values) < len(outputs):
        return None
    count = sum(len(value.items) for value in values)
    key = site_key(translation, scope)
    body = Body(scope.path, key, len(args), count, translation, scope, node, tuple(inputs))
    return [
        *parts_of(body, tuple(args), scope, dict(zip([name for name, _ in outputs], values, strict=True)))
    ]


def site_key(translation: Translation, scope: Scope) -> str:
    """A key for the call of a function that the next one does not get."""
    return f"function {scope.path} {translation.externals.number} {translation.externals.next_site()}"


def parts_of(whole: Whole, args: tuple[Expr, ...], scope: Scope, outputs: Mapping[str, Value]) -> list[Value]:
    """The results of a call, of the types and sizes of `outputs`."""
    parts: list[Part] = []
    for name, value in outputs.items():
        result = value.type.name if value.type in (REAL, INTEGER, BOOLEAN, STRING) else "Integer"
        parts += [
            Part(whole, len(parts) + k, f"{scope.path}.{name}", result) for k in range(len(value.items))
        ]
    items = iter(ex.calls(parts, args))
    return [Value(v.type, v.shape, tuple(islice(items, len(v.items)))) for v in outputs.values()]


def _of_type(value: Constant, type_: ScalarType) -> Constant:
    """A number as a literal of the declared type: at run time there are Reals only."""
    if type_.is_enumeration and isinstance(value, (int, float)):
        index = int(value)
        return EnumValue(type_.name, type_.literals[index - 1], index)
    if isinstance(value, (int, float)):
        return {INTEGER: int, BOOLEAN: bool, REAL: float}.get(type_, float)(value)
    return value
