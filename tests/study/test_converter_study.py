"""Steady states of the converter at random points and parameters, in Python and by the model at level 4."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray

import acausal
from acausal.errors import UsageProblem
from acausal.study.converter import NOMINAL, STUDY_RANGES, Geometry, Operating, steady_map, steady_state
from acausal.study.converter.laws import balance, balance_at
from tests.models import reference_converter as reference

Array = NDArray[np.float64]
POINTS = 24
RNG = np.random.default_rng(20)


def circuits(count: int) -> Geometry:
    """Random circuits within the ranges of the studies."""
    return Geometry.of(
        {
            name: float(getattr(NOMINAL, name)[0]) + half * RNG.uniform(-1, 1, count)
            for name, half in STUDY_RANGES.items()
        }
    )


def by_hand(g: Geometry, i: int) -> dict[str, float]:
    """One of the circuits for the equations written out by hand."""
    names = [name for name in reference.DATA if hasattr(g, name)]
    return reference.DATA | {name: float(np.broadcast_to(getattr(g, name), POINTS)[i]) for name in names}


def test_laws_are_those_written_by_hand() -> None:
    g = circuits(POINTS)
    speeds = RNG.uniform(-100, 500, (3, POINTS))
    flow = np.concatenate([RNG.uniform(-0.1, 0.1, POINTS // 2), RNG.uniform(-2e-4, 2e-4, POINTS // 2)])
    found = balance_at(flow, speeds[0], speeds[1], speeds[2], g)
    for i in range(POINTS):
        wanted = reference.torques_and_pressure(
            by_hand(g, i), float(flow[i]), *(float(w) for w in speeds[:, i])
        )
        values = (found.tau_p[i], found.tau_t[i], found.tau_s[i], found.pressure[i])
        assert values == pytest.approx(wanted, rel=1e-9, abs=1e-9 * float(found.size[i]))


def test_residuals_are_continuous_at_zero_flow() -> None:
    """With loss factors other than 1 the pressures of both directions differ; blended they do not jump."""
    g = Geometry.of({"C_p": 1.15, "C_t": 0.9, "C_s": 0.85})
    flow = np.linspace(-2e-4, 2e-4, 4001)
    w_p, w_t = np.full(flow.shape, 200.0), np.full(flow.shape, 150.0)
    found, w_s = balance(flow, w_p, w_t, g)
    for values in (found.pressure, found.tau_p, found.tau_t, w_s):
        assert float(np.abs(np.diff(values)).max()) < 0.01 * float(np.ptp(values))
    sharp = balance(flow, w_p, w_t, Geometry.of({"C_p": 1.15, "C_t": 0.9, "C_s": 0.85, "Q_0": 1e-9}))[0]
    assert float(np.abs(np.diff(sharp.pressure)).max()) > 0.1 * float(np.ptp(sharp.pressure))
    outside = np.abs(flow) >= 1e-4  # beyond Q_0 nothing is changed but by the stator's speed within it
    assert found.pressure[outside] == pytest.approx(sharp.pressure[outside], rel=1e-3)


def test_speeds_in_both_directions_of_flow() -> None:
    g, w_p, ratio = circuits(2000), RNG.uniform(20, 600, 2000), RNG.uniform(-0.5, 2, 2000)
    found = steady_state(g, Operating(impeller_speed=w_p, turbine_speed=ratio * w_p))
    assert float(found.residual.max()) < 1e-9
    names = {name.split(",")[0] for name in found.branch.tolist()}
    assert names >= {"converter", "coupling", "overrun"}


@cache
def prescribed() -> dict[str, tuple[Geometry, Operating]]:
    """Torques at either shaft or at both; pairs of torques are those of a random speed ratio."""
    w_p, w_t = RNG.uniform(50, 500, POINTS), RNG.uniform(0, 500, POINTS)
    hidden = circuits(POINTS)
    at = steady_state(hidden, Operating(impeller_speed=w_p, turbine_speed=RNG.uniform(0, 0.8, POINTS) * w_p))
    fast = RNG.uniform(150, 500, POINTS)
    return {
        "driving": (
            circuits(POINTS),
            Operating(impeller_torque=RNG.uniform(5, 300, POINTS), turbine_speed=w_t),
        ),
        "braking": (
            circuits(POINTS),
            Operating(impeller_torque=-(fast**2) * RNG.uniform(1e-4, 6e-4, POINTS), turbine_speed=fast),
        ),
        "loaded": (
            circuits(POINTS),
            Operating(impeller_speed=w_p, turbine_torque=w_p**2 * RNG.uniform(-2e-3, 5e-3, POINTS)),
        ),
        "both": (hidden, Operating(impeller_torque=at.impeller_torque, turbine_torque=at.turbine_torque)),
    }


@pytest.mark.parametrize("kind", ["driving", "braking", "loaded", "both"])
def test_torques(kind: str) -> None:
    geometry, at = prescribed()[kind]
    found = steady_state(geometry, at)
    assert float(found.residual.max()) < 1e-9
    assert "none" not in found.branch.tolist()
    for given, value in (
        (at.impeller_torque, found.impeller_torque),
        (at.turbine_torque, found.turbine_torque),
    ):
        if given is not None:
            assert value == pytest.approx(given, rel=1e-9, abs=1e-9)


def test_torques_that_a_shaft_turning_backward_has() -> None:
    """A load that turns the turbine back takes more torque than stall; braking may turn the impeller back."""
    g = circuits(POINTS)
    w_p, ratio = RNG.uniform(50, 500, POINTS), RNG.uniform(-0.5, -0.05, POINTS)
    at = steady_state(g, Operating(impeller_speed=w_p, turbine_speed=ratio * w_p))
    found = steady_state(g, Operating(impeller_torque=at.impeller_torque, turbine_torque=at.turbine_torque))
    assert float(found.residual.max()) < 1e-9
    assert found.turbine_torque == pytest.approx(at.turbine_torque, rel=1e-9)
    w_t = np.full(1, 300.0)
    back = steady_state(NOMINAL, Operating(impeller_speed=np.array([-60.0]), turbine_speed=w_t), "lower")
    found = steady_state(NOMINAL, Operating(impeller_torque=back.impeller_torque, turbine_speed=w_t))
    assert float(found.residual.max()) < 1e-9


def test_two_branches_between_0_98_and_1() -> None:
    w_p, w_t = np.full(3, 200.0), 200 * np.array([0.95, 0.99, 1.05])
    upper, lower = (
        steady_state(NOMINAL, Operating(impeller_speed=w_p, turbine_speed=w_t), choice)
        for choice in ("upper", "lower")
    )
    assert upper.branch.tolist() == ["coupling", "coupling, upper", "overrun"]
    assert lower.branch.tolist() == ["coupling", "still, lower", "overrun"]
    assert float(upper.flow[1]) == pytest.approx(0.0169, rel=0.01)
    between = Operating(impeller_torque=np.array([5.6]), turbine_speed=np.array([198.0]))
    middle = steady_state(NOMINAL, between)
    assert middle.branch.tolist() == ["coupling, middle"]
    assert float(middle.turbine_speed[0] / middle.impeller_speed[0]) == pytest.approx(0.99, rel=1e-3)


def test_torques_that_no_speeds_have() -> None:
    found = steady_state(
        NOMINAL, Operating(impeller_torque=np.array([100.0]), turbine_torque=np.array([300.0, 80.0]))
    )
    assert found.branch.tolist() == ["none", "none"]
    assert np.isinf(found.residual).all()
    with pytest.raises(UsageProblem, match="either the speed or the torque of the turbine"):
        Operating(impeller_speed=np.array([1.0]))
    with pytest.raises(UsageProblem, match="no parameter `R`"):
        Geometry.of({"R": 1.0})


def test_the_map_is_the_models_default() -> None:
    flat = acausal.load("TenSpeed.Benches.TorqueConverterL5").compile().flat
    wanted = steady_map()
    for name, values in (("capacity", wanted.capacity), ("torqueRatioOverrun", wanted.torque_ratio_overrun)):
        for i, value in enumerate(values.tolist(), start=1):
            binding = flat.by_name[f"torus.{name}[{i}]"].binding
            assert binding is not None
            assert binding.number == pytest.approx(value, rel=1e-5, abs=1e-12)


@pytest.mark.parametrize("kind", ["SpeedSpeed", "TorqueSpeed"])
def test_the_model_at_level_4_solves_there_too(kind: str) -> None:
    """From the bench's own start values, at random points and parameters, in both directions of flow."""
    change = "redeclare model Torus = TenSpeed.Converter.TorusL4"
    text = f"model X extends TenSpeed.Benches.TorqueConverter{kind}({change}); end X;"
    compiled = acausal.loads(text).compile()
    w_p, tau, w_t = RNG.uniform(100, 500, POINTS), RNG.uniform(20, 250, POINTS), RNG.uniform(20, 450, POINTS)
    first = {"impeller_speed": w_p} if kind == "SpeedSpeed" else {"impeller_torque": tau}
    g = circuits(POINTS)
    wanted = steady_state(g, Operating(turbine_speed=w_t, **first))
    held = [i for i, name in enumerate(wanted.branch.tolist()) if "middle" not in name]
    for i in held[:6]:  # speeds alone cannot hold the middle branch, and the model solves for the flow first
        changes = {f"geometry.{name}": float(getattr(g, name)[i]) for name in STUDY_RANGES}
        changes |= {"turbineSource.w_start": float(w_t[i]), "turbineSource.w_end": float(w_t[i])}
        name, value = ("w", w_p[i]) if kind == "SpeedSpeed" else ("tau", tau[i])
        changes |= {f"impellerSource.{name}_start": float(value), f"impellerSource.{name}_end": float(value)}
        run = compiled.simulate(parameters=changes, stop_time=1e-3)
        for found, value in (("torus.Q", wanted.flow[i]), ("turbineTorque", wanted.turbine_torque[i])):
            assert float(run.values(found)[-1]) == pytest.approx(float(value), rel=1e-6)


