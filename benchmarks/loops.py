"""Networks whose equations hang together: nothing stores between the nodes, or everything moves as one.

Resistors, linear or not, as a ladder or a grid: one system of equations for all of them. Capacitors in a row
with one to ground at every node: a system for the currents, every state in it. Gears and inertias in a row:
one motion, all torques in one system.
"""

from __future__ import annotations

from functools import partial
from math import ceil, sqrt

PARTS = """
  connector Pin
    Real v(unit = "V") "Potential";
    flow Real i(unit = "A") "Current into the component";
  end Pin;

  connector Flange
    Real phi(unit = "rad") "Angle";
    flow Real tau(unit = "N.m") "Torque into the component";
  end Flange;

  model Linear "Resistor"
    Pin p;
    Pin n;
    parameter Real R(unit = "Ohm") = 10;
  equation
    p.v - n.v = R*p.i;
    p.i + n.i = 0;
  end Linear;

  model Nonlinear "Resistor that grows with its current"
    Pin p;
    Pin n;
    parameter Real R(unit = "Ohm") = 10;
    parameter Real K(unit = "V/A3") = 0.1;
    Real u(unit = "V");
  equation
    u = p.v - n.v;
    u = R*p.i + K*p.i^3;
    p.i + n.i = 0;
  end Nonlinear;

  model Capacitor
    Pin p;
    Pin n;
    parameter Real C(unit = "F") = 1e-3;
    Real u(unit = "V", start = 0);
  equation
    u = p.v - n.v;
    C*der(u) = p.i;
    p.i + n.i = 0;
  end Capacitor;

  model Ground
    Pin p;
  equation
    p.v = 0;
  end Ground;

  model Source "Alternating current"
    Pin p;
    parameter Real I(unit = "A") = 1;
    parameter Real w(unit = "rad/s") = 1;
  equation
    p.i = -I*sin(w*time);
  end Source;

  model Inertia
    Flange a;
    Flange b;
    parameter Real J(unit = "kg.m2") = 1;
    Real w(unit = "rad/s");
  equation
    a.phi = b.phi;
    w = der(a.phi);
    J*der(w) = a.tau + b.tau;
  end Inertia;

  model Gear
    Flange a;
    Flange b;
    parameter Real r = 1.01;
  equation
    a.phi = r*b.phi;
    0 = r*a.tau + b.tau;
  end Gear;

  model Drive "Alternating torque"
    Flange f;
    parameter Real T(unit = "N.m") = 1;
    parameter Real w(unit = "rad/s") = 1;
  equation
    f.tau = -T*sin(w*time);
  end Drive;
"""

LADDER = """
    parameter Integer n = {size};
    {element} along[n];
    {across} across[n];
    Ground ground;
    Source source;
  equation
    connect(source.p, along[1].p);
    for i in 1:n loop
      connect(along[i].n, across[i].p);
      connect(across[i].n, ground.p);
    end for;
    for i in 1:n - 1 loop
      connect(along[i].n, along[i + 1].p);
    end for;
"""

GRID = """
    parameter Integer n = {size};
    {element} along[n, n - 1];
    {across} down[n - 1, n];
    Ground ground;
    Source source;
  equation
    connect(source.p, along[1, 1].p);
    connect(along[1, 1].p, down[1, 1].p);
    for i in 2:n - 1 loop
      connect(along[1, i - 1].n, along[1, i].p);
      connect(along[1, i].p, down[1, i].p);
    end for;
    connect(along[1, n - 1].n, down[1, n].p);
    for j in 2:n loop
      connect(down[j - 1, 1].n, along[j, 1].p);
      for i in 2:n - 1 loop
        connect(along[j, i - 1].n, along[j, i].p);
        connect(along[j, i].p, down[j - 1, i].n);
      end for;
      connect(along[j, n - 1].n, down[j - 1, n].n);
      if j < n then
        for i in 1:n - 1 loop
          connect(along[j, i].p, down[j, i].p);
        end for;
        connect(along[j, n - 1].n, down[j, n].p);
      end if;
    end for;
    connect(down[n - 1, n].n, ground.p);
"""

TRAIN = """
    parameter Integer n = {size};
    Inertia body[n];
    Gear gear[n - 1];
    Drive drive;
  equation
    connect(drive.f, body[1].a);
    for i in 1:n - 1 loop
      connect(body[i].b, gear[i].a);
      connect(gear[i].b, body[i + 1].a);
    end for;
"""

SYSTEMS = {
    "ladder of resistors": (LADDER, "Linear", "Linear", 8),
    "ladder of nonlinear resistors": (LADDER, "Nonlinear", "Nonlinear", 10),
    "ladder of capacitors": (LADDER, "Capacitor", "Capacitor", 10),
    "grid of resistors": (GRID, "Linear", "Linear", 8),
    "grid of nonlinear resistors": (GRID, "Nonlinear", "Nonlinear", 10),
    "train of gears": (TRAIN, "", "", 9),
}
"""Shape, elements, and scalar equations for each cell."""


def system_text(name: str, size: int) -> str:
    """`Net.System` with `size` cells in a row, or as many on each side of a grid."""
    shape, element, across, _ = SYSTEMS[name]
    body = shape.format(size=size, element=element, across=across)
    return f"package Net{PARTS}\n  model System{body}  end System;\nend Net;\n"


def of_equations(name: str, equations: int) -> str:
    """The same with about as many scalar equations."""
    cells = max(2, ceil(equations / SYSTEMS[name][3]))
    return system_text(name, max(3, ceil(sqrt(cells))) if SYSTEMS[name][0] is GRID else cells)


LOOPS = {name: partial(of_equations, name) for name in SYSTEMS}
"""Texts by the number of scalar equations."""

WATCHED = {
    "ladder of resistors": "across[1].p.v",
    "ladder of nonlinear resistors": "across[1].p.v",
    "ladder of capacitors": "across[1].u",
    "grid of resistors": "source.p.v",
    "grid of nonlinear resistors": "source.p.v",
    "train of gears": "body[1].w",
}
"""A variable that moves."""
