"""Alias elimination: what disappears, what stands for it, and that the solution does not change."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

import acausal
from acausal.errors import AcausalError, BalanceProblem, InitializationProblem
from acausal.lang.flat import BOOLEAN, INTEGER, FlatModel, StateSelect
from acausal.symbolic.alias import Simplified, eliminate_aliases
from acausal.symbolic.causalise import causalise
from acausal.symbolic.expressions.text import to_text
from acausal.symbolic.parameters import parameter_values
from tests.symbolic.build import Attributes, model
from tests.symbolic.numeric import run


def simplified(flat: FlatModel) -> Simplified:
    return eliminate_aliases(flat, parameter_values(flat))


def aliases(*equations: str, **variables: Attributes) -> dict[str, str]:
    found = simplified(model(*equations, variables=variables, parameters={"p": 3.0, "q": 4.0}))
    return {alias.name: to_text(alias.value) for alias in found.aliases}


def test_what_cancels_once_aliases_are_replaced_is_gone() -> None:
    """The loop over c is none: 0 = a + c - b with b = c leaves c out."""
    found = simplified(model("b = c", "0 = a + c - b - 1", "c = a^2"))
    (equation,) = [e for e in found.equations if "a ^ 2" not in to_text(e.right)]
    assert "c" not in to_text(equation.right) + to_text(equation.left)
    assert "b" not in to_text(equation.right) + to_text(equation.left)


@pytest.mark.parametrize(
    ("equation", "value"),
    [
        ("b = a", "a"),
        ("b = -a", "-a"),
        ("a + b = 0", "-a"),
        ("0 = a - b", "a"),
        ("2*a = 2*b", "a"),
        ("3*b + 3*a = 0", "-a"),
        ("b = p", "p"),
        ("b = p*q + 1", "p * q + 1.0"),
        ("2*b - p = 0", "p / 2.0"),
        ("b = 5", "5.0"),
    ],
)
def test_forms(equation: str, value: str) -> None:
    assert aliases("der(a) = a + b", equation) == {"b": value}


@pytest.mark.parametrize(
    "equation",
    ["b = 2*a", "b = a + p", "b*p = 1", "b = a*p", "b = time", "b = -der(a)", "b^2 = p", "b = sin(a)"],
)
def test_what_is_no_alias(equation: str) -> None:
    assert aliases("der(a) = a + b", equation) == {}


def test_chains_and_signs() -> None:
    found = aliases("a = -b", "b = c", "c = -d", "der(d) = a + 1")
    assert found == {"a": "d", "b": "-d", "c": "-d"}


def test_constants_spread() -> None:
    found = aliases("c = a*b", "a = p", "b = -a", "d = c + a", "der(x) = d")
    assert found == {"a": "p", "b": "-p", "c": "-p * p", "d": "-p * p + p"}


def test_opposite_and_equal_means_zero() -> None:
    assert aliases("a = b", "a = -b", "der(x) = a") == {"a": "0.0", "b": "0.0"}


def test_types_do_not_mix() -> None:
    assert aliases("n = x", "der(x) = 1", n={"type": INTEGER, "discrete": True}) == {}
    found = aliases("b = c", "c = x > 1", "der(x) = 1", b={"type": BOOLEAN}, c={"type": BOOLEAN})
    assert found == {"c": "b"}


@pytest.mark.parametrize(
    ("attributes", "kept"),
    [
        ({"u.port.v": {}, "u.v": {}}, "u.v"),  # the connector yields to the component
        ({"u.v": {}, "top": {}}, "top"),
        ({"top": {}, "u.v": {"start": 1}}, "u.v"),
        ({"top": {"start": 1}, "u.v": {"start": 1, "fixed": True}}, "u.v"),
        ({"top": {"start": 1, "fixed": True}, "u.v": {"select": StateSelect.PREFER}}, "u.v"),
        ({"first": {}, "second": {}}, "first"),
    ],
)
def test_the_representative(attributes: dict[str, Attributes], kept: str) -> None:
    a, b = attributes
    found = simplified(model(f"{a} = {b}", f"{a} = time", variables=attributes))
    assert [v.name for v in found.unknowns] == [kept]


def test_a_differentiated_variable_represents_its_class() -> None:
    found = simplified(model("top = u.port.x", "der(u.port.x) = 1"))
    assert [v.name for v in found.unknowns] == ["u.port.x"]


def test_the_highest_given_state_select_counts() -> None:
    variables: dict[str, Attributes] = {
        "y": {"select": StateSelect.NEVER},
        "z": {"select": StateSelect.AVOID},
    }
    (x,) = simplified(model("der(x) = 1", "y = -x", "z = x", variables=variables)).unknowns
    assert (x.name, x.state_select) == ("x", StateSelect.AVOID)


def test_merged_values() -> None:
    variables: dict[str, Attributes] = {
        "x": {"min": -5, "max": 9, "select": StateSelect.PREFER},
        "y": {"nominal": 10, "min": -3, "start": 2, "fixed": True},
        "z": {"start": 7, "nominal": 1, "max": 4},
    }
    (x,) = simplified(model("der(x) = 1", "y = -x", "z = x", variables=variables)).unknowns
    assert x.name == "x"
    assert [to_text(e) for e in (x.start, x.nominal, x.min, x.max) if e is not None] == [
        "-2.0",
        "10.0",
        "-5.0",
        "3.0",
    ]
    assert (x.fixed, x.state_select) == (True, StateSelect.PREFER)


def test_two_fixed_starts_must_agree() -> None:
    fixed: Attributes = {"start": 1, "fixed": True}
    variables: dict[str, Attributes] = {"x": fixed, "y": {"start": -1, "fixed": True}}
    (x,) = simplified(model("der(x) = 1", "y = -x", variables=variables)).unknowns
    assert x.fixed
    with pytest.raises(InitializationProblem) as caught:
        simplified(model("der(x) = 1", "y = x", variables=variables))
    assert caught.value.codes == ("start.conflict", "start.conflict")
    lines = [d.span.line for d in caught.value.diagnostics if d.span is not None]
    assert lines == [3, 4]
    assert "it is an alias of `y`" in caught.value.diagnostics[0].message
    variables["y"] = fixed
    with pytest.raises(InitializationProblem) as caught:
        simplified(model("der(x) = 1", "y = -x", variables=variables))
    assert "it is the negative of `y`" in caught.value.diagnostics[0].message


def test_a_fixed_start_must_agree_with_a_constant_value() -> None:
    assert simplified(model("x = 3", variables={"x": {"start": 3, "fixed": True}})).initial_equations == ()
    with pytest.raises(InitializationProblem, match=r"its value is 3.0 by `x = 3.0`"):
        simplified(model("x = 3", variables={"x": {"start": 1, "fixed": True}}))


def test_a_named_derivative_replaces_the_leaf() -> None:
    found = simplified(model("w = der(phi)", "a = der(w)", "a = -k*phi", parameters={"k": 1.0}))
    assert {(entry.of, entry.derivative) for entry in found.named} == {("phi", "w"), ("w", "a")}
    assert [to_text(e.right) for e in found.equations] == ["-k * phi"]
    assert found.aliases == ()
    system = causalise(model("w = der(phi)", "a = der(w)", "a = -phi"))
    assert set(system.states) == {"w", "phi"}
    values = run(system, {"w": 0.5, "phi": 2.0})
    assert (values["der(phi)"], values["der(w)"], values["a"]) == (0.5, -2.0, -2.0)


def test_a_derivative_chain_never_bites_its_tail() -> None:
    system = causalise(model("x = der(y)", "y = der(x)"))
    assert len(system.states) == 2
    system = causalise(model("x = der(x)"))
    assert run(system, {"x": 2.0})["der(x)"] == 2.0


def test_equal_speeds_of_different_angles() -> None:
    """One variable cannot name the derivatives of two: both angles stay states."""
    system = causalise(model("w1 = der(phi1)", "w2 = der(phi2)", "w1 = w2", "w1 = sin(time)"))
    assert set(system.states) == {"phi1", "phi2"}
    values = run(system, {"phi1": 0.1, "phi2": 0.2}, time=1.0)
    assert values["der(phi1)"] == values["der(phi2)"] == pytest.approx(0.8414709848)


def test_a_speed_that_is_opposite_to_another() -> None:
    system = causalise(model("w1 = der(phi1)", "w2 = der(phi2)", "w1 = -w2", "w1 = sin(time)"))
    values = run(system, {"phi1": 0.1, "phi2": 0.2}, time=1.0)
    assert values["der(phi2)"] == pytest.approx(-values["der(phi1)"])


def test_an_angle_that_is_held() -> None:
    system = causalise(model("w = der(phi)", "phi = 3", "j*der(w) = tau", parameters={"j": 1.0}))
    assert (system.states, system.index) == ((), 3)
    assert run(system, {})["tau"] == 0


def test_a_loop_of_aliases_is_a_surplus_equation() -> None:
    with pytest.raises(BalanceProblem) as caught:
        simplified(model("a = b", "b = c", "c = a"))
    (diagnostic,) = caught.value.diagnostics
    assert diagnostic.code == "alias.loop"
    assert set(diagnostic.names) == {"a", "b", "c"}
    assert "test.mo:1" in diagnostic.message
    assert "test.mo:2" in diagnostic.message
    assert diagnostic.span is not None
    assert diagnostic.span.line == 3


@pytest.mark.parametrize(
    "equations", [("a = a + 1",), ("a = 1", "b = 2", "a = b"), ("a = b", "b = a + 1"), ("a = 1", "2*a = 3")]
)
def test_contradictions(equations: tuple[str, ...]) -> None:
    with pytest.raises(BalanceProblem) as caught:
        simplified(model(*equations))
    assert set(caught.value.codes) == {"alias.contradiction"}
    assert all(d.span is not None and d.names for d in caught.value.diagnostics)


def test_two_values_name_both_lines() -> None:
    with pytest.raises(BalanceProblem) as caught:
        simplified(model("a = 1", "b = 2", "a = b"))
    messages = " ".join(d.message for d in caught.value.diagnostics)
    assert "test.mo:3" in messages
    assert "1.0" in messages
    assert "2.0" in messages


@st.composite
def linear_models(draw: st.DrawFn) -> tuple[list[str], list[str]]:
    """A small linear ODE, and the same with every use of a variable going through its own alias."""
    n = draw(st.integers(2, 4))
    plain: list[str] = []
    with_aliases: list[str] = []
    for i in range(n):
        terms = [(draw(st.integers(-3, 3)), j) for j in range(n)]
        plain.append(f"der(x{i}) = 1 + " + " + ".join(f"({a})*x{j}" for a, j in terms))
        with_aliases.append(f"der(x{i}) = 1 + " + " + ".join(f"({a})*c{i}.x{j}" for a, j in terms))
        for j in range(n):
            sign = draw(st.sampled_from(["", "-"]))
            with_aliases += [f"c{i}.x{j} = {sign}m{i}.x{j}", f"{sign}m{i}.x{j} - x{j} = 0"]
    return plain, draw(st.permutations(with_aliases))


@given(linear_models())
def test_aliases_do_not_change_the_solution(models: tuple[list[str], list[str]]) -> None:
    plain, with_aliases = (causalise(model(*equations)) for equations in models)
    assert set(plain.states) == set(with_aliases.states)
    assert len(with_aliases.aliases) == 2 * len(plain.states) ** 2
    states = {name: 0.3 + 0.2 * i for i, name in enumerate(plain.states)}
    expected, found = run(plain, states), run(with_aliases, states)
    for name, value in expected.items():
        assert found[name] == pytest.approx(value)


def test_a_chain_of_ten_thousand_aliases() -> None:
    equations = [f"v{i} = v{i + 1}" for i in range(10000)]
    found = simplified(model(*equations[::-1], "der(v5000) = 1"))
    assert len(found.aliases) == 10000
    assert [v.name for v in found.unknowns] == ["v5000"]


def test_every_error_is_typed() -> None:
    with pytest.raises(AcausalError):
        causalise(model("a = b", "b = c", "c = a"))


NO_GROUND = """
package Circuit
  connector Pin
    Real v;
    flow Real i;
  end Pin;
  model Resistor
    Pin p, n;
  equation
    p.i + n.i = 0;
    p.v - n.v = p.i;
  end Resistor;
  model Source
    Pin p, n;
  equation
    p.i + n.i = 0;
    p.v - n.v = 1;
  end Source;
  model NoGround
    Source source;
    Resistor load;
  equation
    connect(source.p, load.p);
    connect(source.n, load.n);
  end NoGround;
