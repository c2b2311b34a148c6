"""Unit inference: the unit of every expression, as far as declared units prove it.

A variable that declares a unit is *certain*, and so is what sums, products, quotients, constant powers,
roots, `der`, `abs`, `if`, `min` and `max` make of certain parts alone. A number in a sum, a comparison or a
branch takes the unit of its neighbours, which leaves the result known but doubtful (a zero leaves it
certain). A number as a factor may be a quantity whose unit is not written (`9.81 * t`, or a constant of a
package, which stands here as its value): with one of the small fractions of mathematics (`2`, `1/2`, `4/3`,
see `_is_structural`) the product is doubtful, with any other unknown. A variable without a unit may have
any: a product with it is unknown, a sum with it doubtful. Sums on a temperature scale with an offset (degC)
are unknown, because the difference of two is an interval in K.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from acausal.lang import units
from acausal.lang.units import Unit, multiply, same_dimensions, same_unit
from acausal.symbolic.expressions.expr import TIME, Constant, Expr, fold
from acausal.symbolic.expressions.operators import RELATIONS


@dataclass(frozen=True, slots=True)
class Measure:
    """What an expression is measured in; `unit` None: nothing is known."""

    unit: Unit | None
    certain: bool = False
    number: bool = False
    """Made of Integers and of literals such as 2 and 1/2 only: without a unit of its own."""


UNKNOWN = Measure(None)
NUMBER = Measure(None, certain=False, number=True)
_ZERO = Measure(None, certain=True, number=True)

_PER_SECOND = units.power(units.SECOND, Fraction(-1))


@dataclass(frozen=True, slots=True)
class Clash:
    """Two expressions that should have the same unit, inside `node` (None: the two sides themselves)."""

    left: Expr
    right: Expr
    left_unit: Unit
    right_unit: Unit
    certain: bool
    node: Expr | None = None


def _memo_of_time() -> dict[Expr, Measure]:
    return {TIME: Measure(units.SECOND, certain=True)}


@dataclass
class Inference:
    """One run: measures found so far (preset with the variables'), and what the walks noticed.

    `arguments` holds (function, argument, unit) of functions whose argument should be a plain number.
    """

    memo: dict[Expr, Measure] = field(default_factory=_memo_of_time)
    shared: dict[int, list[Measure]] = field(default_factory=dict[int, "list[Measure]"])
    clashes: list[Clash] = field(default_factory=list[Clash])
    arguments: list[tuple[str, Expr, Unit]] = field(default_factory=list[tuple[str, Expr, Unit]])

    declared: dict[Expr, Unit | None] = field(default_factory=dict[Expr, "Unit | None"])
    """Units that functions declare of their results."""

    def measure(self, root: Expr) -> Measure:
        return fold([root], self.visit, self.memo, self.shared)[root]

    def visit(self, node: Expr, args: list[Measure]) -> Measure:
        found = self._found(node, args)
        return self.as_declared(node, found) if node in self.declared else found

    def as_declared(self, node: Expr, found: Measure) -> Measure:
        """A function may give a number another unit on purpose: then that is what is known, with doubt."""
        unit = self.declared[node]
        if found.unit is not None and unit is not None and same_unit(found.unit, unit):
            return found
        return Measure(found.unit if node.op == "sym" else unit)

    def _found(self, node: Expr, args: list[Measure]) -> Measure:
        op = node.op
        if op == "const":
            return _literal(node.value)
        if op == "mul":
            return _product(args)
        if op == "div":
            return _quotient(node, args)
        if op == "add":
            return _sum(args, self.join(node, node.args, args))
        if op in ("min", "max", "homotopy"):
            return self.join(node, node.args, args)
        if op in RELATIONS or op == "atan2":
            self.join(node, node.args, args)
            return NUMBER
        if op == "if":
            return self.join(node, node.args[1:], args[1:])
        if op in _ARGUMENT_IS_NUMBER:
            return self.plain_argument(node, args)
        return _OTHER.get(op, _unknown)(node, args)

    def join(self, node: Expr, parts: Sequence[Expr], measures: Sequence[Measure]) -> Measure:
        """The common unit of parts that must agree; notes the first two that do not."""
        known = [i for i, measure in enumerate(measures) if measure.unit is not None]
        if not known:
            return NUMBER if all(m.number for m in measures) else UNKNOWN
        first = min(known, key=lambda i: not measures[i].certain)
        for i in known:
            clash = compare(parts[first], parts[i], measures[first], measures[i], node)
            if clash is not None:
                self.clashes.append(clash)
                return UNKNOWN
        if all(m.certain for m in measures):
            return measures[first]
        return Measure(measures[first].unit)

    def plain_argument(self, node: Expr, args: list[Measure]) -> Measure:
        for arg, measure in zip(node.args, args, strict=True):
            unit = measure.unit
            if unit is not None and measure.certain and not same_unit(unit, units.ONE):
                self.arguments.append((node.op, arg, unit))
        return NUMBER


def compare(left: Expr, right: Expr, a: Measure, b: Measure, node: Expr | None = None) -> Clash | None:
    """The clash of two parts that should be equal or addable; None where nothing can be said."""
    if a.unit is None or b.unit is None or a.unit is b.unit or same_unit(a.unit, b.unit):
        return None
    if same_dimensions(a.unit, b.unit):
        scales = a.unit.offset != 0 or b.unit.offset != 0
        if not (a.certain and b.certain) or (scales and node is not None and node.op == "add"):
            return None  # a factor or a temperature scale that a number may account for
    return Clash(left, right, a.unit, b.unit, a.certain and b.certain, node)


def _literal(value: Constant | None) -> Measure:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return UNKNOWN
    if value == 0:
        return _ZERO
    return NUMBER if _is_structural(value) else UNKNOWN


def _is_structural(value: float) -> bool:
    """A fraction such as formulas have, and measurements hardly: up to 12, and no tenths or fifths."""
    if not 0.05 < abs(value) < 12.5:
        return False
    fraction = Fraction(value).limit_denominator(12)
    return 12 % fraction.denominator == 0 and math.isclose(float(fraction), value, rel_tol=1e-12)


def _quotient(node: Expr, args: list[Measure]) -> Measure:
    """Who divides by a Real number (`time / 0.5`) rather leaves a unit away than writes a fraction."""
    below = node.args[1]
    if below.is_const and isinstance(below.value, float):
        return UNKNOWN
    return _product([args[0], _power(args[1], Fraction(-1))])


def _product(args: Iterable[Measure]) -> Measure:
    unit: Unit | None = None
    certain = True
    for arg in args:
        if arg.unit is not None:
            certain = certain and arg.certain and arg.unit.offset == 0
            unit = arg.unit if unit is None else multiply(unit, arg.unit)
            if not 1e-200 < unit.factor < 1e200:
                return UNKNOWN
        elif not arg.number:
            return UNKNOWN
        else:
            certain = False
    return NUMBER if unit is None else Measure(unit, certain)


def _power(base: Measure, exponent: Fraction) -> Measure:
    if base.unit is None:
        return NUMBER if base.number else UNKNOWN
    if abs(math.log10(base.unit.factor) * exponent) > 200:
        return UNKNOWN
    return Measure(units.power(base.unit, exponent), base.certain and base.unit.offset == 0)


def _sum(args: list[Measure], joined: Measure) -> Measure:
    """Sums and differences on a temperature scale are either a temperature or an interval."""
    scaled = any(arg.unit is not None and arg.unit.offset != 0 for arg in args)
    return UNKNOWN if scaled else joined


def _general_power(node: Expr, args: list[Measure]) -> Measure:
    exponent = node.args[1]
    if exponent.is_const and isinstance(exponent.value, int | float):
        rational = Fraction(exponent.number).limit_denominator(12)
        if abs(float(rational) - exponent.number) < 1e-12 and abs(rational) <= 100:
            if rational == Fraction(1, 2):
                return _root(node, args)
            return _power(args[0], rational)
    base = args[0].unit
    return Measure(units.ONE) if base is not None and same_unit(base, units.ONE) else UNKNOWN


def _derivative(_node: Expr, args: list[Measure]) -> Measure:
    return UNKNOWN if args[0].unit is None else _product([args[0], Measure(_PER_SECOND, certain=True)])


def _same(_node: Expr, args: list[Measure]) -> Measure:
    return args[0]


def _doubtful(_node: Expr, args: list[Measure]) -> Measure:
    """Rounding keeps a unit, though its meaning depends on it."""
    return args[0] if args[0].unit is None else Measure(args[0].unit)


def _root(node: Expr, args: list[Measure]) -> Measure:
    """The root of a sum is doubtful: magnitudes come from functions whose results declare no unit."""
    measure = _power(args[0], Fraction(1, 2))
    return measure if node.args[0].op != "add" else Measure(measure.unit)


def _number(_node: Expr, _args: list[Measure]) -> Measure:
    return NUMBER


def _unknown(_node: Expr, _args: list[Measure]) -> Measure:
    return UNKNOWN


_ARGUMENT_IS_NUMBER = frozenset("sin cos tan asin acos atan sinh cosh tanh exp log log10".split())
_OTHER: dict[str, Callable[[Expr, list[Measure]], Measure]] = {
    **dict.fromkeys(("neg", "abs", "pre", "noEvent", "smooth", "delay", "derived"), _same),
    **dict.fromkeys(("floor", "ceil", "mod", "rem"), _doubtful),
    **dict.fromkeys(("sign", "integer", "ordinal", "idiv"), _number),
    "der": _derivative,
    "sqrt": _root,
    "pow": _general_power,
}
