"""Expressions of the source to values: names resolved, types and sizes checked, functions inlined.

`Translator` is the front end's one evaluator: `value` gives the symbolic value of an expression,
`evaluate` its compile-time value (for sizes, conditions and subscripts), and `parameter_value` the value
of a parameter by its path. Parameters that were evaluated are remembered as structural.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from acausal.errors import Diagnostic, LookupProblem, Span, TypeProblem, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.arithmetic import as_boolean, as_scalar, as_value, binary, choose, type_error, unary
from acausal.lang.builtins import BUILTINS, NOT_YET, cat
from acausal.lang.flat import BOOLEAN, INTEGER, REAL, STRING, Variability
from acausal.lang.functions import call_function, construct_record
from acausal.lang.instance import Leaf
from acausal.lang.instantiate import Instantiator, enumeration_of
from acausal.lang.modifiers import Binding, Context
from acausal.lang.references import member_value, resolve
from acausal.lang.scope import Root, Scope
from acausal.lang.values import (
    AnyValue,
    Value,
    describe,
    literal,
    scalar,
    select_part,
    stack,
)
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.evaluate import EvaluationFailed, NotConstant, evaluate
from acausal.symbolic.expressions.expr import Constant, Expr
from acausal.symbolic.expressions.text import to_text

MAX_RANGE = 1_000_000
MAX_CALL_DEPTH = 60


@dataclass(frozen=True, slots=True, eq=False)
class Env:
    """Where an expression is translated: its context, local names (iterators, function variables)."""

    context: Context
    locals: Mapping[str, AnyValue] = field(default_factory=lambda: {})
    size: int | None = None
    """Size of the dimension being subscripted: the value of `end`."""
    depth: int = 0
    """How many function calls deep."""

    def with_locals(self, more: Mapping[str, AnyValue]) -> Env:
        return replace(self, locals={**self.locals, **more})


class Translator:
    """See the module's text. One per compilation."""

    def __init__(self, root: Root) -> None:
        self.root = root
        self.instances = Instantiator(root, self.evaluate)
        self.leaves: dict[str, Leaf] = {}
        self.structural: dict[str, None] = {}
        self.warnings: list[Diagnostic] = []
        self._values: dict[str, Constant] = {}
        self._busy: list[str] = []

    # ------------------------------------------------------------------ compile-time values

    def evaluate(self, expression: ast.Expression, context: Context, purpose: str) -> Constant:
        """The value of a scalar expression at compile time; its parameters become structural.

        Raises `TypeProblem` `structural.not-constant` when it depends on a variable.
        """
        return self.evaluate_in(expression, Env(context), purpose)

    def evaluate_in(self, expression: ast.Expression, env: Env, purpose: str) -> Constant:
        value = as_scalar(self.value(expression, env), expression.span)
        return self.evaluate_expr(value.item, expression.span, purpose)

    def evaluate_expr(self, item: Expr, span: Span, purpose: str) -> Constant:
        """As `evaluate`, for a translated scalar."""
        if item.is_const and item.value is not None:
            return item.value
        try:
            result = evaluate(item, self.parameter_value)
        except NotConstant as problem:
            raise _not_constant(problem.name, span, purpose) from None
        except EvaluationFailed as problem:
            raise type_error("parameter.arithmetic", f"{problem} in {purpose}: `{to_text(item)}`", span) from None
        for name in ex.symbols([item]):
            self.structural[name] = None
        return result

    def parameter_value(self, path: str) -> Constant | None:
        """The value of a parameter or constant; None for anything else. Raises on cycles."""
        if path in self._values:
            return self._values[path]
        leaf = self.leaves.get(path)
        if leaf is None or leaf.prefixes.variability > Variability.PARAMETER:
            return None
        if path in self._busy:
            raise _cyclic_parameter(self._busy[self._busy.index(path) :], self.leaves)
        self._busy.append(path)
        try:
            value = self._compute_parameter(leaf)
        finally:
            self._busy.pop()
        self._values[path] = value
        return value

    def _compute_parameter(self, leaf: Leaf) -> Constant:
        binding = leaf.binding or leaf.attributes.get("start")
        if binding is None:
            raise type_error(
                "parameter.no-value",
                f"`{leaf.path}` is needed at compile time but has no value",
                leaf.span,
                f"give it one: `{leaf.path} = ...` in a modification or `-p {leaf.path}=...`",
                (leaf.path,),
            )
        item = as_scalar(self.binding_value(binding), binding.span).item
        try:
            result = evaluate(item, self.parameter_value)
        except NotConstant as problem:
            raise _not_constant(problem.name, binding.span, f"the value of `{leaf.path}`") from None
        except EvaluationFailed as problem:
            raise type_error("parameter.arithmetic", f"{problem} in the value of `{leaf.path}`", binding.span) from None
        for name in ex.symbols([item]):
            self.structural[name] = None
        if leaf.type == REAL and isinstance(result, int) and not isinstance(result, bool):
            return float(result)
        return result

    # ------------------------------------------------------------------ bindings

    def binding_value(self, binding: Binding) -> AnyValue:
        """The value of a modification, or the part of it that falls to one element of an array."""
        if not binding.memo:
            binding.memo.append(self.value(binding.expression, Env(binding.context)))
        value: AnyValue = binding.memo[0]
        for selector in binding.selectors:
            part = select_part(value, selector)
            if part is None:
                raise _bad_part(binding, value, selector)
            value = part
        return value

    # ------------------------------------------------------------------ expressions

    def value(self, node: ast.Expression, env: Env) -> AnyValue:
        """The symbolic value of an expression. Raises `TypeProblem`, `LookupProblem`, `UnsupportedProblem`."""
        if isinstance(node, ast.ComponentReference):
            return self.reference(node, env)
        if isinstance(node, ast.Binary):
            return self._binary(node, env)
        if isinstance(node, (ast.RealLiteral, ast.IntegerLiteral, ast.BooleanLiteral, ast.StringLiteral)):
            return literal(node.value)
        if isinstance(node, ast.Unary):
            return unary(node.operator, self.value(node.operand, env), node.span)
        if isinstance(node, ast.Call):
            return self._call(node, env)
        if isinstance(node, ast.If):
            return self._if(node, env)
        return self._other(node, env)

    def _other(self, node: ast.Expression, env: Env) -> AnyValue:
        if isinstance(node, ast.ArrayConstructor):
            return self._array(node, env)
        if isinstance(node, ast.Range):
            return self._range(node, env)
        if isinstance(node, ast.Matrix):
            return self._matrix(node, env)
        if isinstance(node, ast.End):
            if env.size is None:
                raise type_error("type.end", "`end` is only allowed inside a subscript", node.span)
            return literal(env.size)
        if isinstance(node, ast.Subscripted):
            return self.subscripted(as_value(self.value(node.expression, env), node.span), node.subscripts, env)
        if isinstance(node, ast.Tuple):
            raise type_error("type.tuple", "a list in parentheses is not a value here", node.span)
        raise fail(UnsupportedProblem, "unsupported.expression", "this expression is not supported here", node.span)

    def _binary(self, node: ast.Binary, env: Env) -> AnyValue:
        spine: list[ast.Binary] = []
        left: ast.Expression = node
        while isinstance(left, ast.Binary):
            spine.append(left)
            left = left.left
        if len(spine) > 8 and all(link.operator == "+" for link in spine):
            return self._long_sum(left, spine, env)
        value = self.value(left, env)
        for link in reversed(spine):
            value = binary(link.operator, value, self.value(link.right, env), link.span)
        return value

    def _long_sum(self, first: ast.Expression, spine: Sequence[ast.Binary], env: Env) -> AnyValue:
        """`a + b + c + ...` in one step, because sums are flat."""
        terms = [self.value(first, env), *[self.value(link.right, env) for link in reversed(spine)]]
        plain = [t for t in terms if isinstance(t, Value) and not t.shape and t.type.is_numeric]
        if len(plain) == len(terms):
            type_ = INTEGER if all(t.type == INTEGER for t in plain) else REAL
            return scalar(type_, ex.add(*[t.item for t in plain]))
        value = terms[0]
        for link, term in zip(reversed(spine), terms[1:], strict=True):
            value = binary(link.operator, value, term, link.span)
        return value

    def _if(self, node: ast.If, env: Env) -> AnyValue:
        value: AnyValue | None = None
        pending: list[tuple[Expr, ast.Expression]] = []
        for condition, branch in node.branches:
            test = as_boolean(self.value(condition, env), condition.span)
            if test.is_const:
                if test.value:
                    value = self.value(branch, env)
                    break
                continue
            pending.append((test, branch))
        if value is None:
            value = self.value(node.otherwise, env)
        for test, branch in reversed(pending):
            value = self._branch(test, branch, value, env)
        return value

    def _branch(self, test: Expr, branch: ast.Expression, otherwise: AnyValue, env: Env) -> AnyValue:
        """One `if`; where only the branch taken makes sense (sizes, indices) a parameter condition decides."""
        try:
            return choose(test, self.value(branch, env), otherwise, branch.span)
        except TypeProblem:
            try:
                taken = evaluate(test, self.parameter_value)
            except (NotConstant, EvaluationFailed):
                taken = None
            if taken is None or taken:
                raise
            for name in ex.symbols([test]):
                self.structural[name] = None
            return otherwise

    def _array(self, node: ast.ArrayConstructor, env: Env) -> AnyValue:
        if node.iterators:
            values = [self.value(node.items[0], inner) for inner in self.iterate(node.iterators, env)]
            shape = self._iterator_sizes(node.iterators, env)
            if not values:
                return Value(REAL, (0,), ())
        else:
            values = [self.value(item, env) for item in node.items]
            shape = (len(values),)
        result = stack(values, shape)
        if result is None:
            kinds = ", ".join(dict.fromkeys(describe(v) for v in values))
            raise type_error("type.array-elements", f"the elements of this array do not fit together: {kinds}", node.span)
        return result

    def _iterator_sizes(self, iterators: Sequence[ast.Iterator], env: Env) -> tuple[int, ...]:
        return tuple([len(self.iterator_values(it, env)) for it in iterators])

    def iterate(self, iterators: Sequence[ast.Iterator], env: Env) -> list[Env]:
        """One environment per combination of the iterators' values, the last one running fastest."""
        envs = [env]
        for iterator in iterators:
            envs = [e.with_locals({iterator.name: v}) for e in envs for v in self.iterator_values(iterator, e)]
            if len(envs) > MAX_RANGE:
                raise type_error("for.too-long", f"this loop runs more than {MAX_RANGE} times", iterator.span)
        return envs

    def iterator_values(self, iterator: ast.Iterator, env: Env) -> list[AnyValue]:
        """The values a `for` index takes."""
        if iterator.range is None:
            raise fail(
                UnsupportedProblem,
                "unsupported.implicit-range",
                f"the range of `{iterator.name}` is left out, which is not supported yet",
                iterator.span,
                hint=f"write `{iterator.name} in 1:n`",
            )
        kind = self._type_range(iterator.range, env)
        if kind is not None:
            return kind
        value = as_value(self.value(iterator.range, env), iterator.range.span)
        if len(value.shape) != 1:
            raise type_error("for.range", f"a `for` index runs over a vector, not {describe(value)}", iterator.span)
        return [scalar(value.type, item) for item in value.items]

    def _type_range(self, node: ast.Expression, env: Env) -> list[AnyValue] | None:
        """`for e in EnumerationType` and `for b in Boolean`."""
        if not isinstance(node, ast.ComponentReference) or node.parts[0].name in env.locals:
            return None
        if node.text == "Boolean":
            return [literal(False), literal(True)]
        resolved = resolve(self, node, env)
        if isinstance(resolved, Scope) and isinstance(resolved.definition, ast.EnumerationClass):
            from acausal.lang.values import enumeration_literal

            type_ = enumeration_of(resolved)
            return [enumeration_literal(type_, i) for i in range(1, len(type_.literals) + 1)]
        return None

    def _range(self, node: ast.Range, env: Env) -> Value:
        parts = [node.start, node.step or ast.IntegerLiteral(1, node.span), node.stop]
        values = [self.evaluate_in(part, env, "the range") for part in parts]
        numbers = [v for v in values if isinstance(v, (int, float)) and not isinstance(v, bool)]
        if len(numbers) != 3 or numbers[1] == 0:
            raise type_error("type.range", "a range needs numbers and a step that is not zero", node.span)
        start, step, stop = numbers
        integers = all(isinstance(v, int) for v in numbers)
        count = max(0, int((stop - start) / step + (0 if integers else 1e-10)) + 1) if (stop - start) / step >= 0 else 0
        if count > MAX_RANGE:
            raise type_error("for.too-long", f"this range has more than {MAX_RANGE} elements", node.span)
        items = tuple([ex.const(start + i * step) for i in range(count)])
        return Value(INTEGER if integers else REAL, (count,), items)

    def _matrix(self, node: ast.Matrix, env: Env) -> Value:
        rows: list[Value] = []
        for row in node.rows:
            cells = [as_value(self.value(cell, env), cell.span) for cell in row]
            rows.append(cat(2, [Value(c.type, (*c.shape, 1, 1)[:2], c.items) for c in cells], node.span))
        return cat(1, rows, node.span)

    # ------------------------------------------------------------------ references and subscripts

    def reference(self, node: ast.ComponentReference, env: Env) -> AnyValue:
        """The value of a component reference, an iterator, a constant or an enumeration literal."""
        first = node.parts[0]
        if not node.global_:
            local = env.locals.get(first.name)
            if local is not None:
                return self._local(local, node, env)
            if first.name == "time" and len(node.parts) == 1:
                return scalar(REAL, ex.TIME)
        return member_value(self, resolve(self, node, env), node, env)

    def _local(self, value: AnyValue, node: ast.ComponentReference, env: Env) -> AnyValue:
        for i, part in enumerate(node.parts):
            if i > 0:
                field_value = select_part(value, part.name)
                if field_value is None:
                    raise type_error("lookup.unknown-field", f"{describe(value)} has no field `{part.name}`", part.span)
                value = field_value
            if part.subscripts is not None:
                value = self.subscripted(as_value(value, part.span), part.subscripts, env)
        return value

    def subscripted(self, value: Value, subscripts: ast.Subscripts, env: Env) -> Value:
        """`value[...]`."""
        from acausal.lang.references import apply_subscripts

        return apply_subscripts(self, value, subscripts, env)

    # ------------------------------------------------------------------ calls

    def _call(self, node: ast.Call, env: Env) -> AnyValue:
        name = node.function.text.removeprefix(".")
        if node.iterators:
            return self._reduction(node, name, env)
        special = _SPECIAL.get(name)
        if special is not None:
            return special(self, node, env)
        builtin = BUILTINS.get(name)
        if builtin is not None:
            if node.named:
                raise type_error("call.arguments", f"`{name}` has no named arguments", node.span)
            return builtin([self.value(arg, env) for arg in node.arguments], node.span)
        if name in NOT_YET:
            raise fail(
                UnsupportedProblem, f"unsupported.{name}", f"`{name}(...)` is not supported yet", node.span, names=[name]
            )
        return self._user_call(node, env)

    def _user_call(self, node: ast.Call, env: Env) -> AnyValue:
        if env.depth > MAX_CALL_DEPTH:
            raise type_error(
                "function.recursion", f"functions call each other more than {MAX_CALL_DEPTH} deep", node.span
            )
        scope = env.context.scope.find_class(node.function)
        if scope.kind == "record":
            return construct_record(self, scope, node, env)
        results = call_function(self, scope, node, env)
        if not results:
            raise type_error("function.no-result", f"`{scope.path}` has no output", node.span)
        return results[0]

    def _reduction(self, node: ast.Call, name: str, env: Env) -> AnyValue:
        values = [self.value(node.arguments[0], inner) for inner in self.iterate(node.iterators, env)]
        if name == "array":
            return stack(values, (len(values),)) or Value(REAL, (0,), ())
        if name not in ("sum", "product", "min", "max"):
            raise type_error("call.reduction", f"`{name}` cannot be used with `for`", node.span)
        if not values:
            empty = {"sum": 0.0, "product": 1.0}.get(name)
            if empty is None:
                raise type_error("call.reduction", f"`{name}` over an empty range", node.span)
            return literal(empty)
        stacked = stack(values, (len(values),))
        if stacked is None:
            raise type_error("type.array-elements", f"the terms of this `{name}` do not fit together", node.span)
        return BUILTINS[name]([stacked], node.span)