end Circuit;
"""


def test_a_circuit_without_ground_is_told_that_it_needs_one() -> None:
    with pytest.raises(BalanceProblem) as caught:
        acausal.loads(NO_GROUND, "Circuit.NoGround").compile()
    (found,) = caught.value.diagnostics
    assert found.code == "alias.loop"
    assert "ground" in found.hint
    assert "load.n.i" in found.names
    assert found.span is not None
    assert found.span.line == 24


def test_two_values_name_the_way_between_them() -> None:
    with pytest.raises(BalanceProblem) as caught:
        simplified(model("a.v = 1", "b.v = 2", "a.v = c", "c = -d", "d = -b.v"))
    assert [d.span.line for d in caught.value.diagnostics if d.span is not None] == [2, 1]
    message = caught.value.diagnostics[0].message
    for line in (1, 3, 4, 5):
        assert f"test.mo:{line}" in message


def test_plain_pairs_are_those_that_rewriting_would_find() -> None:
    """The same classes whether an equation is a pair as written or becomes one."""
    plain = simplified(model("x = y", "0 = y + z", "z - w = 0", "der(w) = w"))
    rewritten = simplified(model("2 * x = 2 * y", "-y = z", "z = w", "der(w) = w"))
    assert {a.name: a.value for a in plain.aliases} == {a.name: a.value for a in rewritten.aliases}
    assert [(a.name, to_text(a.value)) for a in plain.aliases] == [("x", "-w"), ("y", "-w"), ("z", "w")]


def test_equal_discrete_variables_may_differ_before_the_start() -> None:
    text = """model M
      Integer i(start = 3, fixed = true), k(start = 5, fixed = true), n(start = 0, fixed = true);
      Integer a = pre(i), b = pre(k), alone(start = 5, fixed = true);
    equation
      when sample(1, 1) then n = pre(n) + 1; end when;
      i = n;
      k = i;
      alone = k;
    end M;"""
    result = acausal.loads(text).compile().simulate(stop_time=1.5)
    values = [[int(result.values(name)[k]) for name in ("a", "b", "k", "alone")] for k in (0, -1)]
    assert values == [[0, 0, 0, 0], [1, 1, 1, 1]]


def test_attributes_of_aliases_that_do_not_fit_are_told() -> None:
    text = """model M
      Real x(min = 1, stateSelect = StateSelect.always), y(min = 1, stateSelect = StateSelect.never);
    equation der(x) = 1; x = -y; end M;"""
    select, bounds = acausal.loads(text).compile().warnings
    assert select.code == "alias.state-select"
    assert select.names == ("y", "x")
    assert bounds.code == "alias.range"
    assert "at least 1" in bounds.message
    assert "at most -1" in bounds.message
    fitting = text.replace("x = -y", "x = y").replace("StateSelect.never", "StateSelect.prefer")
    assert not acausal.loads(fitting).compile().warnings


def test_a_parameter_that_only_its_start_gives_a_value_is_told() -> None:
    model = acausal.loads("model M parameter Real p(start = 3); Real x = p; end M;")
    (warning,) = model.compile().warnings
    assert warning.code == "parameter.start-used"
