"""Published systems of high index from Modelica text: states, index, and motion against closed forms."""

from __future__ import annotations

import math
from itertools import combinations, product

import numpy as np
import pytest

import acausal
from acausal.api import CompiledModel


def compiled(declarations: str, equations: str) -> CompiledModel:
    return acausal.loads(f"model Published\n{declarations}\nequation\n{equations}\nend Published;").compile()


def test_pendulum_of_index_three() -> None:
    """Small swings have the period 2 pi sqrt(L/g); the tension is m g + m v^2/L at the bottom."""
    model = compiled(
        "Real x(start = 0.01, fixed = true), y(start = -1), vx, vy, F;",
        "der(x) = vx; der(y) = vy; der(vx) = -F*x; der(vy) = -F*y - 9.81; x^2 + y^2 = 1;",
    )
    assert (model.index, len(model.states)) == (3, 2)
    period = 2 * math.pi / math.sqrt(9.81)
    run = model.simulate(stop_time=period, rtol=1e-9)
    assert np.max(np.abs(run.values("x") - 0.01 * np.cos(2 * math.pi * run.time / period))) < 1e-6
    bottom = np.argmin(np.abs(run.values("x")))
    assert run.values("F")[bottom] == pytest.approx(9.81 + 0.01**2 * 9.81, rel=1e-4)


def test_pantelides_second_example() -> None:
    """Pantelides 1988, (3): x1' + x2' = a(t), x1 + x2^2 = b(t); one equation differentiated, one state."""
    model = compiled(
        "Real x1, x2(start = 2, fixed = true);", "der(x1) + der(x2) = cos(time); x1 + x2^2 = 4 + 0*time;"
    )
    assert (model.index, model.states) == (2, ("x2",))
    run = model.simulate(rtol=1e-9)
    # x1 + x2 = sin t + 2 with x1 = 4 - x2^2
    root = (1 + np.sqrt(1 + 4 * (2 - np.sin(run.time)))) / 2
    assert np.max(np.abs(run.values("x2") - root)) < 1e-7


def test_mattsson_soederlind_linear_example() -> None:
    """Mattsson and Soederlind 1993, the linear example: x1 + x2 = -sin t, x3 = sin t - cos t."""
    model = compiled(
        "Real x1(start = 0.5), x2, x3, x4;",
        "x1 + x2 + sin(time) = 0; x1 + x2 + x3 + cos(time) = 0; x1 + der(x3) + x4 + 1 = 0;"
        "2*der(der(x1)) + der(der(x2)) + der(der(x3)) + der(x4) + 2 = 0;",
    )
    assert (model.index, len(model.states)) == (3, 2)
    run = model.simulate(rtol=1e-9)
    t, x1, x4 = run.time, run.values("x1"), run.values("x4")
    assert np.max(np.abs(run.values("x3") - np.sin(t) + np.cos(t))) < 1e-12
    assert np.max(np.abs(x4 + 1 + x1 + np.cos(t) + np.sin(t))) < 1e-9
    # x1'' - x1' + (x1 + x2)'' + x3'' - x3'' + 2 = 0 with x4' = -x1' - x3''
    slope = run.values("der(x1)")
    assert np.max(np.abs(slope - slope[0] - (x1 - x1[0]) - (np.cos(t) - 1) + 2 * t)) < 1e-6


