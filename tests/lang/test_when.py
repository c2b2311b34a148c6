"""When-clauses in flat models: what is proven of them, how they count and print, and who refuses them."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import pytest

from acausal.errors import BalanceProblem, Source, TypeProblem
from acausal.lang.base_modelica import print_flat
from acausal.lang.flat import (
    BOOLEAN,
    INTEGER,
    REAL,
    Equation,
    FlatModel,
    Origin,
    Reinit,
    Termination,
    Variability,
    When,
    WhenBranch,
)
from acausal.lang.parser import parse
from acausal.lang.verify import verify
from acausal.symbolic.balance import check_balance
from acausal.symbolic.expressions import expr as ex
from acausal.symbolic.expressions.expr import Expr
from tests.lang.flat_models import assertion, equation, expression, model, real, span, variable

DISCRETE = Variability.DISCRETE
VARIABLES = (
    real("x"),
    real("v"),
    variable("n", INTEGER, DISCRETE),
    variable("b", BOOLEAN, DISCRETE),
    variable("d", REAL, DISCRETE),
)
CONTINUOUS = ("der(x) = v", "der(v) = -9.81", "b = x < 0")


def branch(
    conditions: Sequence[str],
    *equations: str,
    reinits: Sequence[tuple[str, str]] = (),
    assertions: Sequence[str] = (),
    messages: Sequence[str] = (),
) -> WhenBranch:
    return WhenBranch(
        tuple(map(expression, conditions)),
        tuple(map(equation, equations)),
        tuple(Reinit(expression(x), expression(value), span()) for x, value in reinits),
        tuple(map(assertion, assertions)),
        tuple(Termination(ex.const(message), span()) for message in messages),
        span(),
    )


def flat(*branches: WhenBranch, more: Sequence[Equation | str] = ()) -> FlatModel:
    whens = (When(branches, span()),) if branches else ()
    return dataclasses.replace(model(VARIABLES, (*CONTINUOUS, *more)), whens=whens)


COUNTED = branch(["b", "sample(0, 0.1)"], "n = pre(n) + 1", "d = x")


def text_of(found: FlatModel) -> str:
    """What is printed, which is Modelica."""
    text = print_flat(found)
    parse(Source("flat.mo", text))
    return text


def codes(found: FlatModel) -> tuple[str, ...]:
    with pytest.raises(TypeProblem) as caught:
        verify(found)
    return caught.value.codes


def test_one_equation_for_every_variable_that_is_assigned() -> None:
    found = flat(COUNTED, branch(["x > 3"], "d = 1.0", "n = 0"))
    verify(found)
    check_balance(found)
    assert found.equation_count == 5


def test_too_few() -> None:
    with pytest.raises(BalanceProblem) as caught:
        check_balance(flat(branch(["b"], "n = 1")))
    assert caught.value.codes == ("balance.too-few-equations",)
    assert caught.value.diagnostics[0].names == ("d",)


def test_too_many() -> None:
    with pytest.raises(BalanceProblem) as caught:
        check_balance(flat(COUNTED, more=["d = 2 * time"]))
    assert "balance.too-many-equations" in caught.value.codes
    assert "d" in caught.value.diagnostics[0].names


@pytest.mark.parametrize(
    ("wrong", "code"),
    [
        (branch(["x"], "n = 1"), "type.condition"),
        (branch(["noEvent(x > 0)"], "n = 1"), "when.condition"),
        (branch(["b"], "x = 1.0"), "when.left-side"),
        (branch(["b"], "n = x"), "type.equation"),
        (branch(["b"], reinits=[("n", "1")]), "reinit.state"),
        (branch(["b"], reinits=[("x", "b")]), "type.equation"),
        (branch(["b"], assertions=["x"]), "type.assertion"),
    ],
)
def test_what_does_not_fit_is_refused(wrong: WhenBranch, code: str) -> None:
    assert code in codes(flat(wrong))


def test_branches_assign_the_same_variables() -> None:
    assert "when.assigned" in codes(flat(COUNTED, branch(["x > 3"], "n = 0")))


def test_pre_of_a_continuous_variable_stands_at_events_only() -> None:
    verify(flat(branch(["b"], "d = pre(x)", "n = 1")))
    assert codes(flat(more=["d = pre(x)"])) == ("type.pre",)


def test_change_of_a_real_may_be_asked_for() -> None:
    verify(flat(branch(["d != pre(d)"], "n = 1"), more=["d = 0"]))
    assert codes(flat(more=["n = 1 if d == x else 2"])) == ("type.real-equality",)


def test_text() -> None:
    found = flat(
        branch(["initial()", "b"], "n = 1", reinits=[("v", "-pre(v)")], assertions=["x > -1"]),
        branch(["terminal()"], "n = pre(n)", messages=["the end"]),
    )
    assert text_of(found).splitlines()[8:-2] == [
        "  equation",
        "    der('x') = 'v';",
        "    der('v') = -9.81;",
        "    'b' = 'x' < 0;",
        "    when 'b' then",
        "      'n' = 1;",
        "      reinit('v', -pre('v'));",
        "      assert('x' > -1, \"no\");",
        "    elsewhen terminal() then",
        "      'n' = pre('n');",
        '      terminate("the end");',
        "    end when;",
        "  initial equation",
        "    'n' = 1;",
        "    'v' = -pre('v');",
    ]


def assigned(left: str, right: Expr) -> Equation:
    return Equation(expression(left), right, span(), "", Origin.ALGORITHM)


def test_an_algorithm_that_is_a_when_clause_prints_as_one() -> None:
    fires = ex.logical_or(ex.trigger(expression("x > 1")), ex.trigger(expression("b")))
    right = ex.if_then_else(fires, expression("pre(n) + 1"), ex.pre(ex.sym("n")))
    text = text_of(flat(more=[assigned("n", right)]))
    assert "    when {'x' > 1, 'b'} then\n      'n' = pre('n') + 1;\n    end when;\n" in text
    assert "    'n' = pre('n');" in text


def test_other_algorithms_print_edges() -> None:
    right = ex.if_then_else(ex.trigger(expression("x > 1")), ex.const(1), ex.const(0))
    text = text_of(flat(more=[assigned("n", right)]))
    assert "'n' = if edge('$when1') then 1 else 0;" in text
    assert "'$when1' = 'x' > 1;" in text


def test_the_initial_event_fires_nothing_else() -> None:
    assert ex.trigger(ex.initial()) is ex.initial()
    assert ex.trigger(ex.FALSE) is ex.FALSE
