"""A buffer of samples filled in a when-clause, and its transform by a function of many arguments."""

from __future__ import annotations

import numpy as np
import pytest

import acausal
from acausal.errors import SimulationProblem
from acausal.export.support import check_c
from acausal.symbolic.expressions.expr import postorder

MODEL = """
model M
  function transform
    input Real u[:];
    input Integer lines;
    output Real level;
    output Real size[lines];
    output Real angle[lines];
  protected
    Real re;
    Real im;
    constant Real pi = 3.14159265358979323846;
  algorithm
    level := sqrt(sum(u .* u));
    for k in 1:lines loop
      re := 0;
      im := 0;
      for i in 1:size(u, 1) loop
        re := re + u[i]*cos(2*pi*(k - 1)*(i - 1)/size(u, 1));
        im := im - u[i]*sin(2*pi*(k - 1)*(i - 1)/size(u, 1));
      end for;
      size[k] := sqrt(re^2 + im^2)/level;
      angle[k] := if size[k] > 1e-6 then atan2(im, re) else 0;
    end for;
  end transform;
  parameter Integer n = 64;
  parameter Real offset = 0.5;
  final parameter Integer lines = div(n, 2) + 1;
  Real x(start = 0, fixed = true);
  Real y = offset*(1 + x)*(1 + sin(3*time) + 0.4*cos(11*time));
  Integer tick(start = 0, fixed = true);
  discrete Real buffer[n](start = zeros(n), each fixed = true);
  discrete Real size[lines](start = zeros(lines), each fixed = true);
  discrete Real angle[lines](start = zeros(lines), each fixed = true);
  discrete Real level(start = 0, fixed = true);
equation
  der(x) = 1 - x;
algorithm
  when sample(0, 1/n) then
    tick := pre(tick) + 1;
    if tick <= n then
      buffer[tick] := y;
    end if;
  end when;
  when tick == n then
    (level, size, angle) := transform(buffer, lines);
    assert(level >= 0, "no level");
  end when;
end M;
"""


@pytest.mark.parametrize("n", [16, 64])
def test_transform_of_samples_is_that_of_numpy(n: int) -> None:
    result = acausal.loads(MODEL).compile({"n": n}).simulate(stop_time=1.1, rtol=1e-9)
    time = np.arange(n) / n
    samples = 0.5 * (2 - np.exp(-time)) * (1 + np.sin(3 * time) + 0.4 * np.cos(11 * time))
    wanted = np.fft.rfft(samples)
    size = [float(result[f"size[{k + 1}]"][-1]) for k in range(n // 2 + 1)]
    level = float(np.sqrt(np.sum(samples**2)))
    assert size == pytest.approx(np.abs(wanted) / level, rel=1e-6, abs=1e-7)
    assert float(result["angle[2]"][-1]) == pytest.approx(np.angle(wanted[1]), rel=1e-6)
    assert float(result["level"][-1]) == pytest.approx(level)
    assert float(result["size[1]"][0]) == 0


def test_what_makes_no_sense_is_named_where_it_is_used() -> None:
    with pytest.raises(SimulationProblem) as failed:
        acausal.loads(MODEL).compile({"offset": 0}).simulate(stop_time=1.1)
    text = str(failed.value)
    assert "size[" in text
    assert len(text) < 2000


def test_expressions_and_code_grow_with_the_number_of_samples() -> None:
    (nodes, instructions), (more_nodes, more_instructions) = (_sizes(n) for n in (60, 120))
    assert more_nodes < 2.2 * nodes
    assert more_instructions < 2.2 * instructions


def _sizes(n: int) -> tuple[int, int]:
    code = acausal.loads(MODEL).compile({"n": n}).code
    check_c(code)
    nodes = postorder([a.value for a in code.system.discrete.assignments])
    return len(list(nodes)), code.discrete.update.n_instructions()