def test_crane_with_prescribed_trolley() -> None:
    """The load hangs on a rope of constant length; the trolley's motion is given, its force follows."""
    model = compiled(
        "parameter Real L = 2, m = 5, M = 3; Real s, v, x(start = 0), z(start = -2), vx, vz, T, f;",
        "s = 0.05*(1 - cos(3*time)); v = der(s);"
        "der(x) = vx; der(z) = vz; m*der(vx) = -T*(x - s)/L; m*der(vz) = -T*z/L - m*9.81;"
        "(x - s)^2 + z^2 = L^2; M*der(v) = f + T*(x - s)/L;",
    )
    assert (model.index, len(model.states)) == (3, 2)
    run = model.simulate(stop_time=3.0, rtol=1e-9)
    swing = compiled(
        "Real a(start = 0, fixed = true), w(start = 0, fixed = true);",
        "der(a) = w; 2*der(w) = -9.81*sin(a) - 0.45*cos(3*time)*cos(a);",
    ).simulate(stop_time=3.0, rtol=1e-9)
    s, angle = 0.05 * (1 - np.cos(3 * run.time)), swing.values("a")
    assert np.max(np.abs(run.values("x") - s - 2 * np.sin(angle))) < 1e-6
    assert np.max(np.abs(run.values("z") + 2 * np.cos(angle))) < 1e-6
    force = 3 * 0.45 * np.cos(3 * run.time) - run.values("T") * np.sin(angle)
    assert np.max(np.abs(run.values("f") - force)) < 1e-5


def test_loop_of_capacitors_and_cut_set_of_inductors() -> None:
    """C1, C2, C3 in a loop and L1, L2, L3 in a cut set: of six stores four are states."""
    model = compiled(
        "parameter Real C1 = 1, C2 = 2, C3 = 2, L1 = 1, L2 = 2, L3 = 3, R = 5;"
        "Real v1, v2, v3, i1, i2, j1, j2, j3(start = 0), u1, u2, u3, n;",
        "C1*der(v1) = i1; C2*der(v2) = i2; C3*der(v3) = i2; v1 = v2 + v3; i1 + i2 = j1;"
        "L1*der(j1) = u1; L2*der(j2) = u2; L3*der(j3) = u3; j1 = j2 + j3;"
        "1 - R*j1 - u1 - v1 = n; n = u2; n = u3;",
    )
    assert (model.index, len(model.states)) == (2, 4)
    run = model.simulate(stop_time=40.0, rtol=1e-9)
    # one loop: C = C1 + C2 C3/(C2 + C3) = 2, L = L1 + L2 L3/(L2 + L3) = 2.2, R = 5
    root = math.sqrt(25 - 4 * 2.2 / 2)
    a, b = (-5 + root) / 4.4, (-5 - root) / 4.4
    exact = 1 - (b * np.exp(a * run.time) - a * np.exp(b * run.time)) / (b - a)
    assert np.max(np.abs(run.values("v1") - exact)) < 1e-6
    assert np.max(np.abs(3 * run.values("j3") - 2 * run.values("j2"))) < 1e-8


@pytest.mark.parametrize("stages", [1, 4, 20])
def test_gear_train(stages: int) -> None:
    """Inertias joined by ideal gears move as one: J = sum of J_k over the squares of the ratios."""
    joints = "\n".join(
        f"connect(b[{k}].flange_b, g[{k}].flange_a); connect(g[{k}].flange_b, b[{k + 1}].flange_a);"
        for k in range(1, stages + 1)
    )
    model = compiled(
        f"Mechanics.Rotational.Components.Inertia b[{stages + 1}](each J = 0.2);"
        f"Mechanics.Rotational.Components.IdealGear g[{stages}](each ratio = 1.1);"
        "Mechanics.Rotational.Sources.Torque drive(tau_start = 3);",
        joints + "connect(drive.flange, b[1].flange_a);",
    )
    assert (model.index, len(model.states)) == (3, 2)
    total = sum(0.2 / 1.1 ** (2 * k) for k in range(stages + 1))
    assert model.simulate(stop_time=0.1).final(["b[1].a"])["b[1].a"] == pytest.approx(3 / total)


