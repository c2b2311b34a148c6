"""Models that the explanation is tested on."""

from __future__ import annotations

import acausal
from acausal.explain.explanation import Explanation, explain

PENDULUM = """\
model Pendulum "A point mass on a rod"
  Real x(start = 0.8);
  Real y(start = -0.6);
  Real u;
  Real v;
  Real F;
  Real height = -y;
equation
  der(x) = u;
  der(y) = v;
  der(u) = -F*x;
  der(v) = -F*y - (if x > 0 then 9.81 else 9.8);
  x^2 + y^2 = 1;
end Pendulum;
"""


def explained(text: str) -> Explanation:
    return explain(acausal.loads(text).run({}, "causal"))


def chain(cells: int) -> str:
    """Masses on springs, every one a loop of two equations: 5 equations a cell."""
    return f"""
model Chain
  parameter Integer n = {cells};
  Real s[n](each start = 0), v[n](each start = 0), a[n], f[n], g[n];
equation
  for i in 1:n loop
    der(s[i]) = v[i];
    der(v[i]) = a[i];
    a[i] = f[i] + g[i];
    f[i] = -s[i] - 0.5*g[i] + (if i > 1 then s[max(i - 1, 1)] else 0);
    g[i] = 0.1*f[i] - v[i];
  end for;
end Chain;
"""
