"""What `verify` proves of a flat model: each violation has its own message, and good models pass."""

from __future__ import annotations

import dataclasses

import pytest

from acausal.errors import Diagnostic, TypeProblem
from acausal.lang.flat import (
    BOOLEAN,
    INTEGER,
    REAL,
    STRING,
    FlatModel,
    Origin,
    ScalarType,
    StateSelect,
    Variability,
    Variable,
)
from acausal.lang.verify import verify
from acausal.symbolic.expressions.expr import EnumValue, call, const, make, sym
from acausal.symbolic.expressions.kernel import Named
from acausal.symbolic.expressions.operators import OPERATORS
from tests.growth import Work, growth
from tests.lang.flat_models import assertion, equation, expression, model, parameter, real, span, variable

MODE = ScalarType("Mode", ("off", "on"))
OTHER = ScalarType("Other", ("one",))
DISCRETE, CONSTANT, PARAMETER = Variability.DISCRETE, Variability.CONSTANT, Variability.PARAMETER
VARIABLES = (
    *(real("x"), real("y"), real("z[1].v"), parameter("p", value="2.0"), parameter("q", value="p + 1")),
    *(variable("i", INTEGER, DISCRETE), variable("n", INTEGER, PARAMETER, binding="3")),
    *(variable("b", BOOLEAN, DISCRETE), variable("c", BOOLEAN, DISCRETE), variable("d", REAL, DISCRETE)),
    *(variable("s", STRING, PARAMETER, binding="'text'"), variable("K", REAL, CONSTANT, binding="1.5")),
    *(variable("mode", MODE, DISCRETE), variable("other", OTHER, DISCRETE)),
)


def problems(flat: FlatModel) -> tuple[Diagnostic, ...]:
    with pytest.raises(TypeProblem) as caught:
        verify(flat)
    return caught.value.diagnostics


def only(flat: FlatModel) -> Diagnostic:
    (found,) = problems(flat)
    return found


@pytest.mark.parametrize(
    "text",
    [
        "der(x) = -p * x + sin(time)",
        "x = i",
        "i = x",  # coerced, and solved for x (Modelica 3.6, 3.8)
        "x = n * y + 2",
        "x = y if b else n",
        "x = y if y > 0 else 1",
        "b = x > 0",
        "b = x > 0 and not c or i == 3",
        "b = c",
        "mode = pre(mode)",
        "b = mode == mode",
        "b = mode < mode",
        "b = s == s",
        "i = integer(x)",
        "i = integer(mode)",
        "i = idiv(i, 2)",
        "x = mod(x, 2) + rem(i, 2) + floor(y) + ceil(y)",
        "x = min(x, n) + max(i, 1) + abs(i) + sign(x)",
        "x = noEvent(y if x > y else 0)",
        "x = noEvent(y if x == y else 0)",
        "x = y if p == 2 else 0",
        "x = smooth(1, y if x > y else 0)",
        "der(z[1].v) = atan2(x, y) ** 2 / sqrt(x)",
        "x = der(p) + der(K)",
        "x = d",
        "x = y if i == n else pre(d)",
        "b = floor(x) > 0",
    ],
)
def test_well_formed_equations(text: str) -> None:
    verify(model(VARIABLES, [text]))


@pytest.mark.parametrize(
    ("text", "code", "message"),
    [
        ("x = unknown", "flat.unknown-name", "`unknown` is not declared"),
        ("x = b", "type.equation", "different types: `x` is a Real, `b` is a Boolean"),
        ("b = i", "type.equation", "`b` is a Boolean, `i` is an Integer"),
        ("mode = other", "type.equation", "a value of the enumeration Mode, `other` is a value of the enum"),
        ("x = s", "type.equation", "`s` is a String"),
        ("x = y + b", "type.operand", "`+` needs numbers, but `b` is a Boolean"),
        ("x = -b", "type.operand", "`-` needs numbers"),
        ("x = s * 2", "type.operand", "`*` needs numbers, but `s` is a String"),
        ("x = y / mode", "type.operand", "`/` needs numbers, but `mode` is a value of the enumeration Mode"),
        ("x = sin(b)", "type.operand", "`sin` needs numbers"),
        ("i = integer(s)", "type.operand", "`integer` needs numbers"),
        ("b = x and c", "type.operand", "`and` needs Booleans, but `x` is a Real"),
        ("b = not x", "type.operand", "`not` needs Booleans"),
        (
            "x = y if p else 0",
            "type.condition",
            "the condition of an `if` must be Boolean, but `p` is a Real",
        ),
        ("x = y if b else c", "type.mismatch", "both branches of an `if` must have one type"),
        ("b = x > c", "type.mismatch", "both sides of `>` must have one type"),
        ("b = mode == other", "type.mismatch", "both sides of `==`"),
        ("x = min(x, b)", "type.mismatch", "both sides of `min`"),
        ("b = x == y", "type.real-equality", "`x == y` compares Reals for equality"),
        ("b = x != 0", "type.real-equality", "`x <> 0` compares Reals"),
        ("x = y if x == i else 0", "type.real-equality", "`x == i`"),
        ("x = der(i)", "type.der", "der needs a continuous Real, but `i` is an Integer"),
        ("x = der(d)", "type.der", "`d` is discrete and has no derivative"),
        ("x = der(floor(y))", "type.der", "`floor(y)` is discrete"),
        ("x = pre(y)", "type.pre", "pre needs a discrete variable, but `y` is continuous"),
        ("d = pre(d + 1)", "type.pre", "pre needs a variable, not `d + 1`"),
        ("b = noEvent(x > 1)", "type.discrete", "`noEvent(x > 1)` is continuous"),
        ("i = sign(x)", "type.discrete", "`sign(x)` is continuous"),
        ("x = f(y)", "flat.function-call", "a call of the function f is left"),
    ],
)
def test_ill_formed_equations(text: str, code: str, message: str) -> None:
    found = only(model(VARIABLES, [text]))
    assert found.code == code
    assert message in found.message
    assert found.span is not None
    assert found.span.text == text
    assert found.severity == "error"


