"""Overloaded operators of operator records (Modelica 3.6, chapter 14).

An operator is a function, or a class that holds several; which one is called depends on the types of its
operands. `binary_record` and `unary_record` follow 14.5 and 14.6 rule by rule, `construct` 14.3 and
`text_of` 14.4. A record type derived by a short class has the operators of its base.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import prod

from acausal.errors import AcausalError, Span
from acausal.lang import ast
from acausal.lang.arithmetic import type_error
from acausal.lang.formals import class_of, formals_of
from acausal.lang.library import ClassNode
from acausal.lang.record_arrays import as_array, as_items
from acausal.lang.scope import Scope
from acausal.lang.translation import Env, Translation
from acausal.lang.value_calls import call_with
from acausal.lang.values import AnyValue, RecordArray, RecordValue, describe, shape_of

_SAME_SHAPE = ("+", "-")
_SCALARS_ONLY = ("^", "==", "<>", "<", "<=", ">", ">=", "and", "or")


def operator_functions(scope: Scope | None, name: str) -> list[Scope]:
    """The functions of the operator `name` (without quotes) of a record class; none if it has no such one."""
    if scope is None or scope.kind != "record":
        return []
    entry = scope.find_class_entry(f"'{name}'")
    if entry is None:
        return []
    operator = scope.nested(entry)
    if operator.kind == "function":
        return [operator]
    inside = [operator.nested(inner) for inner in operator.table.classes.values()]
    return [function for function in inside if function.kind == "function"]


# --------------------------------------------------------------------------- operators


def binary_record(
    translation: Translation, operator: str, left: AnyValue, right: AnyValue, span: Span, env: Env
) -> AnyValue:
    """`left operator right` where one side at least is of an operator record (14.5).

    Raises `operator.none` and `operator.ambiguous`.
    """
    scalars = not shape_of(left) and not shape_of(right)
    if not operator.startswith(".") or scalars:
        called = _matching(translation, operator.removeprefix("."), (left, right), span, env)
        if called is not None:
            return called
    if scalars:
        raise _no_operator(operator, (left, right), span)
    return _on_arrays(translation, operator, left, right, span, env)


def unary_record(
    translation: Translation, operator: str, operand: AnyValue, span: Span, env: Env
) -> AnyValue:
    """`operator operand` of an operator record or an array of them (14.6)."""
    name = operator.removeprefix(".")
    if name == "+":
        return operand
    found = [f for f in operator_functions(class_of(operand), name) if _fits(translation, f, (operand,))]
    if len(found) > 1:
        raise _ambiguous(operator, (operand,), found, span)
    if found:
        return call_with(translation, found[0], (operand,), span, env)
    if not isinstance(operand, RecordArray):
        raise _no_operator(operator, (operand,), span)
    items = [unary_record(translation, operator, item, span, env) for item in operand.items]
    return as_array(items, operand.shape, operand.scope)


def zero(translation: Translation, scope: Scope | None, span: Span, env: Env) -> AnyValue:
    """The element `'0'` of an operator record. Raises `operator.no-zero`."""
    found = operator_functions(scope, "0")
    if not found:
        name = "this record" if scope is None else f"`{scope.path}`"
        message = f"{name} has no operator '0', which is needed for an empty sum"
        raise type_error("operator.no-zero", message, span, "", () if scope is None else (scope.path,))
    return call_with(translation, found[0], (), span, env)


def sum_of_records(translation: Translation, value: AnyValue, span: Span, env: Env) -> AnyValue:
    """`sum` of an array of records; of an empty one their zero."""
    items = as_items(value)
    return total(translation, items, span, env) if items else zero(translation, class_of(value), span, env)


def total(translation: Translation, terms: Sequence[AnyValue], span: Span, env: Env) -> AnyValue:
    """The sum of records with the operator '+'."""
    value = terms[0]
    for term in terms[1:]:
        value = binary_record(translation, "+", value, term, span, env)
    return value


def _matching(
    translation: Translation, name: str, operands: tuple[AnyValue, AnyValue], span: Span, env: Env
) -> AnyValue | None:
    """The operator that fits both operands, or fits after one of them is converted."""
    left, right = operands
    mine = operator_functions(class_of(left), name)
    theirs = operator_functions(class_of(right), name)
    found = [f for f in mine if _fits(translation, f, operands)]
    others = [f for f in theirs if all(f.node is not g.node for g in mine)]
    found += [f for f in others if _fits(translation, f, operands)]
    if len(found) > 1:
        raise _ambiguous(name, operands, found, span)
    if found:
        return call_with(translation, found[0], operands, span, env)
    converted = [
        *_conversions(translation, mine, left, right, 1),
        *_conversions(translation, theirs, right, left, 0),
    ]
    if len(converted) > 1:
        raise _ambiguous(name, operands, [f for f, _, _ in converted], span)
    if not converted:
        return None
    function, constructor, position = converted[0]
    changed = call_with(translation, constructor, (operands[position],), span, env)
    return call_with(translation, function, (left, changed) if position else (changed, right), span, env)


def _conversions(
    translation: Translation, functions: Sequence[Scope], fixed: AnyValue, other: AnyValue, position: int
) -> list[tuple[Scope, Scope, int]]:
    """Operators that take `fixed` as it is and `other`, operand number `position`, through a constructor."""
    found: list[tuple[Scope, Scope, int]] = []
    if shape_of(other):
        return found
    for function in functions:
        formals = formals_of(translation, function)
        if len(formals) < 2 or not formals[1 - position].takes(fixed):
            continue
        target = formals[position]
        if target.rank or not isinstance(target.type, ClassNode) or target.takes(other):
            continue
        found += [
            (function, constructor, position)
            for constructor in operator_functions(target.scope, "constructor")
            if _fits(translation, constructor, (other,))
        ]
    return found


def _on_arrays(
    translation: Translation, operator: str, left: AnyValue, right: AnyValue, span: Span, env: Env
) -> AnyValue:
    """The operators on arrays that those on scalars define (14.5, rule 4)."""
    name = operator.removeprefix(".")
    a, b = shape_of(left), shape_of(right)
    elementwise = operator.startswith(".") or (name in _SAME_SHAPE and a == b)
    elementwise = elementwise or (name == "*" and (not a or not b)) or (name == "/" and not b)
    if name in _SCALARS_ONLY and not operator.startswith("."):
        raise _no_operator(operator, (left, right), span)
    if not elementwise and name == "*" and len(a) == 2 and 1 <= len(b) <= 2 and a[1] == b[0]:
        return _product(translation, left, right, span, env)
    if not elementwise or (a and b and a != b):
        message = f"the sizes do not fit: {describe(left)} {operator} {describe(right)}"
        raise type_error("type.array-size", message, span)
    shape = a or b
    count = prod(shape)
    firsts = as_items(left) if a else [left] * count
    seconds = as_items(right) if b else [right] * count
    items = [binary_record(translation, name, x, y, span, env) for x, y in zip(firsts, seconds, strict=True)]
    return as_array(items, shape, class_of(left) or class_of(right))


def _product(translation: Translation, left: AnyValue, right: AnyValue, span: Span, env: Env) -> AnyValue:
    """`matrix * vector` and `matrix * matrix`."""
    a, b = shape_of(left), shape_of(right)
    inner, columns = a[1], prod(b[1:])
    firsts, seconds = as_items(left), as_items(right)
    scope = class_of(left) or class_of(right)
    items: list[AnyValue] = []
    for i in range(a[0]):
        for j in range(columns):
            terms = [
                binary_record(translation, "*", firsts[i * inner + k], seconds[k * columns + j], span, env)
                for k in range(inner)
            ]
            empty = not terms
            items.append(
                zero(translation, scope, span, env) if empty else total(translation, terms, span, env)
            )
    return as_array(items, (a[0], *b[1:]), scope)


# --------------------------------------------------------------------------- constructors and String


def construct(translation: Translation, scope: Scope, node: ast.Call, env: Env) -> AnyValue | None:
    """`Record(...)` by the overloaded constructors of an operator record; None if it has none (14.3)."""
    functions = operator_functions(scope, "constructor")
    return None if not functions else _overloaded(translation, functions, scope.path, node, env)


def text_of(translation: Translation, node: ast.Call, env: Env) -> AnyValue | None:
    """`String(record, ...)` by the record's operator 'String'; None if the argument is no record (14.4)."""
    if not node.arguments:
        return None
    first = translation.value(node.arguments[0], env)
    if not isinstance(first, RecordValue):
        return None
    functions = operator_functions(first.scope, "String")
    if not functions:
        raise _no_operator("String", (first,), node.span)
    return _overloaded(translation, functions, "String", node, env)


