"""Exact derivatives of expressions: partial derivatives and time derivatives.

`RULES` gives for every operator the derivative of a node from the derivatives of its arguments (the chain
rule, forward). Where an operator switches (`if`, `abs`, `min`, ...) the rule is that of the piece in force;
`time_derivative` applies it only where the pieces provably meet, because a jump has no derivative, and raises
`NotDifferentiable` otherwise; a branch that the values of parameters exclude needs no proof. Partial
derivatives are those of the piece in force, always.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from acausal.symbolic.expressions.continuity import decided, is_continuous
from acausal.symbolic.expressions.evaluate import Lookup
from acausal.symbolic.expressions.expr import (
    ONE,
    TIME,
    ZERO,
    Expr,
    add,
    call,
    const,
    div,
    fold,
    function,
    homotopy,
    if_then_else,
    mul,
    neg,
    no_event,
    outermost,
    power,
    relation,
    smooth,
    sub,
    substitute,
    unknown_leaves,
)
from acausal.symbolic.expressions.kernel import NoDerivative

Rule = Callable[[Expr, list[Expr]], Expr]
"""Derivative of a node from the node and the derivatives of its arguments."""

DerivativeOf = Callable[[Expr], Expr | None]
"""The time derivative of a leaf: `ZERO` for a parameter, None where it has none."""


INPUT = "it is an input"
"""The reason where a model's input would have to be differentiated."""


class NotDifferentiable(Exception):
    """`expr` has no time derivative; `reason` says why in words that fit behind a colon."""

    def __init__(self, expr: Expr, reason: str) -> None:
        super().__init__(reason)
        self.expr = expr
        self.reason = reason


def _outer(slope: Callable[[Expr], Expr]) -> Rule:
    """D f(u) = f'(u) du, from f' as a function of u."""

    def rule(node: Expr, d: list[Expr]) -> Expr:
        return ZERO if d[0] is ZERO else mul(slope(node.args[0]), d[0])

    return rule


def _zero(node: Expr, d: list[Expr]) -> Expr:
    return ZERO


def _add(node: Expr, d: list[Expr]) -> Expr:
    return add(*d)


def _neg(node: Expr, d: list[Expr]) -> Expr:
    return neg(d[0])


def _mul(node: Expr, d: list[Expr]) -> Expr:
    terms = [
        mul(*node.args[:i], slope, *node.args[i + 1 :]) for i, slope in enumerate(d) if slope is not ZERO
    ]
    return add(*terms) if terms else ZERO


def _div(node: Expr, d: list[Expr]) -> Expr:
    """(a/b)' = a'/b - (a/b) b'/b."""
    b = node.args[1]
    first = ZERO if d[0] is ZERO else div(d[0], b)
    return first if d[1] is ZERO else sub(first, div(mul(node, d[1]), b))


def _pow(node: Expr, d: list[Expr]) -> Expr:
    """(a^b)' = b a^(b-1) a' + a^b log(a) b'."""
    a, b = node.args
    first = ZERO if d[0] is ZERO else mul(b, power(a, sub(b, ONE) if b.op != "const" else _less_one(b)), d[0])
    return first if d[1] is ZERO else add(first, mul(node, function("log", a), d[1]))


def _less_one(b: Expr) -> Expr:
    return const(b.value - 1) if isinstance(b.value, int | float) else sub(b, ONE)


def _atan2(node: Expr, d: list[Expr]) -> Expr:
    """atan2(y, x)' = (x y' - y x') / (x^2 + y^2)."""
    y, x = node.args
    return div(sub(mul(x, d[0]), mul(y, d[1])), add(_square(x), _square(y)))


def _if(node: Expr, d: list[Expr]) -> Expr:
    return if_then_else(node.args[0], d[1], d[2])


# abs, min and max generate no events (Modelica 3.6, 3.7.2), so their derivatives must not either.


def _abs(node: Expr, d: list[Expr]) -> Expr:
    return no_event(if_then_else(relation("ge", node.args[0], ZERO), d[0], neg(d[0])))


def _min(node: Expr, d: list[Expr]) -> Expr:
    return no_event(if_then_else(relation("lt", *node.args), d[0], d[1]))


def _max(node: Expr, d: list[Expr]) -> Expr:
    return no_event(if_then_else(relation("gt", *node.args), d[0], d[1]))


def _mod(node: Expr, d: list[Expr]) -> Expr:
    """mod(a, b) = a - floor(a/b) b, and floor is constant within a piece."""
    return sub(d[0], mul(function("floor", div(*node.args)), d[1]))