# --------------------------------------------------------------------------- operators with function syntax


def _arguments(node: ast.Call, name: str, count: int) -> tuple[ast.Expression, ...]:
    if len(node.arguments) != count or node.named:
        raise type_error("call.arguments", f"`{name}` takes {count} argument(s)", node.span)
    return node.arguments


def _der(translator: Translator, node: ast.Call, env: Env) -> AnyValue:
    (argument,) = _arguments(node, "der", 1)
    value = as_value(translator.value(argument, env), node.span)
    if not value.type.is_numeric:
        raise type_error("type.not-numeric", f"`der` needs a Real, not {describe(value)}", node.span)
    return Value(REAL, value.shape, tuple([ex.der(item) for item in value.items]))


def _no_event(translator: Translator, node: ast.Call, env: Env) -> AnyValue:
    (argument,) = _arguments(node, "noEvent", 1)
    value = as_value(translator.value(argument, env), node.span)
    return Value(value.type, value.shape, tuple([ex.no_event(item) for item in value.items]))


def _smooth(translator: Translator, node: ast.Call, env: Env) -> AnyValue:
    order_node, argument = _arguments(node, "smooth", 2)
    order = translator.evaluate_in(order_node, env, "the order of smooth")
    if not isinstance(order, int) or isinstance(order, bool) or order < 0:
        raise type_error("call.smooth", "the order of `smooth` is an Integer from 0", order_node.span)
    value = as_value(translator.value(argument, env), node.span)
    return Value(value.type, value.shape, tuple([ex.smooth(order, item) for item in value.items]))


