"""Expressions in CasADi against their value in Python, and the safety of untaken branches."""

from __future__ import annotations

import math

import casadi as ca
import numpy as np
import pytest
from casadi import SX, Function
from hypothesis import given
from hypothesis import strategies as st

from acausal.codegen.casadi_expressions import CONSTRUCTORS, FORWARD, jacobian, to_casadi
from acausal.errors import UnsupportedProblem
from acausal.symbolic.expressions import expr as e
from acausal.symbolic.expressions.evaluate import EvaluationFailed, evaluate
from acausal.symbolic.expressions.expr import Constant, Expr, sym
from acausal.symbolic.expressions.operators import KNOWN_AT_EVENTS, OPERATORS, RELATIONS

A, B, C = sym("a"), sym("b"), sym("c")
NAMES = ("a", "b", "c")
REALS = st.floats(-4.0, 4.0).map(lambda v: round(v, 3))


def numeric(root: Expr, values: dict[str, float]) -> float:
    symbols = [SX.sym(name) for name in NAMES]
    code = to_casadi([root], dict(zip(map(sym, NAMES), symbols, strict=True)))[0]
    return float(Function("f", symbols, [code])(*[values[name] for name in NAMES]))


def reference(root: Expr, values: dict[str, float]) -> float | None:
    def lookup(name: str) -> Constant | None:
        return values.get(name)

    try:
        value = evaluate(root, lookup)
    except EvaluationFailed:
        return None
    assert isinstance(value, int | float)
    return float(value)


def applied(op: str) -> Expr:
    operator = OPERATORS[op]
    if op in ("and", "or"):
        return e.make(op, (e.relation("gt", A, e.ZERO), e.relation("gt", B, e.ZERO)))
    if op == "not":
        return e.make("not", (e.relation("gt", A, e.ZERO),))
    if op == "if":
        return e.make("if", (e.relation("gt", A, B), B, C))
    arity = 3 if operator.arity is None else operator.arity
    return e.make(op, (A, B, C)[:arity])


def test_every_operator_has_a_constructor() -> None:
    wrapped = {"const", "sym", "der", "pre", "call", "noEvent", "smooth", "derived", "rate"}
    elsewhere = wrapped | set(KNOWN_AT_EVENTS)
    assert set(CONSTRUCTORS) == set(OPERATORS) - elsewhere


@pytest.mark.parametrize("op", sorted(CONSTRUCTORS))
@given(a=REALS, b=REALS, c=REALS)
def test_operator_agrees_with_python(op: str, a: float, b: float, c: float) -> None:
    values = {"a": a, "b": b, "c": c}
    expected = reference(applied(op), values)
    if expected is not None and math.isfinite(expected):
        assert numeric(applied(op), values) == pytest.approx(expected, rel=1e-12, abs=1e-13)


def random_expressions() -> st.SearchStrategy[Expr]:
    leaves = st.sampled_from([A, B, C, e.const(0.5), e.const(2.0)])

    def extend(inner: st.SearchStrategy[Expr]) -> st.SearchStrategy[Expr]:
        condition = st.builds(e.relation, st.sampled_from(["lt", "le", "gt", "ge"]), inner, inner)
        return st.one_of(
            st.builds(e.add, inner, inner),
            st.builds(e.sub, inner, inner),
            st.builds(e.mul, inner, inner),
            st.builds(e.if_then_else, condition, inner, inner),
            st.builds(e.function, st.sampled_from(["sin", "tanh", "atan"]), inner),
            st.builds(e.no_event, inner),
        )

    return st.recursive(leaves, extend, max_leaves=12)


@given(root=random_expressions(), a=REALS, b=REALS, c=REALS)
def test_whole_expressions_agree_with_python(root: Expr, a: float, b: float, c: float) -> None:
    values = {"a": a, "b": b, "c": c}
    expected = reference(root, values)
    if expected is not None and abs(expected) < 1e100:
        assert numeric(root, values) == pytest.approx(expected, rel=1e-9, abs=1e-9)


def test_long_sums_and_deep_nests_need_no_recursion() -> None:
    deep = A
    for _ in range(20_000):
        deep = e.make("sin", (deep,))
    assert math.isfinite(numeric(deep, {"a": 1.0, "b": 0.0, "c": 0.0}))


def test_untaken_branch_does_no_harm() -> None:
    root = e.if_then_else(
        e.relation("ge", A, e.ZERO), e.function("sqrt", A), e.div(e.ONE, e.function("log", e.neg(A)))
    )
    assert numeric(root, {"a": 4.0, "b": 0.0, "c": 0.0}) == 2.0
    assert numeric(root, {"a": -math.e, "b": 0.0, "c": 0.0}) == pytest.approx(1.0)


def test_derivative_of_untaken_branches_is_finite_forward_but_not_in_reverse() -> None:
    """Two untaken branches share log(a): the finding that `FORWARD` rests on."""
    shared = e.function("log", A)
    root = e.add(
        e.if_then_else(e.relation("gt", B, e.const(1.0)), shared, B),
        e.if_then_else(e.relation("gt", B, e.const(2.0)), e.mul(e.const(2.0), shared), B),
    )
    x = SX.sym("x", 2)
    code = to_casadi([root], {A: x[0], B: x[1]})[0]
    forward = Function("f", [x], [jacobian(code, x)])([0.0, 0.0])
    assert np.array(forward).ravel().tolist() == [0.0, 2.0]
    reverse = ca.jacobian(code, x, {"helper_options": {**FORWARD, "ad_weight": 1.0}})
    assert np.isnan(np.array(Function("f", [x], [reverse])([0.0, 0.0]))).any()


def test_relation_is_a_mode_only_outside_no_event() -> None:
    relation = e.relation("lt", A, B)
    event = e.if_then_else(relation, e.ONE, e.ZERO)
    mode, a, b = SX.sym("m"), SX.sym("a"), SX.sym("b")
    both = to_casadi(
        [event, e.no_event(event), e.make("smooth", (event,), 0)], {A: a, B: b}, {relation: mode}
    )
    values = Function("f", [mode, a, b], [ca.vertcat(*both)])(1.0, 5.0, 2.0)
    assert np.array(values).ravel().tolist() == [1.0, 0.0, 0.0]


@pytest.mark.parametrize("op", sorted(RELATIONS))
def test_relations_at_equality(op: str) -> None:
    values = {"a": 1.0, "b": 1.0, "c": 0.0}
    assert numeric(e.make(op, (A, B)), values) == reference(e.make(op, (A, B)), values)


@pytest.mark.parametrize("root", [e.rate(A), e.const("text"), e.pre(A), sym("unheard")])
def test_what_has_no_code_is_refused(root: Expr) -> None:
    with pytest.raises(UnsupportedProblem):
        to_casadi([root], {A: SX.sym("a")})


def test_root_of_what_is_not_below_zero_has_a_slope_below_zero() -> None:
    x = SX.sym("x")
    (root,) = to_casadi([e.function("sqrt", e.function("max", e.ZERO, sym("x")))], {sym("x"): x})
    run = Function("run", [x], [root, jacobian(root, x)])
    assert [[float(v) for v in run(at)] for at in (-1.0, 0.0, 4.0)] == [[0, 0], [0, 0], [2, 0.25]]