def _overloaded(
    translation: Translation, functions: Sequence[Scope], name: str, node: ast.Call, env: Env
) -> AnyValue:
    """The one function that the arguments of a call fit, element by element if need be."""
    values = [translation.value(argument, env) for argument in node.arguments]
    named = {argument.name: translation.value(argument.value, env) for argument in node.named}
    found = [f for f in functions if _fits(translation, f, values, named)]
    if not found:
        found = [f for f in functions if _fits(translation, f, values, named, spread=True)]
    operands = [*values, *named.values()]
    if len(found) > 1:
        raise _ambiguous(name, operands, found, node.span)
    if not found:
        raise _no_operator(name, operands, node.span)
    return call_with(translation, found[0], values, node.span, env, named)


# --------------------------------------------------------------------------- matching


def _fits(
    translation: Translation,
    function: Scope,
    values: Sequence[AnyValue],
    named: Mapping[str, AnyValue] | None = None,
    *,
    spread: bool = False,
) -> bool:
    """Whether a call with these arguments is a valid match (14.2)."""
    formals = formals_of(translation, function)
    named = named or {}
    rest = formals[len(values) :]
    if len(values) > len(formals) or any(name not in {f.name for f in rest} for name in named):
        return False
    if any(not f.optional and f.name not in named for f in rest):
        return False
    pairs = [*zip(formals, values, strict=False), *[(f, named[f.name]) for f in rest if f.name in named]]
    return all(formal.takes(value, spread=spread) for formal, value in pairs)


# --------------------------------------------------------------------------- errors


def _no_operator(name: str, operands: Sequence[AnyValue], span: Span) -> AcausalError:
    kinds = " and ".join(describe(value) for value in operands) or "nothing"
    records = [scope.path for value in operands if (scope := class_of(value)) is not None]
    message = f"no operator `{name}` is defined for {kinds}"
    hint = "define one in the operator record, or use its fields"
    return type_error("operator.none", message, span, hint, tuple(dict.fromkeys(records)))


def _ambiguous(name: str, operands: Sequence[AnyValue], found: Sequence[Scope], span: Span) -> AcausalError:
    kinds = " and ".join(describe(value) for value in operands)
    paths = [scope.path for scope in found]
    message = f"`{name}` of {kinds} fits several functions: `{'`, `'.join(paths)}`"
    return type_error("operator.ambiguous", message, span, "call one of them by name", tuple(paths))
