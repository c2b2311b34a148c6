"""The equations of components as scalar equations, assertions and connections (Modelica 3.6, chapter 8)."""

from __future__ import annotations

from collections.abc import Sequence

from acausal.errors import AcausalError, Span, TypeProblem, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.arithmetic import as_boolean, as_scalar, type_error
from acausal.lang.connection_nodes import connector_side
from acausal.lang.connections import ConnectionSets, connect
from acausal.lang.flat import STRING, Assertion, Equation, Origin
from acausal.lang.instance import Absent, Instance, leaves
from acausal.lang.iteration import iterate
from acausal.lang.links import GRAPH_CALLS, call_name
from acausal.lang.matching_values import match_values, merge_branches
from acausal.lang.modifiers import Context
from acausal.lang.naming import names_in, with_names
from acausal.lang.printer import print_expression
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue, describe
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import EnumValue, Expr

MAX_EQUATIONS = 1_000_000


class Equations:
    """What the equation sections of components come to, collected component by component."""

    def __init__(self, translation: Translation, sets: ConnectionSets) -> None:
        self._translation = translation
        self.equations: list[Equation] = []
        self.initial: list[Equation] = []
        self.assertions: list[Assertion] = []
        self.sets = sets
        self._conditions = 0
        """How many `if`-equations on variables are being translated."""

    def component(self, instance: Instance) -> None:
        """Add the sections of one component (not of its parts)."""
        for section, scope in instance.scope.table.sections:
            env = Env(Context(scope, instance))
            if isinstance(section, ast.AlgorithmSection):
                raise fail(
                    UnsupportedProblem,
                    "unsupported.algorithm",
                    f"an algorithm section in `{scope.path}` is not supported yet (functions have theirs)",
                    section.span,
                    names=[scope.path],
                    hint="write equations, or put the algorithm into a function",
                )
            target = self.initial if section.initial else self.equations
            for equation in section.equations:
                self._equation(equation, env, target)

    def _equation(self, node: ast.Equation, env: Env, target: list[Equation]) -> None:
        if isinstance(node, ast.EqualEquation):
            self._equal(node, env, target)
        elif isinstance(node, ast.ConnectEquation):
            self._connect(node, env, target)
        elif isinstance(node, ast.ForEquation):
            for inner in iterate(self._translation, node.iterators, env):
                for equation in node.body:
                    self._equation(equation, inner, target)
        elif isinstance(node, ast.IfEquation):
            self._if(node, env, target)
        elif isinstance(node, ast.CallEquation):
            self._call(node, env, target)
        else:
            raise fail(
                UnsupportedProblem,
                "unsupported.when",
                "`when` equations are not supported yet",
                node.span,
                hint="use `if` for what switches continuously; discrete events come in a later version",
            )
        if len(target) > MAX_EQUATIONS:
            message = f"the model has more than {MAX_EQUATIONS} equations"
            raise type_error("flat.too-large", message, node.span)

    def _equal(self, node: ast.EqualEquation, env: Env, target: list[Equation]) -> None:
        try:
            self._sides(node, env, target)
        except TypeProblem as problem:
            raise with_names(problem, names_in(node, _component_of(env))) from None

    def _sides(self, node: ast.EqualEquation, env: Env, target: list[Equation]) -> None:
        if isinstance(node.left, ast.Tuple):
            self._several_results(node, node.left, env, target)
            return
        left = self._translation.value(node.left, env)
        right = self._translation.value(node.right, env)
        self._add(left, right, node.span, env, target)

    def _several_results(
        self, node: ast.EqualEquation, left: ast.Tuple, env: Env, target: list[Equation]
    ) -> None:
        """`(a, , b) = f(x)`."""
        if not isinstance(node.right, ast.Call):
            raise type_error("type.tuple", "only a function call has several results", node.span)
        results = self._translation.results(node.right, env)
        if len(left.items) > len(results):
            name = node.right.function.text
            message = f"`{name}` has only {len(results)} result(s)"
            raise type_error("call.results", message, node.span, "", (name,))
        for item, result in zip(left.items, results, strict=False):
            if item is not None:
                self._add(self._translation.value(item, env), result, node.span, env, target)

    def _add(self, left: AnyValue, right: AnyValue, span: Span, env: Env, target: list[Equation]) -> None:
        component = _component_of(env)
        for a, b in match_values(left, right, span):
            target.append(Equation(a, b, span, component, Origin.EQUATION))  # quicker for one

    # ------------------------------------------------------------------ if

    def _if(self, node: ast.IfEquation, env: Env, target: list[Equation]) -> None:
        """Conditions on parameters decide, those on variables make `if`-expressions."""
        branches: list[tuple[Expr, tuple[ast.Equation, ...]]] = []
        otherwise = node.otherwise
        for condition, body in node.branches:
            test = self._test(condition, env)
            known = self._translation.decide(test)
            if known is None:
                branches.append((test, body))
            elif known:
                otherwise = body
                break
        if branches:
            self._conditional(branches, otherwise, env, target, node.span)
            return
        for equation in otherwise:
            self._equation(equation, env, target)

    def _test(self, node: ast.Expression, env: Env) -> Expr:
        """A condition."""
        try:
            return as_boolean(self._translation.value(node, env), node.span)
        except TypeProblem as problem:
            raise with_names(problem, names_in(node, _component_of(env))) from None

    def _conditional(
        self,
        branches: Sequence[tuple[Expr, tuple[ast.Equation, ...]]],
        otherwise: tuple[ast.Equation, ...],
        env: Env,
        target: list[Equation],
        span: Span,
    ) -> None:
        tests = [test for test, _ in branches]
        bodies: list[list[Equation]] = []
        for k, (test, body) in enumerate(branches):
            guard = ex.logical_and(*[ex.logical_not(t) for t in tests[:k]], test)
            bodies.append(self._branch(body, env, guard))
        guard = ex.logical_and(*[ex.logical_not(t) for t in tests])
        bodies.append(self._branch(otherwise, env, guard))
        counts = [len(body) for body in bodies]
        if len(dict.fromkeys(counts)) > 1:
            raise _unbalanced(counts, tests, span)
        target += [merge_branches(tests, row, span) for row in zip(*bodies, strict=True)]

    def _branch(self, body: Sequence[ast.Equation], env: Env, guard: Expr) -> list[Equation]:
        found: list[Equation] = []
        before = len(self.assertions)
        self._conditions += 1
        for equation in body:
            self._equation(equation, env, found)
        self._conditions -= 1
        otherwise = ex.logical_not(guard)
        for k in range(before, len(self.assertions)):
            old = self.assertions[k]
            condition = ex.logical_or(otherwise, old.condition)
            self.assertions[k] = Assertion(condition, old.message, old.level, old.span, old.component)
        return found

    # ------------------------------------------------------------------ connect and assert

    def _check_unconditional(
        self, what: str, node: ast.Equation, target: list[Equation], names: tuple[str, ...] = ()
    ) -> None:
        """What makes connections must not depend on variables (9.3)."""
        if self._conditions or target is self.initial:
            where = "an if-equation needs a condition known at compile time"
            if not self._conditions:
                where = "an initial equation is not possible"
            hint = "make the condition depend on parameters only" if self._conditions else ""
            raise type_error("connect.conditional", f"`{what}` in {where}", node.span, hint, names or (what,))

    def _connect(self, node: ast.ConnectEquation, env: Env, target: list[Equation]) -> None:
        self._check_unconditional("connect", node, target, (node.left.text, node.right.text))
        left = connector_side(self._translation, node.left, env)
        right = connector_side(self._translation, node.right, env)
        if any(isinstance(member, Absent) for side in (left, right) for member in side.members):
            return  # a conditional component that is not there takes its connections along (4.4.5)
        if left.shape != right.shape:
            sides = f"`{print_expression(node.left)}` and `{print_expression(node.right)}`"
            message = f"{sides} have different sizes: {list(left.shape)} and {list(right.shape)}"
            raise type_error("connect.mismatch", message, node.span, "", (node.left.text, node.right.text))
        for side in (left, right):
            if side.hidden:
                self.sets.hidden.update([leaf.path for member in side.members for leaf in leaves(member)])
        component = _component_of(env)
        for x, y in zip(left.members, right.members, strict=True):
            connect(self.sets, (x, left.inside), (y, right.inside), node.span, component)

    def _call(self, node: ast.CallEquation, env: Env, target: list[Equation]) -> None:
        name = call_name(node.call)
        if name in GRAPH_CALLS:
            self._check_unconditional(name, node, target)
            self._translation.network(node.span).graph(node.span)  # which checks the call
            return
        if name != "assert":
            message = f"`{name}(...)` as an equation is not supported yet"
            raise fail(UnsupportedProblem, "unsupported.call-equation", message, node.span, names=[name])
        arguments = dict(zip(("condition", "message", "level"), node.call.arguments, strict=False))
        arguments |= {named.name: named.value for named in node.call.named}
        known = {"condition", "message", "level"}
        if not {"condition", "message"} <= arguments.keys() <= known or len(node.call.arguments) > len(known):
            message = "`assert` takes a condition, a message and, optionally, a level"
            raise type_error("call.arguments", message, node.span, "", ("assert",))
        condition = self._test(arguments["condition"], env)
        level = "error"
        if "level" in arguments:
            level = self._level(arguments["level"], env)
        message_text = ex.const(self._message(arguments["message"], env))
        self.assertions.append(Assertion(condition, message_text, level, node.span, _component_of(env)))

    def _level(self, node: ast.Expression, env: Env) -> str:
        found = self._translation.evaluate_in(node, env, "the level of an assertion")
        if not isinstance(found, EnumValue) or found.type_name != "AssertionLevel":
            message = "the level of an assertion is AssertionLevel.error or AssertionLevel.warning"
            raise type_error("type.mismatch", message, node.span)
        return found.literal

    def _message(self, node: ast.Expression, env: Env) -> str:
        """The text of an assertion; one that is computed at run time is shown as it is written."""
        try:
            value = as_scalar(self._translation.value(node, env), node.span)
        except UnsupportedProblem:
            return print_expression(node)
        if value.type != STRING:
            message = f"the message of an assertion is a String, not {describe(value)}"
            raise type_error("type.mismatch", message, node.span)
        text = value.item.value if value.item.is_const else None
        return text if isinstance(text, str) else print_expression(node)


def _component_of(env: Env) -> str:
    return env.context.instance.path if env.context.instance is not None else ""


def _unbalanced(counts: Sequence[int], tests: Sequence[Expr], span: Span) -> AcausalError:
    shown = ", ".join(map(str, counts))
    return type_error(
        "if.unbalanced",
        f"the branches of this if-equation have {shown} equations; they must have the same number",
        span,
        "add the missing equations (also an else branch), or make the condition depend on parameters only",
        ex.symbols(tests),
    )
