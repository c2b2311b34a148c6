"""Compiled models linearised: against closed forms and finite differences, at rest and on the way."""

from __future__ import annotations

from importlib.util import find_spec
from math import sqrt

import numpy as np
import pytest

import acausal
from acausal.analysis.linearize import At
from acausal.errors import SimulationProblem, UsageProblem

CHAIN = """model Chain
  parameter Integer n = 6; parameter Real c = 400, m = 0.5;
  input Real f(start = 0);
  Real s[n], v[n];
  Real pull[n + 1];
equation
  pull[1] = c*s[1];
  for i in 2:n loop pull[i] = c*(s[i] - s[i - 1]); end for;
  pull[n + 1] = f;
  for i in 1:n loop der(s[i]) = v[i]; m*der(v[i]) = pull[i + 1] - pull[i]; end for;
end Chain;"""

ROTOR = """model Rotor "Two inertias on a spring, driven against drag: the angles turn for ever"
  parameter Real J = 2, K = 3, c = 50, d = 0.4, drag = 0.1, tau = 5;
  Real a, b, wa(start = 1), wb;
equation
  der(a) = wa; der(b) = wb;
  J*der(wa) = tau - c*(a - b) - d*(wa - wb);
  K*der(wb) = c*(a - b) + d*(wa - wb) - drag*wb*abs(wb);
end Rotor;"""


def test_chain_has_the_textbook_s_eigenvalues() -> None:
    snapshot = acausal.loads(CHAIN).compile().linearize()
    n, omega = 6, sqrt(400 / 0.5)
    exact = 2 * omega * np.sin((2 * np.arange(1, n + 1) - 1) * np.pi / (2 * (2 * n + 1)))
    np.testing.assert_allclose(snapshot.eigenvalues.imag[::2], exact, rtol=1e-9)
    assert snapshot.B.dims == ("derivative", "input")
    last = snapshot.states.index("v[6]")
    assert snapshot.B.values[:, 0].tolist() == [2.0 if i == last else 0.0 for i in range(12)]
    assert sum(snapshot.modes.modes[0].participation) == pytest.approx(1)


def test_response_at_frequency_zero_is_the_compliance() -> None:
    snapshot = acausal.loads(CHAIN).compile().linearize()
    (gain,) = snapshot.response("s[6]", "f", np.array([0.0]))
    assert gain == pytest.approx(6 / 400)
    with pytest.raises(UsageProblem, match="no input `g`"):
        snapshot.response("s[6]", "g", np.array([0.0]))


def test_steady_state_of_what_turns() -> None:
    snapshot = acausal.loads(ROTOR).compile().linearize("steady")
    values = dict(zip(snapshot.states, snapshot.values.tolist(), strict=True))
    speed = sqrt(5 / 0.1)
    assert values["wb"] == pytest.approx(speed, rel=1e-9)
    assert values["a"] - values["b"] == pytest.approx(5 / 50, rel=1e-9)
    rates = dict(zip(snapshot.states, snapshot.rates.tolist(), strict=True))
    assert rates == pytest.approx({"a": speed, "b": speed, "wa": 0, "wb": 0}, abs=1e-7)
    turning = snapshot.modes.modes[0]
    assert abs(turning.eigenvalue) < 1e-9  # the common angle


def test_an_instant_of_a_run_against_finite_differences() -> None:
    compiled = acausal.loads(ROTOR).compile()
    snapshot = compiled.linearize(0.7)
    assert snapshot.time == pytest.approx(0.7)
    assert "not at rest" in snapshot.warnings[0]
    run = compiled.simulate(stop_time=0.7, rtol=1e-9)
    at_rest = dict(zip(snapshot.states, snapshot.values.tolist(), strict=True))
    assert at_rest["wb"] == pytest.approx(float(run.values("wb")[-1]), rel=1e-4)
    i = snapshot.states.index("wb")
    drag = -2 * 0.1 * abs(at_rest["wb"]) / 3 - 0.4 / 3
    assert snapshot.matrices.a[i, i] == pytest.approx(drag, rel=1e-6)


def test_regulator_at_rest() -> None:
    snapshot = acausal.load("TenSpeed.Examples.MainRegulatorPressure").compile().linearize("steady")
    assert (snapshot.eigenvalues.real < 0).all()
    assert not snapshot.warnings
    limits = snapshot.to_json()["max_step"]
    assert isinstance(limits, dict)
    assert 0 < limits["euler"] < 1e-3


PENDULUM = """model Pendulum "In Cartesian coordinates: its states are chosen anew as it swings"
  parameter Real L = 2, g = 9.81;
  Real x(start = 1.9, fixed = true), y(start = -0.6), u(start = 0, fixed = true), v, T;
equation
  der(x) = u; der(y) = v; der(u) = -T*x; der(v) = -T*y - g; x^2 + y^2 = L^2;
end Pendulum;"""


def test_whatever_states_were_chosen() -> None:
    compiled = acausal.loads(PENDULUM).compile()
    rest = compiled.linearize("steady")
    np.testing.assert_allclose(np.abs(rest.eigenvalues), sqrt(9.81 / 2), rtol=1e-7)
    assert rest.is_equilibrium
    chosen = [snapshot.states for snapshot in compiled.snapshots([0.0, 0.6, 1.2])]
    assert len(frozenset(chosen)) > 1


BALL = """model Ball "A ball on a spring that is there below zero only, with a count of its visits"
  parameter Real c = 900, d = 0.2; Real s(start = 0.5, fixed = true), v(start = 0, fixed = true);
  discrete Integer visits(start = 0, fixed = true);
equation
  der(s) = v;
  der(v) = -9.81 - (if s < 0 then c*s else 0) - d*v;
  when s < 0 then visits = pre(visits) + 1; end when;
end Ball;"""


