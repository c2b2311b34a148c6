"""The operators of Modelica expressions and how tightly they bind (Modelica 3.6, section 3.2).

The parser and the printer read the same table. A level is where an operator stands in the grammar: its
operands are of a higher level, except that `or`, `and`, sums and products also take one of their own
level on the left (`a - b - c` is `(a - b) - c`).
"""

from __future__ import annotations

CONDITIONAL, RANGE, OR, AND, NOT, RELATION, SUM, PRODUCT, POWER, PRIMARY = range(10)

BINARY_LEVELS: dict[str, int] = {
    **dict.fromkeys(("or",), OR),
    **dict.fromkeys(("and",), AND),
    **dict.fromkeys(("<", "<=", ">", ">=", "==", "<>"), RELATION),
    **dict.fromkeys(("+", "-", ".+", ".-"), SUM),
    **dict.fromkeys(("*", "/", ".*", "./"), PRODUCT),
    **dict.fromkeys(("^", ".^"), POWER),
}

PREFIX_LEVELS: dict[str, int] = {"not": NOT, **dict.fromkeys(("+", "-", ".+", ".-"), SUM)}
"""Prefix operators: allowed only where an operand of their level may begin, so `2*-3` is not Modelica."""

NOT_ASSOCIATIVE = frozenset((RELATION, POWER))
"""`a < b < c` and `a^b^c` need parentheses."""
