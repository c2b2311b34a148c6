"""Published and physical systems: index, states, and derivatives against closed forms."""

from __future__ import annotations

import math
from itertools import permutations

import pytest

from acausal.errors import AcausalError, ReductionProblem
from acausal.lang.flat import StateSelect
from acausal.symbolic.causal import BlockKind, CausalSystem
from acausal.symbolic.causalise import causalise
from acausal.symbolic.expressions.text import to_text
from tests.symbolic.build import PENDULUM, PENDULUM_PARAMETERS, Attributes, model, pendulum
from tests.symbolic.numeric import initialise, run


def dummies(system: CausalSystem) -> list[str]:
    return [to_text(leaf) for leaf in system.dummy_derivatives]


def test_explicit_ode_has_index_zero() -> None:
    system = causalise(model("der(x) = v", "der(v) = -k*x", parameters={"k": 4.0}))
    assert (system.states, system.index) == (("x", "v"), 0)
    values = run(system, {"x": 2.0, "v": 3.0})
    assert (values["der(x)"], values["der(v)"]) == (3.0, -8.0)


def test_algebraic_parts_make_index_one() -> None:
    system = causalise(model("der(x) = y", "y = sin(x) + 1", "z*z*z + z = y"))
    assert (system.states, system.index) == (("x",), 1)
    values = run(system, {"x": 0.4})
    assert values["z"] ** 3 + values["z"] == pytest.approx(math.sin(0.4) + 1)


def pendulum_acceleration(x: float, y: float, vx: float, vy: float) -> tuple[float, float]:
    """Tension from the twice differentiated constraint: lambda = m (vx^2 + vy^2 - g y) / L^2."""
    length2, g = x * x + y * y, 9.81
    per_mass = (vx * vx + vy * vy - g * y) / length2
    return -per_mass * x, -per_mass * y - g


def test_pendulum() -> None:
    system = causalise(pendulum(x=0.9, y=-1.2))
    assert system.index == 3
    assert len(system.states) == 2
    assert len(system.dummy_derivatives) == 2
    position, speed = (name for name in system.states)
    angle, rate = 0.6, -0.7
    exact = {
        "x": 1.5 * math.sin(angle),
        "y": -1.5 * math.cos(angle),
        "vx": 1.5 * rate * math.cos(angle),
        "vy": 1.5 * rate * math.sin(angle),
    }
    values = run(system, {n: exact[n] for n in (position, speed)}, guesses={"x": 0.9, "y": -1.2})
    for name, value in exact.items():
        assert values[name] == pytest.approx(value, abs=1e-9)
    ax, ay = pendulum_acceleration(*exact.values())
    assert (values["der(vx)"], values["der(vy)"]) == (pytest.approx(ax), pytest.approx(ay))


def test_the_pendulums_states_follow_its_start_position() -> None:
    """Hanging down, x moves; to the side, y does: the other coefficient of the constraint is zero there."""
    assert causalise(pendulum(x=0.0, y=-1.5)).states == ("x", "vx")
    assert causalise(pendulum(x=1.5, y=0.0)).states == ("y", "vy")


def test_pendulum_with_second_derivatives() -> None:
    system = causalise(
        model(
            "der(der(x)) = -f*x",
            "der(der(y)) = -f*y - 9.81",
            "x^2 + y^2 = 2.25",
            variables={"x": {"start": 0.9}, "y": {"start": -1.2}},
        )
    )
    assert (system.index, len(system.states)) == (3, 2)
    assert set(system.states) in ({"x", "der(x)"}, {"y", "der(y)"})


@pytest.mark.parametrize("order", list(permutations(range(5)))[::13])
def test_order_does_not_matter(order: tuple[int, ...]) -> None:
    system = causalise(
        model(
            *[PENDULUM[i] for i in order],
            parameters=PENDULUM_PARAMETERS,
            variables={"x": {"start": 0.9}, "y": {"start": -1.2}},
        )
    )
    assert (system.index, len(system.states)) == (3, 2)


