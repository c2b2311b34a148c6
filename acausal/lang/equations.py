"""The equations of components as scalar equations, assertions and connections (Modelica 3.6, chapter 8)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial

from acausal.errors import AcausalError, Span, TypeProblem
from acausal.lang import ast
from acausal.lang.algorithm_sections import translate_section
from acausal.lang.arithmetic import as_boolean, type_error
from acausal.lang.assertions import assertion_of, guard_assertions, termination_text
from acausal.lang.connecting import add_connection
from acausal.lang.connections import ConnectionSets
from acausal.lang.discrete import DiscreteVariables
from acausal.lang.flat import Equation, Origin, Termination, When
from acausal.lang.instance import Instance
from acausal.lang.iteration import iterate, require_parameters
from acausal.lang.links import GRAPH_CALLS, call_name
from acausal.lang.matching_values import match_values, merge_branches
from acausal.lang.modifiers import Context
from acausal.lang.naming import names_in, names_in_when, with_names
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue
from acausal.lang.when_equations import terminating, translate_when
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr

MAX_EQUATIONS = 1_000_000
MAX_BRANCHES = 2000
"""Branches of one if-equation whose conditions vary."""


class Equations:
    """What the equation sections of components come to, collected component by component."""

    def __init__(self, translation: Translation, sets: ConnectionSets) -> None:
        self._translation = translation
        self.equations: list[Equation] = []
        self.initial: list[Equation] = []
        self.whens: list[When] = []
        self.discrete = DiscreteVariables()
        self.sets = sets
        self._guards: list[Callable[[], Expr]] = []
        """When the branches of the `if`-equations on variables that are being translated are in force."""

    def component(self, instance: Instance) -> None:
        """Add the sections of one component (not of its parts)."""
        for section, scope in instance.scope.table.sections:
            env = Env(Context(scope, instance), at_event=section.initial)
            target = self.initial if section.initial else self.equations
            start = len(self._translation.assertions)
            if isinstance(section, ast.AlgorithmSection):
                result = translate_section(self._translation, section, scope, instance)
                target += result.equations
                self.whens += [terminating(test, end) for test, end in result.terminations]
                self.discrete.assign(result.discrete, section.span)
            else:
                for equation in section.equations:
                    self._equation(equation, env, target)
            self._own(start, instance.path)

    def _own(self, start: int, component: str) -> None:
        """Assertions of functions called from a component's sections belong to the component."""
        found = self._translation.assertions
        for k in range(start, len(found)):
            if not found[k].component and component:
                found[k] = replace(found[k], component=component)

    def _equation(self, node: ast.Equation, env: Env, target: list[Equation]) -> None:
        if isinstance(node, ast.EqualEquation):
            self._equal(node, env, target)
        elif isinstance(node, ast.ConnectEquation):
            self._connect(node, env, target)
        elif isinstance(node, ast.ForEquation):
            require_parameters(self._translation, node.iterators, env)
            for inner in iterate(self._translation, node.iterators, env, node.body):
                for equation in node.body:
                    self._equation(equation, inner, target)
        elif isinstance(node, ast.IfEquation):
            self._if(node, env, target)
        elif isinstance(node, ast.CallEquation):
            self._call(node, env, target)
        else:
            self._when(node, env, target)
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
        if len(tests) > MAX_BRANCHES:
            message = f"this if-equation has more than {MAX_BRANCHES} conditions that vary"
            raise type_error("equation.too-many-branches", message, span, "put the values into a table")

        def guard(k: int) -> Expr:
            return ex.logical_and(*[ex.logical_not(t) for t in tests[:k]], *tests[k : k + 1])

        bodies = [
            self._branch(body, env, partial(guard, k))
            for k, body in enumerate([*[body for _, body in branches], otherwise])
        ]
        counts = [len(body) for body in bodies]
        if len(dict.fromkeys(counts)) > 1:
            raise _unbalanced(counts, tests, span)
        target += [merge_branches(tests, row, span) for row in zip(*bodies, strict=True)]

    def _branch(self, body: Sequence[ast.Equation], env: Env, guard: Callable[[], Expr]) -> list[Equation]:
        """The equations of one branch; `guard`, which may be long, is made where something depends on it."""
        found: list[Equation] = []
        start = len(self._translation.assertions)
        self._guards.append(guard)
        for equation in body:
            self._equation(equation, env, found)
        self._guards.pop()
        if len(self._translation.assertions) > start:
            guard_assertions(self._translation.assertions, start, guard())
        return found

    # ------------------------------------------------------------------ connect and assert

    def _check_unconditional(
        self, what: str, node: ast.Equation, target: list[Equation], names: tuple[str, ...] = ()
    ) -> None:
        """What makes connections must not depend on variables (9.3)."""
        if self._guards or target is self.initial:
            where = "an if-equation needs a condition known at compile time"
            if not self._guards:
                where = "an initial equation is not possible"
            hint = "make the condition depend on parameters only" if self._guards else ""
            raise type_error("connect.conditional", f"`{what}` in {where}", node.span, hint, names or (what,))

    def _connect(self, node: ast.ConnectEquation, env: Env, target: list[Equation]) -> None:
        self._check_unconditional("connect", node, target, (node.left.text, node.right.text))
        add_connection(self._translation, self.sets, node, env)

    def _call(self, node: ast.CallEquation, env: Env, target: list[Equation]) -> None:
        name = call_name(node.call)
        component = _component_of(env)
        if name in GRAPH_CALLS:
            self._check_unconditional(name, node, target)
            self._translation.network(node.span).graph(node.span)  # which checks the call
        elif name == "assert":
            assertion = assertion_of(self._translation, node.call, env, component)
            self._translation.assertions.append(assertion)
        elif name == "terminate":
            text = termination_text(self._translation, node.call, env)
            guard = ex.logical_and(*[guard() for guard in self._guards])
            self.whens.append(terminating(guard, Termination(text, node.span, component)))
        elif name == "reinit":
            message = "`reinit` is only allowed in a when-equation"
            raise type_error("equation.reinit", message, node.span, "", (name,))
        else:
            self._translation.results(node.call, env)

    def _when(self, node: ast.WhenEquation, env: Env, target: list[Equation]) -> None:
        if self._guards or target is self.initial:
            where = "inside an `if` needs a condition known at compile time"
            if not self._guards:
                where = "cannot stand among initial equations"
            message = f"a when-equation {where}"
            hint = "put the `if` into the when-equation, or into its condition" if self._guards else ""
            raise type_error("equation.conditional-when", message, node.span, hint)
        try:
            whens = translate_when(self._translation, node, env, _component_of(env))
        except TypeProblem as problem:
            raise with_names(problem, names_in_when(node, _component_of(env))) from None
        self.whens += whens
        self.discrete.when(whens[0], self._translation)


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
