"""The printed text of flat models: expected text beside the model, valid Modelica, the same every time."""

from __future__ import annotations

import dataclasses

import pytest

from acausal.errors import Source
from acausal.lang.base_modelica import HEADER, print_flat
from acausal.lang.flat import (
    BOOLEAN,
    INTEGER,
    REAL,
    STRING,
    Causality,
    Experiment,
    FlatModel,
    ScalarType,
    StateSelect,
    Variability,
    Variable,
)
from acausal.symbolic.expressions.expr import EnumValue, const
from tests.lang.flat_models import assertion, equation, model, parameter, real, variable

PARAMETER, DISCRETE = Variability.PARAMETER, Variability.DISCRETE


def text_of(flat: FlatModel) -> str:
    """What is printed, after checking that it is Modelica."""
    parser = pytest.importorskip("acausal.lang.parser")
    text = print_flat(flat)
    stored = parser.parse(Source("flat.mo", text))
    assert len(stored.classes) == 1
    return text


def declaration(v: Variable) -> str:
    """The line of one variable."""
    return text_of(model([v])).splitlines()[3].strip()


def test_a_whole_model() -> None:
    flat = model(
        [
            parameter("body.m", "kg", "2.5", min="0.0", description="Mass"),
            variable("g", REAL, Variability.CONSTANT, binding="9.81", unit="m/s2"),
            real("body.x[1]", "m", start="0.1", fixed=True, state_select=StateSelect.PREFER),
            real("body.v", "m/s", display_unit="km/h", nominal="10.0", description='Speed, "fast"'),
            variable("down", BOOLEAN, DISCRETE, start="True"),
        ],
        [
            "der(body.x[1]) = body.v",
            "body.m * der(body.v) = -(body.m * g) * (1 if down else time)",
            "down = body.v < 0 or not body.v < 1",
        ],
        initial=["body.v = 0"],
        assertions=[assertion("body.m > 0", "no mass"), assertion("body.v < 10", 'too "fast"', "warning")],
        experiment=Experiment(stop_time=2.0, tolerance=1e-6),
        name="Lib.Falling",
    )
    flat = dataclasses.replace(flat, description="A body that falls")
    assert (
        text_of(flat)
        == """\
//! base 0.1.0
package 'Lib.Falling'
  model 'Lib.Falling' "A body that falls"
    parameter Real 'body.m'(unit = "kg", min = 0.0) = 2.5 "Mass";
    constant Real 'g'(unit = "m/s2") = 9.81;
    Real 'body.x[1]'(unit = "m", start = 0.1, fixed = true, stateSelect = StateSelect.prefer);
    Real 'body.v'(unit = "m/s", displayUnit = "km/h", nominal = 10.0) "Speed, \\"fast\\"";
    Boolean 'down'(start = true);
  equation
    der('body.x[1]') = 'body.v';
    'body.m' * der('body.v') = -'body.m' * 'g' * (if 'down' then 1 else time);
    'down' = 'body.v' < 0 or not 'body.v' < 1;
    assert('body.m' > 0, "no mass");
    assert('body.v' < 10, "too \\"fast\\"", AssertionLevel.warning);
  initial equation
    'body.v' = 0;
    annotation(experiment(StopTime = 2.0, Tolerance = 1e-06));
  end 'Lib.Falling';
end 'Lib.Falling';
"""
    )


def test_the_smallest_model() -> None:
    assert text_of(model([])) == f"{HEADER}\npackage 'Test'\n  model 'Test'\n  end 'Test';\nend 'Test';\n"


