"""Expressions as CasADi SX: every node once, without Python recursion.

Conditions. CasADi's SX has no `if`; `if_else(c, a, b)` becomes `(c ? a : 0) + (!c ? b : 0)`, where each
half is one operation (OP_IF_ELSE_ZERO) that does not read the untaken branch, so a square root of a
negative number or a division by zero in there does no harm (0 * NaN never occurs). Its *forward* derivative
`(c ? a' : 0)` is as safe. Its *reverse* derivative is not: where two conditions share a subexpression `u =
log(x)`, the sweep adds their masked seeds to 0 first and then multiplies by 1/x, which at x = 0 gives 0 *
inf = NaN. Hence `FORWARD` and `jacobian`: everything here differentiates forward.
`tests/codegen/test_casadi_expressions.py` shows both.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

import casadi as ca
from casadi import SX

from acausal.codegen.kernels import kernel_sx, whole_sx
from acausal.errors import UnsupportedProblem, fail
from acausal.symbolic.expressions.expr import EnumValue, Expr, parts
from acausal.symbolic.expressions.kernel import Part
from acausal.symbolic.expressions.kernels.formula import Formula
from acausal.symbolic.expressions.node import Wide
from acausal.symbolic.expressions.operators import SWITCHING

FORWARD = {"ad_weight": 0.0}
"""Options that make a CasADi Function differentiate forward only."""

_Build = Callable[[list[SX]], SX]


def jacobian(of: SX, by: SX) -> SX:
    """The sparse exact Jacobian by forward differentiation with coloured columns."""
    return ca.jacobian(of, by, {"helper_options": FORWARD})


def _unary(code: int) -> _Build:
    return lambda args: SX.unary(code, args[0])


def _binary(code: int) -> _Build:
    return lambda args: SX.binary(code, args[0], args[1])


def _swapped(code: int) -> _Build:
    return lambda args: SX.binary(code, args[1], args[0])


def _chain(code: int) -> _Build:
    def build(args: list[SX]) -> SX:
        total = args[0]
        for arg in args[1:]:
            total = SX.binary(code, total, arg)
        return total

    return build


def _select(args: list[SX]) -> SX:
    condition, then, otherwise = args
    taken = SX.binary(ca.OP_IF_ELSE_ZERO, condition, then)
    other = SX.binary(ca.OP_IF_ELSE_ZERO, SX.unary(ca.OP_NOT, condition), otherwise)
    return SX.binary(ca.OP_ADD, taken, other)


def _root(args: list[SX]) -> SX:
    """`sqrt(x)`; of `max(0, u)` as an `if`: its slope is infinite where that of `max` is 0."""
    (x,) = args
    if x.is_op(ca.OP_FMAX) and any(x.dep(i).is_zero() for i in (0, 1)):
        u = x.dep(1 if x.dep(0).is_zero() else 0)
        return SX.binary(ca.OP_IF_ELSE_ZERO, SX.binary(ca.OP_LT, SX(0.0), u), SX.unary(ca.OP_SQRT, u))
    return SX.unary(ca.OP_SQRT, x)


def _power(args: list[SX]) -> SX:
    """The fourth root, as that of a pressure difference, is two square roots, which cost less than `pow`."""
    base, exponent = args
    if exponent.is_constant() and float(exponent) == 0.25:
        return SX.unary(ca.OP_SQRT, SX.unary(ca.OP_SQRT, base))
    return SX.binary(ca.OP_POW, base, exponent)


def _log10(args: list[SX]) -> SX:
    return ca.log10(args[0])


def _first(args: list[SX]) -> SX:
    """What is only its first argument: `homotopy(actual, simplified)` at its end, the number of a literal."""
    return args[0]


def _truncated_quotient(args: list[SX]) -> SX:
    """`div(a, b)`: the quotient rounded towards zero."""
    quotient = SX.binary(ca.OP_DIV, args[0], args[1])
    size = SX.unary(ca.OP_FLOOR, SX.unary(ca.OP_FABS, quotient))
    return SX.binary(ca.OP_MUL, SX.unary(ca.OP_SIGN, quotient), size)


def _mod(args: list[SX]) -> SX:
    """`a - floor(a / b) b`, with the sign of `b`."""
    quotient = SX.unary(ca.OP_FLOOR, SX.binary(ca.OP_DIV, args[0], args[1]))
    return SX.binary(ca.OP_SUB, args[0], SX.binary(ca.OP_MUL, quotient, args[1]))


def _rem(args: list[SX]) -> SX:
    """`a - div(a, b) b`, with the sign of `a`."""
    return SX.binary(ca.OP_SUB, args[0], SX.binary(ca.OP_MUL, _truncated_quotient(args), args[1]))


CONSTRUCTORS: dict[str, _Build] = {
    "add": _chain(ca.OP_ADD),
    "mul": _chain(ca.OP_MUL),
    "neg": _unary(ca.OP_NEG),
    "div": _binary(ca.OP_DIV),
    "pow": _power,
    "if": _select,
    "and": _chain(ca.OP_AND),
    "or": _chain(ca.OP_OR),
    "not": _unary(ca.OP_NOT),
    "lt": _binary(ca.OP_LT),
    "le": _binary(ca.OP_LE),
    "gt": _swapped(ca.OP_LT),
    "ge": _swapped(ca.OP_LE),
    "eq": _binary(ca.OP_EQ),
    "ne": _binary(ca.OP_NE),
    "sin": _unary(ca.OP_SIN),
    "cos": _unary(ca.OP_COS),
    "tan": _unary(ca.OP_TAN),
    "asin": _unary(ca.OP_ASIN),
    "acos": _unary(ca.OP_ACOS),
    "atan": _unary(ca.OP_ATAN),
    "atan2": _binary(ca.OP_ATAN2),
    "sinh": _unary(ca.OP_SINH),
    "cosh": _unary(ca.OP_COSH),
    "tanh": _unary(ca.OP_TANH),
    "exp": _unary(ca.OP_EXP),
    "log": _unary(ca.OP_LOG),
    "log10": _log10,
    "sqrt": _root,
    "abs": _unary(ca.OP_FABS),
    "sign": _unary(ca.OP_SIGN),
    "min": _binary(ca.OP_FMIN),
    "max": _binary(ca.OP_FMAX),
    "floor": _unary(ca.OP_FLOOR),
    "ceil": _unary(ca.OP_CEIL),
    "integer": _unary(ca.OP_FLOOR),
    "idiv": _truncated_quotient,
    "mod": _mod,
    "rem": _rem,
    "homotopy": _first,
    "ordinal": _first,
}
"""SX constructor of every operator that is a function of its arguments' values."""

