"""Models of any size for the benchmarks, as Modelica text that every compared tool reads."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from benchmarks.loops import LOOPS, WATCHED
from benchmarks.networks import DOMAINS, SHAPES, network, written_out


@dataclass(frozen=True)
class Case:
    """A model: its text by the number of scalar equations wanted, its class, and a variable to compare."""

    text: Callable[[int], str]
    name: str
    watched: str


def network_cases() -> dict[str, Case]:
    """The nine networks, by `domain shape`."""
    found: dict[str, Case] = {}
    for domain, parts in DOMAINS.items():
        for shape in SHAPES:
            first = "node[1,1]" if shape == "grid" else "node[1]"
            text = partial(network, domain, shape)
            found[f"{domain} {shape}"] = Case(text, "Net.System", f"{first}.{parts.watched}")
    return found


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


RELATIVE = """
package Net
  connector Flange "One-dimensional translation"
    Real s(unit = "m") "Position";
    flow Real f(unit = "N") "Force into the component";
  end Flange;

  partial model TwoFlanges "What has two ends"
    Flange a;
    Flange b;
  end TwoFlanges;

  model Mass "Sliding mass"
    extends TwoFlanges;
    parameter Real m(unit = "kg") = 1 "Mass";
    Real s(unit = "m", start = 0) "Position";
    Real v(unit = "m/s", start = 0) "Speed";
  equation
    a.s = s;
    b.s = s;
    v = der(s);
    m*der(v) = a.f + b.f;
  end Mass;

  model SpringDamper "Linear, with the relative position and speed as states"
    extends TwoFlanges;
    parameter Real c(unit = "N/m") = 100 "Stiffness";
    parameter Real d(unit = "N.s/m") = 1 "Damping";
    Real s_rel(unit = "m", start = 0, stateSelect = StateSelect.prefer) "Elongation";
    Real v_rel(unit = "m/s", start = 0, stateSelect = StateSelect.prefer) "Its rate";
    Real f(unit = "N") "Force";
  equation
    s_rel = b.s - a.s;
    v_rel = der(s_rel);
    f = c*s_rel + d*v_rel;
    b.f = f;
    a.f = -f;
  end SpringDamper;

  model Fixed "The wall"
    Flange a;
  equation
    a.s = 0;
  end Fixed;

  model Pull "Constant force at the free end"
    Flange a;
  equation
    a.f = -1;
  end Pull;

  model System
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
  end System;
end Net;
"""


def relative_chain(cells: int) -> str:
    """The chain of `Net.System` whose every cell is index-reduced: 13 `cells` + 4 scalar equations."""
    return RELATIVE.format(cells=cells)


NETWORKS = network_cases()
EQUATIONS = Case(lambda size: equation_chain(size // 3), "Chain", "s[1]")
RELATIVE_CHAIN = Case(lambda size: relative_chain((size - 4) // 13), "Net.System", "mass[1].s")
OTHERS = {
    "relative chain": RELATIVE_CHAIN,
    "equations on arrays": EQUATIONS,
    "mechanical chain written out": Case(partial(written_out, "mechanical"), "Net.System", "node1.s"),
    "electrical chain written out": Case(partial(written_out, "electrical"), "Net.System", "node1.c.v"),
}
LOOP_CASES = {name: Case(text, "Net.System", WATCHED[name]) for name, text in LOOPS.items()}
CASES = {**NETWORKS, **OTHERS, **LOOP_CASES}