@pytest.mark.parametrize(
    ("v", "expected"),
    [
        (real("x"), "Real 'x';"),
        (real("x", protected=True), "Real 'x' annotation(Protected = true);"),
        (real("x", quantity="Length"), "Real 'x'(quantity = \"Length\");"),
        (real("x", min="-1e300", max="p"), "Real 'x'(min = -1e+300, max = 'p');"),
        (real("f", "N", flow=True), "Real 'f'(unit = \"N\");"),
        (real("u", causality=Causality.INPUT, top_level=True), "input Real 'u';"),
        (real("y", causality=Causality.OUTPUT, top_level=True), "output Real 'y';"),
        (real("a.u", causality=Causality.INPUT), "Real 'a.u';"),
        (
            real("u", causality=Causality.INPUT, top_level=True, protected=True),
            "Real 'u' annotation(Protected = true);",
        ),
        (variable("d", REAL, DISCRETE), "discrete Real 'd';"),
        (variable("i", INTEGER, DISCRETE, start="3"), "Integer 'i'(start = 3);"),
        (variable("s", STRING, PARAMETER, binding="'a\"b\\\\c'"), 'parameter String \'s\' = "a\\"b\\\\c";'),
        (parameter("p", fixed=False, start="1.0"), "parameter Real 'p'(start = 1.0, fixed = false);"),
        (parameter("p", value="2 * (q + 1) ** 2", final=True), "parameter Real 'p' = 2 * ('q' + 1) ^ 2;"),
        (real("'odd name'.x[1,2]"), "Real '\\'odd name\\'.x[1,2]';"),
    ],
)
def test_declarations(v: Variable, expected: str) -> None:
    assert declaration(v) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("x = a - (b - c)", "'x' = 'a' - 'b' + 'c'"),
        ("x = a - b * c / (d * 2)", "'x' = 'a' - 'b' * 'c' / (2 * 'd')"),
        ("x = -a ** 2", "'x' = -'a' ^ 2"),
        ("x = (-a) ** b", "'x' = (-'a') ^ 'b'"),
        ("x = a ** -2", "'x' = 'a' ^ (-2)"),
        ("x = a * (-2)", "'x' = (-2) * 'a'"),
        ("x = idiv(a, b) + mod(a, b)", "'x' = div('a', 'b') + mod('a', 'b')"),
        ("x = noEvent(a if a > 0 else b) + smooth(2, a * b)",
         "'x' = noEvent(if 'a' > 0 then 'a' else 'b') + smooth(2, 'a' * 'b')"),
        ("(a if a > b else b) = 0", "(if 'a' > 'b' then 'a' else 'b') = 0"),
        ("x = pre(i) + 1e-05", "'x' = pre('i') + 1e-05"),
        ("x = 0.1 + 0.2", "'x' = 0.30000000000000004"),
        ("b = a > 1 and (c or not (a <= 2))", "'b' = 'a' > 1 and ('c' or not 'a' <= 2)"),
    ],
)  # fmt: skip
def test_equations(text: str, expected: str) -> None:
    lines = text_of(model([], [text])).splitlines()
    assert lines[3:5] == ["  equation", f"    {expected};"]


def test_enumerations_are_declared_before_the_model() -> None:
    mode = ScalarType("Lib.Mode", ("off", "on"))
    on = EnumValue("Lib.Mode", "on", 2)
    other = EnumValue("Other", "b", 2)
    flat = model([variable("mode", mode, PARAMETER), variable("more", mode, DISCRETE)])
    flat = dataclasses.replace(
        flat,
        variables=(dataclasses.replace(flat.variables[0], binding=const(on)), flat.variables[1]),
        equations=(dataclasses.replace(equation("x = y"), left=const(other), right=const(on)),),
    )
    lines = text_of(flat).splitlines()
    off_text, on_text, b_text = (literal_text(literal) for literal in ("off", "on", "b"))
    assert lines[2] == f"  type 'Lib.Mode' = enumeration({off_text}, {on_text});"
    assert lines[3] == f"  type 'Other' = enumeration({b_text});"
    assert lines[5] == f"    parameter 'Lib.Mode' 'mode' = 'Lib.Mode'.{on_text};"
    assert lines[6] == "    'Lib.Mode' 'more';"
    assert lines[8] == f"    'Other'.{b_text} = 'Lib.Mode'.{on_text};"


def literal_text(literal: str) -> str:
    """Literals are spelled as `constant_text` spells them, in the type as in expressions."""
    from acausal.symbolic.expressions.text import constant_text, quoted_name

    return constant_text(EnumValue("T", literal, 1), quoted_name).partition(".")[2]


def test_experiment() -> None:
    everything = Experiment(start_time=0.0, stop_time=1.5, tolerance=1e-8, interval=0.01)
    lines = text_of(model([], experiment=everything)).splitlines()
    expected = "annotation(experiment(StartTime = 0.0, StopTime = 1.5, Tolerance = 1e-08, Interval = 0.01));"
    assert lines[3].strip() == expected


@pytest.mark.parametrize("value", [0.1, 1 / 3, 1e-300, 123456789.0, 2.0**60, 5e-324])
def test_numbers_are_exact(value: float) -> None:
    line = declaration(dataclasses.replace(parameter("p"), binding=const(value)))
    assert float(line.removesuffix(";").partition("= ")[2]) == value


def test_the_same_model_gives_the_same_text() -> None:
    def build() -> FlatModel:
        return model([real("x"), parameter("p", value="3.0")], ["der(x) = p * x"], initial=["x = 1"])

    assert print_flat(build()) == print_flat(build())
