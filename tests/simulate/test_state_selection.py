"""Dynamic state selection: motions that no single choice of states can follow."""

from __future__ import annotations

import math

import numpy as np
import pytest

import acausal
from acausal.api import CompiledModel
from acausal.errors import ReductionProblem, SimulationProblem
from acausal.simulate import reselect
from acausal.simulate.result import Result

G, L, M = 9.81, 1.5, 2.0


def pendulum(declarations: str) -> CompiledModel:
    return acausal.loads(
        f"""
        model Pendulum
          parameter Real L = {L};
          {declarations};
          Real lambda, E;
        equation
          der(x) = vx; der(y) = vy;
          {M}*der(vx) = -lambda*x;
          {M}*der(vy) = -lambda*y - {M}*{G};
          x^2 + y^2 = L^2;
          E = {M}/2*(vx^2 + vy^2) + {M}*{G}*y;
        end Pendulum;
        """
    ).compile()


def drift(run: Result, name: str = "E") -> float:
    return float(np.ptp(run.values(name)))


@pytest.mark.parametrize(
    ("declarations", "angle", "speed"),
    [
        (f"Real x(start = {L}, fixed = true), y, vx, vy", math.pi / 2, 0.0),
        ("Real x(start = 0, fixed = true), vx(start = 9, fixed = true), y(start = -1.5), vy", 0.0, 6.0),
    ],
)
@pytest.mark.parametrize("rtol", [1e-6, 1e-9])
def test_the_pendulum_swings_through_every_quadrant(
    declarations: str, angle: float, speed: float, rtol: float
) -> None:
    """Twenty swings: the energy drifts like that of the equation in the angle, the length is exact."""
    compiled = pendulum(declarations)
    run = compiled.simulate(stop_time=58.0, rtol=rtol)
    minimal = acausal.loads(
        f"""
        model Angle
          Real phi(start = {angle}, fixed = true), w(start = {speed}, fixed = true), E;
        equation
          der(phi) = w; {L}*der(w) = -{G}*sin(phi);
          E = {M}*({L}^2/2*w^2 - {G * L}*cos(phi));
        end Angle;
        """
    ).compile()
    assert drift(run) < 30 * drift(minimal.simulate(stop_time=58.0, rtol=rtol))
    x, y = run.values("x"), run.values("y")
    assert np.max(np.abs(x**2 + y**2 - L**2)) < 1e-9
    assert np.max(np.abs(x * run.values("vx") + y * run.values("vy"))) < 1e-9
    assert np.min(x) < -1.45 < 1.45 < np.max(x)
    assert bool(np.max(y) > 1.45) is (speed > 0)
    assert run.statistics.state_selections > 40
    assert run.statistics.events == 0
    assert len(compiled.states) == len(run.system.states) == 2


def test_the_period_is_that_of_the_closed_form() -> None:
    """From the horizontal at rest: T = 4 sqrt(L/g) K(sin(pi/4)), whole periods end where they began."""
    half = 1.8540746773013719
    period = 4 * math.sqrt(L / G) * half
    run = pendulum(f"Real x(start = {L}, fixed = true), y, vx, vy").simulate(stop_time=5 * period, rtol=1e-9)
    assert run.final(["x", "y", "vx"]) == pytest.approx({"x": L, "y": 0.0, "vx": 0.0}, abs=1e-4)


def test_a_coarse_output_grid_does_not_hide_a_bad_choice() -> None:
    run = pendulum(f"Real x(start = {L}, fixed = true), y, vx, vy").simulate(stop_time=60.0, interval=20.0)
    assert drift(run) < 0.1
    assert run.statistics.state_selections > 40


