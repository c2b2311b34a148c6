"""Statements of functions and algorithm sections, run at compile time on symbolic values (11.2)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from acausal.errors import AcausalError, Span, TypeProblem, UnsupportedProblem, fail
from acausal.lang import ast
from acausal.lang.arithmetic import as_boolean, as_value, type_error
from acausal.lang.assertions import add_assertion, assertion_of, termination_text
from acausal.lang.assignments import assign
from acausal.lang.flat import BOOLEAN, Termination
from acausal.lang.flow import (
    BREAKS,
    RETURNS,
    STAYS,
    Flow,
    either,
    merge,
    only_where,
    restore,
    run_under,
    state_of,
    then,
    undo,
)
from acausal.lang.function_frame import Frame
from acausal.lang.iteration import iterator_values
from acausal.lang.values import describe
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import FALSE, Expr

MOST_UNCERTAIN = 200
"""Repetitions of a loop that may have been left before, which only the run time knows."""
_BranchNode = tuple[ast.Expression, tuple[ast.Statement, ...]]


def run_algorithm(frame: Frame, sections: Iterable[ast.AlgorithmSection]) -> None:
    """Run algorithm sections; the variables change in `frame`."""
    statements = [statement for section in sections for statement in section.statements]
    if _statements(frame, statements).broken is not FALSE:
        message = f"`break` stands outside a loop in `{frame.scope.path}`"
        raise type_error("function.break", message, frame.scope.span, "", (frame.scope.path,))


def _statements(frame: Frame, statements: Sequence[ast.Statement]) -> Flow:
    for k, statement in enumerate(statements):
        frame.count_step(statement.span)
        flow = _statement(frame, statement)
        if flow is STAYS:
            continue
        rest = statements[k + 1 :]
        if flow.certain or not rest:
            return flow

        def run(rest: Sequence[ast.Statement] = rest) -> Flow:
            return _statements(frame, rest)

        return then(flow, only_where(frame, ex.logical_not(flow.left), run, rest[0].span))
    return STAYS


def _statement(frame: Frame, statement: ast.Statement) -> Flow:
    if isinstance(statement, ast.Assignment):
        assign(frame, statement)
        return STAYS
    if isinstance(statement, ast.IfStatement):
        return _if(frame, statement.branches, statement.otherwise)
    if isinstance(statement, ast.ForStatement):
        return _for(frame, statement.iterators, statement.body)
    if isinstance(statement, ast.WhileStatement):
        return _while(frame, statement)
    if isinstance(statement, ast.ReturnStatement):
        return RETURNS
    if isinstance(statement, ast.BreakStatement):
        return BREAKS
    if isinstance(statement, ast.WhenStatement):
        return _when(frame, statement)
    _call(frame, statement.call)
    return STAYS


def _call(frame: Frame, call: ast.Call) -> None:
    """A call that stands alone: `assert`, `terminate`, or a function whose results are not used."""
    name = call.function.text
    if name == "assert":
        assertion = assertion_of(frame.translation, call, frame.env(), frame.component)
        add_assertion(frame.translation.assertions, assertion, frame.guard)
    elif name == "terminate" and frame.instance is not None:
        text = termination_text(frame.translation, call, frame.env())
        frame.terminations.append((frame.guard, Termination(text, call.span, frame.component)))
    elif name in ("terminate", "reinit"):
        message = f"`{name}` cannot stand in {'a function' if frame.instance is None else 'an algorithm'}"
        raise type_error(f"statement.{name}", message, call.span, "", (frame.scope.path,))
    else:
        frame.results(call)


# --------------------------------------------------------------------------- branches


def _if(frame: Frame, branches: Sequence[_BranchNode], otherwise: tuple[ast.Statement, ...]) -> Flow:
    if not branches:
        return _statements(frame, otherwise)
    (condition, body), rest = branches[0], branches[1:]
    test = as_boolean(frame.value(condition), condition.span)
    known = frame.translation.decide_discrete(test)
    if known is None and (_jumps(body) or any(_jumps(b) for _, b in rest) or _jumps(otherwise)):
        known = frame.translation.decide(test)
    if known is not None:
        return _statements(frame, body) if known else _if(frame, rest, otherwise)
    before = state_of(frame)
    try:
        return _both(
            frame,
            test,
            lambda: _statements(frame, body),
            lambda: _if(frame, rest, otherwise),
            condition.span,
        )
    except TypeProblem:  # sizes or indices make sense in one of the branches only
        known = frame.translation.decide(test)
        if known is None:
            raise
        undo(frame, before)
        return _statements(frame, body) if known else _if(frame, rest, otherwise)


def _both(
    frame: Frame, test: Expr, first: Callable[[], Flow], second: Callable[[], Flow], span: Span
) -> Flow:
    """Run two branches, each from the same start, and merge what they assign."""
    before = state_of(frame)
    flow = run_under(frame, test, first)
    taken = state_of(frame)
    restore(frame, before)
    other_flow = run_under(frame, ex.logical_not(test), second)
    merge(frame, test, taken, state_of(frame), span)
    return either(test, flow, other_flow)


def _jumps(body: Iterable[ast.Statement]) -> bool:
    """Whether statements may break or return."""
    for statement in body:
        if isinstance(statement, (ast.ReturnStatement, ast.BreakStatement)):
            return True
        if isinstance(statement, (ast.ForStatement, ast.WhileStatement)) and _jumps(statement.body):
            return True
        if isinstance(statement, ast.IfStatement) and (
            any(_jumps(b) for _, b in statement.branches) or _jumps(statement.otherwise)
        ):
            return True
    return False


# --------------------------------------------------------------------------- when


def _when(frame: Frame, statement: ast.WhenStatement) -> Flow:
    """`when` of an algorithm section: an `if` on the firing of its conditions (11.2.7.3)."""
    tests = [_fires(frame, condition) for condition, _ in statement.branches]
    outer = frame.at_event
    frame.at_event = True
    try:
        return _when_branches(frame, tests, [body for _, body in statement.branches], statement.span)
    finally:
        frame.at_event = outer


def _when_branches(
    frame: Frame, tests: Sequence[Expr], bodies: Sequence[Sequence[ast.Statement]], span: Span
) -> Flow:
    if not tests:
        return STAYS
    if tests[0] is FALSE:
        return _when_branches(frame, tests[1:], bodies[1:], span)
    return _both(
        frame,
        tests[0],
        lambda: _statements(frame, bodies[0]),
        lambda: _when_branches(frame, tests[1:], bodies[1:], span),
        span,
    )


def _fires(frame: Frame, condition: ast.Expression) -> Expr:
    """Whether one of the conditions fires at this event."""
    value = as_value(frame.value(condition), condition.span)
    if value.type != BOOLEAN or len(value.shape) > 1:
        message = f"the condition of a `when` is a Boolean or a vector of Booleans, not {describe(value)}"
        raise type_error("type.not-boolean", message, condition.span, "", ex.symbols(value.items))
    return ex.logical_or(*[ex.trigger(item) for item in value.items])


# --------------------------------------------------------------------------- loops


def _for(frame: Frame, iterators: Sequence[ast.Iterator], body: Sequence[ast.Statement]) -> Flow:
    """`for i in r, j in s loop`: `break` leaves them all."""
    return Flow(_for_nested(frame, iterators, body).returned) if iterators else STAYS


def _for_nested(frame: Frame, iterators: Sequence[ast.Iterator], body: Sequence[ast.Statement]) -> Flow:
    if not iterators:
        return _statements(frame, body)
    first, rest = iterators[0], iterators[1:]
    values = iterator_values(frame.translation, first, frame.env(), tuple(body))
    hidden = frame.variables.get(first.name)
    flow = STAYS
    for value in values:
        frame.count_step(first.span)
        frame.variables[first.name] = value
        flow = _next(frame, flow, lambda: _for_nested(frame, rest, body), first.span)
        if flow.certain:
            break
    if hidden is None:
        frame.variables.pop(first.name, None)
    else:
        frame.variables[first.name] = hidden
    return flow


def _next(frame: Frame, flow: Flow, run: Callable[[], Flow], span: Span) -> Flow:
    """Run once more where control has not left the loop."""
    if flow is STAYS or flow.left is FALSE:
        return run()
    if len(flow.left.args) > MOST_UNCERTAIN:
        raise _run_time_loop(frame, span)
    return then(flow, only_where(frame, ex.logical_not(flow.left), run, span))


def _while(frame: Frame, statement: ast.WhileStatement) -> Flow:
    return Flow(_rounds(frame, statement, 0).returned)


def _rounds(frame: Frame, statement: ast.WhileStatement, uncertain: int) -> Flow:
    """A `while` from here on, `uncertain` rounds of which happen only if the run time says so.

    `while c loop B` is `if c then B; while c loop B`, where B has made `c` known to be false in the end.
    """
    while True:
        frame.count_step(statement.span)
        test = as_boolean(frame.value(statement.condition), statement.condition.span)
        known = frame.translation.decide(test)
        if known is None:
            if uncertain >= MOST_UNCERTAIN:
                raise _run_time_loop(frame, statement.condition.span)
            span = statement.condition.span
            return _both(frame, test, lambda: _round(frame, statement, uncertain + 1), lambda: STAYS, span)
        if not known:
            return STAYS
        flow = _statements(frame, statement.body)
        if flow is not STAYS:
            return _again(frame, statement, flow, uncertain + 1)


def _round(frame: Frame, statement: ast.WhileStatement, uncertain: int) -> Flow:
    """The body, and what follows."""
    return _again(frame, statement, _statements(frame, statement.body), uncertain)


def _again(frame: Frame, statement: ast.WhileStatement, flow: Flow, uncertain: int) -> Flow:
    """The rounds after one from which control may have left the loop."""
    if flow is STAYS:
        return _rounds(frame, statement, uncertain)
    if flow.certain:
        return flow
    if uncertain >= MOST_UNCERTAIN:
        raise _run_time_loop(frame, statement.span)
    stays = ex.logical_not(flow.left)
    rest = only_where(frame, stays, lambda: _rounds(frame, statement, uncertain), statement.span)
    return then(flow, rest)


def _run_time_loop(frame: Frame, span: Span) -> AcausalError:
    return fail(
        UnsupportedProblem,
        "unsupported.run-time-loop",
        f"`{frame.scope.path}` has a loop whose number of repetitions is known at run time only",
        span,
        names=[frame.scope.path],
        hint=f"let something known at compile time end it after {MOST_UNCERTAIN} repetitions at most",
    )