@pytest.mark.parametrize(
    ("values", "code"),
    [
        ({"A": 0.0}, "out-of-range"),
        ({"R_t": -0.1}, "out-of-range"),
        ({"a_s": 1.57}, "out-of-range"),
        ({"C_p": -0.1}, "out-of-range"),
        ({"rho": np.inf}, "out-of-range"),
        ({"f": np.nan}, "not-a-number"),
        ({"A": np.ones((2, 2))}, "not-a-number"),
        ({"A": np.array([])}, "not-a-number"),
    ],
)
def test_circuits_that_cannot_be(values: dict[str, float | Array], code: str) -> None:
    with pytest.raises(UsageProblem, match=f"converter.{code}") as problem:
        Geometry.of(values)
    assert problem.value.diagnostics[0].names == tuple(values)


def test_operating_points_that_cannot_be() -> None:
    one = np.array([200.0])
    with pytest.raises(UsageProblem, match="`impeller_speed` is not a number"):
        Operating(impeller_speed=np.array([200, np.nan]), turbine_speed=one)
    with pytest.raises(UsageProblem, match="`turbine_torque` is inf"):
        Operating(impeller_speed=one, turbine_torque=np.array([np.inf]))
    with pytest.raises(UsageProblem, match="2 entries do not go with 3"):
        steady_state(NOMINAL, Operating(impeller_speed=np.ones(3), turbine_speed=np.ones(2)))
    with pytest.raises(UsageProblem, match="of one circuit"):
        steady_map(Geometry.of({"A": np.array([0.009, 0.01])}))
