"""Compiled models linearised: against closed forms and finite differences, at rest and on the way."""

from __future__ import annotations

from math import sqrt

import numpy as np
import pytest

import acausal
from acausal.analysis.linearize import At
from acausal.errors import UsageProblem

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


def test_changing_states_are_refused() -> None:
    text = """model P Real x(start = 1, fixed = true), y, u(fixed = true), v, T; equation
      der(x) = u; der(y) = v; der(u) = -T*x; der(v) = -T*y - 9.81; x^2 + y^2 = 1; end P;"""
    with pytest.raises(UsageProblem, match="choice of states"):
        acausal.loads(text).compile().linearize()


@pytest.mark.parametrize("at", [-1.0, float("nan"), float("inf"), "later"])
def test_what_is_no_instant_is_refused(at: At) -> None:
    with pytest.raises(UsageProblem, match="no instant"):
        acausal.loads(ROTOR).compile().linearize(at)
