"""Hash-consed scalar expressions: everything that other packages use of them.

Two structurally equal expressions are the same object, so equality is identity, hashing is free and every
rewrite can be memoised per node. `node` has the nodes, `construct` builds them, `walk` visits them; all
walks are iterative over the directed acyclic graph, because models hold sums of thousands of terms.
"""

from __future__ import annotations

from acausal.symbolic.expressions.construct import (
    MOST_MERGED,
    add,
    call,
    der,
    div,
    function,
    if_then_else,
    logical_and,
    logical_not,
    logical_or,
    mul,
    neg,
    neg_term,
    no_event,
    power,
    pre,
    rebuild,
    relation,
    smooth,
    sub,
)
from acausal.symbolic.expressions.node import (
    FALSE,
    ONE,
    TIME,
    TRUE,
    ZERO,
    Constant,
    EnumValue,
    Expr,
    const,
    make,
    sym,
)
from acausal.symbolic.expressions.operators import (
    OPERATORS,
    RELATIONS,
)
from acausal.symbolic.expressions.walk import (
    fold,
    postorder,
    substitute,
    symbols,
    unknown_leaves,
)

__all__ = [
    "FALSE",
    "MOST_MERGED",
    "ONE",
    "OPERATORS",
    "RELATIONS",
    "TIME",
    "TRUE",
    "ZERO",
    "Constant",
    "EnumValue",
    "Expr",
    "add",
    "call",
    "const",
    "der",
    "div",
    "fold",
    "function",
    "if_then_else",
    "logical_and",
    "logical_not",
    "logical_or",
    "make",
    "mul",
    "neg",
    "neg_term",
    "no_event",
    "postorder",
    "power",
    "pre",
    "rebuild",
    "relation",
    "smooth",
    "sub",
    "substitute",
    "sym",
    "symbols",
    "unknown_leaves",
]
