"""Unit expressions against the SI brochure, the specification's examples and the laws of the algebra."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from acausal.lang.units import (
    BASE_UNITS,
    ONE,
    PREFIXES,
    SYMBOLS,
    MalformedUnit,
    Unit,
    divide,
    format_unit,
    multiply,
    parse_unit,
    power,
    same_dimensions,
    same_unit,
    unit_from,
)


def unit(text: str) -> Unit:
    parsed = parse_unit(text)
    assert isinstance(parsed, Unit), parsed
    return parsed


def malformed(text: str) -> MalformedUnit:
    parsed = parse_unit(text)
    assert isinstance(parsed, MalformedUnit), f"{text} is {parsed}"
    return parsed


# ------------------------------------------------------------------------------ meaning


# Exponents of m, kg, s, A, K, mol, cd: SI brochure, 9th edition, table 4.
DERIVED = {
    "rad": (0, 0, 0, 0, 0, 0, 0),
    "sr": (0, 0, 0, 0, 0, 0, 0),
    "Hz": (0, 0, -1, 0, 0, 0, 0),
    "N": (1, 1, -2, 0, 0, 0, 0),
    "Pa": (-1, 1, -2, 0, 0, 0, 0),
    "J": (2, 1, -2, 0, 0, 0, 0),
    "W": (2, 1, -3, 0, 0, 0, 0),
    "C": (0, 0, 1, 1, 0, 0, 0),
    "V": (2, 1, -3, -1, 0, 0, 0),
    "F": (-2, -1, 4, 2, 0, 0, 0),
    "Ohm": (2, 1, -3, -2, 0, 0, 0),
    "S": (-2, -1, 3, 2, 0, 0, 0),
    "Wb": (2, 1, -2, -1, 0, 0, 0),
    "T": (0, 1, -2, -1, 0, 0, 0),
    "H": (2, 1, -2, -2, 0, 0, 0),
    "lm": (0, 0, 0, 0, 0, 0, 1),
    "lx": (-2, 0, 0, 0, 0, 0, 1),
    "Bq": (0, 0, -1, 0, 0, 0, 0),
    "Gy": (2, 0, -2, 0, 0, 0, 0),
    "Sv": (2, 0, -2, 0, 0, 0, 0),
    "kat": (0, 0, -1, 0, 0, 1, 0),
}


@pytest.mark.parametrize("symbol", DERIVED)
def test_derived_units_of_the_si(symbol: str) -> None:
    assert unit(symbol).dimensions == DERIVED[symbol]
    assert unit(symbol).factor == 1.0


@pytest.mark.parametrize(
    ("text", "si", "factor"),
    [
        ("g", "kg", 1e-3),
        ("mm", "m", 1e-3),
        ("mm2", "m2", 1e-6),  # the exponent includes the prefix
        ("min", "s", 60),
        ("h", "s", 3600),
        ("d", "s", 86400),
        ("deg", "rad", math.pi / 180),
        ("rev", "rad", 2 * math.pi),
        ("rpm", "rad/s", math.pi / 30),
        ("rev/min", "rad/s", math.pi / 30),
        ("l", "m3", 1e-3),
        ("L", "m3", 1e-3),
        ("ml", "m3", 1e-6),
        ("l/min", "m3/s", 1e-3 / 60),
        ("t", "kg", 1e3),
        ("bar", "Pa", 1e5),
        ("mbar", "Pa", 100),
        ("eV", "J", 1.602176634e-19),
        ("kW.h", "J", 3.6e6),
        ("km/h", "m/s", 1 / 3.6),
        ("g/cm3", "kg/m3", 1e3),
        ("dam", "m", 10),
        ("degRk", "K", 5 / 9),
    ],
)
def test_scaled_units(text: str, si: str, factor: float) -> None:
    assert same_dimensions(unit(text), unit(si))
    assert math.isclose(unit(text).factor, factor, rel_tol=1e-12)
    assert not same_unit(unit(text), unit(si))


@pytest.mark.parametrize(
    ("scale", "value", "kelvin"),
    [("degC", 0.0, 273.15), ("degC", 100.0, 373.15), ("degF", 32.0, 273.15), ("degF", 212.0, 373.15)],
)
def test_temperature_scales(scale: str, value: float, kelvin: float) -> None:
    assert math.isclose(unit(scale).factor * value + unit(scale).offset, kelvin, abs_tol=1e-9)


def test_a_temperature_in_a_product_is_an_interval() -> None:
    assert same_unit(unit("J/degC"), unit("J/K"))


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("N.m/(rad.s2)", "W/s"),
        ("kg.m/s2", "kg.m.s-2"),
        ("J/(kg.K)", "J.kg-1.K-1"),
        ("(J/kg)/(kg/m3)", "m5/(kg.s2)"),
        ("1/(1/s)", "s"),
        ("rad", "1"),
        ("rad/s", "1/s"),
        ("Hz", "s-1"),
        ("m+2", "m2"),
        ("((m))", "m"),
        ("mol/mol", "1"),
        ("N.m/m", "N"),
    ],
)
def test_the_same_unit_in_other_words(one: str, other: str) -> None:
    assert same_unit(unit(one), unit(other))
    assert unit(one) == unit(other)


@pytest.mark.parametrize(
    ("text", "meaning"),
    [("m", "meter"), ("min", "minute"), ("T", "tesla"), ("cd", "candela"), ("d", "day"), ("h", "hour")],
)
def test_a_symbol_goes_before_a_prefix(text: str, meaning: str) -> None:
    assert text in SYMBOLS, meaning
    assert unit(text) == SYMBOLS[text]


# ------------------------------------------------------------------------------ malformed


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "expected at position 1, found nothing"),
        ("Nm", "`Nm` is not a unit symbol"),
        ("foo", "`foo` is not a unit symbol"),
        ("k", "`k` is not a unit symbol"),  # a prefix cannot be used in isolation
        ("kkg", "`kkg` is not a unit symbol"),
        ("mmin", "`mmin` is not a unit symbol"),
        ("m/s/s", "unexpected `/` at position 4"),
        ("J/kg.K", "unexpected `.` at position 5"),
        ("m^2", "unexpected `^` at position 2"),
        ("N m", "unexpected ` ` at position 2"),
        ("N*m", "unexpected `*` at position 2"),
        ("m.", "expected at position 3, found nothing"),
        ("m/", "expected at position 3, found nothing"),
        ("m/1", "expected at position 3, found `1`"),
        ("(m", "a `)` is missing"),
        ("m)", "unexpected `)` at position 2"),
        ("m2.5", "expected at position 4, found `5`"),
        ("m1000", "the exponent 1000 is too large"),
        ("Ym99", "beyond floating point"),
        ("ym99", "beyond floating point"),
        ("1/ym99", "beyond floating point"),
        ("(" * 5000 + "m" + ")" * 5000, "parentheses nest deeper than 20"),
    ],
)
def test_malformed_units_say_why(text: str, reason: str) -> None:
    assert reason in malformed(text).reason


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("Nm", "`N.m`"),
        ("m/s/s", "only one `/`"),
        ("J/kg.K", "parentheses"),
        ("m^2", "`m2`"),
        ("N m", "blanks"),
    ],
)
def test_malformed_units_say_what_was_meant(text: str, hint: str) -> None:
    assert hint in malformed(text).hint


@given(st.text(alphabet="mskgNPa12-+./() ^°", max_size=12))
def test_any_text_is_a_unit_or_malformed(text: str) -> None:
    assert isinstance(parse_unit(text), Unit | MalformedUnit)


# ------------------------------------------------------------------------------ algebra and printing


def of_exponents(exponents: list[int]) -> Unit:
    return unit_from(dict(zip(BASE_UNITS, exponents, strict=True)))


exponents = st.integers(-4, 4)
symbols_ = st.sampled_from(sorted(set(SYMBOLS) - {"eV", "debye"}))  # whose powers leave floating point
coherent = st.lists(exponents, min_size=7, max_size=7).map(of_exponents)
products = st.lists(st.tuples(symbols_, exponents), max_size=4)
rationals = st.fractions(-3, 3, max_denominator=4)


def product(parts: list[tuple[str, int]]) -> Unit:
    result = ONE
    for symbol, exponent in parts:
        result = multiply(result, power(SYMBOLS[symbol], Fraction(exponent)))
    return result


@given(coherent)
def test_parse_reads_what_format_writes(one: Unit) -> None:
    assert parse_unit(format_unit(one)) == one


@pytest.mark.parametrize("symbol", SYMBOLS)
@pytest.mark.parametrize("exponent", ["", "2", "-1"])
def test_format_finds_symbols_again(symbol: str, exponent: str) -> None:
    for prefix in ["", *PREFIXES]:
        parsed = parse_unit(prefix + symbol + exponent)
        if isinstance(parsed, Unit) and (not parsed.is_dimensionless or not exponent):
            assert same_unit(unit(format_unit(parsed)), parsed)


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("kg.m/s2", "N"),
        ("N/m2", "Pa"),
        ("rad/s", "1/s"),
        ("kg.m.s-1", "m.kg/s"),
        ("m3/s", "m3/s"),
        ("W/(m2.K)", "W/(m2.K)"),
        ("m.s-2", "m/s2"),
        ("mm2", "mm2"),
        ("deg", "deg"),
        ("rpm", "rev/min"),
        ("degC", "degC"),
        ("bar.l", "hJ"),
        ("deg.m", "0.01745329252 m"),
        ("s-1.kg-1", "1/(kg.s)"),
    ],
)
def test_readable_text(text: str, shown: str) -> None:
    assert format_unit(unit(text)) == shown


def test_rational_powers_are_readable() -> None:
    assert format_unit(power(unit("Pa.m3"), Fraction(1, 2))) == "m.kg^(1/2)/s"


@given(products, products, products)
def test_units_form_a_commutative_group(
    a: list[tuple[str, int]], b: list[tuple[str, int]], c: list[tuple[str, int]]
) -> None:
    x, y, z = product(a), product(b), product(c)
    assert same_unit(multiply(x, y), multiply(y, x))
    assert same_unit(multiply(multiply(x, y), z), multiply(x, multiply(y, z)))
    assert same_unit(multiply(x, ONE), x)
    assert same_unit(multiply(divide(x, y), y), x)


@given(products, products, rationals, rationals)
def test_powers(a: list[tuple[str, int]], b: list[tuple[str, int]], m: Fraction, n: Fraction) -> None:
    x, y = product(a), product(b)
    assert same_unit(multiply(power(x, m), power(x, n)), power(x, m + n))
    assert same_unit(power(multiply(x, y), m), multiply(power(x, m), power(y, m)))
    assert same_unit(power(power(x, m), n), power(x, m * n))


@given(products)
def test_text_of_a_product_means_the_product(parts: list[tuple[str, int]]) -> None:
    text = ".".join(f"{symbol}{exponent}" for symbol, exponent in parts) or "1"
    assert same_unit(unit(text), product(parts))


def test_base_units_come_in_the_brochures_order() -> None:
    assert [unit(base).dimensions.index(1) for base in BASE_UNITS] == list(range(7))