def test_two_coupled_incompressible_volumes() -> None:
    """Tanks joined by a rigid pipe at the bottom: levels are equal at every instant, one state, index 2."""
    model = compiled(
        "parameter Real A1 = 2, A2 = 3, rho = 1000;Real h1(start = 1, fixed = true), h2, p1, p2, q, inflow;",
        "A1*der(h1) = inflow - q; A2*der(h2) = q; p1 = rho*9.81*h1; p2 = rho*9.81*h2; p1 = p2;"
        "inflow = 0.5*sin(time);",
    )
    assert (model.index, len(model.states)) == (2, 1)
    run = model.simulate(stop_time=4.0, rtol=1e-9)
    assert np.max(np.abs(run.values("h2") - 1 - 0.1 * (1 - np.cos(run.time)))) < 1e-7
    assert np.max(np.abs(run.values("q") - 0.3 * np.sin(run.time))) < 1e-7


SHAFTS = ("sun", "carrier", "ring")
RATIO, INERTIAS = 2.5, {"sun": 0.02, "carrier": 0.03, "ring": 0.05}
WILLIS = {"sun": 1.0, "carrier": -(1 + RATIO), "ring": RATIO}
"""w_sun + i w_ring - (1 + i) w_carrier = 0; the shafts' torques stand in the same proportion."""
GIVEN = {"speed": 4.0, "torque": 3.0}


@pytest.mark.parametrize(
    ("driven", "kinds"),
    list(product(combinations(SHAFTS, 2), product(("speed", "torque"), repeat=2))),
)
def test_planetary_set_driven_at_two_shafts(driven: tuple[str, str], kinds: tuple[str, str]) -> None:
    """All twelve combinations: nothing in the set decides what is cause and what is effect.

    With Willis coefficients c_k, tooth torque f: J_k a_k = t_k + c_k f and sum c_k a_k = 0. A speed given at
    a shaft makes a_k = 0 there and its torque the unknown.
    """
    sources = {
        shaft: f"Mechanics.Rotational.Sources.Speed {shaft}Drive(w_start = 4);"
        if kind == "speed"
        else f"Mechanics.Rotational.Sources.Torque {shaft}Drive(tau_start = 3);"
        for shaft, kind in zip(driven, kinds, strict=True)
    }
    model = compiled(
        f"Mechanics.Rotational.Components.IdealPlanetary set(ratio = {RATIO});"
        + "".join(f"Mechanics.Rotational.Components.Inertia {k}(J = {j});" for k, j in INERTIAS.items())
        + "".join(sources.values()),
        "".join(f"connect({k}.flange_b, set.{k});" for k in SHAFTS)
        + "".join(f"connect({k}Drive.flange, {k}.flange_a);" for k in driven),
    )
    fixed = [shaft for shaft, kind in zip(driven, kinds, strict=True) if kind == "speed"]
    assert len(model.states) == 2 * (2 - len(fixed))
    assert model.index == 3
    run = model.simulate(stop_time=0.2, rtol=1e-9)
    pushed = {shaft: 3.0 for shaft, kind in zip(driven, kinds, strict=True) if kind == "torque"}
    free = [shaft for shaft in SHAFTS if shaft not in fixed]
    tooth = -sum(WILLIS[k] * pushed.get(k, 0.0) / INERTIAS[k] for k in free)
    tooth /= sum(WILLIS[k] ** 2 / INERTIAS[k] for k in free)
    for shaft in SHAFTS:
        acceleration, speed = run.values(f"{shaft}.a"), run.values(f"{shaft}.w")
        exact = (pushed.get(shaft, 0.0) + WILLIS[shaft] * tooth) / INERTIAS[shaft] if shaft in free else 0.0
        assert acceleration == pytest.approx(np.full(len(run.time), exact), abs=1e-6)
        if shaft in fixed:
            assert speed == pytest.approx(np.full(len(run.time), 4.0))
            torque = -WILLIS[shaft] * tooth
            assert -run.values(f"{shaft}Drive.flange.tau") == pytest.approx(np.full(len(run.time), torque))
    willis = sum(WILLIS[k] * run.values(f"{k}.w") for k in SHAFTS)
    assert np.max(np.abs(willis)) < 1e-8
