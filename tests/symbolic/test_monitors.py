"""What is watched of a choice of states: determinants, quality, thresholds, and where nothing is."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from acausal.symbolic.causal_text import print_causal
from acausal.symbolic.causalise import causalise, choose_states, with_states
from acausal.symbolic.expressions.evaluate import evaluate
from acausal.symbolic.expressions.expr import Expr, const, sym
from acausal.symbolic.monitors import LARGEST_BLOCK, THRESHOLD, Row, determinant, state_monitors
from tests.symbolic.build import PENDULUM_PARAMETERS, Attributes, model, pendulum

matrices = st.integers(1, 5).flatmap(
    lambda n: st.lists(
        st.lists(st.sampled_from([-2.0, -1.0, 0.0, 0.0, 1.0, 3.0]), min_size=n, max_size=n),
        min_size=n,
        max_size=n,
    )
)


def value(expr: Expr, values: dict[str, float]) -> float:
    number = evaluate(expr, values.get)
    assert isinstance(number, int | float)
    return float(number)


@given(matrices)
def test_determinant_is_numpys(matrix: list[list[float]]) -> None:
    exact = float(np.linalg.det(np.array(matrix)))
    assert value(determinant([[const(a) for a in row] for row in matrix]), {}) == pytest.approx(exact)
    symbols = [[sym(f"a{i}{j}") for j in range(len(matrix))] for i in range(len(matrix))]
    given_values = {f"a{i}{j}": a for i, row in enumerate(matrix) for j, a in enumerate(row)}
    assert value(determinant(symbols), given_values) == pytest.approx(exact)


def test_the_pendulum_is_watched_by_the_angle_of_its_rod() -> None:
    system = causalise(pendulum(x=0.9, y=-1.2))
    assert system.dynamic is not None
    (monitor,) = system.dynamic.monitors
    assert {*monitor.solved_for, *monitor.alternatives} == {"x", "y"}
    assert system.zero_crossings[-1].relation is monitor.relation
    assert system.events == ()
    (dummy,) = monitor.solved_for
    for angle in (0.1, 0.3, 0.33, 1.0):
        point = {dummy: np.sin(angle), monitor.alternatives[0]: np.cos(angle)}
        assert evaluate(monitor.relation, point.get) == (np.sin(angle) ** 2 > THRESHOLD)
    assert "states chosen anew" in print_causal(system)


def test_a_new_choice_keeps_equations_and_names() -> None:
    system = causalise(pendulum(x=0.9, y=-1.2))
    present = {"x": 0.1, "y": -1.49} if "y" in system.states else {"x": 1.49, "y": -0.1}
    chosen = choose_states(system, system.states, present)
    other = with_states(system, chosen)
    assert not set(other.states) & set(system.states)
    assert len(other.states) == 2
    names = [
        {unknown for block in s.blocks for unknown in block.unknowns} | {sym(state) for state in s.states}
        for s in (system, other)
    ]
    assert names[0] == names[1]
    back = choose_states(system, other.states, {"x": present["y"], "y": present["x"]})
    assert {leaf.name for leaf in back.states} == set(system.states)


def test_a_sound_choice_stays() -> None:
    system = causalise(pendulum(x=0.9, y=-1.2))
    for angle in np.linspace(0.6, 0.97, 5):
        present = {"x": 1.5 * float(np.cos(angle)), "y": -1.5 * float(np.sin(angle))}
        assert [leaf.name for leaf in choose_states(system, system.states, present).states] == list(
            system.states
        )


def test_nominal_values_scale_what_is_compared() -> None:
    """The circle in millimetres and metres: with nominal values neither axis is favoured."""
    equations = ("der(x) = vx", "der(y) = vy", "der(vx) = -f*x", "der(vy) = -f*y", "(x/1000)^2 + y^2 = L^2")
    variables: dict[str, Attributes] = {
        "x": {"start": 1000.0, "nominal": 1000.0},
        "y": {"start": 0.4},
        "vx": {"nominal": 1000.0},
    }
    system = causalise(model(*equations, variables=variables, parameters=PENDULUM_PARAMETERS))
    assert set(system.states) == {"y", "vy"}
    assert system.dynamic is not None
    assert [monitor.threshold for monitor in system.dynamic.monitors] == [THRESHOLD]


@pytest.mark.parametrize("held", [True, False])
def test_nothing_is_watched_where_nothing_else_could_be_chosen(held: bool) -> None:
    """A prescribed point on a curve leaves no choice; a constraint with constant coefficients no doubt."""
    equations = ["der(x) = vx", "x^3 + x = sin(time)"] if held else ["der(x) = a", "der(y) = b", "x = 2*y"]
    system = causalise(model(*equations, *([] if held else ["a + b = sin(time)"])))
    assert system.dynamic is None
    assert system.zero_crossings == ()


def test_a_block_too_large_for_a_determinant_is_watched_row_by_row() -> None:
    dynamic = causalise(pendulum(x=0.9, y=-1.2)).dynamic
    assert dynamic is not None
    constraint = dynamic.monitors[0].constraints[0]
    count = LARGEST_BLOCK + 1
    rows = [
        Row(constraint, {f"x{i}": sym("a"), f"x{(i + 1) % count}": const(0.5), "y": const(0.25)}, f"x{i}")
        for i in range(count)
    ]
    point = {"a": 1.0}

    def number(expr: Expr) -> float:
        return value(expr, point)

    found = state_monitors(rows, lambda a: a.is_const, number)
    assert [m.solved_for for m in found] == [(f"x{i}",) for i in range(count)]
    assert all(m.alternatives == ("y",) for m in found)
    assert evaluate(found[0].relation, point.get) is True
    assert evaluate(found[0].relation, {"a": 0.05}.get) is False
    assert len(state_monitors(rows[:-1], lambda a: a.is_const, number)) == count - 1
