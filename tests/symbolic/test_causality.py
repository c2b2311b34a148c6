"""Nothing in a component decides the causality: every mix of sources at two ports gives the same motion.

Two stores with a link between them. Across quantities follow a = 1 + sin(t)/2 and b = cos(t)/3 at the ports;
the through quantities that belong to them are known in closed form. Whichever is prescribed at a port,
the other one must come out.
"""

from __future__ import annotations

from itertools import product
from math import cos, sin

import pytest

import acausal

STORES = {
    # domain: connector, what a store says of its port, how often its across quantity is differentiated
    "hydraulic": ("Real p; flow Real q;", "2 * der(port.p) = port.q;", "p", "q", 1),
    "electrical": ("Real v; flow Real i;", "2 * der(port.v) = port.i;", "v", "i", 1),
    "translational": ("Real s; flow Real f;", "v = der(port.s); 2 * der(v) = port.f;", "s", "f", 2),
}

TEXT = """package Net
  connector Port {connector} end Port;
  model Store
    Port port;
    Real v(start = {speed});
  equation
    {store}
    {idle}
  end Store;
  model Link
    Port a, b;
  equation
    a.{through} = 3 * (a.{across} - b.{across});
    a.{through} + b.{through} = 0;
  end Link;
  model Across
    Port port;
    Real u;
  equation
    port.{across} = u;
  end Across;
  model Through
    Port port;
    Real u;
  equation
    port.{through} = -u;
  end Through;
  model System
    parameter Real T(unit = "s") = 1;
    Real t = time / T;
    Store m(port({across}(start = 1)), v(start = 0.5)), n(port({across}(start = 1 / 3)), v(start = 0));
    Link link;
    {left} left(u = {left_u});
    {right} right(u = {right_u});
  equation
    connect(left.port, m.port);
    connect(m.port, link.a);
    connect(link.b, n.port);
    connect(n.port, right.port);
  end System;
end Net;"""


@pytest.mark.parametrize("domain", STORES)
@pytest.mark.parametrize(("left", "right"), list(product(("Across", "Through"), repeat=2)))
def test_every_mix_of_sources_gives_the_same_motion(domain: str, left: str, right: str) -> None:
    connector, store, across, through, order = STORES[domain]
    a, b = "(1 + sin(t) / 2)", "(cos(t) / 3)"
    slopes = {1: ("cos(t) / 2", "(-sin(t) / 3)"), 2: ("(-sin(t) / 2)", "(-cos(t) / 3)")}[order]
    through_a, through_b = (
        f"2 * {s} + 3 * ({x} - {y})" for s, x, y in ((slopes[0], a, b), (slopes[1], b, a))
    )
    text = TEXT.format(
        connector=connector,
        store=store,
        idle="" if order == 2 else "v = 0;",
        speed=0,
        across=across,
        through=through,
        left=left,
        right=right,
        left_u=a if left == "Across" else through_a,
        right_u=b if right == "Across" else through_b,
    )
    compiled = acausal.loads(text, "Net.System").compile()
    assert len(compiled.states) == order * (left, right).count("Through")
    assert compiled.index == 1 + (order if "Across" in (left, right) else 0)
    result = compiled.simulate(stop_time=2, rtol=1e-9)
    final = result.final([f"left.port.{across}", f"right.port.{across}", f"left.port.{through}"])
    at = 1 + sin(2) / 2, cos(2) / 3
    assert final[f"left.port.{across}"] == pytest.approx(at[0], rel=1e-6)
    assert final[f"right.port.{across}"] == pytest.approx(at[1], rel=1e-6)
    slope = cos(2) / 2 if order == 1 else -sin(2) / 2
    assert final[f"left.port.{through}"] == pytest.approx(-(2 * slope + 3 * (at[0] - at[1])), rel=1e-5)