def _rem(node: Expr, d: list[Expr]) -> Expr:
    return sub(d[0], mul(function("idiv", *node.args), d[1]))


def _no_event(node: Expr, d: list[Expr]) -> Expr:
    return no_event(d[0])


def _smooth(node: Expr, d: list[Expr]) -> Expr:
    order = node.value if isinstance(node.value, int) else 0
    return smooth(order - 1, d[0]) if order >= 1 else d[0]


def _homotopy(node: Expr, d: list[Expr]) -> Expr:
    return homotopy(d[0], d[1])


def _call(node: Expr, d: list[Expr]) -> Expr:
    terms: list[Expr] = []
    for i, slope in enumerate(d):
        if slope is ZERO:
            continue
        try:
            partial_kernel = node.kernel.partial(i)
        except NoDerivative as problem:
            raise NotDifferentiable(node, f"`{problem}` has no known derivative") from None
        if partial_kernel is not None:
            terms.append(mul(call(partial_kernel, *node.args), slope))
    return add(*terms) if terms else ZERO


def _first(node: Expr, d: list[Expr]) -> Expr:
    return d[0]


def _square(a: Expr) -> Expr:
    return power(a, const(2))


RULES: dict[str, Rule] = {
    "const": _zero,
    "sym": _zero,  # leaves are seeded by the caller
    "der": _zero,
    "pre": _zero,  # constant between events
    **dict.fromkeys(("ordinal", "initial", "terminal", "sample", "trigger"), _zero),
    "delay": _zero,  # the past; it has no time derivative
    "homotopy": _homotopy,
    "noEvent": _no_event,
    "smooth": _smooth,
    "call": _call,
    "derived": _first,
    "rate": _zero,  # stands inside `derived` only
    "if": _if,
    **dict.fromkeys(("or", "and", "not", "lt", "le", "gt", "ge", "eq", "ne"), _zero),
    "add": _add,
    "neg": _neg,
    "mul": _mul,
    "div": _div,
    "pow": _pow,
    "sin": _outer(lambda u: function("cos", u)),
    "cos": _outer(lambda u: neg(function("sin", u))),
    "tan": _outer(lambda u: add(ONE, _square(function("tan", u)))),
    "asin": _outer(lambda u: div(ONE, function("sqrt", sub(ONE, _square(u))))),
    "acos": _outer(lambda u: neg(div(ONE, function("sqrt", sub(ONE, _square(u)))))),
    "atan": _outer(lambda u: div(ONE, add(ONE, _square(u)))),
    "atan2": _atan2,
    "sinh": _outer(lambda u: function("cosh", u)),
    "cosh": _outer(lambda u: function("sinh", u)),
    "tanh": _outer(lambda u: sub(ONE, _square(function("tanh", u)))),
    "exp": _outer(lambda u: function("exp", u)),
    "log": _outer(lambda u: div(ONE, u)),
    "log10": _outer(lambda u: div(const(1 / math.log(10)), u)),
    "sqrt": _outer(lambda u: div(const(0.5), function("sqrt", u))),
    "abs": _abs,
    "sign": _zero,
    "min": _min,
    "max": _max,
    "floor": _zero,
    "ceil": _zero,
    "integer": _zero,
    "idiv": _zero,
    "mod": _mod,
    "rem": _rem,
}
"""Derivative of the piece in force, for every operator of the operator table."""

JUMPS = frozenset({"sign", "floor", "ceil", "integer", "idiv", "mod", "rem"})
"""Functions that jump: no time derivative unless their arguments are constant."""

_RATES = frozenset({"rate"})
_LEAVES = frozenset({"sym", "der", "pre"})


def partial(root: Expr, leaf: Expr) -> Expr:
    """The partial derivative of `root` with respect to the leaf `x`, `der(x)` or `pre(x)`. O(nodes)."""
    return gradient(root, [leaf])[0]


def gradient(root: Expr, leaves: Sequence[Expr]) -> tuple[Expr, ...]:
    """The partial derivatives of `root` with respect to `leaves`. O(nodes) for each leaf."""
    return tuple(_directional(root, leaf) for leaf in leaves)


def _directional(root: Expr, leaf: Expr) -> Expr:
    def visit(node: Expr, d: list[Expr]) -> Expr:
        if node.op in _LEAVES:
            return ONE if node is leaf else ZERO
        return RULES[node.op](node, d)

    return fold([root], visit)[root]


