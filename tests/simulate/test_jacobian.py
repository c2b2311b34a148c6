"""Exact Jacobians against central differences: states, inputs, parameters, torn blocks, events, residuals."""

from __future__ import annotations

import numpy as np
import pytest

import acausal
from acausal.api import CompiledModel
from acausal.errors import LookupProblem, UsageProblem
from acausal.simulate.initialize import initialize

MODEL = """model Network
  parameter Real k = 2, twice = 2 * k, c = 0.3;
  parameter Real off = 1;
  final parameter Real closed = 3;
  input Real u(start = 0.5);
  Real x(start = 1), y(start = 0.5), a(start = 0.7), b, e;
equation
  der(x) = -twice * x + a * u;
  der(y) = k * b - closed * y;
  a^3 + a * c = x + b;
  b * (1 + y^2) = a - c * y;
  e = if x * k > off then a else b;
end Network;"""


@pytest.fixture(scope="module")
def network() -> CompiledModel:
    return acausal.loads(MODEL).compile()


POINT = {"x": 1.3, "y": -0.4}


def values(
    compiled: CompiledModel, of: str, states: dict[str, float], k: float = 2.0, c: float = 0.3
) -> list[float]:
    """Derivatives, event functions or outputs at a point."""
    point = initialize(compiled.code, 0.0, {"k": k, "c": c})
    evaluator = point.evaluator
    evaluator.at(0.0, np.array([states[name] for name in compiled.states]))
    evaluator.settle()
    if of == "derivatives":
        return evaluator.xdot.tolist()
    run = evaluator.event if of == "events" else evaluator.output
    run()
    return run.outputs[0].tolist()


@pytest.mark.parametrize("of", ["derivatives", "events", "outputs"])
def test_by_states(network: CompiledModel, of: str) -> None:
    jacobian = network.jacobian(of, "states", states=POINT)
    assert jacobian.columns == ("x", "y")
    for name, at in POINT.items():
        ahead, behind = (np.array(values(network, of, POINT | {name: at + h})) for h in (1e-6, -1e-6))
        slopes = (ahead - behind) / 2e-6
        for row, slope in zip(jacobian.rows, slopes, strict=True):
            assert jacobian[row, name] == pytest.approx(slope, rel=1e-6, abs=1e-7)


@pytest.mark.parametrize("of", ["derivatives", "events", "outputs"])
def test_by_parameters_through_their_bindings(network: CompiledModel, of: str) -> None:
    """`twice` follows `k`; what is final is no column."""
    jacobian = network.jacobian(of, "parameters", states=POINT)
    assert jacobian.columns == ("k", "twice", "c", "off")
    for name, at in (("k", 2.0), ("c", 0.3)):
        ahead, behind = (np.array(values(network, of, POINT, **{name: at + h})) for h in (1e-6, -1e-6))
        slopes = (ahead - behind) / 2e-6
        for row, slope in zip(jacobian.rows, slopes, strict=True):
            assert jacobian[row, name] == pytest.approx(slope, rel=1e-6, abs=1e-7)


def test_a_parameter_that_is_given_no_longer_follows(network: CompiledModel) -> None:
    follows = network.jacobian("derivatives", "parameters", states=POINT)
    given = network.jacobian("derivatives", "parameters", states=POINT, parameters={"twice": 4.0})
    assert follows["der(x)", "k"] == pytest.approx(2 * follows["der(x)", "twice"])
    assert given["der(x)", "k"] == 0


def test_by_inputs(network: CompiledModel) -> None:
    jacobian = network.jacobian("derivatives", "inputs", states=POINT)
    a = network.jacobian("outputs", "states", states=POINT)
    assert jacobian.columns == ("u",)
    point = dict(zip(a.rows, values(network, "outputs", POINT), strict=True))
    assert jacobian["der(x)", "u"] == pytest.approx(point["a"])


def test_residuals_are_functions_of_all_their_variables(network: CompiledModel) -> None:
    by_unknowns = network.jacobian("residuals", "unknowns", states=POINT)
    by_states = network.jacobian("residuals", "states", states=POINT)
    assert len(by_unknowns.rows) == len(by_unknowns.columns) == 5
    assert "der(x)" in by_unknowns.columns
    total = -np.linalg.solve(by_unknowns.matrix.toarray(), by_states.matrix.toarray())
    exact = network.jacobian("derivatives", "states", states=POINT)
    for row in exact.rows:
        assert np.allclose(
            total[by_unknowns.columns.index(row)], [exact[row, name] for name in exact.columns]
        )


def test_columns_are_coloured() -> None:
    """A chain of 40 cells has a banded Jacobian: three directions give it whole."""
    cells = 40
    text = f"""model Chain
      Real x[{cells}](each start = 1);
    equation
      der(x[1]) = x[2] - x[1];
      for i in 2:{cells - 1} loop der(x[i]) = x[i - 1] - 2 * x[i] + x[i + 1]; end for;
      der(x[{cells}]) = x[{cells - 1}] - x[{cells}];
    end Chain;"""
    jacobian = acausal.loads(text).compile().jacobian()
    assert jacobian.colours == 3
    assert jacobian.matrix.nnz == 3 * cells - 2


def test_labels_and_wrong_choices(network: CompiledModel) -> None:
    jacobian = network.jacobian(states=POINT)
    array = jacobian.to_xarray()
    assert array.dims == ("of", "wrt")
    assert array.values.tolist() == jacobian.matrix.toarray().tolist()
    with pytest.raises(LookupProblem, match="no row or column `z`"):
        _ = jacobian["der(x)", "z"]
    for of, wrt in (("states", "states"), ("derivatives", "unknowns"), ("derivatives", "time")):
        with pytest.raises(UsageProblem):
            network.jacobian(of, wrt)


@pytest.mark.parametrize(("of", "wrt"), [("derivatives", "states"), ("outputs", "parameters")])
def test_slopes_that_are_infinite_behind_a_condition_do_no_harm(of: str, wrt: str) -> None:
    """A closed orifice beside a block with a solver: the slope of a root at zero, in a direction of zero."""
    model = acausal.load("TenSpeed.Examples.RigidClutches").compile()
    assert np.isfinite(model.jacobian(of, wrt).matrix.data).all()
