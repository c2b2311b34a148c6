"""Blocks whose matrix no run changes are factored once; the results are those of a solver."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import acausal
from acausal.api import CompiledModel
from acausal.codegen.functions import Code
from acausal.simulate.evaluator import Evaluator

Vector = NDArray[np.float64]

STAGES = 55
LADDER = f"""
model Ladder "Resistors in a row, one to ground at every node, a capacitor at the far end"
  parameter Integer n = {STAGES};
  parameter Real R[n] = {{1 + 0.1*mod(3*i, 7) for i in 1:n}};
  parameter Real G = 0.02 "Of each resistor to ground";
  parameter Real C = 0.5;
  input Real u(start = 1);
  Real v[n + 1], i[n];
  Real x(start = 0.2, fixed = true);
equation
  v[1] = u + 0.1*sin(time);
  for k in 1:n loop
    v[k] - v[k + 1] = R[k]*i[k];
  end for;
  for k in 1:n - 1 loop
    i[k] = i[k + 1] + G*v[k + 1];
  end for;
  v[n + 1] = x;
  C*der(x) = i[n];
end Ladder;
"""


@pytest.fixture(scope="module")
def ladder() -> CompiledModel:
    # a shunt of 2 S beside 1 Ohm lets errors grow four times a stage: many guesses
    return acausal.loads(LADDER).compile(G=2.0)


def current(resistances: Vector, conductance: float, u: float, x: float) -> float:
    """i[n] of the ladder, by nodal analysis."""
    n = len(resistances)
    matrix, right = np.zeros((n - 1, n - 1)), np.zeros(n - 1)
    for k in range(n - 1):
        matrix[k, k] = 1 / resistances[k] + 1 / resistances[k + 1] + conductance
        if k:
            matrix[k, k - 1] = matrix[k - 1, k] = -1 / resistances[k]
    right[0] += u / resistances[0]
    right[-1] += x / resistances[-1]
    return float((np.linalg.solve(matrix, right)[-1] - x) / resistances[-1])


def evaluator(code: Code, parameters: Vector) -> Evaluator:
    found = Evaluator(code, parameters)
    found.u[:] = 1.0
    return found


def parameters_of(model: CompiledModel, **changed: float) -> Vector:
    """All parameters, those named changed."""
    names = model.causal.parameters
    given, override = np.zeros(len(names)), np.zeros(len(names))
    for name, value in changed.items():
        given[names.index(name)], override[names.index(name)] = value, 1.0
    return np.asarray(model.code.parameters(given, override).full()).ravel()


def test_the_matrix_is_factored_when_the_parameters_are_known(ladder: CompiledModel) -> None:
    quick = ladder.code.quick
    assert quick.factors is not None
    assert quick.factors.nnz_out(0) == len(ladder.code.dynamic.guesses) ** 2 > 144
    assert quick.ode is not None
    assert quick.ode.name_in() == ["t", "x", "p", "m", "u", "d", "z", "w"]
    assert ladder.code.ode.name_in() == ["t", "x", "p", "m", "u", "d", "z"]


@pytest.mark.parametrize("changed", [{}, {"G": 0.3}, {"G": 5.0, "R[7]": 20.0, "C": 2.0}])
def test_derivatives_are_exact_for_all_parameters(ladder: CompiledModel, changed: dict[str, float]) -> None:
    names = ladder.causal.parameters
    p = parameters_of(ladder, **changed)
    value = dict(zip(names, p.tolist(), strict=True))
    found = evaluator(ladder.code, p)
    found.at(0.7, np.array([0.3]))
    assert found.evaluate()
    resistances = np.array([value[f"R[{k + 1}]"] for k in range(STAGES)])
    exact = current(resistances, value["G"], 1.0 + 0.1 * np.sin(0.7), 0.3) / value["C"]
    assert found.xdot[0] == pytest.approx(exact, rel=1e-10)
    robust = ladder.code.ode(0.7, [0.3], p, [], [1.0], [], np.zeros(found.guess.size))
    assert found.xdot[0] == pytest.approx(float(robust[0]), rel=1e-10)
    found.jac()
    slope = float(ladder.code.jac(0.7, [0.3], p, [], [1.0], [], np.zeros(found.guess.size)))
    assert found.jacobian[0] == pytest.approx(slope, rel=1e-9)


def test_slopes_by_parameters_stay_exact(ladder: CompiledModel) -> None:
    """The public derivatives solve the block themselves: their slope by G against a difference."""
    h = 1e-5
    ends = [
        ladder.simulate(stop_time=0.0, parameters={"G": 2.0 + s}).final(["der(x)"])["der(x)"] for s in (-h, h)
    ]
    slope = ladder.jacobian("derivatives", "parameters")["der(x)", "G"]
    assert slope == pytest.approx((ends[1] - ends[0]) / (2 * h), rel=1e-5, abs=1e-12)


def test_runs_agree_with_and_without_compiled_functions(ladder: CompiledModel) -> None:
    runs = [ladder.simulate(stop_time=3.0, rtol=1e-8, compiled=compiled) for compiled in (False, True)]
    assert runs[0].values("x") == pytest.approx(runs[1].values("x"), rel=1e-12)
    rest = runs[0].values("i[40]")[-1]
    assert abs(rest) < 0.2


SINGULAR = """
model Floating "A network of currents that floats: its potentials have no level"
  parameter Integer n = 16;
  parameter Real G = 1;
  Real v[n];
  Real x(start = 1, fixed = true);
equation
  for k in 1:n loop
    G*(v[k] - v[if k > 1 then k - 1 else n]) + G*(v[k] - v[if k < n then k + 1 else 1])
      + 0.5*(v[k] - v[if k > 8 then k - 8 else k + 8])
      = (if k == 1 then x else if k == 5 then -x else 0);
  end for;
  der(x) = v[5] - v[1];
end Floating;
"""


def test_a_singular_matrix_is_left_to_the_solver() -> None:
    model = acausal.loads(SINGULAR).compile()
    run = model.simulate(stop_time=0.5, rtol=1e-8)
    slope = -float(np.log(run.values("x")[-1])) / 0.5
    laplacian = np.zeros((16, 16))
    for k in range(16):
        for other, g in (((k + 1) % 16, 1.0), ((k + 8) % 16, 0.25)):
            laplacian[k, k] += g
            laplacian[other, other] += g
            laplacian[k, other] -= g
            laplacian[other, k] -= g
    right = np.zeros(16)
    right[0], right[4] = 1.0, -1.0
    v = np.linalg.lstsq(laplacian, right, rcond=None)[0]
    assert slope == pytest.approx(v[0] - v[4], rel=1e-6)
