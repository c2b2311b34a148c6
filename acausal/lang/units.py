"""Unit expressions (Modelica 3.6, chapter 19): parsed to SI dimensions and a factor, combined, printed.

`parse_unit("N.m/(rad.s2)")` gives a `Unit`: the exponents of the seven SI base units, the factor to the
coherent SI unit, and for temperature scales the offset, so that a value in SI is `factor * value + offset`.
Plane and solid angles are dimensionless (`rad`, `sr` and `1` are the same unit; `deg` is pi/180 and `rev` is
2 pi of it), hence `Hz`, `1/s` and `rad/s` are one unit too. Text that is no unit gives a `MalformedUnit`,
which says what is wrong: a model with a strange unit still compiles.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache

BASE_UNITS = ("m", "kg", "s", "A", "K", "mol", "cd")
Dimensions = tuple[Fraction, Fraction, Fraction, Fraction, Fraction, Fraction, Fraction]

_MAX_NESTING = 20
_MAX_EXPONENT = 99


@dataclass(frozen=True, slots=True)
class Unit:
    """`dimensions`: exponents of `BASE_UNITS`; a value in SI is `factor * value + offset`."""

    dimensions: Dimensions
    factor: float = 1.0
    offset: float = 0.0
    _hash: int = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "_hash", self.dimensions.__hash__() ^ self.factor.__hash__())

    def __hash__(self) -> int:
        return self._hash

    @property
    def is_dimensionless(self) -> bool:
        return not any(self.dimensions)

    def __str__(self) -> str:
        return format_unit(self)


@dataclass(frozen=True, slots=True)
class MalformedUnit:
    """A text that is no unit expression, why, and what may have been meant."""

    text: str
    reason: str
    hint: str = ""


# ------------------------------------------------------------------------------ algebra


def unit_from(exponents: dict[str, int | Fraction], factor: float = 1.0, offset: float = 0.0) -> Unit:
    """A unit from exponents of base units by name: `unit_from({"m": 1, "s": -2})`."""
    m, kg, s, a, k, mol, cd = (Fraction(exponents.get(base, 0)) for base in BASE_UNITS)
    return Unit((m, kg, s, a, k, mol, cd), factor, offset)


ONE = unit_from({})
SECOND = unit_from({"s": 1})


@lru_cache(maxsize=4096)
def multiply(a: Unit, b: Unit) -> Unit:
    """`a * b`. A temperature scale counts as its interval here: `J/degC` is `J/K`."""
    m, kg, s, i, k, mol, cd = (x + y for x, y in zip(a.dimensions, b.dimensions, strict=True))
    return Unit((m, kg, s, i, k, mol, cd), a.factor * b.factor)


@lru_cache(maxsize=4096)
def power(a: Unit, exponent: Fraction) -> Unit:
    """`a ^ exponent` with a rational exponent."""
    m, kg, s, i, k, mol, cd = (x * exponent for x in a.dimensions)
    return Unit((m, kg, s, i, k, mol, cd), a.factor**exponent)


def divide(a: Unit, b: Unit) -> Unit:
    """`a / b`."""
    return multiply(a, power(b, Fraction(-1)))


def same_dimensions(a: Unit, b: Unit) -> bool:
    """Whether one can be converted into the other."""
    return a.dimensions == b.dimensions


def same_unit(a: Unit, b: Unit) -> bool:
    """Whether a value means the same in both: dimensions, factor (to 1e-9) and offset."""
    return a is b or (
        a.dimensions == b.dimensions
        and math.isclose(a.factor, b.factor, rel_tol=1e-9)
        and math.isclose(a.offset, b.offset, rel_tol=1e-9)
    )


# ------------------------------------------------------------------------------ symbols

_PREFIX_LETTERS = "Y Z E P T G M k h da d c m u n p f a z y".split()
_PREFIX_POWERS = (24, 21, 18, 15, 12, 9, 6, 3, 2, 1, -1, -2, -3, -6, -9, -12, -15, -18, -21, -24)
PREFIXES = {letter: float(f"1e{n}") for letter, n in zip(_PREFIX_LETTERS, _PREFIX_POWERS, strict=True)}

# In terms of symbols above; the SI brochure (9th edition), tables 4 and 8.
_DERIVED = """
    rad = 1; sr = 1; Hz = 1/s; N = kg.m/s2; Pa = N/m2; J = N.m; W = J/s; C = A.s; V = W/A; F = C/V
    Ohm = V/A; S = A/V; Wb = V.s; T = Wb/m2; H = Wb/A; lm = cd.sr; lx = lm/m2; Bq = 1/s; Gy = J/kg; Sv = J/kg
    kat = mol/s