WRAPPERS = frozenset({"noEvent", "smooth"})
"""Below these, relations are computed instead of being events."""


class Converter:
    """Converts expressions to SX over fixed leaves; the memos live as long as the converter.

    `leaves` gives the SX of symbols, `der(x)` and anything else that is an input (more may be added between
    calls, as blocks are solved). A relation or `integer` in `modes` becomes its symbol, except below
    `noEvent` and `smooth`, where it is computed: hence one memo for each of the two contexts.
    """

    def __init__(self, leaves: dict[Expr, SX], modes: dict[Expr, SX]) -> None:
        self.leaves = leaves
        self.modes = modes
        self._memos: tuple[dict[Expr, SX], dict[Expr, SX]] = ({}, {})
        self._results: tuple[_Results, _Results] = ({}, {})

    def __call__(self, root: Expr, literal: bool = False) -> SX:
        """The SX of `root`; `literal` computes relations even where they are events."""
        result = self._known(root, literal)
        return result if result is not None else self._convert(root, literal)

    def _known(self, node: Expr, literal: bool) -> SX | None:
        found = self.leaves.get(node)
        if found is None:
            found = self._memos[literal].get(node)
        if found is None and not literal and node.op in SWITCHING:
            found = self.modes.get(node)
        return found

    def _convert(self, root: Expr, root_literal: bool) -> SX:
        known = self._known
        stack: list[tuple[Expr, bool, bool]] = [(root, root_literal, root_literal or root.op in WRAPPERS)]
        while stack:
            node, literal, below = stack[-1]
            if node in self._memos[literal]:
                stack.pop()
                continue
            if node.op == "call" and isinstance(node.kernel, Part):
                found = self._results[literal].get((node.kernel.whole.key, node.wide or node.args))
                if found is not None:
                    stack.pop()
                    self._memos[literal][node] = found[node.kernel.index]
                    continue
            args: list[SX] = []
            pending = parts(node)
            for arg in pending:
                value = known(arg, below)
                if value is not None:
                    args.append(value)
                else:
                    stack.append((arg, below, below or arg.op in WRAPPERS))
            if len(args) == len(pending):
                stack.pop()
                self._memos[literal][node] = self._built(node, args, literal)
        result = known(root, root_literal)
        assert result is not None
        return result

    def _built(self, node: Expr, args: list[SX], literal: bool) -> SX:
        if node.op != "call" or not isinstance(node.kernel, Part) or node.kernel.result == "String":
            return _build(node, args)
        whole = node.kernel.whole
        column = whole_sx(whole, ca.vertcat(*args) if args else SX(0, 1), _formula)
        found = self._results[literal][whole.key, node.wide or node.args] = list(ca.vertsplit(column))
        return found[node.kernel.index]


_Results = dict[tuple[str, Wide | tuple[Expr, ...]], list[SX]]
"""What calls with the same arguments come to, all results of a function together."""


def _formula(formula: Formula, formals: SX) -> SX:
    """The results of a function written out, at values of its arguments."""
    leaves = dict(zip(formula.formals, ca.vertsplit(formals), strict=True))
    return ca.densify(ca.vertcat(*to_casadi(formula.results, leaves)))


def to_casadi(
    roots: Iterable[Expr], leaves: Mapping[Expr, SX], modes: Mapping[Expr, SX] | None = None
) -> list[SX]:
    """The SX of each root, sharing every node. Raises `UnsupportedProblem` for what has no numeric code."""
    convert = Converter(dict(leaves), dict(modes or {}))
    return [convert(root) for root in roots]


def _build(node: Expr, args: list[SX]) -> SX:
    op = node.op
    constructor = CONSTRUCTORS.get(op)
    if constructor is not None:
        return constructor(args)
    if op == "const":
        return _constant(node)
    if op in WRAPPERS or op == "derived":
        return args[0]
    if op == "call":
        return kernel_sx(node.kernel, args)
    raise _refuse(node)


def _constant(node: Expr) -> SX:
    value = node.value
    if isinstance(value, EnumValue):
        return SX(float(value.index))
    if value is None or isinstance(value, str):
        raise _refuse(node)
    return SX(float(value))


def _refuse(node: Expr) -> Exception:
    what = {
        "sym": f"`{node.value}` has no value here",
        "const": f"the string {node.value!r} has no numeric value",
    }
    message = what.get(node.op, f"`{node.op}` cannot be turned into code")
    names = (node.name,) if node.op == "sym" else ()
    return fail(UnsupportedProblem, "codegen.no-code", message, names=names)
