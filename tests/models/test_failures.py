"""What fails in the gearbox fails as it would; the solver never does."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import acausal

ELEMENTS = ("C1", "C2", "C3", "B1", "B2", "B3")


@cache
def run(name: str, level: int = 4) -> acausal.Result:
    text = (
        f"model M extends TenSpeed.Failures.{name}(redeclare TenSpeed.Gearbox.Level{level} gearbox); end M;"
    )
    stop = 10.5 if name in ("TieUp", "SupplyLost", "Reversal") else 10.0 if "Step" in name else 8.0
    return acausal.loads(text).compile().simulate(stop_time=stop, interval=0.01)


def last(result: acausal.Result, name: str) -> float:
    return float(result.values(name)[-1])


def w_8(result: acausal.Result) -> float:
    return last(result, "gearbox.body[8].w")


FAILURES = (
    "InputStep",
    "OutputStep",
    "SupplyLost",
    "ClutchesOff",
    "FrictionLost",
    "TieUp",
    "Standstill",
    "Reversal",
)


@pytest.mark.parametrize("name", FAILURES)
def test_no_element_carries_more_than_its_capacity(name: str) -> None:
    check_capacities(run(name))


@pytest.mark.slow
@pytest.mark.parametrize("level", [3, 2, 1])
@pytest.mark.parametrize("name", FAILURES)
def test_every_failure_runs_to_its_end_at_every_level(name: str, level: int) -> None:
    result = run(name, level)
    check_capacities(result)
    simple, fine = (last(one, "gearbox.body[8].w") for one in (run(name), result))
    assert fine == pytest.approx(simple, rel=0.05, abs=0.1)


def check_capacities(result: acausal.Result) -> None:
    for element in ELEMENTS:
        capacity = result.values(f"gearbox.{element}.capacity")
        assert (np.abs(result.values(f"torque_{element}")) <= capacity * (1 + 1e-9) + 1e-6).all(), element


def test_a_step_of_the_input_torque_makes_a_brake_slip() -> None:
    result = run("InputStep")
    held = result.time < 9
    assert np.abs(result.values("slip_B2")[held & (result.time > 8.9)]).max() < 0.01
    assert abs(last(result, "slip_B2")) > 30


def test_a_blow_on_the_output_slows_the_vehicle() -> None:
    result = run("OutputStep")
    before = result.values("gearbox.body[8].w")[np.searchsorted(result.time, 9.0) - 1]
    # 2,000 N.m less what the gearbox gives, on 16 kg.m2 and the gearbox
    assert before - w_8(result) == pytest.approx((2000 - 480) / 17.5, rel=0.2)


def test_without_pressure_the_input_runs_away() -> None:
    result = run("SupplyLost")
    assert last(result, "gearbox.body[1].w") > 800
    for brake in ("B1", "B2", "B3"):
        assert last(result, f"torque_{brake}") == pytest.approx(0, abs=1)


def test_without_clutches_first_drives_nothing() -> None:
    assert abs(w_8(run("ClutchesOff"))) < 25
    assert w_8(run("Reversal")) < 0


def test_a_brake_without_friction_slips() -> None:
    result = run("FrictionLost")
    assert abs(last(result, "torque_B1")) < 5
    assert abs(last(result, "slip_B1")) > 50


def test_four_elements_tie_up() -> None:
    result = run("TieUp")
    slips = [abs(last(result, f"slip_{name}")) for name in ("B1", "B2", "C2", "C3")]
    assert max(slips) > 10
    speed = result.values("gearbox.body[8].w")
    at_nine, at_ten = (float(speed[np.searchsorted(result.time, t)]) for t in (9.0, 10.0))
    assert at_ten < at_nine + 5  # in second alone it would gain 28 rad/s


def test_everything_may_stand_under_torque() -> None:
    result = run("Standstill")
    assert abs(w_8(result)) < 0.1
    assert last(result, "outputTorque") == pytest.approx(787, rel=0.02)
    assert result.statistics.events < 100


def test_the_levels_agree_on_a_tie_up() -> None:
    assert w_8(run("TieUp", 3)) == pytest.approx(w_8(run("TieUp")), rel=0.01)
