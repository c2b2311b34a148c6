"""Networks of components: chains, trees and 2-D grids in three physical domains, storage at every node.

Every text has one package `Net` with a `Node` (storage), a `Link` (what joins two nodes), a `Source` and the
model `Net.System`.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil

MECHANICAL = """
  connector Flange "One-dimensional translation"
    Real s(unit = "m") "Position";
    flow Real f(unit = "N") "Force into the component";
  end Flange;

  partial model TwoFlanges "What has two ends"
    Flange a;
    Flange b;
  end TwoFlanges;

  model Node "Sliding mass"
    Flange p;
    parameter Real m(unit = "kg") = 1 "Mass";
    Real s(unit = "m", start = 0) "Position";
    Real v(unit = "m/s", start = 0) "Speed";
  equation
    s = p.s;
    der(s) = v;
    m*der(v) = p.f;
  end Node;

  model Link "Spring and damper, by the relative position and speed"
    extends TwoFlanges;
    parameter Real c(unit = "N/m") = 100 "Stiffness";
    parameter Real d(unit = "N.s/m") = 1 "Damping";
    Real s_rel(unit = "m") "Elongation";
    Real v_rel(unit = "m/s") "Its rate";
    Real f(unit = "N") "Force";
  equation
    s_rel = b.s - a.s;
    v_rel = der(s_rel);
    f = c*s_rel + d*v_rel;
    b.f = f;
    a.f = -f;
  end Link;

  model Source "Prescribed force"
    Flange p;
  equation
    p.f = -1;
  end Source;
"""

ELECTRICAL = """
  connector Pin "Electrical terminal"
    Real v(unit = "V") "Potential";
    flow Real i(unit = "A") "Current into the component";
  end Pin;

  partial model OnePort "What has two pins and one current"
    Pin p;
    Pin n;
    Real v(unit = "V") "Voltage";
    Real i(unit = "A") "Current from p to n";
  equation
    v = p.v - n.v;
    p.i = i;
    n.i = -i;
  end OnePort;

  model Resistor
    extends OnePort;
    parameter Real R(unit = "Ohm") = 10 "Resistance";
  equation
    v = R*i;
  end Resistor;

  model Capacitor
    extends OnePort(v(start = 0));
    parameter Real C(unit = "F") = 1e-3 "Capacitance";
  equation
    C*der(v) = i;
  end Capacitor;

  model Ground
    Pin p;
  equation
    p.v = 0;
  end Ground;

  model Node "Capacitor to ground"
    Pin p;
    Capacitor c;
    Ground g;
  equation
    connect(p, c.p);
    connect(c.n, g.p);
  end Node;

  model Link "Resistor between two nodes"
    Pin a;
    Pin b;
    Resistor r;
  equation
    connect(a, r.p);
    connect(r.n, b);
  end Link;

  model Source "Prescribed current"
    Pin p;
  equation
    p.i = -1;
  end Source;
"""

HYDRAULIC = """
  connector Port "Hydraulic port"
    Real p(unit = "Pa") "Pressure";
    flow Real q(unit = "m3/s") "Volume flow into the component";
  end Port;

  model Node "Capacity of compressible oil"
    Port p;
    parameter Real V(unit = "m3") = 1e-5 "Volume";
    parameter Real K(unit = "Pa") = 1e9 "Bulk modulus";
    Real pressure(unit = "Pa", start = 1e5, nominal = 1e5) "Pressure";
  equation
    p.p = pressure;
    V/K*der(pressure) = p.q;
  end Node;

  model Link "Laminar restriction"
    Port a;
    Port b;
    parameter Real G(unit = "m3/(s.Pa)") = 1e-11 "Conductance";
    Real dp(unit = "Pa") "Pressure drop";
    Real q(unit = "m3/s") "Flow from a to b";
  equation
    dp = a.p - b.p;
    q = G*dp;
    a.q = q;
    b.q = -q;
  end Link;

  model Source "Prescribed flow"
    Port p;
  equation
    p.q = -1e-6;
  end Source;
"""

CHAIN = """
    parameter Integer n = {size};
    Node node[n];
    Link link[n - 1];
    Source source;
  equation
    connect(source.p, node[1].p);
    for i in 2:n loop
      connect(node[i - 1].p, link[i - 1].a);
      connect(link[i - 1].b, node[i].p);
    end for;
"""

TREE = """
    parameter Integer n = {size};
    Node node[n];
    Link link[n - 1];
    Source source;
  equation
    connect(source.p, node[1].p);
    for i in 2:n loop
      connect(node[div(i, 2)].p, link[i - 1].a);
      connect(link[i - 1].b, node[i].p);
    end for;
"""

GRID = """
    parameter Integer n = {size};
    Node node[n, n];
    Link across[n, n - 1];
    Link down[n - 1, n];
    Source source;
  equation
    connect(source.p, node[1, 1].p);
    for i in 1:n loop
      for j in 2:n loop
        connect(node[i, j - 1].p, across[i, j - 1].a);
        connect(across[i, j - 1].b, node[i, j].p);
        connect(node[j - 1, i].p, down[j - 1, i].a);
        connect(down[j - 1, i].b, node[j, i].p);
      end for;
    end for;
"""


@dataclass(frozen=True)
class Domain:
    """Component models of one domain, and the scalar equations a node and a link add, connections included.

    `watched` is the variable of a node that stands for the result.
    """

    parts: str
    node: int
    link: int
    watched: str


DOMAINS = {
    "mechanical": Domain(MECHANICAL, 4, 7, "s"),
    "electrical": Domain(ELECTRICAL, 10, 10, "c.v"),
    "hydraulic": Domain(HYDRAULIC, 3, 6, "pressure"),
}
SHAPES = {"chain": CHAIN, "tree": TREE, "grid": GRID}


def network(domain: str, shape: str, equations: int) -> str:
    """The text of `Net.System` in the smallest size that has at least `equations` scalar equations."""
    each = DOMAINS[domain]
    size = 2
    if shape == "grid":
        while size * size * each.node + 2 * size * (size - 1) * each.link + 2 < equations:
            size += 1
    else:
        size = ceil((equations - 2 + each.link) / (each.node + each.link))
    body = SHAPES[shape].format(size=size)
    return f"package Net\n{each.parts}\n  model System{body}  end System;\nend Net;\n"


def written_out(domain: str, equations: int) -> str:
    """The chain without arrays of components, for tools that have none: every component declared by name."""
    each = DOMAINS[domain]
    size = ceil((equations - 2 + each.link) / (each.node + each.link))
    lines = [f"    Node node{i};" for i in range(1, size + 1)]
    lines += [f"    Link link{i};" for i in range(1, size)]
    lines += ["    Source source;", "  equation", "    connect(source.p, node1.p);"]
    for i in range(1, size):
        lines.append(f"    connect(node{i}.p, link{i}.a);")
        lines.append(f"    connect(link{i}.b, node{i + 1}.p);")
    body = "\n".join(lines)
    return f"package Net\n{each.parts}\n  model System\n{body}\n  end System;\nend Net;\n"
