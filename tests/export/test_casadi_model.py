"""A model as CasADi functions: they agree with runs, can be differentiated, saved and read."""

from __future__ import annotations

from pathlib import Path

import casadi as ca
import numpy as np
import pytest

import acausal
from acausal.api import CompiledModel
from acausal.errors import LookupProblem, UsageProblem
from acausal.export.casadi_model import CasadiModel
from tests.export.packages import compiled

LOOP = """
model Loop
  parameter Real k(unit = "N/m") = 2 "Stiffness";
  parameter Real k2 = 2*k;
  input Real u(start = 1);
  Real x(start = 1, fixed = true, unit = "m", nominal = 5) "Place";
  Real y(start = 1);
equation
  der(x) = u - k2 * y;
  y ^ 3 + y = x;
end Loop;
"""

BALL = """
model Ball
  Real h(start = 1, fixed = true);
  Real v(start = -1, fixed = true);
  Integer n(start = 0, fixed = true);
equation
  der(h) = v;
  der(v) = -9.81;
  when h < 0 then
    reinit(v, -0.5 * pre(v));
    n = pre(n) + 1;
  end when;
end Ball;
"""


@pytest.fixture(scope="module")
def model() -> CompiledModel:
    return compiled(LOOP)


@pytest.fixture(scope="module")
def functions(model: CompiledModel) -> CasadiModel:
    return model.to_casadi()


def signature(functions: CasadiModel) -> list[ca.DM]:
    return [functions.start[name] for name in functions.ode.name_in()]


def test_labels(functions: CasadiModel) -> None:
    state = functions.labels["x"][0]
    assert (state.name, state.unit, state.nominal, state.start) == ("x", "m", 5.0, 1.0)
    assert state.description == "Place"
    assert functions.names("u") == ("u",)
    assert functions.names("y") == ("x", "y")
    assert functions.names("tunable") == ("k", "k2")


def test_functions_agree(functions: CasadiModel) -> None:
    given = signature(functions)
    xdot, z = functions.ode(*given)
    given[2] = z
    ode, alg = functions.dae(*given)
    y = float(np.asarray(functions.outputs(*given))[1, 0])
    assert abs(y**3 + y - 1) < 1e-10
    assert abs(float(ode) - float(xdot)) < 1e-12
    assert float(ca.norm_inf(alg)) < 1e-10
    assert abs(float(functions.jac(*given)) + 4 / (3 * y**2 + 1)) < 1e-9


def test_initial(functions: CasadiModel) -> None:
    start = functions.start
    found = functions.initial(t=0, u=start["u"], p=start["p"], s=start["s"], guess=1)
    assert abs(float(found["x0"]) - 1) < 1e-12


@pytest.mark.parametrize("plugin", ["idas", "cvodes"])
def test_integrators_and_their_slopes(model: CompiledModel, functions: CasadiModel, plugin: str) -> None:
    problem = functions.problem("k")
    if plugin == "cvodes":
        names = ("t", "x", "z", "u", "p", "m", "d")
        known = {"z": functions.start["z"], "m": functions.start["m"], "d": functions.start["d"]}
        symbols = {**problem, **known, "p": functions.tuned("k")(problem["p"])}
        problem = {name: problem[name] for name in ("t", "x", "u", "p")}
        problem["ode"] = functions.ode(*[symbols[name] for name in names])[0]
    options = {"abstol": 1e-11, "reltol": 1e-10}
    run = ca.integrator("run", plugin, problem, 0.0, 1.0, options)
    more = {"z0": functions.start["z"]} if plugin == "idas" else {}
    k = ca.MX.sym("k")
    end = run(x0=1, u=0.5, p=k, **more)["xf"]
    value = ca.Function("value", [k], [end, ca.jacobian(end, k)])
    found, slope = (float(v) for v in value(1.5))
    ends = [
        model.simulate(rtol=1e-11, parameters={"k": k}, inputs={"u": 0.5}).final(["x"])["x"]
        for k in (1.4999, 1.5, 1.5001)
    ]
    assert abs(found - ends[1]) < 1e-7
    assert abs(slope - (ends[2] - ends[0]) / 2e-4) < 1e-4


def test_one_pass_over_an_event() -> None:
    functions = compiled(BALL).to_casadi()
    given = dict(functions.start)
    del given["s"]
    given["x"] = ca.DM([-1e-9, -3.0])
    assert float(functions.events(**given)["holds"]) == 1.0
    given["d"] = functions.update(**given)["d_next"]  # the values before the event
    given["m"] = functions.events(**given)["holds"]
    found = functions.update(**given)
    assert found["x_new"].full().ravel().tolist() == [-1e-9, 1.5]
    assert float(found["d_new"][functions.index("d", "n")]) == 1.0
    again = functions.update(**{**given, "d": found["d_next"]})
    assert again["x_new"].full().ravel().tolist() == [-1e-9, -3.0]


def test_pass_over_an_event_with_one_value_that_is_frozen() -> None:
    source = "when time > 0.5 then n = 2.0; end when;"
    functions = compiled(f"model One discrete Real n(start = 1); equation {source} end One;").to_casadi()
    assert functions["update"].size1_in("d") == len(functions.names("d"))
    falling = "Real x(start = 3.5, fixed = true), y; equation der(x) = -1; y = integer(x);"
    functions = compiled(f"model Whole {falling} end Whole;").to_casadi()
    given = dict(functions.start)
    del given["s"]
    assert functions.names("d") == ("integer(x)",)
    assert functions.update(**given)["d_new"].full().ravel().tolist() == [3.0]


def test_saved_and_read(functions: CasadiModel, tmp_path: Path) -> None:
    for name in ("a.casadi", "b.casadi"):
        functions.save(tmp_path / name)
    assert (tmp_path / "a.casadi").read_bytes() == (tmp_path / "b.casadi").read_bytes()
    read = acausal.load_casadi(tmp_path / "a.casadi")
    assert read.labels == functions.labels
    assert float(read.ode(*signature(read))[0]) == float(functions.ode(*signature(functions))[0])


def test_wrong_files_and_names(functions: CasadiModel, tmp_path: Path) -> None:
    (tmp_path / "no").write_text("x", encoding="utf-8")
    for path in ("no", "missing"):
        with pytest.raises(UsageProblem):
            acausal.load_casadi(tmp_path / path)
    with pytest.raises(LookupProblem, match="`q` is not among the labels"):
        functions.tuned("q")
    with pytest.raises(LookupProblem):
        functions["nothing"]


def test_unknown_vectors_are_named() -> None:
    model = acausal.loads("model M Real x; equation der(x) = -x; end M;").compile().to_casadi()
    with pytest.raises(LookupProblem, match="no vector `q`"):
        model.names("q")
