"""The initial problem: determined, under- and over-determined, with parameters to be found."""

from __future__ import annotations

import pytest

from acausal.errors import InitializationProblem
from acausal.symbolic.causal import CausalSystem
from acausal.symbolic.causalise import causalise
from acausal.symbolic.expressions.text import to_text
from tests.symbolic.build import Attributes, model, pendulum
from tests.symbolic.numeric import initialise


def report(system: CausalSystem) -> dict[str, tuple[str, str]]:
    return {value.name: (to_text(value.value), value.reason) for value in system.initial.values}


def test_fixed_and_assumed_starts_of_states() -> None:
    variables: dict[str, Attributes] = {"x": {"start": 2, "fixed": True}, "y": {"start": "3*p"}}
    system = causalise(
        model("der(x) = y", "der(y) = z", "z = -x", variables=variables, parameters={"p": 0.5})
    )
    assert report(system) == {"x": ("2.0", "fixed"), "y": ("3.0 * p", "assumed")}
    values = initialise(system)
    assert (values["x"], values["y"], values["der(y)"]) == (2, 1.5, -2)


def test_an_initial_equation_takes_the_place_of_a_start() -> None:
    system = causalise(model("der(x) = 1 - x", "der(y) = x - y", initial=["der(y) = 0"]))
    assert report(system) == {"x": ("0.0", "assumed")}
    assert initialise(system)["y"] == 0
    steady = causalise(model("der(x) = 1 - x", "der(y) = x - y", initial=["der(x) = 0", "der(y) = 0"]))
    assert report(steady) == {}
    assert (initialise(steady)["x"], initialise(steady)["y"]) == (1, 1)


def test_a_fixed_algebraic_variable_determines_the_state() -> None:
    variables: dict[str, Attributes] = {"y": {"start": 6, "fixed": True}, "x": {"start": 9}}
    system = causalise(model("der(x) = -x", "y = 2*x", variables=variables))
    assert report(system) == {"y": ("6.0", "fixed")}
    assert initialise(system)["x"] == 3


def test_redundant_conditions_become_checks() -> None:
    variables: dict[str, Attributes] = {"x": {"start": 2, "fixed": True}, "y": {"start": 4, "fixed": True}}
    system = causalise(model("der(x) = -x", "y = 2*x", variables=variables))
    assert len(system.initial.checks) == 1
    assert initialise(system)["y"] == 4
    contradictory = causalise(
        model("der(x) = -x", "y = 2*x", variables={**variables, "y": {"start": 5, "fixed": True}})
    )
    with pytest.raises(AssertionError):
        initialise(contradictory)


def test_constrained_starts_are_consistent() -> None:
    """Both angles fixed though one follows from the other: the second becomes a check."""
    variables: dict[str, Attributes] = {
        "a.phi": {"start": 2, "fixed": True},
        "b.phi": {"start": 1, "fixed": True},
    }
    system = causalise(
        model(
            "der(a.phi) = a.w", "der(b.phi) = b.w", "der(a.w) = t", "der(b.w) = 1 - 2*t", "a.phi = 2*b.phi",
            variables=variables,
        )
    )  # fmt: skip
    assert len(system.initial.checks) == 1
    assert initialise(system)["b.phi"] == 1


def test_a_parameter_is_found_from_an_initial_equation() -> None:
    system = causalise(
        model(
            "der(x) = -k*x + u",
            "u = 2",
            variables={"x": {"start": 4, "fixed": True}},
            parameters={"k": 0.1},
            free_parameters=["k"],
            initial=["der(x) = 0"],
        )
    )
    assert initialise(system)["k"] == pytest.approx(0.5)


def test_a_free_parameter_without_equation_uses_its_start() -> None:
    system = causalise(model("der(x) = -k*x", parameters={"k": 0.1}, free_parameters=["k"]))
    assert report(system) == {"x": ("0.0", "assumed"), "k": ("0.1", "assumed")}
    assert initialise(system)["k"] == 0.1


@pytest.mark.parametrize(
    ("attributes", "start"),
    [
        ({}, "0.0"),
        ({"min": 2}, "2.0"),
        ({"min": -2}, "0.0"),
        ({"max": -3}, "-3.0"),
        ({"min": 1, "start": 5}, "5.0"),
    ],
)
def test_default_starts_lie_within_the_bounds(attributes: Attributes, start: str) -> None:
    system = causalise(model("der(x) = 1", variables={"x": attributes}))
    assert report(system)["x"] == (start, "assumed")


def test_guesses_of_nonlinear_blocks_are_reported() -> None:
    system = causalise(pendulum(x=0.9, y=-1.2))
    reasons = {name: reason for name, (_, reason) in report(system).items()}
    assert sorted(reasons.values()) == ["assumed", "assumed", "guess"]


def test_states_are_assumed_before_anything_else() -> None:
    system = causalise(model("der(x) = -x", "y = 2*x", "w = y + x", variables={"y": {"start": 4}}))
    assert report(system) == {"x": ("0.0", "assumed")}
    other = causalise(
        model(
            "der(x) = -x", "der(v) = x", initial=["x*x = 4"], variables={"x": {"start": 1}, "v": {"start": 3}}
        )
    )
    assert report(other)["v"] == ("3.0", "assumed")
    assert report(other)["x"] == ("1.0", "guess")
    assert initialise(other, guesses={"x": 1.0})["x"] == pytest.approx(2.0)


def test_what_cannot_be_determined_is_named() -> None:
    """The initial equations leave no room for the only variable that could be assumed."""
    system = causalise(model("der(x) = 1", initial=["der(x) = 1"]))
    assert len(system.initial.checks) == 1
    assert report(system) == {"x": ("0.0", "assumed")}


def test_errors_are_typed() -> None:
    with pytest.raises(InitializationProblem):
        causalise(model("x = 3", variables={"x": {"start": 1, "fixed": True}}))