def test_modes_are_frozen_as_they_are_there() -> None:
    compiled = acausal.loads(BALL).compile()
    free, touching, early = compiled.snapshots([0.1, 0.36, "initial"])
    assert (free.time, touching.time, early.time) == (0.1, 0.36, 0.0)
    assert free.eigenvalues.imag.tolist() == [0, 0]
    assert abs(touching.eigenvalues.imag[0]) == pytest.approx(sqrt(900 - 0.01), rel=1e-9)
    assert [(r.text, r.holds) for r in touching.relations] == [("s < 0", True)]
    single = compiled.linearize(0.36)
    np.testing.assert_allclose(single.values, touching.values, rtol=1e-9)


def test_an_event_is_seen_from_before() -> None:
    compiled = acausal.loads(BALL).compile()
    fall = sqrt(2 * 0.5 / 9.81)
    snapshot = compiled.linearize(0.3)
    (relation,) = snapshot.relations
    assert 0 < relation.seconds < 2 * (fall * 1.02 - 0.3)
    assert snapshot.near_events == (relation,)
    assert any("event is within a step" in text and "s < 0" in text for text in snapshot.warnings)


def test_residual_by_state() -> None:
    snapshot = acausal.loads(ROTOR).compile().linearize()
    residual = dict(zip(snapshot.states, snapshot.residual.tolist(), strict=True))
    assert residual["wa"] == pytest.approx((5 - 0.4) / 2)
    assert residual["a"] == pytest.approx(0.5)  # half of it is the turning of both
    assert snapshot.moving[0] in ("wa", "wb")
    assert not snapshot.is_equilibrium


def test_a_run_that_ends_before_the_instant() -> None:
    text = """model Ends Real x(start = 0, fixed = true); equation der(x) = 1;
      when x > 0.5 then terminate("far enough"); end when; end Ends;"""
    with pytest.raises(SimulationProblem, match="far enough"):
        acausal.loads(text).compile().linearize(0.8)


def test_labels_and_control_theory() -> None:
    snapshot = acausal.loads(CHAIN).compile().linearize()
    assert snapshot.A.dims == ("derivative", "state")
    assert float(snapshot.A[snapshot.states.index("s[1]"), snapshot.states.index("v[1]")]) == 1
    bode = snapshot.bode("s[6]", frequency=[0.0, 1.0])
    assert bode.magnitude[0, 0, 0] == pytest.approx(6 / 400)
    assert dict(bode.to_xarray().sizes) == {"output": 1, "input": 1, "frequency": 2}
    assert snapshot.bode().gain.shape == (12, 1, 400)
    with pytest.raises(UsageProblem, match="has no inputs"):
        acausal.loads(ROTOR).compile().linearize().bode()


def test_python_control() -> None:
    snapshot = acausal.loads(CHAIN).compile().linearize()
    if find_spec("control") is None:
        with pytest.raises(UsageProblem, match="python-control"):
            snapshot.to_control()
        return
    system = snapshot.to_control(["s[6]"])
    assert system.state_labels == list(snapshot.states)
    np.testing.assert_array_equal(system.A, snapshot.matrices.a)
    assert (system.output_labels, system.input_labels) == (["s[6]"], ["f"])


@pytest.mark.parametrize("at", [-1.0, float("nan"), float("inf"), "later", "steady@soon"])
def test_what_is_no_instant_is_refused(at: At) -> None:
    with pytest.raises(UsageProblem, match="no instant"):
        acausal.loads(ROTOR).compile().linearize(at)


def test_steady_state_with_the_sources_of_an_instant() -> None:
    text = """model Driven Real x(start = 0, fixed = true); equation
      der(x) = (if time < 1 then 2 else 6*time) - 3*x; end Driven;"""
    early, late = acausal.loads(text).compile().snapshots(["steady@0.5", "steady@2"])
    assert (early.values[0], late.values[0]) == (pytest.approx(2 / 3), pytest.approx(4))
    assert (late.time, late.at, late.relations[0].holds) == (2.0, "steady", False)


def test_a_root_of_zero_has_no_slope() -> None:
    text = "model Empty Real h(start = 0, fixed = true); equation der(h) = -sqrt(h); end Empty;"
    compiled = acausal.loads(text).compile()
    with pytest.raises(SimulationProblem, match=r"slope of `der\(h\)` with respect to `h` is not finite"):
        compiled.linearize()
    with pytest.raises(SimulationProblem, match="not finite"):
        compiled.variants({}, start={"h": [1.0, 0.0]})


def test_delays_are_told() -> None:
    text = """model Late Real x(start = 1, fixed = true); equation
      der(x) = -delay(x, 0.5) - 0.2*x; end Late;"""
    snapshot = acausal.loads(text).compile().linearize(0.4)
    assert snapshot.eigenvalues[0] == pytest.approx(-0.2)
    assert "delayed values are held" in snapshot.warnings[-1]


def test_what_is_no_instant_and_no_frequency() -> None:
    text = "model M input Real u(start = 1); Real x(start = 0, fixed = true); equation der(x) = u - x; end M;"
    compiled = acausal.loads(text).compile()
    for at in (None, [1.0], "soon", -1.0, float("nan")):
        with pytest.raises(UsageProblem, match="no instant"):
            compiled.linearize(at)  # type: ignore[arg-type]  # wrong on purpose
    for frequency in ([], [-1.0], [float("nan")], [[1.0]]):
        with pytest.raises(UsageProblem, match="frequencies"):
            compiled.linearize().bode("x", "u", frequency)  # type: ignore[arg-type]  # wrong on purpose