def _size(translator: Translator, node: ast.Call, env: Env) -> AnyValue:
    if not 1 <= len(node.arguments) <= 2:
        raise type_error("call.arguments", "`size` takes an array and, optionally, a dimension", node.span)
    shape = as_value(translator.value(node.arguments[0], env), node.span).shape
    if len(node.arguments) == 1:
        return Value(INTEGER, (len(shape),), tuple([ex.const(n) for n in shape]))
    dimension = translator.evaluate_in(node.arguments[1], env, "a dimension")
    if not isinstance(dimension, int) or not 1 <= dimension <= len(shape):
        raise type_error("type.array-size", f"there is no dimension {dimension} in an array of {len(shape)}", node.span)
    return literal(shape[dimension - 1])


def _pure(translator: Translator, node: ast.Call, env: Env) -> AnyValue:
    (argument,) = _arguments(node, "pure", 1)
    return translator.value(argument, env)


def _fill_like(translator: Translator, node: ast.Call, env: Env) -> AnyValue:
    """`zeros`, `ones`, `fill`, `identity`, `linspace`: sizes may be parameters, which become structural."""
    name = node.function.text
    first = {"fill": 1, "linspace": 2}.get(name, 0)
    values: list[AnyValue] = [translator.value(arg, env) for arg in node.arguments[:first]]
    for arg in node.arguments[first:]:
        size = translator.evaluate_in(arg, env, f"a size in `{name}`")
        values.append(literal(size) if isinstance(size, (int, float)) else literal(-1))
    return BUILTINS[name](values, node.span)


