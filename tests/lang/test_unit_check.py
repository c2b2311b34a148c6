"""Provable unit clashes are errors, doubtful ones warnings, and correct physics is silent."""

from __future__ import annotations

import pytest

from acausal.errors import Diagnostic
from acausal.lang.flat import INTEGER, Origin, Variability
from acausal.lang.unit_check import check_units
from tests.growth import Work, growth
from tests.lang.flat_models import assertion, equation, model, parameter, real, variable

# A physicist's alphabet: every equation below is written in these.
VARIABLES = (
    *(real("x", "m"), real("y", "m"), real("xmm", "mm"), real("s", "m"), real("r", "m"), real("L", "m")),
    *(real("v", "m/s"), real("a", "rad/s2"), real("acc", "m/s2"), real("w", "rad/s"), real("phi", "rad")),
    *(
        real("m", "kg"),
        real("J", "kg.m2"),
        real("tau", "N.m"),
        real("f", "N"),
        real("P", "W"),
        real("E", "J"),
    ),
    *(real("p", "Pa"), real("dp", "Pa"), real("pbar", "bar"), real("rho", "kg/m3"), real("q", "m3/s")),
    *(
        real("A", "m2"),
        real("c", "1"),
        real("T", "K"),
        real("TC", "degC"),
        real("TC2", "degC"),
        real("t", "s"),
    ),
    *(real("b", "N.m.s/rad"), real("C", "m3/Pa"), real("h", "J/kg"), real("deg", "deg"), real("freq", "Hz")),
    *(real("k"), real("g"), variable("n", INTEGER, Variability.PARAMETER)),
)


def check(text: str, origin: Origin = Origin.EQUATION) -> tuple[Diagnostic, ...]:
    return check_units(model(VARIABLES, [equation(text, origin)]))


def only(found: tuple[Diagnostic, ...]) -> Diagnostic:
    assert len(found) == 1, found
    return found[0]


