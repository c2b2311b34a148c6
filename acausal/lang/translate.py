"""Expressions of the source to values: names resolved, types and sizes checked, functions inlined.

`Translator` is the front end's one evaluator: `value` gives the symbolic value of an expression,
`evaluate` its compile-time value (for sizes, conditions and subscripts), and `parameter_value` the value
of a parameter by its path. Parameters that were evaluated are remembered as structural.
"""

from __future__ import annotations

from acausal.errors import Diagnostic, Span, TypeProblem, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.arithmetic import (
    as_scalar,
    type_error,
    unary,
)
from acausal.lang.arrays import array_call, array_value, matrix_value, range_value, reduction
from acausal.lang.builtin_calls import builtin_value
from acausal.lang.builtins import BUILTINS, NOT_YET
from acausal.lang.connection_calls import CONNECTION_CALLS
from acausal.lang.enumeration_calls import literal_of
from acausal.lang.externals import Externals, is_external_class
from acausal.lang.flat import INTEGER, REAL, Assertion, Variability
from acausal.lang.formals import Formal
from acausal.lang.function_lookup import function_and_owner, function_scope
from acausal.lang.function_values import call_given, given_function
from acausal.lang.functions import call_function, construct_record
from acausal.lang.index_choices import (
    Choice,
    VariableIndex,
    check_size,
    chosen,
    element_of_nothing,
    holds,
    with_colon,
    with_index,
)
from acausal.lang.index_types import check_use
from acausal.lang.instance import Instance, Leaf
from acausal.lang.instantiate import Instantiator
from acausal.lang.iteration import enumerated
from acausal.lang.modifiers import Binding, Context
from acausal.lang.network import Network
from acausal.lang.operations import binary_value, if_value
from acausal.lang.operator_records import construct, unary_record
from acausal.lang.parameter_errors import (
    bad_part,
    cyclic_parameter,
    no_value,
    not_constant,
    too_deep_calls,
)
from acausal.lang.references import current_value, member_value, resolve
from acausal.lang.scope import FoundComponent, Root, Scope
from acausal.lang.special_calls import SPECIAL
from acausal.lang.subscripts import part_of, subscripted
from acausal.lang.texts import string_value
from acausal.lang.translation import Env
from acausal.lang.values import AnyValue, Value, describe, first_size, literal, scalar, select_part
from acausal.lang.work import Budget
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.evaluate import EvaluationFailed, NotConstant, evaluate
from acausal.symbolic.expressions.expr import Constant, Expr
from acausal.symbolic.expressions.text import beginning

MAX_CALL_DEPTH = 60