_SPECIAL = {
    "der": _der,
    "noEvent": _no_event,
    "smooth": _smooth,
    "size": _size,
    "pure": _pure,
    "zeros": _fill_like,
    "ones": _fill_like,
    "fill": _fill_like,
    "identity": _fill_like,
    "linspace": _fill_like,
}


# --------------------------------------------------------------------------- messages


def _not_constant(name: str, span: Span, purpose: str) -> TypeProblem:
    return type_error(
        "structural.not-constant",
        f"{purpose} must be known at compile time, but it depends on `{name}`",
        span,
        "make it depend on parameters and constants only",
        (name,),
    )


def _cyclic_parameter(cycle: Sequence[str], leaves: Mapping[str, Leaf]) -> LookupProblem:
    lines = ", ".join(f"`{name}` at {leaves[name].span}" for name in cycle)
    error = fail(
        LookupProblem,
        "parameter.cyclic",
        f"the value of `{cycle[0]}` depends on itself: {' -> '.join([*cycle, cycle[0]])}",
        leaves[cycle[0]].span,
        names=cycle,
        hint=f"give one of them a value of its own: {lines}",
    )
    assert isinstance(error, LookupProblem)
    return error


def _bad_part(binding: Binding, value: AnyValue, selector: int | str) -> TypeProblem:
    if isinstance(selector, str):
        return type_error("type.mismatch", f"{describe(value)} has no field `{selector}`", binding.span)
    if isinstance(value, Value) and not value.shape:
        return type_error(
            "modification.missing-each",
            "a scalar is given to every element of an array",
            binding.span,
            "write `each` in front of the modification, or give an array",
        )
    return type_error(
        "type.array-size", f"{describe(value)} has too few elements for the array it is given to", binding.span
    )


