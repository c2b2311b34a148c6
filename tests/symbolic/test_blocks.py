"""Ordering, solving and tearing: every system is evaluated and compared with its residuals."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from acausal.errors import TypeProblem
from acausal.lang.flat import BOOLEAN
from acausal.symbolic.causal import BlockKind, CausalSystem
from acausal.symbolic.causalise import causalise
from acausal.symbolic.expressions.evaluate import evaluate
from acausal.symbolic.expressions.text import to_text
from tests.symbolic.build import model
from tests.symbolic.numeric import run


def kinds(system: CausalSystem) -> list[BlockKind]:
    return [block.kind for block in system.blocks]


def test_explicit_assignments_come_in_order() -> None:
    system = causalise(model("c = b + 1", "b = a*a", "a = sin(x)", "der(x) = c"))
    order = [to_text(block.unknowns[0]) for block in system.blocks]
    assert order == ["a", "b", "c", "der(x)"]
    assert set(kinds(system)) == {BlockKind.EXPLICIT}


@pytest.mark.parametrize(
    ("equation", "value"),
    [
        ("2*y + x = 3", "(-x + 3.0) / 2.0"),
        ("x*y = 1", "1.0 / x"),
        ("exp(y) = x", "log(x)"),
        ("log(2*y) = x", "exp(x) / 2.0"),
        ("x = 3*(y - p)", "(x + 3.0 * p) / 3.0"),
    ],
)
def test_scalar_equations_are_solved(equation: str, value: str) -> None:
    system = causalise(model("der(x) = y", equation, parameters={"p": 2.0}))
    assert set(kinds(system)) == {BlockKind.EXPLICIT}
    found = run(system, {"x": 0.7})
    expected = run(causalise(model("der(x) = y", f"y = {value}", parameters={"p": 2.0})), {"x": 0.7})
    assert found["y"] == pytest.approx(expected["y"])


def test_a_switching_coefficient_is_not_divided_by() -> None:
    system = causalise(model("der(x) = y", "(if x > 0 then 1 else 0)*y + x = 1"))
    assert BlockKind.LINEAR in kinds(system)
    assert run(system, {"x": 0.5})["y"] == pytest.approx(0.5)


def test_the_unknown_in_its_own_condition_is_a_mode() -> None:
    system = causalise(model("der(x) = y", "y = if y > 0 then x + 1 else x - 1"))
    (block,) = [b for b in system.blocks if to_text(b.unknowns[0]) == "y"]
    assert block.kind is BlockKind.EXPLICIT or block.kind is BlockKind.LINEAR
    guarded = causalise(model("der(x) = y", "y = noEvent(if y > 0 then x + 1 else x - y)"))
    assert BlockKind.NONLINEAR in kinds(guarded)


def test_a_linear_loop_is_torn_and_linear() -> None:
    system = causalise(
        model(
            "der(x) = i1",
            "u = r1*i1 + v",
            "v = r2*i2",
            "v = r3*i3 + x",
            "i1 = i2 + i3",
            "u = 5",
            parameters={"r1": 1.0, "r2": 2.0, "r3": 3.0},
        )
    )
    loops = [block for block in system.blocks if block.tearing]
    assert [block.kind for block in loops] == [BlockKind.LINEAR]
    assert (loops[0].size, len(loops[0].tearing)) == (4, 1)
    values = run(system, {"x": 1.0})
    assert values["i1"] == pytest.approx(values["i2"] + values["i3"])
    assert pytest.approx(values["i1"] + values["v"]) == 5
    assert values["v"] == pytest.approx(3 * values["i3"] + 1.0)


def test_a_nonlinear_loop() -> None:
    system = causalise(model("der(x) = a", "a + b = x", "a*a*a + a = b", "c = a + b"))
    (loop,) = [block for block in system.blocks if block.tearing]
    assert loop.kind is BlockKind.NONLINEAR
    assert len(loop.tearing) == 1
    values = run(system, {"x": 2.0})
    assert values["a"] ** 3 + 2 * values["a"] == pytest.approx(2.0)


def test_products_of_loop_unknowns_are_nonlinear() -> None:
    system = causalise(model("der(x) = a", "a + b = x", "a*b = 1 + x"))
    assert BlockKind.NONLINEAR in kinds(system)


def test_boolean_equations_are_assigned() -> None:
    system = causalise(
        model(
            "on = x > 1", "off = not on", "der(x) = if off then 1 else -1",
            variables={"on": {"type": BOOLEAN, "discrete": True}, "off": {"type": BOOLEAN, "discrete": True}},
        )
    )  # fmt: skip
    assert run(system, {"x": 2.0})["der(x)"] == -1
    assert run(system, {"x": 0.0})["der(x)"] == 1
    assert set(kinds(system)) == {BlockKind.EXPLICIT}


def test_zero_crossings() -> None:
    system = causalise(
        model(
            "der(x) = if x > 1 and time < t0 then 1 else -1",
            "y = noEvent(if x > 3 then 1 else 2) + smooth(1, if x > 4 then x else 1)",
            "z = if p > 1 then 1 else if x > 1 then 2 else 3",
            parameters={"p": 0.0, "t0": 2.0},
            assertions=["x < 100", "p < 3"],
        )
    )
    assert [to_text(z.relation) for z in system.zero_crossings] == ["x > 1.0", "time < t0", "x < 100.0"]
    assert [z.equation is None for z in system.zero_crossings] == [False, False, True]


def test_equality_of_reals_is_refused() -> None:
    with pytest.raises(TypeProblem) as caught:
        causalise(model("der(x) = if x == 1 then 1 else 2"))
    assert caught.value.codes == ("type.real-equality",)
    causalise(model("der(x) = if noEvent(p == 1) then 1 else 2", parameters={"p": 1.0}))
    causalise(model("der(x) = if integer(x) == integer(time) then 1.5 else 2"))


def test_a_loop_with_a_condition_without_event_is_nonlinear() -> None:
    clipped = "z = if noEvent(y > 2) then 2 else if noEvent(y < -2) then -2 else y"
    system = causalise(model("der(x) = z", "2*y = x - z", clipped))
    assert BlockKind.NONLINEAR in kinds(system)
    assert run(system, {"x": 9.0})["z"] == pytest.approx(2.0)
    assert run(system, {"x": 3.0})["z"] == pytest.approx(1.0)


@st.composite
def linear_systems(draw: st.DrawFn) -> list[str]:
    """Diagonally dominant linear equations with a sparse pattern, shuffled and some negated."""
    n = draw(st.integers(2, 7))
    equations: list[str] = []
    for i in range(n):
        others = draw(st.lists(st.integers(0, n - 1), max_size=3))
        terms = "".join([f" + ({draw(st.sampled_from([-1, 0.5, 2]))})*y{j}" for j in others if j != i])
        left, right = f"20*y{i}{terms}", f"x + {i}"
        equations.append(f"-({left}) = -({right})" if draw(st.booleans()) else f"{left} = {right}")
    return draw(st.permutations([*equations, "der(x) = y0"]))


@given(linear_systems())
def test_any_linear_system_is_solved(equations: list[str]) -> None:
    flat = model(*equations)
    system = causalise(flat)
    assert system.states == ("x",)
    assert BlockKind.NONLINEAR not in kinds(system)
    assert sum(block.size for block in system.blocks) + len(system.aliases) == len(equations)
    values = run(system, {"x": 0.7})
    for equation in flat.equations:
        if equation.left.op != "der":
            left, right = evaluate(equation.left, values.get), evaluate(equation.right, values.get)
            assert left == pytest.approx(right, abs=1e-9)