def test_pantelides_second_example() -> None:
    """Pantelides 1988: x1' + x2' = a(t), x1 + x2^2 = b(t) keeps one state, its index is 2."""
    system = causalise(model("der(x1) + der(x2) = sin(time)", "x1 + x2^2 = cos(time)"))
    assert (system.index, len(system.states)) == (2, 1)


def test_mattsson_soederlind_linear_example() -> None:
    """Mattsson and Soederlind 1993, the linear example with four equations; 2 degrees of freedom remain."""
    system = causalise(
        model(
            "x1 + x2 + sin(time) = 0",
            "x1 + x2 + x3 + cos(time) = 0",
            "x1 + der(x3) + x4 + 1 = 0",
            "2*der(der(x1)) + der(der(x2)) + der(der(x3)) + der(x4) + 2 = 0",
        )
    )
    assert (system.index, len(system.states)) == (3, 2)
    values = run(system, dict.fromkeys(system.states, 0.3), time=0.8)
    t = 0.8
    assert values["x3"] == pytest.approx(math.sin(t) - math.cos(t))
    assert values["x1"] + values["x2"] == pytest.approx(-math.sin(t))
    assert values["der(x3)"] == pytest.approx(math.cos(t) + math.sin(t))


def test_loop_of_capacitors() -> None:
    """Three capacitors in a loop: one voltage follows from the others; i = C_s dv/dt for the source."""
    system = causalise(
        model(
            "c1*der(v1) = i1",
            "c2*der(v2) = i2",
            "c3*der(v3) = i2",
            "v1 = v2 + v3",
            "i1 + i2 = (u - v1)/r",
            "u = sin(time)",
            parameters={"c1": 1.0, "c2": 2.0, "c3": 2.0, "r": 5.0},
        )
    )
    assert (system.index, len(system.states)) == (2, 2)
    values = run(system, dict.fromkeys(system.states, 0.2), time=1.0)
    charge = (math.sin(1.0) - values["v1"]) / 5.0
    assert values["der(v1)"] == pytest.approx(charge / (1.0 + 1.0))
    assert values["v1"] == pytest.approx(values["v2"] + values["v3"])


def test_two_masses_rigidly_coupled_by_an_alias() -> None:
    system = causalise(
        model(
            "v1 = der(s1)",
            "v2 = der(s2)",
            "m1*der(v1) = f - r",
            "m2*der(v2) = r",
            "s1 = s2",
            "f = sin(time)",
            parameters={"m1": 1.0, "m2": 3.0},
        )
    )
    assert system.index == 3
    assert len(system.states) == 2
    values = run(system, dict.fromkeys(system.states, 0.5), time=1.0)
    assert values["der(v1)"] == pytest.approx(math.sin(1.0) / 4.0)
    assert values["v2"] == 0.5
    assert {choice.name for choice in system.choices if not choice.is_state} == {"s2", "v2"}


def test_two_masses_with_an_offset_constraint() -> None:
    system = causalise(
        model(
            "v1 = der(s1)",
            "v2 = der(s2)",
            "m1*der(v1) = f - r",
            "m2*der(v2) = r",
            "s2 = s1 + d",
            "f = sin(time)",
            parameters={"m1": 1.0, "m2": 3.0, "d": 0.1},
        )
    )
    assert (system.index, len(system.states)) == (3, 2)
    assert system.states == ("v1", "s1")
    values = run(system, {"v1": 0.5, "s1": 0.2}, time=1.0)
    assert values["der(v1)"] == pytest.approx(math.sin(1.0) / 4.0)
    assert (values["s2"], values["v2"]) == (pytest.approx(0.3), pytest.approx(0.5))


PLANETARY = (
    "der(s.phi) = s.w",
    "der(c.phi) = c.w",
    "der(r.phi) = r.w",
    "js*der(s.w) = s.tau + ts",
    "jc*der(c.w) = c.tau",
    "jr*der(r.w) = r.tau",
    "s.phi + i*r.phi = (1 + i)*c.phi",
    "r.tau = i*s.tau",
    "c.tau = -(1 + i)*s.tau",
    "ts = 10",
)


