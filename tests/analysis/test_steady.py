"""Steady states that are hard to find, and models that have none."""

from __future__ import annotations

from math import atanh, sqrt

import pytest

import acausal
from acausal.errors import SimulationProblem

RELIEF = """model Relief "A volume that is fed, behind a relief valve that opens on the way"
  parameter Real q = 2, k = 5, crack = 3 "where it opens", leak = 0.1;
  Real p(start = 0, fixed = true); Boolean open = p > crack;
equation
  der(p) = q - leak*p - (if open then k*(p - crack) else 0);
end Relief;"""

LIFT = """model Lift "A spool on a spring that is lifted off its seat, with a stiff stop at both ends"
  parameter Real m = 0.02, c = 4e3, d = 2, F = 12, stop = 1e7, most = 2e-3;
  Real s(start = 0, fixed = true), v(start = 0, fixed = true);
equation
  der(s) = v;
  m*der(v) = F - c*s - d*v - noEvent(if s < 0 then stop*s elseif s > most then stop*(s - most) else 0);
end Lift;"""


def state(text: str, name: str) -> float:
    snapshot = acausal.loads(text).compile().linearize("steady")
    assert snapshot.is_equilibrium
    return float(snapshot.values[snapshot.states.index(name)])


def test_a_valve_opens_on_the_way() -> None:
    assert state(RELIEF, "p") == pytest.approx((2 + 5 * 3) / 5.1, rel=1e-9)
    snapshot = acausal.loads(RELIEF).compile().linearize("steady")
    assert snapshot.relations[0].holds
    assert snapshot.eigenvalues[0] == pytest.approx(-5.1)


def test_against_a_stop() -> None:
    assert state(LIFT, "s") == pytest.approx((12 + 1e7 * 2e-3) / (1e7 + 4e3), rel=1e-9)


def test_square_roots_and_far_away_starts() -> None:
    text = """model Tanks Real h1(start = 0.01, fixed = true), h2(start = 4, fixed = true);
      parameter Real q = 1e-3; equation
      der(h1) = q - 5e-4*sqrt(h1); der(h2) = 5e-4*sqrt(h1) - 2e-4*sqrt(h2); end Tanks;"""
    assert state(text, "h1") == pytest.approx(4, rel=1e-8)
    assert state(text, "h2") == pytest.approx(25, rel=1e-8)


def test_a_dry_brake_holds() -> None:
    text = """model Held "Coulomb friction over a narrow range of speeds"
      Real phi(start = 0, fixed = true), w(start = 30, fixed = true);
      equation der(phi) = w; der(w) = 3 - 8*tanh(w/1e-3) ; end Held;"""
    assert state(text, "w") == pytest.approx(1e-3 * atanh(3 / 8), rel=1e-9)


def test_what_is_fed_and_not_drained() -> None:
    text = """model Fed Real p1(unit = "Pa", start = 1), p2(unit = "Pa", start = 2); equation
      der(p1) = 1 - 3*(p1 - p2); der(p2) = 3*(p1 - p2); end Fed;"""
    with pytest.raises(SimulationProblem, match="nothing acts back on `p1`, `p2`") as caught:
        acausal.loads(text).compile().linearize("steady")
    assert caught.value.diagnostics[0].code == "steady.none"
    assert set(caught.value.diagnostics[0].names) == {"p1", "p2"}


def test_a_body_that_is_pushed_for_ever() -> None:
    text = (
        """model Pushed Real s(unit = "m"), v(unit = "m/s"); equation der(s) = v; der(v) = 2; end Pushed;"""
    )
    with pytest.raises(SimulationProblem, match="nothing acts back on `v`"):
        acausal.loads(text).compile().linearize("steady")


def test_a_relay_that_never_rests() -> None:
    text = """model Relay Real T(start = 15, fixed = true); discrete Boolean on(start = true, fixed = true);
      equation der(T) = (if on then 30 else 0) - 0.5*T;
      when {T > 22, T < 18} then on = T < 18; end when; end Relay;"""
    with pytest.raises(SimulationProblem, match="modes changed"):
        acausal.loads(text).compile().linearize("steady")


def test_a_tank_at_its_own_speed_is_no_rest() -> None:
    text = """model Fills Real h(start = 1); equation der(h) = 0.1; end Fills;"""
    assert acausal.loads(text).compile().linearize().moving == ("h",)


def test_a_shaft_that_is_driven_turns() -> None:
    text = """model Turns Real phi(unit = "rad"), w(unit = "rad/s"); parameter Real tau = 4, d = 0.5;
      equation der(phi) = w; 2*der(w) = tau - d*w*abs(w); end Turns;"""
    snapshot = acausal.loads(text).compile().linearize("steady")
    assert snapshot.is_equilibrium
    assert snapshot.rates[snapshot.states.index("phi")] == pytest.approx(sqrt(8))
