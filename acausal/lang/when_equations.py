"""When-equations as `When` clauses of the flat model (Modelica 3.6, 8.3.5 and 8.3.6).

Loops are unrolled and conditions on parameters decided; an `if` on anything else becomes `if` expressions.
`initial()` in a body is known: true in a branch that acts at initialisation, false in any other.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from acausal.errors import AcausalError, Span, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.algorithm_targets import check_assignable, scalars, target_value
from acausal.lang.arithmetic import as_boolean, as_value, type_error
from acausal.lang.assertions import assertion_of, guard_assertions, termination_text
from acausal.lang.flat import (
    BOOLEAN,
    REAL,
    Assertion,
    Equation,
    Reinit,
    Termination,
    Variability,
    When,
    WhenBranch,
)
from acausal.lang.iteration import iterate, require_parameters
from acausal.lang.matching_values import match_values
from acausal.lang.references import Selection, resolve
from acausal.lang.translation import Env, Translation
from acausal.lang.values import AnyValue, describe
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import FALSE, TRUE, Expr

_INITIAL = ex.initial()


def translate_when(
    translation: Translation, node: ast.WhenEquation, env: Env, component: str
) -> tuple[When, ...]:
    """One when-equation; `terminate` under a condition makes a clause of its own.

    Raises `when.*`, `reinit.*`, `assignment.*` and what expressions raise.
    """
    branches: list[WhenBranch] = []
    others: list[When] = []
    earlier: list[Expr] = []
    for condition, body in node.branches:
        conditions = _conditions(translation, condition, env)
        for part, initially in _phases(conditions):
            work = _Body(translation, component, initially)
            before = len(translation.assertions)
            work.equations(body, env.with_event())
            assertions = translation.assertions[before:]
            del translation.assertions[before:]
            branches.append(work.branch(part, tuple(assertions), condition.span))
            fires = ex.logical_or(*[ex.trigger(c) for c in part])
            for guard, termination in work.terminations:
                if guard is not TRUE and initially is TRUE:
                    raise _conditional_start(termination)
                if guard is not TRUE:
                    test = ex.logical_and(ex.logical_not(ex.logical_or(*earlier)), fires, guard)
                    others.append(terminating(test, termination))
            earlier.append(fires)
    _check_same_variables(branches)
    return (When(tuple(branches), node.span, component), *others)


def _conditional_start(termination: Termination) -> AcausalError:
    message = "`terminate` under a condition that is not known at compile time cannot act at initialisation"
    hint = "leave `initial()` out of the conditions of this when-equation"
    return fail(UnsupportedProblem, "unsupported.initial-terminate", message, termination.span, hint=hint)


def terminating(test: Expr, termination: Termination) -> When:
    """The clause that ends the simulation when `test` becomes true."""
    conditions = (_INITIAL if test is TRUE else test,)
    branch = WhenBranch(conditions, (), (), (), (termination,), termination.span)
    return When((branch,), termination.span, termination.component)


def _conditions(translation: Translation, node: ast.Expression, env: Env) -> tuple[Expr, ...]:
    value = as_value(translation.value(node, env), node.span)
    if value.type != BOOLEAN or len(value.shape) > 1:
        message = f"the condition of a `when` is a Boolean or a vector of Booleans, not {describe(value)}"
        hint = "compare it with something"
        raise type_error("type.not-boolean", message, node.span, hint, ex.symbols(value.items))
    written = node.items if isinstance(node, ast.ArrayConstructor) and not node.iterators else (node,)
    if len(written) != len(value.items):
        return value.items
    return tuple([_as_written(item, part) for item, part in zip(value.items, written, strict=True)])


def _as_written(item: Expr, node: ast.Expression) -> Expr:
    """`when f(initial())` does not act at initialisation as `when initial()` does, nor later (8.6)."""
    if item is not _INITIAL or (isinstance(node, ast.Call) and node.function.text.endswith("initial")):
        return item
    return FALSE


def _phases(conditions: tuple[Expr, ...]) -> Iterator[tuple[tuple[Expr, ...], Expr]]:
    """The conditions with what `initial()` is when they fire: separately for `{initial(), c}`."""
    others = tuple([c for c in conditions if c is not _INITIAL])
    if len(others) < len(conditions):
        yield (_INITIAL,), TRUE
    if others or not conditions:
        yield others, FALSE


def _check_same_variables(branches: Sequence[WhenBranch]) -> None:
    """All branches determine the same variables (8.3.5.2)."""
    every = dict.fromkeys([e.left for branch in branches for e in branch.equations])
    for branch in branches:
        own = {e.left for e in branch.equations}
        missing = [left.name for left in every if left not in own]
        if missing:
            shown = ", ".join(f"`{name}`" for name in missing[:6])
            message = f"this branch of the when-equation does not determine {shown}, another one does"
            hint = f"add `{missing[0]} = pre({missing[0]})` to keep its value"
            raise type_error("when.branches", message, branch.span, hint, tuple(missing[:6]))


@dataclass(slots=True)
class _Body:
    """The equations of one branch, or of one branch of an `if` in it."""

    translation: Translation
    component: str
    initially: Expr
    values: dict[Expr, tuple[Expr, Span]] = field(default_factory=dict[Expr, tuple[Expr, Span]])
    """What the variables that the branch determines are given."""
    reinits: dict[Expr, Reinit] = field(default_factory=dict[Expr, Reinit])
    terminations: list[tuple[Expr, Termination]] = field(default_factory=list[tuple[Expr, Termination]])
    """With the condition under which each is reached."""

    def branch(
        self, conditions: tuple[Expr, ...], assertions: tuple[Assertion, ...], span: Span
    ) -> WhenBranch:
        equations = [Equation(left, right, at, self.component) for left, (right, at) in self.values.items()]
        return WhenBranch(
            conditions,
            tuple(equations),
            tuple(self.reinits.values()),
            assertions,
            tuple([termination for guard, termination in self.terminations if guard is TRUE]),
            span,
        )

    def equations(self, nodes: Sequence[ast.Equation], env: Env) -> None:
        for node in nodes:
            self.equation(node, env)

    def equation(self, node: ast.Equation, env: Env) -> None:
        if isinstance(node, ast.EqualEquation):
            self.equal(node, env)
        elif isinstance(node, ast.IfEquation):
            self.conditional(node, env)
        elif isinstance(node, ast.ForEquation):
            require_parameters(self.translation, node.iterators, env)
            for inner in iterate(self.translation, node.iterators, env, node.body):
                self.equations(node.body, inner)
        elif isinstance(node, ast.CallEquation):
            self.call(node.call, env)
        elif isinstance(node, ast.WhenEquation):
            message = "a when-equation cannot stand inside another one"
            raise type_error("equation.nested-when", message, node.span)
        else:
            message = "`connect` cannot stand in `when`"
            names = (node.left.text, node.right.text)
            raise type_error("equation.connect-in-when", message, node.span, "", names)

    # ------------------------------------------------------------------ v = expression

    def equal(self, node: ast.EqualEquation, env: Env) -> None:
        if isinstance(node.left, ast.ComponentReference):
            self.give(node.left, self.value(node.right, env), env, node.span)
            return
        if not isinstance(node.left, ast.Tuple) or not isinstance(node.right, ast.Call):
            message = "in a when-equation the left side is a variable, or a list of variables in parentheses"
            raise type_error("equation.when-left-side", message, node.left.span)
        results = self.translation.results(node.right, env)
        if len(node.left.items) > len(results):
            name = node.right.function.text
            message = f"`{name}` has only {len(results)} result(s)"
            raise type_error("call.results", message, node.span, "", (name,))
        for item, result in zip(node.left.items, results, strict=False):
            if isinstance(item, ast.ComponentReference):
                self.give(item, result, env, node.span)

    def give(self, target: ast.ComponentReference, value: AnyValue, env: Env, span: Span) -> None:
        left = target_value(self.translation, target, env, initial=False)
        check_assignable(left, value, target)
        for symbol, item in match_values(left, value, span):
            if symbol in self.values:
                message = f"`{symbol.name}` is determined twice in one branch of a when-equation"
                raise type_error("when.twice", message, span, "", (symbol.name,))
            self.values[symbol] = (self.known(item), span)

    def value(self, node: ast.Expression, env: Env) -> AnyValue:
        return self.translation.value(node, env)

    def known(self, item: Expr) -> Expr:
        """The expression with what `initial()` is here."""
        return ex.substitute(item, {_INITIAL: self.initially})

    # ------------------------------------------------------------------ if

    def conditional(self, node: ast.IfEquation, env: Env) -> None:
        """A condition on parameters takes its branch; any other merges the branches."""
        parts: list[tuple[Expr, _Body]] = []
        otherwise = node.otherwise
        before = TRUE
        for condition, body in node.branches:
            test = self.known(as_boolean(self.value(condition, env), condition.span))
            decided = self.translation.decide(test)
            if decided is None:
                parts.append((test, self.inside(body, env, ex.logical_and(before, test))))
                before = ex.logical_and(before, ex.logical_not(test))
            elif decided:
                otherwise = body
                break
        if not parts:
            self.equations(otherwise, env)
            return
        last = self.inside(otherwise, env, before)
        self.merge(parts, last, node.span)

    def inside(self, body: Sequence[ast.Equation], env: Env, guard: Expr) -> _Body:
        """One branch of an `if`, whose assertions hold under `guard`."""
        inner = _Body(self.translation, self.component, self.initially)
        start = len(self.translation.assertions)
        inner.equations(body, env)
        guard_assertions(self.translation.assertions, start, guard)
        self.terminations += [(ex.logical_and(guard, c), t) for c, t in inner.terminations]
        return inner

    def merge(self, parts: Sequence[tuple[Expr, _Body]], last: _Body, span: Span) -> None:
        bodies = [*[body for _, body in parts], last]
        for symbol in dict.fromkeys([symbol for body in bodies for symbol in body.values]):
            if not all(symbol in body.values for body in bodies):
                message = (
                    f"one branch of this `if` in a when-equation determines `{symbol.name}`, another not"
                )
                hint = f"add `{symbol.name} = pre({symbol.name})` to keep its value, also as an else branch"
                raise type_error("when.if-branches", message, span, hint, (symbol.name,))
            if symbol in self.values:
                message = f"`{symbol.name}` is determined twice in one branch of a when-equation"
                raise type_error("when.twice", message, span, "", (symbol.name,))
            right = last.values[symbol][0]
            for test, body in reversed(parts):
                right = ex.if_then_else(test, body.values[symbol][0], right)
            self.values[symbol] = (right, span)
        self.merge_reinits(parts, last)

    def merge_reinits(self, parts: Sequence[tuple[Expr, _Body]], last: _Body) -> None:
        """A state that no branch sets anew keeps its value."""
        bodies = [*[body for _, body in parts], last]
        found = {state: reinit for body in bodies for state, reinit in body.reinits.items()}
        for state, reinit in found.items():
            value = last.reinits[state].value if state in last.reinits else state
            for test, body in reversed(parts):
                taken = body.reinits[state].value if state in body.reinits else state
                value = ex.if_then_else(test, taken, value)
            self.add_reinit(Reinit(state, value, reinit.span, self.component))

    # ------------------------------------------------------------------ calls

    def call(self, call: ast.Call, env: Env) -> None:
        name = call.function.text
        if name == "assert":
            assertion = assertion_of(self.translation, call, env, self.component)
            self.translation.assertions.append(assertion)
        elif name == "terminate":
            text = termination_text(self.translation, call, env)
            self.terminations.append((TRUE, Termination(text, call.span, self.component)))
        elif name == "reinit":
            self.reinit(call, env)
        else:
            self.translation.results(call, env)

    def reinit(self, call: ast.Call, env: Env) -> None:
        if len(call.arguments) != 2 or call.named:
            message = "`reinit` takes a state and its new value"
            raise type_error("call.arguments", message, call.span, "", ("reinit",))
        target, value = call.arguments
        if not isinstance(target, ast.ComponentReference):
            raise type_error("reinit.state", "`reinit` needs a variable", target.span)
        found = resolve(self.translation, target, env)
        if not isinstance(found, Selection) or found.constant:
            raise _no_state(target.text, target.span)
        for leaf in scalars(found.members):
            if leaf.type != REAL or leaf.prefixes.variability is not Variability.CONTINUOUS:
                raise _no_state(leaf.path, target.span)
        left = as_value(self.value(target, env), target.span)
        right = self.value(value, env)
        check_assignable(left, right, target)
        for state, item in match_values(left, right, call.span):
            self.add_reinit(Reinit(state, self.known(item), call.span, self.component))

    def add_reinit(self, reinit: Reinit) -> None:
        if reinit.state in self.reinits:
            name = reinit.state.name
            message = f"`{name}` is set by two `reinit` of one when-clause"
            hint = "put them into different branches of an `if`"
            raise type_error("reinit.twice", message, reinit.span, hint, (name,))
        self.reinits[reinit.state] = reinit


def _no_state(name: str, span: Span) -> AcausalError:
    message = f"`reinit` needs a continuous Real variable, and `{name}` is none"
    return type_error("reinit.state", message, span, "", (name,))