@pytest.mark.parametrize("select", ["prefer", "always", "avoid", "never"])
def test_a_wish_for_states_decides_at_the_start_only(select: str) -> None:
    """With `always` there is nothing else to choose: the run goes on as long as the choice can be solved.

    With `never` it ends where nothing else can be the state.
    """
    states = f"Real x(start = 1, stateSelect = StateSelect.{select}), vx(start = 2), y(start = -1.1), vy"
    compiled = pendulum(states)
    expected = ("x", "vx") if select in ("prefer", "always") else ("y", "vy")
    assert set(compiled.states) == set(expected)
    run = compiled.simulate(stop_time=0.2, rtol=1e-8)
    assert drift(run) < 1e-3
    if select == "never":
        with pytest.raises(ReductionProblem, match=r"nothing else can be the state"):
            compiled.simulate(stop_time=10.0, rtol=1e-8)
    elif select != "always":
        assert drift(compiled.simulate(stop_time=10.0, rtol=1e-8)) < 1e-3


def test_values_of_all_names_go_on_when_states_change_roles() -> None:
    run = pendulum(f"Real x(start = {L}, fixed = true), y, vx, vy").simulate(stop_time=3.0, rtol=1e-8)
    for name, other in (("x", "vx"), ("y", "vy"), ("der(x)", "vx"), ("der(y)", "vy")):
        assert np.isfinite(run.values(name)).all()
        slope = np.gradient(run.values(name), run.time) if not name.startswith("der") else run.values(name)
        assert np.max(np.abs(slope - run.values(other))[1:-1]) < 1e-2
    assert list(run.system.states) == ["y", "vy"]


DOUBLE = """
model Double
  Real x1(start = 1), y1(start = 0), x2(start = 1.5), y2(start = 0.2), f1, f2, E;
equation
  der(der(x1)) = -f1*x1 - f2*(x1 - x2);
  der(der(y1)) = -f1*y1 - f2*(y1 - y2) - 9.81;
  der(der(x2)) = -f2*(x2 - x1);
  der(der(y2)) = -f2*(y2 - y1) - 9.81;
  x1^2 + y1^2 = 1;
  (x2 - x1)^2 + (y2 - y1)^2 = 1;
  E = 0.5*(der(x1)^2 + der(y1)^2 + der(x2)^2 + der(y2)^2) + 9.81*(y1 + y2);
end Double;
"""


def test_double_pendulum() -> None:
    """Two constraints, four possible choices, states that are derivatives."""
    compiled = acausal.loads(DOUBLE).compile()
    assert (compiled.index, len(compiled.states)) == (3, 4)
    run = compiled.simulate(stop_time=10.0, rtol=1e-9)
    assert drift(run) < 1e-4
    x1, y1, x2, y2 = (run.values(name) for name in ("x1", "y1", "x2", "y2"))
    assert np.max(np.abs(x1**2 + y1**2 - 1)) < 1e-9
    assert np.max(np.abs((x2 - x1) ** 2 + (y2 - y1) ** 2 - 1)) < 1e-9
    assert run.statistics.state_selections > 10
    angle = acausal.loads(ANGLES).compile().simulate(stop_time=2.0, rtol=1e-10)
    found = compiled.simulate(stop_time=2.0, rtol=1e-10)
    assert found.final(["x1", "y1", "x2", "y2"]) == pytest.approx(
        angle.final(["x1", "y1", "x2", "y2"]), abs=1e-6
    )


ANGLES = """
model Angles "The same in minimal coordinates: angles from the x axis, Lagrange's equations"
  Real a(start = 0, fixed = true), b(start = asin(0.2), fixed = true);
  Real u(start = 0, fixed = true), v(start = 0, fixed = true), x1, y1, x2, y2;
equation
  der(a) = u; der(b) = v;
  2*der(u) + cos(a - b)*der(v) + sin(a - b)*v^2 + 2*9.81*cos(a) = 0;
  cos(a - b)*der(u) + der(v) - sin(a - b)*u^2 + 9.81*cos(b) = 0;
  x1 = cos(a); y1 = sin(a); x2 = x1 + cos(b); y2 = y1 + sin(b);
end Angles;
"""


