"""`function f_x = der(f, x)`: partial derivatives of functions (Modelica 3.6, 12.7.2)."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from acausal.errors import AcausalError, Span
from acausal.lang import ast
from acausal.lang.arithmetic import type_error
from acausal.lang.flat import INTEGER, REAL
from acausal.lang.scope import Scope
from acausal.lang.values import AnyValue, Value
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.diff import NotDifferentiable, partial
from acausal.symbolic.expressions.expr import Expr

Run = Callable[[Scope, dict[str, AnyValue]], list[AnyValue]]
"""The results of a function for given inputs."""


def differentiated(
    scope: Scope, definition: ast.DerClass, given: Mapping[str, AnyValue], span: Span, run: Run
) -> list[AnyValue]:
    """The derivatives of all results of the base function by the named inputs, one after the other.

    Raises TypeProblem `function.partial-derivative`.
    """
    inputs = dict(given)
    actual: dict[Expr, Expr] = {}
    for name in dict.fromkeys(definition.variables):
        value = given.get(name)
        entry = scope.table.components.get(name)
        if entry is None or entry.clause.causality != "input":
            raise _impossible(scope, f"`{name}` is no input of it", definition.span)
        if not isinstance(value, Value) or value.shape or value.type not in (REAL, INTEGER):
            raise _impossible(scope, f"`{name}` must be given, as a Real scalar", span)
        symbol = ex.sym(f"{scope.path}.{name}")
        inputs[name] = Value(REAL, (), (symbol,))
        actual[symbol] = value.item
    results: list[AnyValue] = []
    for result in run(scope.table.bases[0].scope, inputs):
        if not isinstance(result, Value) or result.type != REAL:
            raise _impossible(scope, "its results must be Reals", definition.span)
        items = [_slope(scope, item, definition, actual, span) for item in result.items]
        results.append(Value(REAL, result.shape, tuple(items)))
    return results


def _slope(
    scope: Scope, item: Expr, definition: ast.DerClass, actual: Mapping[Expr, Expr], span: Span
) -> Expr:
    try:
        for name in definition.variables:
            item = partial(item, ex.sym(f"{scope.path}.{name}"))
    except NotDifferentiable as problem:
        raise _impossible(scope, str(problem), span) from None
    return ex.substitute(item, actual)


def _impossible(scope: Scope, why: str, span: Span) -> AcausalError:
    message = f"the partial derivative `{scope.path}` cannot be computed: {why}"
    return type_error("function.partial-derivative", message, span, "", (scope.path,))
