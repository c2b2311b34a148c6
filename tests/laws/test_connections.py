"""Laws of connections (Modelica 3.6, 9.2), on random trees of components with arrays of connectors."""

from __future__ import annotations

from collections import Counter

from hypothesis import given, settings

from acausal.lang.flat import FlatModel, Origin
from acausal.lang.verify import verify
from acausal.symbolic.expressions.expr import Expr
from tests.language.models import flat_model
from tests.laws.connector_trees import PREAMBLE, Group, groups

_BALANCES = (Origin.FLOW_BALANCE, Origin.UNCONNECTED)


def flatten(network: Group) -> FlatModel:
    return flat_model(PREAMBLE + network.text("Test"))


def components(pairs: list[tuple[str, str]], nodes: list[str]) -> list[set[str]]:
    """The connected components of a graph, by merging sets."""
    sets = {node: {node} for node in nodes}
    for a, b in pairs:
        if sets[a] is not sets[b]:
            sets[a] |= sets[b]
            for node in sets[b]:
                sets[node] = sets[a]
    unique = {id(s): s for s in sets.values()}
    return sorted(unique.values(), key=min)


def signs(flat: FlatModel) -> Counter[tuple[str, int]]:
    """How often each flow variable occurs in a balance, with each sign."""
    found: Counter[tuple[str, int]] = Counter()
    for equation in flat.equations:
        if equation.origin not in _BALANCES:
            continue
        assert equation.right.value == 0
        terms = equation.left.args if equation.left.op == "add" else (equation.left,)
        for term in terms:
            found[_signed(term)] += 1
    return found


def _signed(term: Expr) -> tuple[str, int]:
    return (term.args[0].name, -1) if term.op == "neg" else (term.name, 1)


@given(groups())
@settings(max_examples=60)
def test_equations_are_as_many_as_unknowns(network: Group) -> None:
    flat = flatten(network)
    verify(flat)
    assert len(flat.equations) == len(flat.unknowns)


@given(groups())
@settings(max_examples=60)
def test_each_flow_is_balanced_once_on_each_side(network: Group) -> None:
    found = signs(flatten(network))
    for pin in network.all_pins():
        is_own = ".p[" not in pin
        assert found[f"{pin}.i", 1] == 1
        assert found[f"{pin}.i", -1] == int(is_own)


@given(groups())
@settings(max_examples=60)
def test_potentials_of_a_set_are_equal_and_of_no_others(network: Group) -> None:
    flat = flatten(network)
    pins = network.all_pins()
    equal = [
        (e.left.name.removesuffix(".v"), e.right.name.removesuffix(".v"))
        for e in flat.equations
        if e.origin is Origin.CONNECTION
    ]
    assert components(equal, pins) == components(network.all_connections(), pins)