"""
_SCALED: tuple[tuple[str, str, float, float], ...] = (
    ("g", "kg", 1e-3, 0.0),
    ("min", "s", 60.0, 0.0),
    ("h", "s", 3600.0, 0.0),
    ("d", "s", 86400.0, 0.0),
    ("deg", "rad", math.pi / 180, 0.0),
    ("rev", "rad", 2 * math.pi, 0.0),
    ("rpm", "rad/s", 2 * math.pi / 60, 0.0),
    ("l", "m3", 1e-3, 0.0),
    ("L", "m3", 1e-3, 0.0),
    ("t", "kg", 1e3, 0.0),
    ("bar", "Pa", 1e5, 0.0),
    ("eV", "J", 1.602176634e-19, 0.0),
    ("debye", "C.m", 1e-21 / 299792458, 0.0),
    ("var", "W", 1.0, 0.0),
    ("dB", "1", 1.0, 0.0),  # a level: as dimensionless as its argument, and never converted
    ("degC", "K", 1.0, 273.15),
    ("degF", "K", 5 / 9, 459.67 * 5 / 9),
    ("degRk", "K", 5 / 9, 0.0),
)
_NO_PREFIX = frozenset({"kg", "min", "h", "d", "rev", "rpm", "dB", "degC", "degF", "degRk"})

SYMBOLS: dict[str, Unit] = {base: unit_from({base: 1}) for base in BASE_UNITS}


def _symbol(text: str) -> Unit | None:
    """A unit operand: a symbol, or failing that a prefix and a symbol (in this order, says the chapter)."""
    found = SYMBOLS.get(text)
    if found is not None:
        return found
    for length in (1, 2):
        prefix, rest = PREFIXES.get(text[:length]), SYMBOLS.get(text[length:])
        if prefix is not None and rest is not None and text[length:] not in _NO_PREFIX:
            return Unit(rest.dimensions, prefix * rest.factor)
    return None


# ------------------------------------------------------------------------------ parsing

_OPERAND = re.compile(r"([A-Za-z_]+)([+-]?[0-9]+)?")


class _Malformed(Exception):
    """Leaves the parser; `parse_unit` turns it into a `MalformedUnit`."""

    def __init__(self, reason: str, hint: str = "") -> None:
        super().__init__(reason)
        self.reason = reason
        self.hint = hint


@lru_cache(maxsize=4096)
def parse_unit(text: str) -> Unit | MalformedUnit:
    """The unit that a `unit` or `displayUnit` attribute denotes, or what is wrong with it."""
    try:
        unit, end = _expression(text, 0, 0)
        if end != len(text):
            raise _rest(text, end)
    except _Malformed as problem:
        return MalformedUnit(text, problem.reason, problem.hint)
    except ArithmeticError:
        return MalformedUnit(text, "its factor is beyond floating point")
    if not 0 < unit.factor < math.inf:
        return MalformedUnit(text, "its factor is beyond floating point")
    return unit


def _expression(text: str, at: int, depth: int) -> tuple[Unit, int]:
    """`numerator [ / denominator ]`; one division only."""
    numerator, at = _numerator(text, at, depth)
    if not text.startswith("/", at):
        return numerator, at
    if text.startswith("(", at + 1):
        denominator, at = _parenthesis(text, at + 1, depth)
    else:
        denominator, at = _factor(text, at + 1)
    return divide(numerator, denominator), at


def _numerator(text: str, at: int, depth: int) -> tuple[Unit, int]:
    if text.startswith("(", at):
        return _parenthesis(text, at, depth)
    if text.startswith("1", at):
        return ONE, at + 1
    unit, at = _factor(text, at)
    while text.startswith(".", at):
        factor, at = _factor(text, at + 1)
        unit = multiply(unit, factor)
    return unit, at


def _parenthesis(text: str, at: int, depth: int) -> tuple[Unit, int]:
    if depth == _MAX_NESTING:
        raise _Malformed(f"parentheses nest deeper than {_MAX_NESTING}")
    unit, at = _expression(text, at + 1, depth + 1)
    if not text.startswith(")", at):
        raise _Malformed("a `)` is missing") if at == len(text) else _rest(text, at)
    return unit, at + 1


def _factor(text: str, at: int) -> tuple[Unit, int]:
    match = _OPERAND.match(text, at)
    if match is None:
        found = f"`{text[at]}`" if at < len(text) else "nothing"
        raise _Malformed(f"a unit symbol is expected at position {at + 1}, found {found}")
    unit = _symbol(match[1])
    if unit is None:
        raise _Malformed(f"`{match[1]}` is not a unit symbol", _meant(match[1]))
    exponent = int(match[2] or 1) if len(match[2] or "") <= 3 else _MAX_EXPONENT + 1
    if abs(exponent) > _MAX_EXPONENT:
        raise _Malformed(f"the exponent {match[2]} is too large")
    return (unit if match[2] is None else power(unit, Fraction(exponent))), match.end()


def _meant(symbol: str) -> str:
    """`Nm` is two symbols without the dot."""
    for cut in range(1, len(symbol)):
        if _symbol(symbol[:cut]) is not None and _symbol(symbol[cut:]) is not None:
            return f"a product has a dot: `{symbol[:cut]}.{symbol[cut:]}`"
    return ""


def _rest(text: str, at: int) -> _Malformed:
    hints = {
        "/": "only one `/` is allowed: put parentheses around the denominator, as in `J/(kg.K)`",
        ".": "put parentheses around the denominator, as in `J/(kg.K)`",
        "*": "a product has a dot, as in `N.m`",
        " ": "a unit has no blanks; a product has a dot, as in `N.m`",
        "^": "an exponent follows its symbol directly, as in `m2`",
    }
    return _Malformed(f"unexpected `{text[at]}` at position {at + 1}", hints.get(text[at], ""))


def _define(text: str, factor: float = 1.0, offset: float = 0.0) -> Unit:
    unit = parse_unit(text)
    assert isinstance(unit, Unit), text
    return Unit(unit.dimensions, factor * unit.factor, offset)


for _name, _text in re.findall(r"(\w+) = (\S+?)(?:;|\s)", _DERIVED):
    SYMBOLS[_name] = _define(_text)
for _name, _text, _factor_to_si, _offset in _SCALED:
    SYMBOLS[_name] = _define(_text, _factor_to_si, _offset)
parse_unit.cache_clear()


# ------------------------------------------------------------------------------ printing

# What is printed by name, in order of preference; everything else in base units.
_READABLE = tuple(
    (text, _define(text))
    for text in (
        *("1", "1/s", "N", "Pa", "J", "W", "C", "V", "F", "Ohm", "S", "Wb", "T", "H"),
        *("N/m", "N.s/m", "N.m.s", "Pa.s", "Pa/s", "W/K", "W/(m.K)", "W/(m2.K)", "V/m", "J/K", "J/(kg.K)"),
        *("km/h", "rev/min", "deg/s", "l/min", "l/s", "kW.h", "A.h", "g/cm3", "N/mm", "kg/h", "t/h"),
    )
)


def format_unit(unit: Unit) -> str:
    """A readable unit expression; `parse_unit` reads it back when exponents are whole and SI or `_READABLE`.

    A factor that no symbol has is written in front (`0.0254 m`), a broken exponent as `m^(1/2)`.
    """
    named = _named(unit)
    if named is not None:
        return named
    powers = list(zip(BASE_UNITS, unit.dimensions, strict=True))
    above = [_power_text(base, exponent) for base, exponent in powers if exponent > 0]
    below = [_power_text(base, -exponent) for base, exponent in powers if exponent < 0]
    text = ".".join(above) or "1"
    if below:
        text += "/" + (below[0] if len(below) == 1 else f"({'.'.join(below)})")
    if not math.isclose(unit.factor, 1.0, rel_tol=1e-9):
        text = f"{unit.factor:.10g} {text}"
    return text if unit.offset == 0 else f"{text} + {unit.offset:.10g}"


def _power_text(base: str, exponent: Fraction) -> str:
    if exponent.denominator != 1:
        return f"{base}^({exponent})"
    return base if exponent == 1 else f"{base}{exponent}"


def _named(unit: Unit) -> str | None:
    """A preferred text, a symbol or a prefixed symbol (also to a power) that means exactly this unit."""
    for text, known in _READABLE:
        if same_unit(known, unit):
            return text
    if unit.is_dimensionless or unit.factor != 1.0 or unit.offset != 0.0:
        exponents = [int(e) for e in unit.dimensions if e and e.denominator == 1]
        for exponent in dict.fromkeys([1, -1, 2, -2, 3, -3, *exponents]):
            found = _named_power(unit, exponent)
            if found is not None:
                return found
    return None


def _named_power(unit: Unit, exponent: int) -> str | None:
    suffix = "" if exponent == 1 else str(exponent)
    for symbol, known in SYMBOLS.items():
        if power(known, Fraction(exponent)).dimensions != unit.dimensions:
            continue
        for prefix in ("", *PREFIXES):
            candidate = parse_unit(prefix + symbol + suffix)
            if isinstance(candidate, Unit) and same_unit(candidate, unit):
                return prefix + symbol + suffix
    return None
