"""Binary operators and `if` in expressions, with what parameters decide."""

from __future__ import annotations

from collections.abc import Sequence

from acausal.errors import AcausalError, LookupProblem, TypeProblem
from acausal.lang import ast
from acausal.lang.arithmetic import RELATIONS, as_boolean, binary, choose
from acausal.lang.assertions import guard_assertions
from acausal.lang.flat import BOOLEAN, INTEGER, REAL, ScalarType
from acausal.lang.operator_records import binary_record
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue, Value, scalar
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr

EVENT_FUNCTIONS = ("integer", "floor", "ceil", "div", "mod", "rem")


def binary_value(translation: Translation, node: ast.Binary, env: Env) -> AnyValue:
    """`left operator right`; a chain of operators is walked without recursion."""
    if not isinstance(node.left, ast.Binary):
        left_value = translation.value(node.left, env)
        return _operation(translation, node, left_value, _right(translation, node, left_value, env), env)
    spine: list[ast.Binary] = []
    left: ast.Expression = node
    while isinstance(left, ast.Binary):
        spine.append(left)
        left = left.left
    if len(spine) > 8 and all(link.operator == "+" for link in spine):
        return _long_sum(translation, left, spine, env)
    value = translation.value(left, env)
    for link in reversed(spine):
        value = _operation(translation, link, value, _right(translation, link, value, env), env)
    return value


def _right(translation: Translation, node: ast.Binary, left: AnyValue, env: Env) -> AnyValue:
    """The right side. What it asserts holds where `and` and `or` need it: `i <= n and x[i] > 0`."""
    if (
        node.operator not in ("and", "or")
        or not isinstance(left, Value)
        or left.shape
        or left.type != BOOLEAN
    ):
        return translation.value(node.right, env)
    found = translation.assertions
    start = len(found)
    value = translation.value(node.right, env)
    guard_assertions(found, start, left.item if node.operator == "and" else ex.logical_not(left.item))
    return value


def _operation(
    translation: Translation, node: ast.Binary, left: AnyValue, right: AnyValue, env: Env
) -> AnyValue:
    """One binary operation. Relations of Reals in functions raise no events (8.5), others never do."""
    if not isinstance(left, Value) or not isinstance(right, Value):
        return binary_record(translation, node.operator, left, right, node.span, env)
    value = binary(node.operator, left, right, node.span)
    if env.depth and node.operator in RELATIONS and not value.shape and REAL in (_type(left), _type(right)):
        return scalar(value.type, ex.no_event(value.item))
    return value


def without_events(value: Value) -> Value:
    """`noEvent` of every element: in functions, `integer` and the like raise no events (8.5)."""
    return Value(value.type, value.shape, tuple([ex.no_event(item) for item in value.items]))


def _type(value: AnyValue) -> ScalarType | None:
    return value.type if isinstance(value, Value) else None


def _long_sum(
    translation: Translation, first: ast.Expression, spine: Sequence[ast.Binary], env: Env
) -> AnyValue:
    """`a + b + c + ...` in one step, because sums are flat."""
    terms = [translation.value(first, env), *[translation.value(link.right, env) for link in reversed(spine)]]
    plain = [t for t in terms if isinstance(t, Value) and not t.shape and t.type.is_numeric]
    if len(plain) == len(terms):
        type_ = INTEGER if all(t.type == INTEGER for t in plain) else REAL
        return scalar(type_, ex.add(*[t.item for t in plain]))
    value = terms[0]
    for link, term in zip(reversed(spine), terms[1:], strict=True):
        value = _operation(translation, link, value, term, env)
    return value


def if_value(translation: Translation, node: ast.If, env: Env) -> AnyValue:
    """`if c1 then a elseif c2 then b else c`; a condition known at compile time takes its branch."""
    found = translation.assertions
    decided: ast.Expression | None = None
    pending: list[tuple[Expr, ast.Expression]] = []
    for condition, branch in node.branches:
        start = len(found)
        test = as_boolean(translation.value(condition, env), condition.span)
        if pending and len(found) > start:
            guard_assertions(found, start, ex.logical_not(ex.logical_or(*[t for t, _ in pending])))
        if not test.is_const:
            pending.append((test, branch))
        elif test.value:
            decided = branch
            break
    start = len(found)
    if decided is not None:
        value = translation.value(decided, env)
    else:
        value = _untaken(translation, pending, node.otherwise, env)
    for test, branch in reversed(pending):
        guard_assertions(found, start, ex.logical_not(test))
        middle = len(found)
        value = _branch(translation, test, branch, value, env)
        guard_assertions(found, middle, test)
    return value


def _untaken(
    translation: Translation,
    pending: Sequence[tuple[Expr, ast.Expression]],
    otherwise: ast.Expression,
    env: Env,
) -> AnyValue:
    """The last branch, or the one that parameters decide for if the last makes no sense then."""
    try:
        return translation.value(otherwise, env)
    except (TypeProblem, LookupProblem) as problem:
        if not _may_be_untaken(problem):
            raise
        for test, branch in pending:
            if translation.decide(test):
                return translation.value(branch, env)
        raise


def _branch(
    translation: Translation, test: Expr, branch: ast.Expression, otherwise: AnyValue, env: Env
) -> AnyValue:
    """One `if`; where the branches do not fit together (sizes, indices), parameters must decide it."""
    taken: AnyValue | None = None
    try:
        taken = translation.value(branch, env)
        return choose(test, taken, otherwise, branch.span)
    except (TypeProblem, LookupProblem) as problem:
        decided = translation.decide(test) if _may_be_untaken(problem) else None
        if decided is None or (decided and taken is None):
            raise
        return taken if decided and taken is not None else otherwise


def _may_be_untaken(problem: AcausalError) -> bool:
    """Whether a branch that parameters decide against may be as it is: ill-sized, or part of a circle."""
    return isinstance(problem, TypeProblem) or problem.codes == ("parameter.cyclic",)
