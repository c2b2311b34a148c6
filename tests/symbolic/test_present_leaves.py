"""Leaves of many equations that share large parts."""

from __future__ import annotations

from acausal.symbolic.expressions.expr import add, call, calls, der, each_symbol, if_then_else, mul, pre, sym
from acausal.symbolic.expressions.expr import relation as relation_of
from acausal.symbolic.expressions.kernel import Named
from acausal.symbolic.leaves import PresentLeaves, value_leaves
from tests.growth import Work, growth

MANY = tuple([sym(f"x{k}") for k in range(40)])
ONE_KERNEL, OTHER_KERNEL = Named("f", len(MANY)), Named("g", len(MANY))


def test_they_are_the_value_leaves_but_left_limits() -> None:
    u, v = sym("u"), sym("v")
    fires = relation_of("gt", v, u)
    held = tuple([if_then_else(relation_of("gt", sym("time"), x), u, pre(x)) for x in MANY])
    roots = [
        add(*MANY),
        mul(add(*MANY), v),
        if_then_else(fires, call(ONE_KERNEL, *held), pre(v)),
        if_then_else(fires, call(OTHER_KERNEL, *held), der(v)),
        call(OTHER_KERNEL, *MANY),
        add(call(ONE_KERNEL, *MANY), u),
    ]
    leaves = PresentLeaves()
    for left in roots:
        for right in roots:
            expected = [leaf for leaf in value_leaves([left, right]) if leaf.op != "pre"]
            assert list(leaves([left, right])) == expected


def test_calls_that_share_their_arguments_are_the_calls() -> None:
    first, second = calls([ONE_KERNEL, OTHER_KERNEL], MANY)
    assert first.args is second.args
    assert first is call(ONE_KERNEL, *MANY)
    assert second is call(OTHER_KERNEL, *MANY)
    assert first is not second


def test_equations_that_share_a_large_part_cost_what_the_part_costs_once() -> None:
    u = sym("u")

    def prepare(size: int) -> Work:
        held = tuple([if_then_else(relation_of("gt", u, sym(f"y{k}")), u, sym("v")) for k in range(size)])
        shared = calls([Named(f"f{k}", size) for k in range(size)], held)
        leaves = PresentLeaves()
        return lambda: [leaves([node]) for node in shared]

    assert growth(prepare, 100, 800) < 4


def test_symbols_come_one_by_one() -> None:
    assert next(each_symbol([add(*MANY)])) == "x0"
