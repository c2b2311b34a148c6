"""The little simplification the passes need beyond the constructors of `expr`: like terms of a sum."""

from __future__ import annotations

from acausal.symbolic.expressions.expr import ZERO, Expr, add, const, mul


def split_factor(term: Expr) -> tuple[float, Expr | None]:
    """A term as (literal factor, the rest); the rest of a literal is None. `-2*x*y` is (-2, x*y)."""
    sign = 1.0
    if term.op == "neg":
        sign, term = -1.0, term.args[0]
    if term.op == "const" and not isinstance(term.value, str):
        return sign * term.number, None
    if term.op == "mul" and term.args[0].op == "const":
        rest = term.args[1:]
        return sign * term.args[0].number, rest[0] if len(rest) == 1 else mul(*rest)
    return sign, term


def collect_terms(root: Expr) -> Expr:
    """The sum with equal terms added up, so that what cancels disappears; other expressions unchanged."""
    if root.op != "add":
        return root
    factors: dict[Expr | None, float] = {}
    for term in root.args:
        factor, rest = split_factor(term)
        factors[rest] = factors.get(rest, 0.0) + factor
    terms = [const(f) if rest is None else mul(const(f), rest) for rest, f in factors.items() if f != 0]
    return add(*terms) if terms else ZERO
