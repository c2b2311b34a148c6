"""Solving one equation for one leaf, and what every equation can be solved for."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

from acausal.lang.flat import Variable
from acausal.symbolic.causal import Assignment, CausalEquation
from acausal.symbolic.expressions.expr import Expr, div, function, neg_term, postorder, sub
from acausal.symbolic.expressions.linear import linear_coefficient, slopes
from acausal.symbolic.expressions.operators import OPERATORS
from acausal.symbolic.leaves import all_leaves
from acausal.symbolic.parameters import ParameterValues
from acausal.symbolic.when_clauses import is_assignment


class Solvability(IntEnum):
    """How an equation determines a leaf, the best first."""

    SAFE = 0
    """Linear, the coefficient a number or parameter expression that is not zero."""
    VARYING = 1
    """Linear, the coefficient depending on the state; it may pass through zero."""
    SWITCHING = 2
    """Linear, with a coefficient that holds an `if`: it may be zero in one of its modes."""
    NONLINEAR = 3


@dataclass(frozen=True)
class Profile:
    """An equation with its leaves: `solvable` those outside conditions, `leaves` all of them.

    `numbers` are the coefficients of leaves with which the equation is linear, with the values that
    parameters are declared with; those that are not numbers are left out.
    """

    equation: CausalEquation
    solvable: dict[Expr, Solvability]
    leaves: tuple[Expr, ...]
    numbers: dict[Expr, float]


class Profiler:
    """Analyses equations once each; the running and the initial system share the results."""

    def __init__(self, values: ParameterValues, variables: dict[str, Variable]) -> None:
        self._values = values
        self._variables = variables
        self._profiles: dict[CausalEquation, Profile] = {}

    def profile(self, equation: CausalEquation) -> Profile:
        """The profile of an equation. O(nodes), once."""
        found = self._profiles.get(equation)
        if found is None:
            found = self._profiles[equation] = self._analyse(equation)
        return found

    def _analyse(self, equation: CausalEquation) -> Profile:
        left, right = equation.left, equation.right
        leaves = all_leaves([left, right])
        if is_assignment(left, right):
            return Profile(equation, {left: Solvability.SAFE}, leaves, {})
        if not self.is_numeric(left) or not self.is_numeric(right):
            return Profile(equation, _direct(left, right), leaves, {})
        found = slopes(sub(left, right))
        present = {leaf: a for leaf, a in found.items() if a is None or not _vanishes(a)}
        known = {leaf: None if a is None else self._number(a) for leaf, a in present.items()}
        solvable = {leaf: _rated(a, known[leaf]) for leaf, a in present.items()}
        return Profile(equation, solvable, leaves, {leaf: a for leaf, a in known.items() if a is not None})

    def is_numeric(self, expr: Expr) -> bool:
        """Whether the expression is Real, so that it may be subtracted and divided."""
        while expr.op in ("if", "noEvent", "smooth", "pre"):
            expr = expr.args[-1]
        if expr.op == "sym":
            variable = self._variables.get(expr.name)
            return variable is None or variable.type.name == "Real" or not variable.is_unknown
        if expr.op == "const":
            return isinstance(expr.value, int | float) and not isinstance(expr.value, bool)
        return OPERATORS[expr.op].shape not in ("relation", "logical")

    def _number(self, coefficient: Expr) -> float | None:
        return coefficient.number if coefficient.op == "const" else self._values.number(coefficient)


def _rated(coefficient: Expr | None, number: float | None) -> Solvability:
    if coefficient is None:
        return Solvability.NONLINEAR
    if number is not None:
        return Solvability.SAFE if number != 0 else Solvability.SWITCHING
    if any(node.op in ("if", "abs", "min", "max", "sign") for node in postorder([coefficient])):
        return Solvability.SWITCHING
    return Solvability.VARYING


def _vanishes(coefficient: Expr) -> bool:
    """Whether the leaf's terms cancel: nothing can be solved for it."""
    return coefficient.op == "const" and coefficient.number == 0


def _direct(left: Expr, right: Expr) -> dict[Expr, Solvability]:
    """Leaves of an equation that is not Real: solved only as `x = expression`."""
    result = dict.fromkeys(all_leaves([left, right]), Solvability.NONLINEAR)
    for one, other in ((right, left), (left, right)):
        if one.op == "sym" and one not in all_leaves([other]):
            result[one] = Solvability.SAFE
    return result


def solve(equation: CausalEquation, leaf: Expr) -> Assignment | None:
    """The equation solved for `leaf` if it is linear or invertible in it, else None. O(nodes)."""
    left, right = equation.left, equation.right
    if left is leaf and is_assignment(left, right):
        return Assignment(leaf, right, equation)
    for one, other in ((left, right), (right, left)):
        if one is leaf and leaf not in all_leaves([other]):
            return Assignment(leaf, other, equation)
    parts = linear_coefficient(sub(left, right), leaf, frozen=True)
    if parts is not None:
        return Assignment(leaf, div(neg_term(parts[1]), parts[0]), equation)
    return _inverted(equation, leaf)


_INVERSE: dict[str, str] = {"exp": "log", "log": "exp"}
"""Strictly monotone functions whose inverse exists wherever the equation has a solution."""


def _inverted(equation: CausalEquation, leaf: Expr) -> Assignment | None:
    """`f(a*x + b) = c` as `x = (f^-1(c) - b) / a`."""
    for one, other in ((equation.left, equation.right), (equation.right, equation.left)):
        if one.op in _INVERSE and leaf not in all_leaves([other]):
            inner = CausalEquation(one.args[0], function(_INVERSE[one.op], other), equation.flat)
            found = solve(inner, leaf)
            return None if found is None else Assignment(leaf, found.value, equation)
    return None