def test_bead_on_a_closed_curve_keeps_its_energy() -> None:
    run = acausal.loads(
        """
        model Bead
          Real x(start = 1), y(start = 0.1), vx, vy(start = 2), f, E;
        equation
          der(x) = vx; der(y) = vy;
          der(vx) = -f*2*x*(1 + y^2); der(vy) = -f*(8*y + 2*y*x^2);
          x^2*(1 + y^2) + 4*y^2 = 1;
          E = 0.5*(vx^2 + vy^2);
        end Bead;
        """
    ).compile()
    found = run.simulate(stop_time=10.0, rtol=1e-9)
    assert drift(found) < 1e-5 * found.values("E")[0]
    assert np.min(found.values("x")) < -0.95


def test_a_choice_valid_everywhere_is_never_changed() -> None:
    """A crank: the piston follows from the angle everywhere, so nothing is watched."""
    compiled = acausal.loads(
        """
        model Crank
          Real phi(start = 0.3), w(start = 6), s, v, f;
        equation
          der(phi) = w; der(s) = v;
          0.1*der(w) = -0.5*cos(phi)*f; der(v) = f;
          s = 0.5*sin(phi);
        end Crank;
        """
    ).compile()
    assert compiled.causal.dynamic is None
    assert compiled.states == ("phi", "w")
    wished = acausal.loads(
        """
        model Crank
          Real phi(start = 0.3), w(start = 6), s(stateSelect = StateSelect.prefer), v(start = 3), f, E;
        equation
          der(phi) = w; der(s) = v;
          0.1*der(w) = -0.5*cos(phi)*f; der(v) = f;
          s = 0.5*sin(phi);
          E = 0.05*w^2 + 0.5*v^2;
        end Crank;
        """
    ).compile()
    assert set(wished.states) == {"s", "v"}
    run = wished.simulate(stop_time=3.0, rtol=1e-8)
    assert run.statistics.state_selections == 1
    assert drift(run) < 1e-4


def test_events_and_choices_of_states_share_a_run() -> None:
    """A wind that blows only on the right half: events where x changes sign, besides the choices."""
    compiled = acausal.loads(
        f"""
        model Wind
          Real x(start = {L}, fixed = true), y, vx, vy, lambda, W(start = 0, fixed = true), E;
        equation
          der(x) = vx; der(y) = vy;
          der(vx) = -lambda*x + (if x > 0.2 then -1 else 0);
          der(vy) = -lambda*y - {G};
          x^2 + y^2 = {L}^2;
          der(W) = if x > 0.2 then -vx else 0;
          E = 0.5*(vx^2 + vy^2) + {G}*y - W;
        end Wind;
        """
    ).compile()
    assert len(compiled.causal.events) == 1 < len(compiled.causal.zero_crossings)
    run = compiled.simulate(stop_time=10.0, rtol=1e-9)
    assert drift(run) < 1e-4
    assert run.statistics.events >= 6
    assert run.statistics.state_selections >= 10


def test_choices_that_accumulate_are_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reselect, "MOST_CHOICES", 3)
    monkeypatch.setattr(reselect, "SHARE", 0.5)
    with pytest.raises(SimulationProblem) as caught:
        pendulum(f"Real x(start = {L}, fixed = true), y, vx, vy").simulate(stop_time=10.0)
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.code == "simulate.state-selection"
    assert {"x", "y"} <= set(diagnostic.names)
    assert diagnostic.span is not None
    assert "x ^ 2 + y ^ 2 = L ^ 2" in diagnostic.message


def test_parameters_changed_at_run_time_hold_after_a_new_choice() -> None:
    compiled = pendulum("Real x(start = 1.5), y(start = -0.1), vx, vy")
    run = compiled.simulate(stop_time=10.0, rtol=1e-8, parameters={"L": 2.5})
    assert run.statistics.state_selections > 5
    assert np.max(np.abs(np.hypot(run.values("x"), run.values("y")) - 2.5)) < 1e-9
