"""Functions as arguments of functions, with some of their own arguments bound (Modelica 3.6, 12.4.2).

A function is handed on as the call of a kernel without arguments, which no flat model holds: `f(x)` in the
function that takes it becomes a call of the function that was given.
"""

from __future__ import annotations

from dataclasses import dataclass

from acausal.errors import AcausalError, Span
from acausal.lang import ast
from acausal.lang.arithmetic import type_error
from acausal.lang.class_table import ComponentEntry
from acausal.lang.flat import ScalarType
from acausal.lang.predefined import SIMPLE_TYPES
from acausal.lang.scope import Scope
from acausal.lang.translation import Env, Translation
from acausal.lang.value_calls import reference
from acausal.lang.values import AnyValue, Value, scalar
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Constant
from acausal.symbolic.expressions.kernel import Kernel


@dataclass(frozen=True, eq=False)
class FunctionValue(Kernel):
    """The function `scope` with the values of the arguments that are `bound`."""

    scope: Scope
    bound: dict[str, AnyValue]
    key: str
    name: str
    arity: int = 0
    result: str = "function"
    continuity: int = -1

    def evaluate(self, *args: Constant) -> Constant:
        raise ValueError(f"the function {self.name} is no value")

    @property
    def open(self) -> list[ComponentEntry]:
        """The inputs that a call gives."""
        return [entry for entry in inputs_of(self.scope) if entry.name not in self.bound]


def inputs_of(scope: Scope) -> list[ComponentEntry]:
    """The public inputs of a function, in order."""
    entries = scope.table.components.values()
    return [entry for entry in entries if entry.clause.causality == "input" and not entry.protected]


def is_function_type(entry: ComponentEntry) -> bool:
    """Whether an input of a function is a function itself."""
    if entry.clause.type.text in SIMPLE_TYPES:
        return False
    return entry.scope.find_class(entry.clause.type).kind == "function"


def function_value(
    translation: Translation,
    entry: ComponentEntry,
    node: ast.ComponentReference | ast.PartialFunction,
    env: Env,
) -> Value:
    """The argument for an input that is a function. Raises `TypeProblem`, `LookupProblem`."""
    wanted = entry.scope.find_class(entry.clause.type)
    if isinstance(node, ast.ComponentReference):
        given = given_function(env, node)
        if given is None:
            given = _made(translation, env.context.scope.find_class(node, "function"), {})
    else:
        base = given_function(env, node.function)
        scope = env.context.scope.find_class(node.function, "function") if base is None else base.scope
        bound = {} if base is None else dict(base.bound)
        names = {e.name for e in inputs_of(scope)}
        for named in node.named:
            if named.name not in names or named.name in bound:
                message = f"`{named.name}` is not an open input of `{scope.path}`"
                raise type_error("call.arguments", message, named.span, "", (named.name,))
            bound[named.name] = translation.value(named.value, env)
        given = _made(translation, scope, bound)
    _check(given, wanted, entry, node.span)
    return scalar(ScalarType(wanted.path, (), True), ex.call(given))


def _made(translation: Translation, scope: Scope, bound: dict[str, AnyValue]) -> FunctionValue:
    key = f"function {scope.path} {translation.externals.number} {translation.externals.next_site()}"
    return FunctionValue(scope, bound, key, scope.path)


def _check(given: FunctionValue, wanted: Scope, entry: ComponentEntry, span: Span) -> None:
    """The open inputs must be those of the function type, by number (12.4.2.1 wants their types too)."""
    if given.scope.kind != "function":
        message = f"`{given.scope.path}` is a {given.scope.kind}, but `{entry.name}` is a function"
        raise type_error("call.function-argument", message, span, "", (entry.name,))
    needed = [e for e in given.open if e.declaration.modification is None]
    expected = inputs_of(wanted)
    if not len(needed) <= len(expected) <= len(given.open):
        message = (
            f"`{entry.name}` is called with {len(expected)} argument(s), "
            f"but `{given.scope.path}` takes {len(given.open)} here"
        )
        hint = "bind the others: `function f(a = 1)`"
        raise type_error("call.function-argument", message, span, hint, (entry.name,))


def given_function(env: Env, name: ast.ComponentReference) -> FunctionValue | None:
    """The function that a local name stands for."""
    if name.global_ or len(name.parts) != 1:
        return None
    value = env.locals.get(name.text)
    if not isinstance(value, Value) or value.shape:
        return None
    item = value.item
    return item.kernel if item.op == "call" and isinstance(item.kernel, FunctionValue) else None


def call_given(given: FunctionValue, node: ast.Call, env: Env) -> tuple[ast.Call, Env]:
    """The call of a function that was given, with its bound arguments, and where to translate it."""
    if len(node.arguments) > len(given.open):
        raise _too_many(given, node)
    named = [
        ast.NamedArgument(entry.name, argument, argument.span)
        for entry, argument in zip(given.open, node.arguments, strict=False)
    ]
    local = {f"#{name}": value for name, value in given.bound.items()}
    bound = [ast.NamedArgument(name, reference(f"#{name}", node.span), node.span) for name in given.bound]
    call = ast.Call(node.function, (), (*named, *node.named, *bound), (), node.span)
    return call, env.with_locals(local)


def _too_many(given: FunctionValue, node: ast.Call) -> AcausalError:
    message = f"`{node.function.text}` is `{given.scope.path}` and takes {len(given.open)} argument(s) here"
    return type_error("call.arguments", message, node.span, "", (node.function.text,))