class TimeDerivative:
    """Time derivatives of many expressions over the same leaves, sharing what they share.

    `derivative_of` gives the derivatives of the leaves other than `time`; `values` those of parameters, by
    which switching points are compared. Work is O(nodes) over all calls together.
    """

    def __init__(self, derivative_of: DerivativeOf, values: Lookup) -> None:
        self._derivative_of = derivative_of
        self._values = values
        self._strict: dict[Expr, Expr | NotDifferentiable] = {}
        self._free: dict[Expr, Expr | NotDifferentiable] = {}
        """As `_strict`, where `smooth` vouches for every switch."""

    def __call__(self, root: Expr) -> Expr:
        """D root / dt. Raises `NotDifferentiable`."""
        result = fold([root], self._visit_strict, self._strict)[root]
        if isinstance(result, NotDifferentiable):
            raise NotDifferentiable(result.expr, result.reason)
        return result

    def _visit_strict(self, node: Expr, args: list[Expr | NotDifferentiable]) -> Expr | NotDifferentiable:
        if node.op == "smooth" and isinstance(node.value, int) and node.value >= 1:
            inner = fold([node.args[0]], self._visit_free, self._free)[node.args[0]]
            return inner if isinstance(inner, NotDifferentiable) else smooth(node.value - 1, inner)
        return self._visit(node, args, vouched=False)

    def _visit_free(self, node: Expr, args: list[Expr | NotDifferentiable]) -> Expr | NotDifferentiable:
        return self._visit(node, args, vouched=True)

    def _visit(
        self, node: Expr, args: list[Expr | NotDifferentiable], *, vouched: bool
    ) -> Expr | NotDifferentiable:
        if node.op in _LEAVES:
            return self._leaf(node)
        if node.op == "derived":
            return self._given(node.args[1])
        slopes: list[Expr] = []
        for i, slope in enumerate(self._reachable(node, args) if node.op == "if" else args):
            if node.op == "call" and not node.kernel.moves_with(i):
                slopes.append(ZERO)
            elif isinstance(slope, NotDifferentiable):
                return slope
            else:
                slopes.append(slope)
        moves = any(slope is not ZERO for slope in slopes)
        if node.op == "delay" and moves:
            return NotDifferentiable(node, "the derivative of a delayed value is not known")
        if node.op == "call" and moves and node.kernel.continuity < 0:
            return NotDifferentiable(node, f"{node.kernel.name} jumps")
        if not vouched and node.op in JUMPS and moves:
            return NotDifferentiable(node, f"{node.op} jumps")
        if not vouched and node.op == "if" and not self._allowed(node):
            return NotDifferentiable(node, "its branches do not provably meet where the condition switches")
        try:
            return RULES[node.op](node, slopes)
        except NotDifferentiable as problem:
            return problem

    def _reachable(self, node: Expr, args: list[Expr | NotDifferentiable]) -> list[Expr | NotDifferentiable]:
        """The slopes of an `if`; of a branch that the parameters' values exclude without proofs."""
        if not any(isinstance(slope, NotDifferentiable) for slope in args[1:]):
            return args
        taken = decided(node.args[0], self._values)
        if taken is None:
            return args
        at = 2 if taken else 1
        branch = node.args[at]
        return [*args[:at], fold([branch], self._visit_free, self._free)[branch], *args[at + 1 :]]

    def _given(self, derivative: Expr) -> Expr | NotDifferentiable:
        """The derivative that an author gave, with the rates in it found (deeper ones when they are due)."""
        mapping: dict[Expr, Expr] = {}
        for node in outermost(derivative, _RATES):
            arg = node.args[0]
            slope = fold([arg], self._visit_strict, self._strict)[arg]
            if isinstance(slope, NotDifferentiable):
                return slope
            mapping[node] = slope
        return substitute(derivative, mapping) if mapping else derivative

    def _leaf(self, node: Expr) -> Expr | NotDifferentiable:
        if node is TIME:
            return ONE
        if node.op == "pre":
            return ZERO
        slope = self._derivative_of(node)
        return NotDifferentiable(node, INPUT) if slope is None else slope

    def _allowed(self, node: Expr) -> bool:
        condition = node.args[0]
        if not any(self._moves(leaf) for leaf in unknown_leaves(condition)):
            return True
        return is_continuous(node, self._moves, self._values)

    def _moves(self, leaf: Expr) -> bool:
        return self._leaf(leaf) is not ZERO


def _no_values(name: str) -> None:
    return None


def time_derivative(root: Expr, derivative_of: DerivativeOf, values: Lookup = _no_values) -> Expr:
    """D root / dt by the chain rule; `TimeDerivative` shares work between many expressions.

    Raises `NotDifferentiable` where a switch is not proven continuous (see the module's text).
    """
    return TimeDerivative(derivative_of, values)(root)