def test_messages_name_the_variables() -> None:
    assert only(model(VARIABLES, ["x = y + b"])).names == ("y", "b")
    assert only(model(VARIABLES, ["x = b"])).names == ("x", "b")


def test_unknown_name_suggests_a_near_one() -> None:
    assert only(model(VARIABLES, ["x = z[1].w"])).hint == "did you mean `z[1].v`?"


def test_connected_variables_of_different_types() -> None:
    flat = model(VARIABLES, [equation("x = b", Origin.CONNECTION)])
    assert only(flat).message == "connected variables have different types: `x` is a Real, `b` is a Boolean"


def test_every_wrong_equation_is_reported_up_to_twenty() -> None:
    assert [p.code for p in problems(model(VARIABLES, ["x = b", "y = w", "x = y"]))] == [
        "type.equation",
        "flat.unknown-name",
    ]
    assert len(problems(model(VARIABLES, ["x = b"] * 30))) == 20


def test_a_shared_wrong_part_is_reported_in_each_equation() -> None:
    found = problems(model(VARIABLES, ["x = y + sin(b)", "y = 2 * sin(b)"]))
    assert [p.span.text for p in found if p.span] == ["x = y + sin(b)", "y = 2 * sin(b)"]


@pytest.mark.parametrize("texts", [("x = noEvent(1 if y == 0 else 2)", "z[1].v = 1 if y == 0 else 2")] * 2)
def test_equality_allowed_in_one_place_is_not_in_another(texts: tuple[str, str]) -> None:
    for order in (texts, texts[::-1]):
        found = only(model(VARIABLES, list(order)))
        assert found.code == "type.real-equality"
        assert found.span is not None
        assert found.span.text == texts[1]


# ------------------------------------------------------------------------------ initial equations, assertions


def test_everything_is_discrete_in_initial_equations() -> None:
    verify(model(VARIABLES, initial=["x = pre(y)", "b = noEvent(x > 1)", "der(x) = 0"]))


def test_initial_equations_have_types() -> None:
    assert only(model(VARIABLES, initial=["x = b"])).code == "type.equation"


def test_assertions() -> None:
    verify(model(VARIABLES, assertions=[assertion("x > 0 and p > 0")]))
    found = only(model(VARIABLES, assertions=[assertion("x + 1")]))
    assert found.code == "type.assertion"
    assert found.message == "the condition of an assert must be a Boolean, but `x + 1` is a Real"
    silent = dataclasses.replace(assertion("x > 0"), message=const(1))
    assert only(model(VARIABLES, assertions=[silent])).message.startswith(
        "the message of an assert must be a"
    )
    assert only(model(VARIABLES, assertions=[assertion("w > 0")])).code == "flat.unknown-name"


# ------------------------------------------------------------------------------ declarations


def test_duplicate_names() -> None:
    found = only(model([real("x"), real("y"), real("x")]))
    assert (found.code, found.names) == ("flat.duplicate-name", ("x",))
    assert found.hint == "the other declaration is at Test.mo:1:1"


def test_time_is_not_declared() -> None:
    assert "simulation time" in only(model([real("time")])).message


