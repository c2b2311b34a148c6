"""Models of any size for the benchmarks, as Modelica text that every compared tool reads."""

from __future__ import annotations


def equation_chain(cells: int) -> str:
    """Masses, springs and dampers in a chain, as equations on arrays: 3 `cells` + 1 scalar equations."""
    return f"""
model Chain "Masses between springs and dampers, pulled at the end"
  parameter Integer n = {cells};
  parameter Real m = 1 "Mass";
  parameter Real c = 100 "Stiffness";
  parameter Real d = 1 "Damping";
  Real s[n](each start = 0, each fixed = true) "Position";
  Real v[n](each start = 0, each fixed = true) "Speed";
  Real f[n + 1] "Force in front of each mass";
equation
  f[1] = c*s[1] + d*v[1];
  for i in 2:n loop
    f[i] = c*(s[i] - s[i - 1]) + d*(v[i] - v[i - 1]);
  end for;
  f[n + 1] = 1;
  for i in 1:n loop
    der(s[i]) = v[i];
    m*der(v[i]) = f[i + 1] - f[i];
  end for;
end Chain;
"""


def component_chain(cells: int) -> str:
    """The same chain from components and connectors: 14 scalar equations a cell, most of them aliases."""
    return f"""
package Parts
  connector Flange
    Real s;
    flow Real f;
  end Flange;

  model Mass
    Flange a;
    Flange b;
    parameter Real m = 1;
    Real s(start = 0);
    Real v(start = 0);
  equation
    a.s = s;
    b.s = s;
    der(s) = v;
    m*der(v) = a.f + b.f;
  end Mass;

  model SpringDamper
    Flange a;
    Flange b;
    parameter Real c = 100;
    parameter Real d = 1;
    Real ds;
    Real f;
  equation
    ds = b.s - a.s;
    f = c*ds + d*der(ds);
    b.f = f;
    a.f = -f;
  end SpringDamper;

  model Fixed
    Flange a;
  equation
    a.s = 0;
  end Fixed;

  model Pull
    Flange a;
  equation
    a.f = -1;
  end Pull;

  model Chain
    parameter Integer n = {cells};
    Mass mass[n];
    SpringDamper link[n];
    Fixed wall;
    Pull pull;
  equation
    connect(wall.a, link[1].a);
    for i in 1:n loop
      connect(link[i].b, mass[i].a);
    end for;
    for i in 2:n loop
      connect(mass[i - 1].b, link[i].a);
    end for;
    connect(mass[n].b, pull.a);
  end Chain;
end Parts;
"""