def test_planetary_gear_set() -> None:
    ratio, js, jc, jr = 2.5, 0.02, 0.03, 0.05
    system = causalise(model(*PLANETARY, parameters={"i": ratio, "js": js, "jc": jc, "jr": jr}))
    assert (system.index, len(system.states)) == (3, 4)
    values = run(system, dict.fromkeys(system.states, 0.0))
    speeds = [values["der(s.w)"], values["der(c.w)"], values["der(r.w)"]]
    assert speeds[0] + ratio * speeds[2] == pytest.approx((1 + ratio) * speeds[1])
    # virtual work: the constraint torque does no work
    torque = values["s.tau"]
    assert js * speeds[0] == pytest.approx(torque + 10)
    assert jc * speeds[1] == pytest.approx(-(1 + ratio) * torque)
    assert all(block.kind is not BlockKind.NONLINEAR for block in system.blocks)


@pytest.mark.parametrize("held", ["s.phi", "c.phi", "r.phi"])
def test_planetary_gear_set_with_one_body_held(held: str) -> None:
    free = [e for e in PLANETARY if not e.startswith("ts")]
    system = causalise(model(*free, f"{held} = 0", parameters={"i": 2.5, "js": 0.02, "jc": 0.03, "jr": 0.05}))
    assert (system.index, len(system.states)) == (3, 2)


def tank(pressure: str, **variables: Attributes) -> CausalSystem:
    return causalise(
        model(
            "der(m) = q",
            "m = rho0*V*exp((p - p0)/K)",
            pressure,
            parameters={"rho0": 800.0, "V": 1e-3, "p0": 1e5, "K": 1e9},
            variables=variables,
        )
    )


def test_prescribed_pressure_takes_the_state_away() -> None:
    system = tank("p = p0 + smooth(2, if time < 1 then 0 else 1e6*(time - 1)^3)")
    assert (system.states, system.index) == ((), 2)
    values = run(system, {}, time=1.5)
    assert values["q"] == pytest.approx(values["m"] / 1e9 * 3e6 * 0.25)


def test_constant_pressure_takes_the_state_away() -> None:
    system = tank("p = p0")
    assert (system.states, system.index) == ((), 2)
    assert run(system, {})["q"] == 0


def test_prescribed_flow_leaves_the_state() -> None:
    assert tank("q = 0.1").states == ("m",)
    assert tank("q = 0.1").index == 1


def test_preferred_variable_becomes_the_state_though_it_is_not_differentiated() -> None:
    system = tank("q = 0.1", p={"select": StateSelect.PREFER})
    assert system.states == ("p",)
    assert run(system, {"p": 1e5})["der(p)"] == pytest.approx(0.1 / (0.8 / 1e9))


def test_prefer_gives_way_where_the_derivative_does_not_exist() -> None:
    system = causalise(
        model("der(x) = p", "p = if time < 1 then 0 else 1", variables={"p": {"select": StateSelect.PREFER}})
    )
    assert system.states == ("x",)


def test_a_jump_cannot_be_prescribed() -> None:
    with pytest.raises(ReductionProblem) as caught:
        tank("p = if time < 1 then 1e5 else 2e5")
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.code == "reduction.not-differentiable"
    assert diagnostic.span is not None
    assert diagnostic.span.line == 3
    assert "if time < 1.0 then 100000.0 else 200000.0" in diagnostic.message
    assert "smooth" in diagnostic.hint
    assert diagnostic.names[0] == "p"


def test_constant_coefficients_are_pivots_before_varying_ones() -> None:
    """A crank: s follows from phi everywhere, phi from s only away from the dead centres."""
    equations = (
        "der(phi) = w",
        "der(s) = v",
        "j*der(w) = 1 - r*cos(phi)*f",
        "m*der(v) = f",
        "s = r*sin(phi)",
    )
    for variables in (None, {"s": Attributes(start=0.3)}):
        system = causalise(model(*equations, variables=variables, parameters={"j": 1.0, "m": 1.0, "r": 0.5}))
        assert system.states == ("phi", "w")
    wished = causalise(
        model(
            *equations,
            variables={"s": {"select": StateSelect.PREFER, "start": 0.1}},
            parameters={"j": 1.0, "m": 1.0, "r": 0.5},
        )
    )
    assert set(wished.states) == {"s", "v"}


