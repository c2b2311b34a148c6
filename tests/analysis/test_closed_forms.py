"""Eigenvalues of compiled models against closed forms, to 1e-9."""

from __future__ import annotations

from math import sqrt

import numpy as np
from numpy.typing import NDArray

import acausal
from acausal.analysis.snapshot import Snapshot

LADDER = """model Ladder "Sections of a series resistor and inductor and a capacitor to ground, far end open"
  parameter Integer n = 10; parameter Real R = 0.7, L = 2e-3, C = 5e-6;
  Real i[n](each start = 0, each fixed = true), v[n](each start = 0, each fixed = true);
  Real loss[n], across[n], shunt[n];
equation
  for k in 1:n loop
    loss[k] = R*i[k];
    across[k] = (if k == 1 then 0 else v[max(k - 1, 1)]) - v[k] - loss[k];
    L*der(i[k]) = across[k];
    shunt[k] = i[k] - (if k == n then 0 else i[min(k + 1, n)]);
    C*der(v[k]) = shunt[k];
  end for;
end Ladder;"""

PLANETARY = """model Planetary "Sun and carrier on springs to ground, the ring held"
  parameter Real Js = 0.02, Jc = 0.3, ks = 80, kc = 2000, ratio = 2.4 "ring teeth by sun teeth";
  Real sun(start = 0), carrier, ring;
  Real ts, tc, tr, ws, wc;
equation
  sun + ratio*ring = (1 + ratio)*carrier;
  ring = 0;
  ws = der(sun); wc = der(carrier);
  Js*der(ws) = ts - ks*sun;
  Jc*der(wc) = tc - kc*carrier;
  tr = ratio*ts;
  ts + tr + tc = 0;
end Planetary;"""

LINE = """model Line "A line of lumped volumes between a supply and a closed end"
  parameter Integer n = 12;
  parameter Real length(unit = "m") = 3, area(unit = "m2") = 5e-5, rho(unit = "kg/m3") = 850;
  parameter Real beta(unit = "Pa") = 1.4e9, lambda(unit = "Pa.s/m3") = 2e9 "Resistance of the whole line";
  parameter Real V(unit = "m3") = area*length/n, I(unit = "kg/m4") = rho*length/n/area;
  Real p[n](each unit = "Pa", each start = 1e5, each fixed = true, each nominal = 1e5);
  Real q[n](each unit = "m3/s", each start = 0, each fixed = true, each nominal = 1e-4);
equation
  for k in 1:n loop
    I*der(q[k]) = (if k == 1 then 1e5 else p[max(k - 1, 1)]) - p[k] - lambda/n*q[k];
    V/beta*der(p[k]) = q[k] - (if k == n then 0 else q[min(k + 1, n)]);
  end for;
end Line;"""


def held(n: int) -> NDArray[np.float64]:
    """sin of a chain of n that is held at one end: half the natural frequencies over sqrt(c / m)."""
    return np.sin((2 * np.arange(1, n + 1) - 1) * np.pi / (2 * (2 * n + 1)))


def damped(frequencies: NDArray[np.float64], decay: float) -> NDArray[np.complex128]:
    """Roots of s^2 + 2 decay s + frequency^2 = 0, slowest first, pairs with the positive one first."""
    root = np.sqrt(decay**2 - frequencies.astype(np.complex128) ** 2)
    return np.sort_complex(np.concatenate([-decay + root, -decay - root]))


def check(snapshot: Snapshot, exact: NDArray[np.complex128]) -> None:
    found = np.sort_complex(snapshot.eigenvalues.round(6))
    np.testing.assert_allclose(found, np.sort_complex(exact.round(6)), rtol=1e-9, atol=1e-5)
    for value in exact:  # each to 1e-9 of itself, whatever sorting does to rounding
        assert np.abs(snapshot.eigenvalues - value).min() <= 1e-9 * abs(value)


def test_ladder() -> None:
    snapshot = acausal.loads(LADDER).compile().linearize()
    frequencies = 2 / sqrt(2e-3 * 5e-6) * held(10)
    check(snapshot, damped(frequencies, 0.7 / (2 * 2e-3)))
    assert snapshot.is_equilibrium


def test_planetary_gear() -> None:
    snapshot = acausal.loads(PLANETARY).compile().linearize()
    i = 1 + 2.4
    exact = sqrt((80 * i**2 + 2000) / (0.02 * i**2 + 0.3))
    assert len(snapshot.states) == 2
    check(snapshot, damped(np.array([exact]), 0.0))


def test_fluid_line() -> None:
    snapshot = acausal.loads(LINE).compile().linearize()
    n, inertance, capacity = 12, 850 * 3 / 12 / 5e-5, 5e-5 * 3 / 12 / 1.4e9
    check(snapshot, damped(2 / sqrt(inertance * capacity) * held(n), 2e9 / n / (2 * inertance)))
    assert snapshot.modes.modes[0].leading(snapshot.states)[0] in ("q[1]", "p[12]")


def test_parameters_change_without_compiling() -> None:
    compiled = acausal.loads(LADDER).compile()
    one, other = compiled.linearize(parameters={"C": 2e-5}), compiled.linearize()
    check(one, damped(2 / sqrt(2e-3 * 2e-5) * held(10), 175.0))
    check(other, damped(2 / sqrt(2e-3 * 5e-6) * held(10), 175.0))
