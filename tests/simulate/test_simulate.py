"""Runs against closed forms: accuracy, conservation, parameters, time intervals and results."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from acausal.codegen.functions import Code, generate
from acausal.errors import LookupProblem, SimulationProblem, UsageProblem
from acausal.lang.flat import Assertion, Experiment
from acausal.simulate.options import resolve
from acausal.simulate.result import Result
from acausal.simulate.simulate import simulate
from acausal.symbolic.causal import Block, BlockKind
from acausal.symbolic.expressions import expr as e
from acausal.symbolic.expressions.expr import TIME, const, sym
from tests.codegen.systems import SPAN, explicit, hand_system, rate, torn

X, V, Z, K = sym("x"), sym("v"), sym("z"), sym("k")


def decay() -> Code:
    return generate(
        hand_system(
            {"x": 1.0},
            [rate("x", e.neg(e.mul(K, X)))],
            parameters={"k": 1.0},
            aliases=[("part.y", e.neg(X)), ("c", e.mul(const(2.0), K))],
            units={"x": "Pa"},
        )
    )


def oscillator() -> Code:
    return generate(hand_system({"x": 1.0, "v": 0.0}, [rate("x", V), rate("v", e.neg(X))]))


@pytest.mark.parametrize("rtol", [1e-5, 1e-7, 1e-9])
def test_decay_follows_the_tolerance(rtol: float) -> None:
    result = simulate(decay(), rtol=rtol)
    assert np.max(np.abs(result.values("x") - np.exp(-result.time))) < 20 * rtol


def test_oscillator_conserves_energy_and_phase() -> None:
    result = simulate(oscillator(), stop_time=20.0, rtol=1e-9)
    x, v = result.values("x"), result.values("v")
    assert np.max(np.abs(0.5 * (x**2 + v**2) - 0.5)) < 1e-6
    assert np.max(np.abs(x - np.cos(result.time))) < 1e-6


def test_nominal_scales_the_absolute_tolerance() -> None:
    size = 1e-9
    code = generate(
        hand_system(
            {"x": size, "v": 0.0}, [rate("x", V), rate("v", e.neg(X))], nominal={"x": size, "v": size}
        )
    )
    result = simulate(code, stop_time=10.0)
    assert np.max(np.abs(result.values("x") / size - np.cos(result.time))) < 1e-4


def test_sparse_and_dense_agree() -> None:
    """60 oscillators take the sparse linear solver, one the dense."""
    states: dict[str, float] = {}
    blocks: list[Block] = []
    for i in range(60):
        states |= {f"x{i}": 1.0, f"v{i}": 0.0}
        blocks += [rate(f"x{i}", sym(f"v{i}")), rate(f"v{i}", e.neg(sym(f"x{i}")))]
    result = simulate(generate(hand_system(states, blocks)), stop_time=3.0, rtol=1e-8)
    assert result.final(["x0", "x59"]) == pytest.approx({"x0": math.cos(3), "x59": math.cos(3)}, abs=1e-6)


def test_nonlinear_loop_on_the_way() -> None:
    """z^2 = x, dx/dt = -2 z: the square root falls linearly, x = (1 - t)^2."""
    block = torn(BlockKind.NONLINEAR, ["z"], [(e.mul(Z, Z), X)])
    code = generate(hand_system({"x": 1.0}, [block, rate("x", e.mul(const(-2.0), Z))], guesses={"z": 1.0}))
    result = simulate(code, stop_time=0.9, rtol=1e-9)
    assert np.max(np.abs(result.values("x") - (1 - result.time) ** 2)) < 1e-7


def test_parameters_and_starts_change_without_compiling() -> None:
    code = decay()
    result = simulate(code, parameters={"k": 3.0}, start={"x": 2.0}, rtol=1e-9)
    assert result.final(["x", "part.y", "c", "k"]) == pytest.approx(
        {"x": 2 * math.exp(-3), "part.y": -2 * math.exp(-3), "c": 6.0, "k": 3.0}, rel=1e-6
    )
    assert simulate(code, rtol=1e-9).final(["x"])["x"] == pytest.approx(math.exp(-1), rel=1e-6)


def test_grid_is_the_interval_and_ends_at_the_stop_time() -> None:
    result = simulate(decay(), stop_time=1.0, interval=0.3)
    assert result.time.tolist() == pytest.approx([0.0, 0.3, 0.6, 0.9, 1.0])
    assert len(simulate(decay()).time) == 501


def test_defaults_come_from_the_experiment() -> None:
    options = resolve(Experiment(1.0, 3.0, 1e-4, 0.5))
    assert (options.start_time, options.stop_time, options.rtol, options.interval) == (1.0, 3.0, 1e-4, 0.5)


def test_no_states() -> None:
    code = generate(hand_system({}, [explicit(Z, e.function("sin", TIME))]))
    result = simulate(code)
    assert result.values("z") == pytest.approx(np.sin(result.time))
    assert result.statistics.steps == 0


def test_interval_of_no_length() -> None:
    result = simulate(decay(), stop_time=0.0)
    assert result.time.tolist() == [0.0]
    assert result.final(["x"]) == {"x": 1.0}


@pytest.mark.parametrize(
    "wrong",
    [{"stop_time": -1.0}, {"rtol": 0.0}, {"atol": -1.0}, {"interval": math.nan}, {"max_step": 0.0}],
)
def test_senseless_options_are_refused(wrong: dict[str, float]) -> None:
    with pytest.raises(UsageProblem):
        resolve(Experiment(), **wrong)  # pyright: ignore[reportArgumentType]


def test_unknown_solver_and_parameter_are_refused() -> None:
    with pytest.raises(UsageProblem, match="did you mean cvode"):
        simulate(decay(), solver="cvod")
    with pytest.raises(LookupProblem, match="no parameter `kk`"):
        simulate(decay(), parameters={"kk": 1.0})
    with pytest.raises(LookupProblem, match="`nothing`"):
        simulate(decay(), start={"nothing": 1.0})


def test_not_a_number_names_equation_variable_and_time() -> None:
    root = e.function("sqrt", e.sub(const(0.5), TIME))
    code = generate(hand_system({"x": 1.0}, [explicit(Z, root), rate("x", Z)]))
    with pytest.raises(SimulationProblem, match=r"z is not a number at time 0\.5.*sqrt") as caught:
        simulate(code)
    assert caught.value.codes == ("simulate.not-finite",)
    assert caught.value.diagnostics[0].span is SPAN


def test_finite_escape_names_the_state() -> None:
    code = generate(hand_system({"x": 1.0, "v": 0.0}, [rate("x", e.mul(X, X)), rate("v", const(1.0))]))
    with pytest.raises(SimulationProblem) as caught:
        simulate(code, stop_time=2.0)
    assert caught.value.diagnostics[0].names[0] == "x"


def test_loop_without_solution_is_named() -> None:
    block = torn(BlockKind.NONLINEAR, ["z"], [(e.mul(Z, Z), e.sub(const(0.5), TIME))])
    code = generate(hand_system({"x": 0.0}, [block, rate("x", Z)], guesses={"z": 1.0}))
    with pytest.raises(SimulationProblem, match=r"found no solution.*z \* z") as caught:
        simulate(code)
    assert caught.value.diagnostics[0].names == ("z",)


def test_singular_loop_is_named() -> None:
    """a z = x with a = 1 - t, singular at 1."""
    names = ["z", "w"]
    left = e.mul(e.sub(const(0.5), TIME), Z)
    block = torn(BlockKind.LINEAR, names, [(e.add(left, sym("w")), X), (sym("w"), const(1.0))])
    code = generate(hand_system({"x": 0.0}, [block, rate("x", const(1.0))]))
    with pytest.raises(SimulationProblem, match=r"singular at time 0\.5"):
        simulate(code, interval=0.5)


def asserted(level: str) -> Code:
    assertion = Assertion(e.relation("gt", X, const(0.5)), const("x is too small"), level, SPAN)
    return generate(hand_system({"x": 1.0}, [rate("x", e.neg(X))], assertions=[assertion]))


def test_violated_assertion_stops_the_run() -> None:
    with pytest.raises(SimulationProblem, match=r"x is too small \(at time 0\.694") as caught:
        simulate(asserted("AssertionLevel.error"))
    assert caught.value.diagnostics[0].span is SPAN


def test_assertion_of_level_warning_is_collected_once() -> None:
    result = simulate(asserted("AssertionLevel.warning"))
    assert [w.severity for w in result.warnings] == ["warning"]
    assert "x is too small" in result.warnings[0].message


def test_xarray_has_units_and_aliases() -> None:
    result = simulate(decay())
    dataset = result.to_xarray(["x", "part.y"])
    assert dataset["x"].attrs["units"] == "Pa"
    assert dataset["time"].attrs["units"] == "s"
    assert float(dataset["part.y"][-1]) == -float(result["x"][-1])
    assert result.unit("der(x)") == "Pa/s"
    assert result.default_names == ("x", "c")


def test_unknown_variable_gets_a_hint() -> None:
    with pytest.raises(LookupProblem, match=r"did you mean part\.y"):
        simulate(decay()).values("part.z")


def test_csv_is_deterministic_and_exact(tmp_path: Path) -> None:
    first = simulate(decay()).to_csv(tmp_path / "a.csv", ["x", "part.y"])
    second = simulate(decay()).to_csv(tmp_path / "b.csv", ["x", "part.y"])
    assert first.read_bytes() == second.read_bytes()
    header, *rows = first.read_text().splitlines()
    assert header == "time,x,part.y"
    result: Result = simulate(decay())
    assert [float(v) for v in rows[-1].split(",")] == [
        1.0,
        result.values("x")[-1],
        result.values("part.y")[-1],
    ]


def test_statistics_are_plausible() -> None:
    statistics = simulate(oscillator(), stop_time=20.0).statistics
    assert 50 < statistics.steps <= statistics.rhs_evaluations
    assert statistics.jacobian_evaluations > 0
    assert statistics.events == 0
    assert statistics.real_time_factor == pytest.approx(statistics.cpu_seconds / 20.0)
