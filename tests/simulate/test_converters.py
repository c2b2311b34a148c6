"""Power converters of ideal diodes and thyristors: many switches in one loop, several at the same instant.

The characteristic with a path parameter is that of Otter, Elmqvist and Mattsson, "Hybrid modeling in Modelica
based on the synchronous data flow principle", CACSD 1999. The expected values are elementary.
"""

from __future__ import annotations

import numpy as np
import pytest

import acausal
from acausal.simulate.result import Result

LIBRARY = """
package P
  partial model Switch "conducts while s > 0, blocks while s < 0"
    input Real v;
    Real i, s(start = 0);
    Boolean off(start = true);
  equation
    v = s*(if off then 1 else 1e-5);
    i = s*(if off then 1e-5 else 1);
  end Switch;

  model Diode
    extends Switch;
  equation
    off = s < 0;
  end Diode;

  model Thyristor
    extends Switch;
    input Boolean fire;
  equation
    off = s < 0 or pre(off) and not fire;
  end Thyristor;

  model Transistor
    extends Switch;
    input Boolean fire;
  equation
    off = s < 0 or not fire;
  end Transistor;
"""
STAR = """
  model Star "bridge of many phases; by symmetry its upper and its lower half commutate at the same instant"
    constant Integer m = {m};
    Diode up[m], down[m];
    Real v[m], top, bottom, i(start = 0, fixed = true);
  equation
    for k in 1:m loop
      v[k] = 100*sin(2*3.14159265358979*(2*time + k/m)) + (if time > 0.5 then 50*cos(7.0*k) else 0);
      up[k].v = v[k] - top;
      down[k].v = bottom - v[k];
    end for;
    sum(up.i) = i;
    sum(down.i) = i;
    0.01*der(i) = top - bottom - 10*i;
  end Star;
"""
BRIDGE = """
  model Bridge "thyristors that commutate short-circuit the source, as the current goes on"
    Thyristor p1, p2, n1, n2;
    Real u = 100*sin(100*3.14159265358979*time), a, b, top, bottom, i(start = 0, fixed = true);
    Boolean first = sin(100*3.14159265358979*(time - 1e-3)) > 0;
  equation
    a - b = u;
    a + b = 0;
    p1.v = a - top;
    p2.v = b - top;
    n1.v = bottom - a;
    n2.v = bottom - b;
    p1.fire = first;
    n2.fire = first;
    p2.fire = not first;
    n1.fire = not first;
    p1.i + p2.i = i;
    n1.i + n2.i = i;
    0.1*der(i) = top - bottom - 2*i - 20;
  end Bridge;
"""
LEG = """
  model Leg "one leg of an inverter with free-wheeling diodes"
    Transistor upper, lower;
    Diode back_up, back_down;
    Real out, i(start = 0, fixed = true);
  equation
    upper.v = 50 - out;
    back_up.v = out - 50;
    lower.v = out + 50;
    back_down.v = -50 - out;
    upper.fire = sin(200*3.14159265358979*time) > 0;
    lower.fire = not upper.fire;
    upper.i + back_down.i - lower.i - back_up.i = i;
    0.01*der(i) = out - 5*i;
  end Leg;
"""


def run(model: str, stop: float) -> Result:
    name = model.split()[1]
    compiled = acausal.loads(f"{LIBRARY}{model}end P;", f"P.{name}").compile()
    return compiled.simulate(stop_time=stop, interval=stop / 400)


@pytest.mark.parametrize("m", [3, 12])
def test_bridge_of_many_phases_gives_the_largest_difference(m: int) -> None:
    result = run(STAR.format(m=m), 1.0)
    time, k = result.time, np.arange(1, m + 1)[:, None]
    jump = np.where(time > 0.5, 50 * np.cos(7.0 * k), 0.0)
    v = 100 * np.sin(2 * np.pi * (2 * time + k / m)) + jump
    found = result.values("top") - result.values("bottom")
    apart = time != 0.5
    assert found[apart] == pytest.approx((v.max(axis=0) - v.min(axis=0))[apart], abs=2e-3)


def test_thyristors_that_commutate() -> None:
    """Once it flows, the current goes on, and the voltage has the sign of the pair that conducts."""
    result = run(BRIDGE, 0.1)
    time, i = result.time, result.values("i")
    late = (time > 0.07) & (np.abs(np.sin(100 * np.pi * (time - 1e-3))) > 0.02)
    assert i[time > 0.07].min() > 1
    sign = np.sign(np.sin(100 * np.pi * (time - 1e-3)))
    voltage = result.values("top") - result.values("bottom")
    fired = (sign * 100 * np.sin(100 * np.pi * time))[late]
    assert voltage[late] == pytest.approx(fired, abs=5e-3)


def test_free_wheeling_diodes() -> None:
    """The output follows the transistors, whichever way the current goes."""
    result = run(LEG, 0.04)
    phase = np.sin(200 * np.pi * result.time)
    clear = np.abs(phase) > 1e-6
    assert result.values("out")[clear] == pytest.approx(50 * np.sign(phase[clear]), abs=2e-3)
    i = result.values("i")
    assert i.min() < -2
    assert i.max() > 2
