"""Where control goes in a running algorithm: values of the variables, and the jumps out of statements.

A jump under a condition that is known only at run time leaves its loop or function under that condition: what
follows is then run where it is false, and every variable keeps its value where it is true.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from acausal.errors import Span
from acausal.lang.arithmetic import choose
from acausal.lang.function_frame import Frame
from acausal.lang.values import AnyValue, RecordValue, Value
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import FALSE, TRUE, Expr


@dataclass(frozen=True, slots=True)
class Flow:
    """The conditions under which control leaves the function (`returned`) or the loop (`broken`)."""

    returned: Expr = FALSE
    broken: Expr = FALSE

    @property
    def left(self) -> Expr:
        """The condition under which what follows is not reached."""
        return ex.logical_or(self.returned, self.broken)

    @property
    def certain(self) -> bool:
        """Whether nothing that follows is reached."""
        return self.left is TRUE


STAYS = Flow()
RETURNS = Flow(returned=TRUE)
BREAKS = Flow(broken=TRUE)


def then(first: Flow, second: Flow) -> Flow:
    """The flow of two pieces of which the second is run where control has not left the first."""
    if first is STAYS or second is STAYS:
        return second if first is STAYS else first
    return Flow(
        ex.logical_or(first.returned, ex.logical_and(ex.logical_not(first.broken), second.returned)),
        ex.logical_or(first.broken, ex.logical_and(ex.logical_not(first.returned), second.broken)),
    )


def either(test: Expr, taken: Flow, other: Flow) -> Flow:
    """The flow of an `if`."""
    if taken is other:
        return taken
    return Flow(
        _either(test, taken.returned, other.returned),
        _either(test, taken.broken, other.broken),
    )


def _either(test: Expr, a: Expr, b: Expr) -> Expr:
    if a is b:
        return a
    return ex.logical_or(ex.logical_and(test, a), ex.logical_and(ex.logical_not(test), b))


# --------------------------------------------------------------------------- variables


@dataclass(frozen=True, slots=True)
class State:
    """Values of the variables at one point."""

    variables: dict[str, AnyValue]
    current: dict[Expr, Expr]
    assigned: frozenset[str]
    assertions: int
    terminations: int


def state_of(frame: Frame) -> State:
    """The present values, not affected by what comes."""
    counts = len(frame.translation.assertions), len(frame.terminations)
    return State(dict(frame.variables), dict(frame.current), frozenset(frame.assigned), *counts)


def restore(frame: Frame, state: State) -> None:
    """Back to the values of a state; what was asserted since then stays."""
    frame.variables = dict(state.variables)
    frame.current = dict(state.current)
    frame.assigned = set(state.assigned)


def undo(frame: Frame, state: State) -> None:
    """As if nothing had been run since `state`."""
    restore(frame, state)
    del frame.translation.assertions[state.assertions :]
    del frame.terminations[state.terminations :]


def run_under(frame: Frame, condition: Expr, run: Callable[[], Flow]) -> Flow:
    """Run something where `condition` is true, from the values that the variables have then."""
    outer = frame.path
    frame.path = (*outer, condition)
    known = {test: truth for test, truth in facts(condition).items() if test in frame.tests}
    if known:
        frame.variables = {name: _known_value(value, known) for name, value in frame.variables.items()}
        frame.current = {symbol: _known(item, known) for symbol, item in frame.current.items()}
    try:
        return run()
    finally:
        frame.path = outer


def only_where(frame: Frame, condition: Expr, run: Callable[[], Flow], span: Span) -> Flow:
    """Run something where `condition` is true; where it is false the variables keep their values.

    The flow is that of the case in which it is run.
    """
    before = state_of(frame)
    flow = run_under(frame, condition, run)
    taken = state_of(frame)
    restore(frame, before)
    run_under(frame, ex.logical_not(condition), lambda: STAYS)
    merge(frame, condition, taken, state_of(frame), span)
    return flow


def merge(frame: Frame, test: Expr, taken: State, other: State, span: Span) -> None:
    """The variables have the values of `taken` where `test` is true, and else those of `other`."""
    if test.op == "not":
        test, taken, other = test.args[0], other, taken
    frame.tests.add(test)
    frame.variables = {
        name: a if a is other.variables[name] else choose(test, a, other.variables[name], span)
        for name, a in taken.variables.items()
        if name in other.variables
    }
    frame.current = {
        symbol: a if a is other.current[symbol] else ex.if_then_else(test, a, other.current[symbol])
        for symbol, a in taken.current.items()
    }
    frame.assigned = {*taken.assigned, *other.assigned}


# --------------------------------------------------------------------------- what conditions say


def facts(condition: Expr) -> dict[Expr, bool]:
    """What is true and what is false where a condition is true."""
    known: dict[Expr, bool] = {}
    stack = [(condition, True)]
    while stack:
        node, truth = stack.pop()
        if node.op == "not":
            stack.append((node.args[0], not truth))
        else:
            known[node] = truth
            if node.op == ("and" if truth else "or"):
                stack += [(part, truth) for part in node.args]
    return known


def _known(item: Expr, known: Mapping[Expr, bool]) -> Expr:
    """An `if` whose condition is known is the branch that it takes."""
    while item.op == "if" and item.args[0] in known:
        item = item.args[1 if known[item.args[0]] else 2]
    return item


def _known_value(value: AnyValue, known: Mapping[Expr, bool]) -> AnyValue:
    if isinstance(value, Value):
        if not any(item.op == "if" and item.args[0] in known for item in value.items):
            return value
        return Value(value.type, value.shape, tuple([_known(item, known) for item in value.items]))
    if isinstance(value, RecordValue):
        fields = {name: _known_value(field, known) for name, field in value.fields.items()}
        unchanged = all(field is value.fields[name] for name, field in fields.items())
        return value if unchanged else value.with_fields(fields)
    return value