@pytest.mark.parametrize(
    ("declaration", "code", "message"),
    [
        (
            parameter("k", value="x"),
            "flat.variability",
            "the value of the parameter `k` may use parameters and",
        ),
        (parameter("k", value="time"), "flat.variability", "but `time` is continuous"),
        (parameter("k", value="pre(d)"), "flat.variability", "but `d` is discrete"),
        (parameter("k", value="der(p)"), "flat.variability", "`der(p)` varies with time"),
        (
            variable("k", REAL, CONSTANT, binding="p"),
            "flat.variability",
            "constants only, but `p` is a parameter",
        ),
        (
            real("k", start="x"),
            "flat.variability",
            "the attribute start of `k` may use parameters and constants",
        ),
        (real("k", nominal="2 * y"), "flat.variability", "the attribute nominal of `k`"),
        (parameter("k", value="nothing"), "flat.unknown-name", "`nothing` is not declared"),
        (real("k", max="nothing"), "flat.unknown-name", "`nothing` is not declared"),
        (parameter("k", value="True"), "type.value", "`k` is a Real, but its value `true` is a Boolean"),
        (
            variable("k", INTEGER, PARAMETER, binding="1.5"),
            "type.value",
            "`k` is an Integer, but its value `1.5`",
        ),
        (variable("k", INTEGER, PARAMETER, binding="p"), "type.value", "`p` is a Real"),
        (variable("k", MODE, PARAMETER, binding="1"), "type.value", "a value of the enumeration Mode"),
        (variable("k", STRING, PARAMETER, binding="1"), "type.value", "`k` is a String"),
        (real("k", start="'zero'"), "type.attribute", 'its start `"zero"` is a String'),
        (variable("k", BOOLEAN, DISCRETE, start="0"), "type.attribute", "its start `0` is an Integer"),
        (variable("k", BOOLEAN, DISCRETE, min="False"), "type.attribute", "has no attribute min"),
        (
            variable("k", INTEGER, DISCRETE, unit="m"),
            "type.attribute",
            "an Integer, which has no attribute unit",
        ),
        (variable("k", INTEGER, DISCRETE, nominal="1"), "type.attribute", "no attribute nominal"),
        (variable("k", BOOLEAN, DISCRETE, state_select=StateSelect.PREFER), "type.attribute", "stateSelect"),
        (variable("k", INTEGER, DISCRETE, flow=True), "type.flow", "the flow variable `k` must be a Real"),
        (variable("k", BOOLEAN, Variability.CONTINUOUS), "flat.variability", "a Boolean and so discrete"),
        (real("k", binding="1.0"), "flat.binding", "must be an equation of the flat model"),
        (parameter("k", value="p + s"), "type.operand", "`+` needs numbers, but `s` is a String"),
    ],
)
def test_ill_formed_declarations(declaration: Variable, code: str, message: str) -> None:
    found = only(model([*VARIABLES, declaration]))
    assert found.code == code
    assert message in found.message
    assert "k" in found.names
    assert found.span == declaration.span


def test_well_formed_declarations() -> None:
    on = const(EnumValue("Mode", "on", 2))
    mode = dataclasses.replace(variable("m", MODE, PARAMETER, start="1"), start=on, binding=on)
    more = [
        parameter("k", value="n * K + q"),
        variable("l", INTEGER, PARAMETER, binding="n + 1", min="0", max="n"),
        real("v", start="p", min="-K", max="10", nominal="q", fixed=True, flow=True),
        parameter("free", fixed=False),
        mode,
    ]
    verify(model([*VARIABLES, *more], [equation("v = x")]))


# ------------------------------------------------------------------------------ completeness and scale


@pytest.mark.parametrize("op", [name for name, entry in OPERATORS.items() if entry.shape != "leaf"])
def test_every_operator_has_a_rule(op: str) -> None:
    """Whatever the arguments, an operator is typed or refused, never forgotten."""
    arity = OPERATORS[op].arity or 2
    args = tuple(map(expression, ("b", "x", "y")[:arity]))
    node = call(Named("f", 2), *args) if op == "call" else make(op, args, 1 if op == "smooth" else None)
    flat = model(VARIABLES)
    wrong = dataclasses.replace(equation("x = y"), right=node)
    codes = codes_of(dataclasses.replace(flat, equations=(wrong,)))
    assert all(code.startswith(("type.", "flat.")) for code in codes)


def codes_of(flat: FlatModel) -> tuple[str, ...]:
    try:
        verify(flat)
    except TypeProblem as problem:
        return problem.codes
    return ()


def test_wrong_number_of_arguments() -> None:
    node = make("atan2", (sym("x"),))
    wrong = dataclasses.replace(equation("x = y"), right=node)
    flat = dataclasses.replace(model(VARIABLES), equations=(wrong,))
    assert only(flat).message == "atan2 takes 2 arguments, not 1"


def chain(length: int) -> FlatModel:
    equations = [equation(f"v[{i}] = der(x[{i}]) + (v[{i + 1}] - v[{i}]) * k") for i in range(length)]
    names = [real(f"{kind}[{i}]") for i in range(length + 1) for kind in ("x", "v")]
    return model([*names, parameter("k", value="1.0")], equations)


def test_time_for_each_equation_does_not_grow() -> None:
    def prepare(size: int) -> Work:
        flat = chain(size)
        return lambda: verify(flat)

    assert growth(prepare, 1_000, 10_000) < 3


def test_a_deep_expression_needs_no_stack() -> None:
    node = sym("x")
    for _ in range(20_000):
        node = make("sin", (node,))
    deep = dataclasses.replace(equation("x = y"), right=node)
    verify(dataclasses.replace(model(VARIABLES), equations=(deep,)))


def test_span_of_a_declaration_is_its_own() -> None:
    assert only(model([*VARIABLES, parameter("k", value="x")])).span == span("k")
