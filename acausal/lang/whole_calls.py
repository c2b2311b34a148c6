"""Calls with many arguments in when-clauses: one node, whose arguments all results share (11.2.7).

Every result of such a function (the transform of a buffer, say) may depend on every argument: written out,
each equation would hold what the function computes on the way. The function is therefore inlined once, for
arguments of its own, and becomes a kernel where that comes to more than `MOST_WRITTEN_OUT` operations.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace

from acausal.errors import AcausalError
from acausal.lang.flat import Variability
from acausal.lang.function_kernels import parts_of, site_key
from acausal.lang.scope import Scope
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue, RecordArray, RecordValue, Value
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr, Kind
from acausal.symbolic.expressions.kernels.formula import Formula

MANY = 16
"""Elements of arrays that change with time from which on a function is looked at as a whole."""
MOST_WRITTEN_OUT = 3_000
_LEAVES = frozenset({"sym", "der", "pre"})
_CAPTURED = Kind("captured", _LEAVES, lambda node: node.args)
_Arguments = dict[str, AnyValue]


def called_as_whole(
    translation: Translation,
    scope: Scope,
    given: _Arguments,
    env: Env,
    run: Callable[[_Arguments], list[AnyValue]],
) -> list[AnyValue] | None:
    """The results of `run(arguments)`, as parts of a kernel if they are large.

    None where it has few arguments that vary, or `run` fails: with the arguments as they are the message will
    name them.
    """
    actual: dict[Expr, Expr] = {}
    opening = _Opening(translation, actual, {})
    opened = {name: opening.opened(value, f"#{env.depth}.{name}") for name, value in given.items()}
    if len(actual) < MANY:
        return None
    checks = len(translation.assertions)
    try:
        results = run(opened)
    except AcausalError:
        del translation.assertions[checks:]
        return None
    values = [value for value in results if isinstance(value, Value)]
    roots = tuple([item for value in values for item in value.items])
    memo: dict[Expr, Expr] = {}
    for k in range(checks, len(translation.assertions)):
        old = translation.assertions[k]
        condition, message = (ex.substitute(e, actual, memo) for e in (old.condition, old.message))
        translation.assertions[k] = replace(old, condition=condition, message=message)
    if len(values) < len(results) or _operations(roots) <= MOST_WRITTEN_OUT:
        return [_closed(value, actual, memo) for value in results]
    captured = [leaf for leaf in ex.gather(roots, _CAPTURED) if leaf not in actual]
    formals = (*actual, *captured)
    whole = Formula(scope.path, site_key(translation, scope), formals, roots)
    outputs = [
        e.name for e in scope.table.components.values() if e.clause.causality == "output" and not e.protected
    ]
    shown = dict(zip(outputs, values, strict=True))
    return [*parts_of(whole, (*actual.values(), *captured), scope, shown)]


@dataclass
class _Opening:
    """Puts symbols for the elements of arrays that change with time; `actual` is what these stand for."""

    translation: Translation
    actual: dict[Expr, Expr]
    changing: dict[Expr, bool]

    def opened(self, value: AnyValue, name: str) -> AnyValue:
        """An array with symbols; anything else as it is."""
        if not isinstance(value, Value) or not value.shape or value.type.external:
            return value
        items: list[Expr] = []
        for k, item in enumerate(value.items, start=1):
            if ex.fold([item], self._changes, self.changing)[item]:
                items.append(ex.sym(f"{name}[{k}]"))
                self.actual[items[-1]] = item
            else:
                items.append(item)
        return Value(value.type, value.shape, tuple(items))

    def _changes(self, node: Expr, args: list[bool]) -> bool:
        """Whether it is more than constants and parameters."""
        if node.op != "sym":
            return any(args) or node.op == "call"
        found = self.translation.leaf(node.name)
        return found is None or found.prefixes.variability > Variability.PARAMETER


def _closed(value: AnyValue, actual: Mapping[Expr, Expr], memo: dict[Expr, Expr]) -> AnyValue:
    """With the arguments in the places of the symbols."""
    if isinstance(value, RecordValue):
        return value.with_fields({name: _closed(field, actual, memo) for name, field in value.fields.items()})
    if isinstance(value, RecordArray):
        items = [_closed(item, actual, memo) for item in value.items]
        records = tuple([item for item in items if isinstance(item, RecordValue)])
        return RecordArray(value.shape, records, value.scope)
    return Value(value.type, value.shape, tuple([ex.substitute(i, actual, memo) for i in value.items]))


def _operations(roots: Iterable[Expr]) -> int:
    """Distinct nodes that compute; calls that share their arguments count as one."""
    seen: set[int] = set()
    stack = [*roots]
    count = 0
    while stack:
        node = stack.pop()
        if id(node) in seen or not node.args or node.op in _LEAVES:
            continue
        seen.add(id(node))
        if node.op == "call" and node.wide is not None:
            if id(node.wide) in seen:
                continue
            seen.add(id(node.wide))
        count += 1
        stack.extend(node.args)
    return count