@pytest.mark.parametrize("select", [StateSelect.ALWAYS, StateSelect.PREFER])
def test_state_select_decides(select: StateSelect) -> None:
    equations = ("der(x) = a", "der(y) = b", "x = 2*y + 1", "a + b = sin(time)")
    assert causalise(model(*equations)).states == ("x",)
    assert causalise(model(*equations, variables={"y": {"select": select}})).states == ("y",)
    assert causalise(model(*equations, variables={"x": {"select": StateSelect.AVOID}})).states == ("y",)
    assert causalise(model(*equations, variables={"y": {"fixed": True, "start": 1}})).states == ("y",)
    assert causalise(model(*equations, variables={"y": {"start": 1}})).states == ("y",)


def test_always_that_cannot_be_is_an_error() -> None:
    with pytest.raises(ReductionProblem) as caught:
        causalise(model("x = sin(time)", "der(x) = y", variables={"x": {"select": StateSelect.ALWAYS}}))
    assert caught.value.codes == ("states.always-impossible",)
    both: dict[str, Attributes] = {n: {"select": StateSelect.ALWAYS} for n in ("x", "y")}
    with pytest.raises(ReductionProblem) as caught:
        causalise(model("der(x) = a", "der(y) = b", "x = 2*y", "a + b = 1", variables=both))
    assert "x = 2.0 * y" in caught.value.diagnostics[0].message


def test_redundant_constraints_are_named() -> None:
    """Structurally fine, but the second constraint is twice the first."""
    with pytest.raises(AcausalError) as caught:
        causalise(
            model(
                "der(x) = a + f",
                "der(y) = b + f - g",
                "der(z) = c - 2*f + g",
                "x + y + z = 0",
                "2*x + 2*y + 2*z = 0",
                "a + b + c = sin(time)",
                "a - b = cos(time)",
                "c = 1",
            )
        )
    assert "reduction.redundant-constraints" in caught.value.codes
    assert {"x", "y", "z"} <= set(caught.value.diagnostics[0].names)


def test_derivatives_of_expressions_are_expanded() -> None:
    system = causalise(model("der(rho*V) = q", "V = 2 + x", "der(x) = 1", "q = -rho"))
    assert system.states == ("rho", "V")
    values = run(system, {"rho": 3.0, "V": 3.0})
    assert values["der(rho)"] * 3 + 3.0 * 1.0 == pytest.approx(-3.0)
    assert causalise(model("y = der(2*time + p)", "der(x) = y", parameters={"p": 1.0})).states == ("x",)


def test_an_input_is_known_but_has_no_derivative() -> None:
    variables: dict[str, Attributes] = {"u": {"input": True}}
    assert causalise(model("der(x) = u", variables=variables)).states == ("x",)
    with pytest.raises(ReductionProblem, match="it is an input"):
        causalise(model("der(x) = y", "x = u", variables=variables))


def test_choices_explain_themselves() -> None:
    system = causalise(pendulum(x=0.9, y=-1.2))
    choices = {choice.name: choice for choice in system.choices}
    assert {n for n, c in choices.items() if c.is_state} == set(system.states)
    lost = next(c for n, c in choices.items() if not c.is_state and n.startswith("v"))
    assert "test.mo:5" in lost.reason


def test_starting_consistently() -> None:
    system = causalise(pendulum(x=0.9, y=-1.2))
    values = initialise(system, guesses={"x": 0.9, "y": -1.2})
    assert values["x"] ** 2 + values["y"] ** 2 == pytest.approx(2.25)
    assert values["x"] * values["vx"] + values["y"] * values["vy"] == pytest.approx(0)
