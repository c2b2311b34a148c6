"""Constraints between states that only a sum of equations shows: cut-sets of bridges that float."""

from __future__ import annotations

import numpy as np
import pytest

import acausal
from acausal.api import CompiledModel

LIBRARY = """
package P
  connector Pin
    Real v;
    flow Real i;
  end Pin;

  partial model Branch
    Pin p, n;
    Real v, i;
  equation
    v = p.v - n.v;
    i = p.i;
    p.i + n.i = 0;
  end Branch;

  model Diode
    extends Branch;
    Real s(start = 0);
    Boolean off(start = true);
  equation
    off = s < 0;
    v = s*(if off then 1 else 1e-5);
    i = s*(if off then 1e-5 else 1);
  end Diode;

  model Inductor
    extends Branch;
  equation
    v = 1e-3*der(i);
  end Inductor;

  model Resistor
    extends Branch;
    parameter Real R = 10;
  equation
    v = R*i;
  end Resistor;

  model Capacitor
    extends Branch(v(start = 0, fixed = true));
  equation
    i = 1e-3*der(v);
  end Capacitor;

  model Source
    extends Branch;
    parameter Real phase = 0;
  equation
    v = 100*sin(100*3.14159265358979*time - phase);
  end Source;

  model Ground
    Pin p;
  equation
    p.v = 0;
  end Ground;

  model Bridge "three inductors feed a direct-current side without a ground"
    Source source[3](phase = {0, 2.0943951023932, 4.1887902047864});
    Inductor choke[3];
    Diode up[3], down[3];
    Capacitor c;
    Resistor load;
    Ground ground;
  equation
    for k in 1:3 loop
      connect(source[k].n, ground.p);
      connect(source[k].p, choke[k].p);
      connect(choke[k].n, up[k].p);
      connect(choke[k].n, down[k].n);
      connect(up[k].n, c.p);
      connect(down[k].p, c.n);
    end for;
    connect(c.p, load.p);
    connect(c.n, load.n);
  end Bridge;

  model Triangle "capacitors in a triangle that resistors hold"
    Capacitor c[3];
    Resistor r[3](R = {1, 2, 3});
    Source source;
    Ground ground;
  equation
    connect(c[1].n, c[2].p);
    connect(c[2].n, c[3].p);
    connect(c[3].n, c[1].p);
    connect(r[1].p, c[1].p);
    connect(r[2].p, c[2].p);
    connect(r[3].p, c[3].p);
    connect(r[1].n, source.p);
    connect(r[2].n, ground.p);
    connect(r[3].n, ground.p);
    connect(source.n, ground.p);
  end Triangle;
end P;
"""


@pytest.fixture(scope="module")
def bridge() -> CompiledModel:
    return acausal.loads(LIBRARY, "P.Bridge").compile()


def test_the_currents_into_a_floating_bridge_are_no_three_states(bridge: CompiledModel) -> None:
    states = bridge.code.system.states
    assert "c.v" in states
    assert len([name for name in states if name.startswith("choke")]) == 2
    assert len(states) == 3


def test_the_bridge_charges_its_capacitor(bridge: CompiledModel) -> None:
    """The mean of the largest voltage difference, 3/pi * sqrt(3) * 100 V, less what commutation takes.

    Commutation takes 3 omega L I / pi of it, with I = u / 10 Ohm.
    """
    result = bridge.simulate(stop_time=0.2)
    total = sum(result.values(f"choke[{k}].i") for k in (1, 2, 3))
    assert np.abs(total).max() < 1e-9
    late = result.time > 0.16
    expected = 3 / np.pi * np.sqrt(3) * 100 / (1 + 3 * 100 * np.pi * 1e-3 / np.pi / 10)
    assert result.values("c.v")[late].mean() == pytest.approx(expected, rel=0.01)


def test_a_triangle_of_capacitors_has_two_states() -> None:
    compiled = acausal.loads(LIBRARY, "P.Triangle").compile()
    assert len(compiled.code.system.states) == 2
    result = compiled.simulate(stop_time=0.02)
    total = sum(result.values(f"c[{k}].v") for k in (1, 2, 3))
    assert np.abs(total).max() < 1e-9
