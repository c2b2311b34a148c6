"""When-clauses, triggers and the functions that jump, as plain equations and guarded actions.

`when c then v = e; elsewhen b then v = f; end when` becomes

    v = if fires(c) then e else if fires(b) then f else pre(v)
    fires(c) = c and not pre(c) and not initial()

except that `fires(initial())` is `initial()` (Modelica 3.6, 8.3.5). `pre(c)` of a condition is a value of its
own. `floor(x)`, `ceil(x)`, `div(x, y)`, `mod(x, y)` and `rem(x, y)` of what varies continuously are written
with `integer`, so that there is one function that holds a whole number between events.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from acausal.lang.flat import (
    Assertion,
    Equation,
    FlatModel,
    Reinit,
    StateSelect,
    Variable,
    When,
    WhenBranch,
)
from acausal.symbolic.causal import Check, Reset, Stop
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.expressions.operators import EVENT_FUNCTIONS
from acausal.symbolic.leaves import is_moving, value_leaves


@dataclass(frozen=True)
class Lowered:
    """`flat` without when-clauses, and what else happens at events, in the variables of `flat`."""

    flat: FlatModel
    resets: tuple[Reset, ...]
    checks: tuple[Check, ...]
    stops: tuple[Stop, ...]

    @property
    def roots(self) -> list[Expr]:
        """Every expression of the actions."""
        found = [e for reset in self.resets for e in (reset.condition, reset.value)]
        found += [e for check in self.checks for e in (check.condition, check.assertion.condition)]
        return [*found, *(stop.condition for stop in self.stops)]


def fires(condition: Expr) -> Expr:
    """Whether a when-condition becomes true at this event."""
    if condition.op == "initial":
        return condition
    return ex.logical_and(condition, ex.logical_not(ex.pre(condition)), ex.logical_not(ex.initial()))


def is_momentary(condition: Expr) -> bool:
    """Whether a condition is true at events only: `fires(c)`, `edge(b)`, `initial()`, `sample(...)`."""
    if condition.op == "or":
        return all(is_momentary(part) for part in condition.args)
    if condition.op == "and":
        edges = any(part.op == "not" and _is_past(part.args[0], condition.args) for part in condition.args)
        return edges or any(is_momentary(part) for part in condition.args)
    return condition.op in ("initial", "terminal", "sample", "trigger")


def is_assignment(left: Expr, right: Expr) -> bool:
    """Whether `left = right` is what a when-clause makes of a variable: no other is determined by it.

    `v = if fires(c) then ... else pre(v)`, where the new value does not depend on v itself.
    """
    if left.op != "sym" or right.op != "if" or not is_momentary(right.args[0]):
        return False
    last = right
    while last.op == "if" and is_momentary(last.args[0]):
        last = last.args[2]
    return last.op == "pre" and last.args[0] is left and left not in value_leaves([right])


def _is_past(node: Expr, parts: Sequence[Expr]) -> bool:
    return node.op == "pre" and node.args[0] in parts


def lower(flat: FlatModel) -> Lowered:
    """Everything that happens at events as equations and actions. O(nodes)."""
    rewrite = _Rewriter(flat.by_name)
    equations = [_rewritten(equation, rewrite) for equation in flat.equations]
    resets: list[Reset] = []
    checks: list[Check] = []
    stops: list[Stop] = []
    for when in flat.whens:
        equations += [_rewritten(equation, rewrite) for equation in _equations(when)]
        for condition, branch in _guarded(when):
            test = rewrite(condition)
            resets += [_reset(test, reinit, rewrite) for reinit in branch.reinits]
            checks += [Check(test, _rewritten_assertion(a, rewrite)) for a in branch.assertions]
            stops += [Stop(test, end) for end in branch.terminations]
    lowered = replace(
        flat,
        variables=_with_states(flat, resets),
        equations=tuple(equations),
        initial_equations=tuple([_rewritten(e, rewrite) for e in flat.initial_equations]),
        assertions=tuple([_rewritten_assertion(a, rewrite) for a in flat.assertions]),
        whens=(),
    )
    return Lowered(lowered, tuple(resets), tuple(checks), tuple(stops))


def _with_states(flat: FlatModel, resets: Sequence[Reset]) -> tuple[Variable, ...]:
    """The variables; those that are reset must be states (Modelica 3.6, 8.3.6)."""
    names = {reset.state for reset in resets}
    return tuple(
        [replace(v, state_select=StateSelect.ALWAYS) if v.name in names else v for v in flat.variables]
    )


def _reset(test: Expr, reinit: Reinit, rewrite: _Rewriter) -> Reset:
    return Reset(test, reinit.state.name, rewrite(reinit.value), reinit.span)


def _rewritten(equation: Equation, rewrite: _Rewriter) -> Equation:
    left, right = rewrite(equation.left), rewrite(equation.right)
    if left is equation.left and right is equation.right:
        return equation
    return replace(equation, left=left, right=right)


def _rewritten_assertion(assertion: Assertion, rewrite: _Rewriter) -> Assertion:
    condition = rewrite(assertion.condition)
    return assertion if condition is assertion.condition else replace(assertion, condition=condition)


def _fires_any(branch: WhenBranch) -> Expr:
    return ex.logical_or(*[fires(condition) for condition in branch.conditions])


def _guarded(when: When) -> list[tuple[Expr, WhenBranch]]:
    """Every branch with the condition under which it acts: it fires, and none before it does."""
    found: list[tuple[Expr, WhenBranch]] = []
    earlier: list[Expr] = []
    for branch in when.branches:
        own = _fires_any(branch)
        found.append((ex.logical_and(own, *[ex.logical_not(e) for e in earlier]), branch))
        earlier.append(own)
    return found


def _equations(when: When) -> list[Equation]:
    """One equation for each variable that the clause assigns."""
    result: list[Equation] = []
    for variable in when.assigned:
        value = ex.pre(variable)
        origin: Equation | None = None
        for branch in reversed(when.branches):
            given = next((e for e in branch.equations if e.left is variable), None)
            origin = given or origin
            own = ex.pre(variable) if given is None else given.right
            value = ex.if_then_else(_fires_any(branch), own, value)
        assert origin is not None
        result.append(replace(origin, left=variable, right=value))
    return result


class _Rewriter:
    """Writes `trigger` and the jumping functions out; shares work between all calls."""

    def __init__(self, variables: Mapping[str, Variable]) -> None:
        self._memo: dict[Expr, Expr] = {}
        self._shared: dict[int, list[Expr]] = {}
        self._moving: dict[Expr, bool] = {}
        self._variables = variables

    def __call__(self, root: Expr) -> Expr:
        return ex.fold([root], self._written_out, self._memo, self._shared)[root]

    def _written_out(self, node: Expr, args: list[Expr]) -> Expr:
        if node.op == "trigger":
            return fires(args[0])
        if node.op in EVENT_FUNCTIONS and ex.fold([node], self._moves, self._moving)[node]:
            return _with_integer(node.op, args)
        new = tuple(args)
        return node if new == node.args else ex.rebuild(node, new)

    def _moves(self, node: Expr, args: list[bool]) -> bool:
        """Whether the value changes between events."""
        if node.op == "sym":
            return node is ex.TIME or is_moving(self._variables.get(node.name))
        return node.op in ("der", "delay") or (node.op != "pre" and any(args))


def _with_integer(op: str, args: Sequence[Expr]) -> Expr:
    if op in ("integer", "floor"):
        return ex.function("integer", args[0])
    if op == "ceil":
        return ex.neg(ex.function("integer", ex.neg(args[0])))
    quotient = ex.div(*args)
    if op == "mod":
        return ex.sub(args[0], ex.mul(ex.function("integer", quotient), args[1]))
    whole = ex.if_then_else(
        ex.relation("ge", quotient, ex.ZERO),
        ex.function("integer", quotient),
        ex.neg(ex.function("integer", ex.neg(quotient))),
    )
    return whole if op == "idiv" else ex.sub(args[0], ex.mul(whole, args[1]))
