"""Dry friction with a path parameter: discrete and continuous unknowns in one loop.

Otter, Elmqvist and Mattsson, "Hybrid modeling in Modelica based on the synchronous data flow principle",
CACSD 1999, describe the element; the closed forms are elementary.
"""

from __future__ import annotations

import numpy as np
import pytest

import acausal
from acausal.simulate.result import Result

LIBRARY = """
package P
  partial model Rub "sticks, or slides either way"
    parameter Real slide = 1, hold = 1;
    Real v, a, f, s, grip;
    Boolean off, up(start = false), down(start = false), stuck(start = false);
    Integer way(start = 3, fixed = true) "1 up, -1 down, 0 stuck, 2 off, 3 not known yet";
  equation
    up = pre(way) == 0 and (s > hold*grip or pre(up) and s > slide*grip)
      or pre(way) == -1 and v > 1e-10 or initial() and v > 0;
    down = pre(way) == 0 and (s < -hold*grip or pre(down) and s < -slide*grip)
      or pre(way) == 1 and v < -1e-10 or initial() and v < 0;
    stuck = not off and not (pre(way) == 1 or up or pre(way) == -1 or down);
    a = if stuck then 0 else if off then s else if up then s - hold*grip else if down then s + hold*grip
      else if pre(way) == 1 then s - slide*grip else s + slide*grip;
    f = if stuck then s else if off then 0 else if up then hold*grip else if down then -hold*grip
      else if pre(way) == 1 then slide*grip else -slide*grip;
    way = if off then 2 else if (pre(way) == 1 or pre(way) == 2 or up) and v > 0 then 1
      else if (pre(way) == -1 or pre(way) == 2 or down) and v < 0 then -1 else 0;
  end Rub;

  model Clutch
    extends Rub;
    input Real left, right, force;
  equation
    v = left - right;
    a = der(v);
    grip = force;
    off = force <= 0;
  end Clutch;

  model One
    Clutch k;
    Real w1(start = 10, fixed = true), w2(start = 0, fixed = true);
  equation
    k.left = w1;
    k.right = w2;
    k.force = if time < 1 then 0 else 2;
    der(w1) = -k.f;
    2*der(w2) = k.f;
  end One;

  model Belt "a mass between a spring and a belt that moves"
    extends Rub(slide = 1, hold = 1.5);
    Real x(start = 0.05, fixed = true), u(start = 0, fixed = true);
  equation
    der(x) = u;
    der(u) = -10*x - f;
    v = u - 0.1;
    a = der(v);
    grip = 1;
    off = false;
  end Belt;

  model Train "clutches between masses in a row, engaged one after the other"
    parameter Integer n = 10;
    Clutch k[n](each slide = 1, each hold = 1.25);
    Real w[n + 1](start = linspace(10, 0, n + 1), each fixed = true);
    Real push = 4*sin(3*time);
  equation
    for i in 1:n loop
      k[i].left = w[i];
      k[i].right = w[i + 1];
      k[i].force = if time < 0.1*i then 0 else 3;
    end for;
    der(w[1]) = push - k[1].f;
    for i in 2:n loop
      der(w[i]) = k[i - 1].f - k[i].f;
    end for;
    der(w[n + 1]) = k[n].f;
  end Train;
end P;
"""


def run(name: str, stop: float, rtol: float | None = None, interval: float | None = None) -> Result:
    return (
        acausal.loads(LIBRARY, f"P.{name}").compile().simulate(stop_time=stop, rtol=rtol, interval=interval)
    )


@pytest.mark.parametrize("solver", ["rodas", "cvode"])
def test_a_clutch_slips_and_sticks(solver: str) -> None:
    compiled = acausal.loads(LIBRARY, "P.One").compile()
    result = compiled.simulate(stop_time=6.0, solver=solver)
    stick = 1 + 10 / 3
    t, w1 = result.time, result.values("w1")
    assert w1[t < 1] == pytest.approx(10.0)
    slipping = (t > 1) & (t < stick)
    assert w1[slipping] == pytest.approx(10 - 2 * (t[slipping] - 1), rel=1e-6)
    assert w1[t > stick] == pytest.approx(10 / 3, rel=1e-6)
    assert result.values("k.way")[-1] == 0
    assert result.values("k.f")[-1] == pytest.approx(0.0, abs=1e-9)


def test_stick_slip_has_its_period() -> None:
    result = run("Belt", 12.0, rtol=1e-8)
    way, time = result.values("way"), result.time
    starts = time[1:][(way[1:] == 0) & (way[:-1] != 0)]
    omega = np.sqrt(10.0)
    angle = np.arctan2(0.1 / omega, 0.05)
    period = 1.0 + (np.pi + 2 * angle) / omega
    assert len(starts) >= 4
    assert np.diff(starts[1:]) == pytest.approx(period, rel=1e-5)
    assert result.values("x").max() == pytest.approx(0.1 + np.hypot(0.05, 0.1 / omega), rel=1e-4)


def test_ten_clutches_in_a_row_keep_momentum() -> None:
    result = run("Train", 4.0, rtol=1e-8)
    w = np.array([result.values(f"w[{i}]") for i in range(1, 12)])
    given = 55 + 4 / 3 * (1 - np.cos(3 * result.time))
    assert w.sum(axis=0) == pytest.approx(given, rel=1e-6)
    stuck = np.array([result.values(f"k[{i}].stuck") for i in range(1, 11)])
    assert stuck.any()
    assert np.abs(w[:-1] - w[1:])[stuck == 1].max() < 1e-6
    gap, f = w[:-1] - w[1:], np.array([result.values(f"k[{i}].f") for i in range(1, 11)])
    assert (f * gap >= -1e-9).all()  # friction never drives


def test_the_listing_shows_the_loop_in_order() -> None:
    from acausal.symbolic.causal_text import print_causal

    text = print_causal(acausal.loads(LIBRARY, "P.One").compile().causal)
    assert "discrete system, at events" in text
    assert text.index("k.up :=") < text.index("k.stuck :=")
    assert "remembered: " in text
