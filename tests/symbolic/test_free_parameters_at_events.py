"""Parameters that initialisation determines from discrete variables (Modelica 3.6, 8.6)."""

from __future__ import annotations

import acausal

_MODEL = """
model Test
  function same
    input Boolean u;
    output Boolean y = u;
  algorithm
  end same;
  discrete Real x(start = 0.5, fixed = true);
  discrete Real y(start = 0.5, fixed = true);
  discrete Real z(start = 0.5, fixed = true);
  parameter Real p(fixed = false);
  parameter Real q(fixed = false);
equation
  when {same(initial()), time > 2} then
    x = 2;
  end when;
  when {initial(), time > 2} then
    y = 2;
  end when;
  when same(initial()) then
    z = 2;
  end when;
initial equation
  x = p;
  y = q;
end Test;
"""


def test_a_parameter_takes_the_value_of_a_discrete_variable() -> None:
    run = acausal.loads(_MODEL).compile().simulate(stop_time=1.0)
    found = {name: float(run[name].values[-1]) for name in ("x", "y", "z", "p", "q")}
    assert found == {"x": 0.5, "y": 2.0, "z": 0.5, "p": 0.5, "q": 2.0}