class Translator(Budget):
    """See the module's text. One per compilation."""

    def __init__(self, root: Root) -> None:
        super().__init__()
        self.root = root
        self.warnings: list[Diagnostic] = []
        self.declared_units: dict[Expr, str] = {}
        self.instances = Instantiator(self)
        self.externals = Externals(self, root.library)
        self.leaves: dict[str, Leaf] = {}
        self.formals: dict[Scope, tuple[Formal, ...]] = {}
        self.structural: dict[str, None] = {}
        self._network: Network | None = None
        self.assertions: list[Assertion] = []
        self.left_limits: dict[str, Span] = {}
        self._values: dict[str, Constant] = {}
        self._constants: dict[Leaf, Constant] = {}
        self._busy: dict[Leaf, None] = {}
        self._hidden: dict[tuple[Scope, str], bool] = {}

    def start(self, root: Instance) -> Network:
        """The model is complete: from now on its connections can be asked for."""
        self._network = Network(self, root, self.instances.overdetermined, self.instances.has_streams)
        if self.instances.has_expandable:
            self._network.expand(root.span)
        return self._network

    def network(self, span: Span) -> Network:
        """The connections of the model. Raises `connections.too-early` while it is being built."""
        if self._network is None:
            message = "this depends on connections, which are not known while components are built"
            raise type_error("connections.too-early", message, span)
        return self._network

    def leaf(self, path: str) -> Leaf | None:
        """The scalar of this name, if an expression named it."""
        return self.leaves.get(path)

    def note(self, leaf: Leaf) -> None:
        """Remember a scalar that an expression names, for `parameter_value`."""
        self.leaves.setdefault(leaf.path, leaf)

    # ------------------------------------------------------------------ compile-time values

    def evaluate(self, expression: ast.Expression, context: Context, purpose: str) -> Constant:
        """The value of a scalar expression at compile time; its parameters become structural.

        Raises `TypeProblem` `structural.not-constant` when it depends on a variable.
        """
        return self.evaluate_in(expression, Env(context), purpose)

    def evaluate_in(self, expression: ast.Expression, env: Env, purpose: str) -> Constant:
        """As `evaluate`, where there are local names."""
        value = as_scalar(self.value(expression, env), expression.span)
        return self.evaluate_expr(value.item, expression.span, purpose)

    def evaluate_expr(self, item: Expr, span: Span, purpose: str) -> Constant:
        """As `evaluate`, for a translated scalar."""
        if item.is_const and item.value is not None:
            return item.value
        try:
            result = evaluate(item, self.parameter_value)
        except NotConstant as problem:
            raise not_constant(problem.name, span, purpose) from None
        except EvaluationFailed as problem:
            message = f"{problem} in {purpose}: `{beginning(item, 200)[:200]}`"
            raise type_error("parameter.arithmetic", message, span, "", ex.symbols([item])) from None
        self._shaped_by(item)
        return result

    def known(self, item: Expr) -> Constant | None:
        """The value of a scalar that depends on parameters only, which become structural; else None."""
        if item.is_const:
            return item.value
        try:
            result = evaluate(item, self.parameter_value)
        except (NotConstant, EvaluationFailed, TypeProblem):
            return None
        self._shaped_by(item)
        return result

    def decide(self, condition: Expr) -> bool | None:
        """The value of a condition on parameters, which become structural; None for any other."""
        if condition.is_const:
            return bool(condition.value)
        try:
            result = evaluate(condition, self.parameter_value)
        except (NotConstant, EvaluationFailed):
            return None
        except TypeProblem as problem:
            if problem.codes != ("parameter.no-value",):
                raise
            return None  # a component by itself: its parameters get values where it is used
        self._shaped_by(condition)
        return bool(result)

    def decide_discrete(self, condition: Expr) -> bool | None:
        """As `decide`, if the condition depends on Integer, Boolean and enumeration parameters only."""
        for name in ex.each_symbol([condition]):
            leaf = self.leaves.get(name)
            if leaf is None or leaf.type == REAL or leaf.prefixes.variability > Variability.PARAMETER:
                return None
        return self.decide(condition)

    def mark_evaluated(self, path: str) -> None:
        """Make a parameter structural, and those that its value depends on.

        Where it has no value, whoever needs that value says so.
        """
        try:
            self.parameter_value(path)
        except TypeProblem:
            return
        self.structural[path] = None

    def _shaped_by(self, item: Expr) -> None:
        for name in ex.symbols([item]):
            self.structural[name] = None

    def parameter_value(self, path: str) -> Constant | None:
        """The value of a parameter or constant; None for anything else. Raises on cycles."""
        if path not in self._values:
            leaf = self.leaves.get(path)
            if leaf is None or leaf.prefixes.variability > Variability.PARAMETER or self._is_free(leaf):
                return None
            self._values[path] = self._compute(leaf)
        return self._values[path]

    def _is_free(self, leaf: Leaf) -> bool:
        """Whether the initial problem determines a parameter: `fixed = false` and no value."""
        fixed = leaf.attributes.get("fixed")
        if fixed is None or leaf.binding is not None:
            return False
        value = as_scalar(self.binding_value(fixed), fixed.span).item
        return value.is_const and not value.value

    def constant_of(self, leaf: Leaf) -> Constant:
        """The value of a package's constant."""
        if leaf not in self._constants:
            self._constants[leaf] = self._compute(leaf)
        return self._constants[leaf]

    def _compute(self, leaf: Leaf) -> Constant:
        if leaf in self._busy:
            busy = list(self._busy)
            raise cyclic_parameter(busy[busy.index(leaf) :])
        self._busy[leaf] = None
        try:
            return self._compute_parameter(leaf)
        finally:
            del self._busy[leaf]

    def _compute_parameter(self, leaf: Leaf) -> Constant:
        binding = leaf.binding
        if binding is None and leaf.prefixes.variability is Variability.PARAMETER:
            binding = leaf.attributes.get("start")
        if binding is None:
            raise no_value(leaf)
        value = as_scalar(self.binding_value(binding), binding.span)
        if value.type != leaf.type and not (leaf.type == REAL and value.type == INTEGER):
            message = f"`{leaf.path}` is {leaf.type}, but its value is {describe(value)}"
            raise type_error("type.mismatch", message, binding.span, "", (leaf.path,))
        try:
            result = evaluate(value.item, self.parameter_value)
        except NotConstant as problem:
            raise not_constant(problem.name, binding.span, f"the value of `{leaf.path}`") from None
        except EvaluationFailed as problem:
            message = f"{problem} in the value of `{leaf.path}`"
            raise type_error("parameter.arithmetic", message, binding.span, "", (leaf.path,)) from None
        self._shaped_by(value.item)
        return float(result) if leaf.type == REAL and isinstance(result, int) else result

    # ------------------------------------------------------------------ bindings

    def binding_value(self, binding: Binding) -> AnyValue:
        """The value of a modification, or the part of it that falls to one element of an array."""
        if not binding.memo:
            binding.memo.append(self.value(binding.expression, Env(binding.context)))
        value: AnyValue = binding.memo[0]
        for selector in binding.selectors:
            if isinstance(selector, str):
                part = select_part(value, selector)
            else:
                index, size = selector
                part = select_part(value, index) if first_size(value) == size else None
            if part is None:
                raise bad_part(binding, value, selector)
            value = part
        return value

    # ------------------------------------------------------------------ expressions

    def value(self, node: ast.Expression, env: Env) -> AnyValue:
        """The symbolic value of an expression."""
        if isinstance(node, ast.ComponentReference):
            return self._reference(node, env)
        if isinstance(node, ast.Binary):
            return self.counted(binary_value(self, node, env), node.span)
        if isinstance(node, (ast.RealLiteral, ast.IntegerLiteral, ast.BooleanLiteral, ast.StringLiteral)):
            return literal(node.value)
        if isinstance(node, ast.Unary):
            operand = self.value(node.operand, env)
            if not isinstance(operand, Value):
                return unary_record(self, node.operator, operand, node.span, env)
            return unary(node.operator, operand, node.span)
        if isinstance(node, ast.Call):
            return self.counted(self._call(node, env), node.span)
        if isinstance(node, ast.If):
            return if_value(self, node, env)
        return self._other(node, env)

    def _other(self, node: ast.Expression, env: Env) -> AnyValue:
        if isinstance(node, ast.ArrayConstructor):
            return array_value(self, node, env)
        if isinstance(node, ast.Range):
            return range_value(self, node, env)
        if isinstance(node, ast.Matrix):
            return matrix_value(self, node, env)
        if isinstance(node, ast.End):
            if env.size is None:
                raise type_error("type.end", "`end` is only allowed inside a subscript", node.span)
            return env.size
        if isinstance(node, ast.Subscripted):
            inner = self.value(node.expression, env)
            return subscripted(self, inner, node.subscripts, env, "this array")
        if isinstance(node, ast.Tuple):
            raise type_error("type.tuple", "a list in parentheses is not a value here", node.span)
        what = "`:`" if isinstance(node, ast.Colon) else "a function as an argument"
        raise fail(UnsupportedProblem, "unsupported.expression", f"{what} is not supported here", node.span)

    # ------------------------------------------------------------------ references and calls

    def _reference(self, node: ast.ComponentReference, env: Env) -> AnyValue:
        """The value of a component reference, an iterator, a constant or an enumeration literal."""
        if not node.global_:
            first = node.parts[0]
            local = env.locals.get(first.name)
            if local is not None:
                return part_of(self, local, node, env)
            if first.name == "time" and len(node.parts) == 1:
                return scalar(REAL, ex.TIME)
        try:
            found = resolve(self, node, env)
        except VariableIndex as varying:
            if varying.choice is None or not holds(node, varying.choice):
                raise
            return self._chosen(node, varying.choice, env)
        check_use(self, node, env)
        value = member_value(self, found, node)
        return current_value(value, env.current) if env.current else value

    def _chosen(self, node: ast.ComponentReference, choice: Choice, env: Env) -> AnyValue:
        """The value of a reference with a subscript that varies at run time."""
        if choice.size == 0:
            return element_of_nothing(self, self._reference(with_colon(node, choice), env), choice)
        check_size(choice)
        values = [self._reference(with_index(node, choice, k), env) for k in range(1, choice.size + 1)]
        choice.check(self, ex.TRUE)
        return chosen(choice, values, node.span)

    def enumerated(self, node: ast.Expression, env: Env) -> list[Value] | None:
        """The values of `Boolean` or of an enumeration type; None for anything else."""
        return enumerated(self, node, env)

    def _call(self, node: ast.Call, env: Env) -> AnyValue:
        name = node.function.text.removeprefix(".")
        if node.iterators:
            return reduction(self, node, name, env)
        if name == "array":
            return array_call(self, node, env)
        if name == "String":
            return string_value(self, node, env)
        special = SPECIAL.get(name) or CONNECTION_CALLS.get(name)
        if special is not None:
            return special(self, node, env)
        builtin = BUILTINS.get(name)
        if builtin is not None and (node.function.global_ or not self._is_hidden(name, env)):
            if node.named:
                raise type_error("call.arguments", f"`{name}` has no named arguments", node.span)
            return builtin_value(self, name, builtin, node, env)
        if name in NOT_YET:
            message = f"`{name}(...)` is not supported yet"
            raise fail(UnsupportedProblem, f"unsupported.{name}", message, node.span, names=[name])
        return self._user_call(node, env)

    def _is_hidden(self, name: str, env: Env) -> bool:
        """Whether a function of the model's own stands before the built-in one of its name (5.3)."""
        key = (env.context.scope, name)
        found = self._hidden.get(key)
        if found is None:
            found = self._hidden[key] = _is_function(env.context.scope.find(name))
        return found

    def _user_call(self, node: ast.Call, env: Env) -> AnyValue:
        given = given_function(env, node.function)
        if given is not None:
            return self.results(node, env)[0]
        scope = function_scope(self, node.function, env)
        if is_external_class(scope):
            return self.call(scope.find_nested("constructor", node.function.span), node, env)[0]
        if scope.kind == "record":
            constructed = construct(self, scope, node, env)
            return construct_record(self, scope, node, env) if constructed is None else constructed
        literal_value = literal_of(self, scope, node, env)
        if literal_value is not None:
            return literal_value
        results = self.results(node, env)
        if not results:
            message = f"`{scope.path}` has no output"
            raise type_error("function.no-result", message, node.span, "", (scope.path,))
        return results[0]

    def results(self, node: ast.Call, env: Env) -> list[AnyValue]:
        """All outputs of a function call, in order. Raises `function.recursion`."""
        given = given_function(env, node.function)
        if given is not None:
            return self.call(given.scope, *call_given(given, node, env))
        scope, owner = function_and_owner(self, node.function, env)
        return self.call(scope, node, env, owner)

    def call(self, scope: Scope, node: ast.Call, env: Env, owner: Instance | None = None) -> list[AnyValue]:
        """As `results`, of the function `scope` of the component `owner`."""
        if env.depth > MAX_CALL_DEPTH:
            raise too_deep_calls(node.function.text, MAX_CALL_DEPTH, node.span)
        if env.depth == 0:
            self.begin_call()
        return call_function(self, scope, node, env, owner)


def _is_function(found: FoundComponent | Scope | None) -> bool:
    return isinstance(found, Scope) and found.kind == "function"