@pytest.mark.parametrize(
    "text",
    [
        "tau = J * a",
        "P = tau * w",
        "v = w * r",
        "q = c * sqrt(2 * dp / rho) * A",
        "q = c * A * sqrt(2 / rho) * dp / sqrt(abs(dp))",
        "E = 0.5 * m * v ** 2",
        "phi = s / r",
        "v = der(x)",
        "w = der(phi)",
        "a = der(der(phi))",
        "m * der(v) + f = 0",
        "0 = m * der(v) + f",
        "q = C * der(p)",
        "x = x + y",
        "x = x + 1",
        "x = 2.5",
        "v = 9.81 * t",  # the number may be an acceleration
        "x = 1000 * t",
        "x = 0.1 * t",
        "x = t / 0.5",
        "E = m / 3.0",
        "v = 2 * 9.81 * t",
        "0 = x",
        "x = k * t",
        "x = k",
        "k = x / t",
        "k + x = t * k",
        "n = n * 2",
        "x = n * y",
        "c = 1 - phi",
        "c = phi + w * t",
        "w = freq",
        "w = 6.283185307179586 * freq",
        "TC = T - 273.15",
        "T = TC + 273.15",
        "TC - TC2 = T - T",
        "h = 4182 * (TC - TC2)",
        "TC = TC2",
        "xmm = 1000 * x",
        "deg = phi * 180 / 3.141592653589793",
        "p = max(p, 0)",
        "p = min(p, dp)",
        "f = f if x > 0 else 0",
        "f = f if x > 0 else -f",
        "v = sign(v) * abs(v)",
        "dp = rho * v * abs(v) / 2",
        "c = sin(phi) + cos(w * t)",
        "c = exp(-t / 2)",
        "c = exp(p / dp)",
        "phi = atan2(x, y)",
        "x = pre(x)",
        "x = noEvent(x if x > y else y)",
        "x = smooth(1, y)",
        "0 = noEvent(x - y if x > y else t)",
        "A = x ** 2",
        "x = A ** 0.5",
        "r = (A * s) ** (1 / 3)",
        "x = someFunction(t)",
        "k = x ** k",
        "t = time",
        "v = x / time",
        "x = mod(x, y)",
    ],
)
def test_correct_physics_is_silent(text: str) -> None:
    assert check(text) == ()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("x = t", "`x` is in m, `t` is in s"),
        ("x = v", "`x` is in m, `v` is in m/s"),
        ("x = der(y)", "`x` is in m, `der(y)` is in m/s"),
        ("v = der(phi)", "`v` is in m/s, `der(phi)` is in 1/s"),
        ("tau = J * w", "`tau` is in N.m, `J * w` is in N.m.s"),
        ("p = f / x", "`p` is in Pa, `f / x` is in N/m"),
        ("x = xmm", "`x` is in m, `xmm` is in mm"),
        ("p = pbar", "`p` is in Pa, `pbar` is in bar"),
        ("T = TC", "`T` is in K, `TC` is in degC"),
        ("phi = deg", "`phi` is in rad, `deg` is in deg"),
        ("x = -t", "`x` is in m, `-t` is in s"),
        ("x = sqrt(f)", "`x` is in m, `sqrt(f)` is in m^(1/2).kg^(1/2)/s"),
        ("x = y ** 2", "`x` is in m, `y ^ 2` is in m2"),
        ("E = P", "`E` is in J, `P` is in W"),
        ("x = time", "`x` is in m, `time` is in s"),
        ("x = noEvent(t if x > y else 0)", "`x` is in m"),
        ("c = x", "`c` is in 1, `x` is in m"),
    ],
)
def test_sides_that_provably_differ(text: str, message: str) -> None:
    found = only(check(text))
    assert (found.code, found.severity) == ("unit.clash", "error")
    assert found.message.startswith("the two sides have different units: " + message)
    assert found.span is not None
    assert found.span.text == text


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("k = x + t", "`x` is in m, `t` is in s within `x + t`"),
        ("f = m * der(v) + x", "`m * der(v)` is in N, `x` is in m within `m * der(v) + x`"),
        ("0 = p - pbar", "`p` is in Pa, `-pbar` is in bar within `p - pbar`"),
        ("k = (x if x > t else y)", "`x` is in m, `t` is in s within `x > t`"),
        ("k = (x if k > 0 else t)", "`x` is in m, `t` is in s within `if"),
        ("k = max(x, t)", "`x` is in m, `t` is in s within `max(x, t)`"),
        ("k = k * sin(k + k * (x + t))", "`x` is in m, `t` is in s within `x + t`"),
    ],
)
def test_clash_inside_an_expression(text: str, message: str) -> None:
    found = only(check(text))
    assert (found.code, found.severity) == ("unit.clash", "error")
    assert found.message.startswith("in this equation: " + message)


def test_a_clash_is_reported_once_though_the_expression_is_shared() -> None:
    found = check_units(model(VARIABLES, ["k = x + t", "g = x + t"]))
    assert only(found).span == equation("k = x + t").span


@pytest.mark.parametrize(
    "text",
    [
        "x = 2 * t",
        "x = t / 3",
        "E = 0.5 * m * v",
        "x = t * 4 / 3",
        "x = t + 1",
        "x = t + k",
        "v = 2 * x",
        "x = floor(t)",
        "x = sqrt(t ** 2 + t ** 2)",
        "x = x + 2 * t",
    ],
)
def test_doubtful_clash_is_a_warning(text: str) -> None:
    found = only(check(text))
    assert (found.code, found.severity) == ("unit.suspect", "warning")


@pytest.mark.parametrize("text", ["c = exp(t)", "c = sin(t)", "c = log(p)", "c = sin(deg)", "c = cos(w)"])
def test_functions_of_plain_numbers(text: str) -> None:
    found = only(check(text))
    assert (found.code, found.severity) == ("unit.argument", "warning")


def test_message_names_the_variables_and_shows_the_line() -> None:
    found = only(check("tau = J * w"))
    assert found.names == ("tau", "J", "w")
    assert found.render() == "\n".join(
        [
            "Test.mo:1:1: error: " + found.message + " [unit.clash]",
            "    1 | tau = J * w",
            "      | ^^^^^^^^^^^",
            "  hint: declare the unit that is meant, or convert with a parameter that carries the units",
        ]
    )


def test_hint_of_a_wrong_scale_says_the_factor() -> None:
    assert only(check("p = pbar")).hint.startswith("1 Pa is 1e-05 bar: convert, or use one unit")
    assert only(check("T = TC")).hint.startswith("K and degC have different zero points")


