"""Constraints between states that appear only in a sum of equations.

Index reduction looks at who is in which equation. The currents into a bridge of diodes whose other side
floats add up to zero, i1 + i2 + i3 = 0, but that is the sum of the current balances of all its nodes, each of
which holds currents of diodes: by structure every balance determines one of these, and in numbers they are
dependent in every mode. Such sums are found exactly, for equations in which what is not differentiated has
whole numbers as coefficients, and each replaces one of its equations, so that Pantelides' algorithm sees the
constraint. Sums without anything that is differentiated stay as they are: a redundant or contradicting
equation, which the solver of the block finds and explains.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import isfinite

from acausal.symbolic.alias import Simplified
from acausal.symbolic.causal import CausalEquation
from acausal.symbolic.expressions.expr import ZERO, Expr, add, const, mul, sym
from acausal.symbolic.expressions.simplify import split_factor
from acausal.symbolic.graphs.cancellation import cancelling_sums
from acausal.symbolic.graphs.types import Eq, Var
from acausal.symbolic.leaves import Chains, all_leaves

_LARGEST = 1e6
"""Whole coefficients up to this are exact."""


def reveal_constraints(model: Simplified) -> Simplified:
    """The model with every hidden constraint in place of one of its equations. Near-linear."""
    chains = model.chains()
    differentiated = _differentiated(model, chains)
    columns: dict[Expr, Var] = {}
    sums = [_linear_sum(equation, chains, differentiated) for equation in model.equations]
    rows = [_row(one, columns) if one is not None else {} for one in sums]
    equations = list(model.equations)
    for found in cancelling_sums(rows):
        constraint = _constraint(sums, found)
        if any(leaf in differentiated for leaf in all_leaves([constraint])):
            last = list(found)[-1]
            flat = replace(equations[last].flat, left=constraint, right=ZERO)
            equations[last] = CausalEquation(constraint, ZERO, flat)
    return replace(model, equations=tuple(equations))


def _differentiated(model: Simplified, chains: Chains) -> dict[Expr, None]:
    """Unknowns that have a derivative in the equations."""
    found = dict.fromkeys(sym(name) for name in chains.named)
    for equation in model.equations:
        for leaf in all_leaves([equation.left, equation.right]):
            lower = leaf
            while lower.op == "der":
                lower = lower.args[0]
                found[lower] = None
    return found


@dataclass(frozen=True)
class _Sum:
    """`0 = sum of factor * leaf + rest`: leaves that are not differentiated, and all else."""

    factors: Mapping[Expr, int]
    rest: tuple[tuple[float, Expr | None], ...]


def _linear_sum(equation: CausalEquation, chains: Chains, known: Mapping[Expr, None]) -> _Sum | None:
    """The equation as a sum; None where not all of what is not differentiated has whole coefficients."""
    factors: dict[Expr, float] = {}
    rest: list[tuple[float, Expr | None]] = []
    stack = [(-1.0, equation.right), (1.0, equation.left)]
    while stack:
        sign, root = stack.pop()
        number, term = split_factor(root)
        if term is not None and term.op in ("add", "neg"):
            stack.extend((sign * number, part) for part in reversed(term.args))
        elif not isfinite(number):
            return None
        elif term is None or not any(_is_open(leaf, chains, known) for leaf in all_leaves([term])):
            rest.append((sign * number, term))
        elif term.op in ("sym", "der"):
            factors[term] = factors.get(term, 0.0) + sign * number
        else:
            return None
    if not all(factor.is_integer() and abs(factor) <= _LARGEST for factor in factors.values()):
        return None
    return _Sum({leaf: int(factor) for leaf, factor in factors.items() if factor}, tuple(rest))


def _is_open(leaf: Expr, chains: Chains, known: Mapping[Expr, None]) -> bool:
    """Whether the running system has to determine the leaf as it is."""
    return leaf not in known and chains.is_unknown(leaf)


def _row(one: _Sum, columns: dict[Expr, Var]) -> dict[Var, int]:
    return {columns.setdefault(leaf, Var(len(columns))): factor for leaf, factor in one.factors.items()}


def _constraint(sums: Sequence[_Sum | None], found: Mapping[Eq, Fraction]) -> Expr:
    """What is left of the sum of equations."""
    total: dict[Expr | None, Fraction] = {}
    for eq, factor in found.items():
        one = sums[eq]
        for number, term in one.rest if one is not None else ():
            total[term] = total.get(term, Fraction(0)) + factor * Fraction(number)
    terms = [
        const(float(factor)) if term is None else mul(const(float(factor)), term)
        for term, factor in total.items()
        if factor
    ]
    return add(*terms) if terms else ZERO
