"""The whole symbolic core: laws, growth, and the text a person reads."""

from __future__ import annotations

import random
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from acausal.symbolic.causal import CausalSystem
from acausal.symbolic.causal_text import print_causal
from acausal.symbolic.causalise import causalise
from tests.growth import Work, growth
from tests.symbolic.build import chain, model, pendulum
from tests.symbolic.numeric import run


def drive_train(stages: int) -> list[str]:
    """Inertias in a row, rigidly geared in pairs, springs between the pairs; one degree of freedom a pair."""
    equations: list[str] = []
    for i in range(stages):
        a, b = f"g{i}.a", f"g{i}.b"
        torque = f"c*(g{i - 1}.b.phi - {a}.phi)" if i else "sin(time)"
        load = f"c*({b}.phi - g{i + 1}.a.phi)" if i + 1 < stages else "0"
        equations += [
            f"{a}.w = der({a}.phi)",
            f"{b}.w = der({b}.phi)",
            f"j*der({a}.w) = {torque} + {a}.tau",
            f"j*der({b}.w) = {b}.tau - {load}",
            f"{a}.phi = ratio*{b}.phi",
            f"{b}.tau + ratio*{a}.tau = 0",
        ]
    return equations


PARAMETERS: dict[str, str | float | None] = {"j": 0.1, "c": 50.0, "ratio": 2.0}


def degrees(system: CausalSystem) -> tuple[int, int]:
    return len(system.states), system.index


@given(st.randoms(use_true_random=False))
def test_order_changes_neither_states_nor_derivatives(rng: random.Random) -> None:
    equations = drive_train(3)
    first = causalise(model(*equations, parameters=PARAMETERS))
    rng.shuffle(equations)
    negated = [re.sub(r"^(.*) = (.*)$", r"-(\1) = -(\2)", e) if rng.random() < 0.3 else e for e in equations]
    second = causalise(model(*negated, parameters=PARAMETERS))
    assert degrees(first) == degrees(second) == (6, 3)
    known = run(first, {name: 0.1 * i for i, name in enumerate(first.states)}, time=0.4)
    found = run(second, {name: known[name] for name in second.states}, time=0.4)
    for name, value in known.items():
        if name in found:
            assert found[name] == pytest.approx(value, abs=1e-9)


def test_compilation_is_deterministic() -> None:
    texts = {print_causal(causalise(model(*drive_train(4), parameters=PARAMETERS))) for _ in range(3)}
    assert len(texts) == 1


def test_time_for_each_equation_does_not_grow() -> None:
    """Generous against the noise of a shared machine; benchmarks/ measures the ratio itself."""

    def prepare(cells: int) -> Work:
        flat = chain(cells)
        return lambda: causalise(flat)

    assert growth(prepare, 100, 1000) < 3


def test_a_long_rigid_train_is_reduced_locally() -> None:
    system = causalise(model(*drive_train(200), parameters=PARAMETERS))
    assert degrees(system) == (400, 3)
    assert max(block.size for block in system.blocks) <= 8


def test_many_masses_on_one_rigid_shaft() -> None:
    n = 60
    equations = ["f0 = sin(time)", f"f{n} = 0"]
    for i in range(n):
        equations += [f"v{i} = der(s{i})", f"m*der(v{i}) = f{i} - f{i + 1}"]
        equations += [f"s{i + 1} = s{i} + d"] if i + 1 < n else []
    system = causalise(model(*equations, parameters={"m": 0.5, "d": 0.1}))
    assert degrees(system) == (2, 3)
    values = run(system, dict.fromkeys(system.states, 0.0), time=1.0)
    assert values["der(v7)"] == pytest.approx(0.8414709848 / (0.5 * n))


def test_the_text_names_everything() -> None:
    text = print_causal(causalise(pendulum(x=0.9, y=-1.2)))
    for part in (
        "index 3, 2 states",
        "states\n",
        "running system\n",
        "initial values\n",
        "initial system\n",
        "parameter m = 2.0",
        "nonlinear block of 1, torn to 1",
        "linear block of 3, torn to 1",
        "differentiated once",
        "differentiated twice",
        "(test.mo:5)",
        "assumed",
        "guess",
    ):
        assert part in text


def test_the_text_shows_events_aliases_and_checks() -> None:
    text = print_causal(
        causalise(
            model(
                "der(x) = if x > 1 then p else -y",
                "y = x",
                "z = 2*x",
                parameters={"p": 1.0, "q": 2.0},
                free_parameters=["q"],
                variables={"x": {"start": 1, "fixed": True}, "z": {"start": 2, "fixed": True}},
                assertions=["x < 100"],
            )
        )
    )
    for part in (
        "y = x  // test.mo:2",
        "1: x > 1.0",
        "x < 100.0  //",
        "initial checks",
        "determined by the initial",
    ):
        assert part in text
