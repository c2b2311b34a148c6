"""Discrete equations: which they are, their order, and what makes events."""

from __future__ import annotations

import acausal
from acausal.symbolic.causal import CausalSystem
from acausal.symbolic.discrete import in_order
from acausal.symbolic.expressions.text import to_text


def causal(text: str) -> CausalSystem:
    return acausal.loads(f"model M\n{text}\nend M;\n").compile().causal


def order(system: CausalSystem) -> list[str]:
    return [to_text(unknown) for unknown in system.discrete.unknowns]


def test_discrete_equations_use_what_stands_before_them() -> None:
    system = causal(
        """Integer a, b, c; Real x(start = 0, fixed = true);
        equation c = a + b; b = 2*a; der(x) = c; when x > 1 then a = pre(a) + 1; end when;"""
    )
    assert order(system) == ["a", "b", "c"]
    assert in_order(system.discrete.assignments[::-1])[0].unknown is system.discrete.unknowns[0]


def test_an_equation_between_a_discrete_and_a_continuous_real_is_continuous() -> None:
    system = causal(
        """discrete Real d(start = 0, fixed = true); Real u, x(start = 0, fixed = true);
        equation der(x) = u; u = d; when x > 1 then d = x; end when;"""
    )
    assert order(system) == ["d"]
    assert "u" in {to_text(unknown) for block in system.blocks for unknown in block.unknowns}


def test_known_instants_and_located_crossings() -> None:
    system = causal(
        """parameter Real T = 0.5; discrete Real next(start = 1, fixed = true);
        Real x(start = 0, fixed = true);
        equation der(x) = if 2*time > T then 1 else 2;
        when time >= pre(next) then next = pre(next) + 1; end when;
        when x > sin(time) then reinit(x, 0); end when;"""
    )
    known = {to_text(z.relation): z.instant and to_text(z.instant) for z in system.zero_crossings}
    assert known["x > sin(time)"] is None
    assert known["time >= pre(next)"] == "pre(next)"
    assert "T" in (known["2 * time > T"] or "")


def test_bodies_of_when_clauses_make_no_events() -> None:
    system = causal(
        """Integer n(start = 0, fixed = true); Real x(start = 0, fixed = true);
        equation der(x) = 1; when sample(0, 1) then n = if x > 0.3 then 1 else integer(x); end when;"""
    )
    assert system.zero_crossings == ()
    assert [to_text(node) for node in system.discrete.samples] == ["sample(0, 1)"]


def test_whole_numbers_are_one_function() -> None:
    system = causal("Real a, b, c; equation a = floor(time); b = integer(time); c = mod(time, 1);")
    assert order(system) == ["integer(time)"]
    assert len(system.zero_crossings) == 2
