"""What calls with the same many arguments share: walked once, found in the same order."""

from __future__ import annotations

from acausal.symbolic.expressions.expr import (
    Expr,
    add,
    call,
    const,
    der,
    function,
    gather,
    if_then_else,
    mul,
    no_event,
    pre,
    sub,
    sym,
    symbols,
    unknown_leaves,
)
from acausal.symbolic.expressions.expr import relation as relation_of
from acausal.symbolic.expressions.kernel import Named
from acausal.symbolic.expressions.linear import slopes
from acausal.symbolic.expressions.text import beginning, quoted_name, to_text
from acausal.symbolic.expressions.walk import UNKNOWNS
from tests.growth import Work, growth

X = tuple([sym(f"x{k}") for k in range(20)])
U, V = sym("u"), sym("v")


def _mixed(kernel: str, first: tuple[Expr, ...]) -> Expr:
    inner = [no_event(if_then_else(relation_of("gt", x, V), x, pre(x))) for x in X]
    held = [if_then_else(relation_of("gt", U, x), a, der(V)) for x, a in zip(X, inner, strict=True)]
    return call(Named(kernel, len(held) + len(first)), *first, *held)


def test_calls_made_apart_share_their_arguments() -> None:
    one, other = call(Named("f", 20), *X), call(Named("g", 20), *list(X))
    assert one.wide is other.wide
    assert one.wide is not None
    assert one.args is other.args
    assert call(Named("f", 2), U, V).wide is None


def test_walks_find_the_same_in_the_same_order_as_in_a_function_that_shares_nothing() -> None:
    wide = _mixed("f", (V, add(X[3], X[2])))
    nested = call(Named("g", 20), *X[:10], wide, *X[10:19])
    assert symbols([wide])[:4] == ("v", "x3", "x2", "u")
    flat = [function("max", a, a) for a in wide.args]
    assert unknown_leaves(wide) == gather(flat, UNKNOWNS)
    inside = [*nested.args[:10], *wide.args, *nested.args[11:]]
    assert symbols([nested]) == symbols(inside)
    assert symbols([sub(wide, U), nested]) == symbols([*wide.args, U, *inside])


def test_a_call_has_a_slope_of_none_in_every_leaf_of_its_arguments() -> None:
    wide = _mixed("f", (mul(U, V),))
    for frozen in (True, False):
        keys: dict[Expr, None] = {}
        for arg in wide.args:
            keys.update(dict.fromkeys(slopes(arg, frozen=frozen)))
        found = slopes(wide, frozen=frozen)
        assert list(found.items()) == list(keys.items())
    y = sym("y")
    around = slopes(add(y, function("max", wide, _mixed("g", (mul(U, V),)))))
    assert list(around) == [y, *slopes(wide)]


def test_equations_that_share_arguments_cost_what_these_cost_once() -> None:
    def prepare(size: int) -> Work:
        held = [
            if_then_else(relation_of("gt", U, sym(f"y{k % 9}")), V, mul(U, const(k))) for k in range(size)
        ]
        shared = [call(Named(f"f{k}", size), *held) for k in range(size)]
        return lambda: [unknown_leaves(node) for node in shared]

    assert growth(prepare, 100, 800) < 4


def test_elements_of_arrays_print_as_ranges() -> None:
    a, m = [sym(f"p.a[{k}]") for k in range(1, 31)], [sym(f"m[2,{k}]") for k in range(3, 5)]
    node = call(Named("f", 35), *a, U, pre(V), *m, a[0])
    assert to_text(node) == "f(p.a[1:30], u, pre(v), m[2,3:4], p.a[1])"
    assert [beginning(node, most) for most in (5, 99)] == [to_text(node)[:6], to_text(node)]
    assert to_text(node, quoted_name).startswith("f('p.a[1]', 'p.a[2]', 'p.a[3]'")