def test_connection_has_its_own_message() -> None:
    found = only(check("p = pbar", Origin.CONNECTION))
    assert found.message == "connected variables have different units: `p` is in Pa, `pbar` is in bar"
    found = only(check("p = T", Origin.CONNECTION))
    assert "connect only connectors" in found.hint


def test_flow_balance_has_its_own_message() -> None:
    found = only(check("q + f = 0", Origin.FLOW_BALANCE))
    assert found.message.startswith("a connection adds flows of different units: `q` is in m3/s, `f` is in N")


def test_long_expressions_are_cut() -> None:
    text = "x = t" + " + t" * 3 + " * c" * 40
    assert len(only(check(text)).message) < 200


# ------------------------------------------------------------------------------ declarations


def test_binding_of_a_parameter() -> None:
    found = only(check_units(model([parameter("L", "m"), parameter("m", "kg", "L")])))
    assert (found.code, found.severity) == ("unit.clash", "error")
    assert found.message == "`m` and its value have different units: `m` is in kg, `L` is in m"
    assert found.names == ("m", "L")


@pytest.mark.parametrize("attribute", ["start", "min", "max", "nominal"])
def test_attributes(attribute: str) -> None:
    wrong = model([parameter("L", "m"), real("m", "kg", **{attribute: "L"})])
    assert f"its attribute {attribute} have" in only(check_units(wrong)).message
    right = model(
        [parameter("L", "m"), real("x", "m", **{attribute: "2 * L"}), real("y", "m", **{attribute: "3"})]
    )
    assert check_units(right) == ()


def test_clash_within_a_binding() -> None:
    flat = model([parameter("L", "m"), parameter("m", "kg"), parameter("k", "", "L + m")])
    assert only(check_units(flat)).message.startswith("in the value of `k`: `L` is in m, `m` is in kg")


def test_initial_equations_and_assertions() -> None:
    flat = model(VARIABLES, initial=["x = t"], assertions=[assertion("p > T")])
    assert [found.code for found in check_units(flat)] == ["unit.clash", "unit.clash"]
    assert check_units(flat)[1].message.startswith("in this assertion: `p` is in Pa, `T` is in K")


def test_malformed_unit_is_a_warning_and_then_unknown() -> None:
    flat = model([real("a", "Nm"), real("b", "Nm"), real("c", "m")], ["a = c", "b = c * a"])
    found = only(check_units(flat))
    assert (found.code, found.severity, found.names) == ("unit.malformed", "warning", ("a", "b"))
    assert found.message == '"Nm" is not a unit: `Nm` is not a unit symbol; `a`, `b` are taken without unit'
    assert found.hint == "a product has a dot: `N.m`"


def test_malformed_display_unit() -> None:
    found = only(check_units(model([real("a", "m", display_unit="inchworm")])))
    assert found.code == "unit.malformed"


def test_display_unit_must_show_the_quantity() -> None:
    fine = [real("w", "rad/s", display_unit="rev/min"), real("p", "Pa", display_unit="bar"), real("z")]
    assert check_units(model(fine)) == ()
    found = only(check_units(model([real("w", "rad/s", display_unit="rev")])))
    assert (found.code, found.severity) == ("unit.display", "warning")


# ------------------------------------------------------------------------------ scale


def test_powers_that_leave_floating_point_are_unknown() -> None:
    variables = [real("tiny", "ym"), real("x")]
    assert check_units(model(variables, ["x = 1 / ((tiny ** 12) ** 12) ** 12"])) == ()


def test_deep_and_long_expressions_take_linear_time() -> None:
    def prepare(size: int) -> Work:
        chain = [equation(f"v[{i}] = der(x[{i}]) + (v[{i + 1}] - v[{i}]) * c") for i in range(size)]
        kinds = (("x", "m"), ("v", "m/s"))
        names = [real(f"{kind}[{i}]", unit) for i in range(size + 1) for kind, unit in kinds]
        flat = model([*names, real("c", "1")], chain)
        assert check_units(flat) == ()
        return lambda: check_units(flat)

    assert growth(prepare, 1_000, 10_000) < 3
