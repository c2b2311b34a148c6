"""Constructors of expressions, with the rewrites that are exact in real arithmetic and cheap.

Constant folding, neutral elements, double negation, flattening of nested sums and products. Anything
cleverer lives in `simplify`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import isnan

from acausal.symbolic.expressions.kernel import Kernel
from acausal.symbolic.expressions.node import FALSE, ONE, TRUE, ZERO, EnumValue, Expr, call, const, make
from acausal.symbolic.expressions.operators import LARGEST_INTEGER, OPERATORS, RELATIONS

MOST_MERGED = 256
"""Sums and products of more parts stay nested: merging them again and again would take quadratic time, and
`x := x * x` in a loop exponential space."""


def _is_number(node: Expr) -> bool:
    return node.op == "const" and type(node.value) in (float, int)


def _literal(node: Expr) -> float | None:
    """The number that a node is, with its type; None for anything else."""
    value = node.value
    if node.op == "const" and isinstance(value, (float, int)) and not isinstance(value, bool):
        return value
    return None


def _bounded(value: float) -> float:
    """An Integer beyond 64 bits becomes a Real, lest it grow without end."""
    return float(value) if isinstance(value, int) and abs(value) > LARGEST_INTEGER else value


def add(*terms: Expr) -> Expr:
    """Sum; nested sums are flattened up to `MOST_MERGED` terms, literal numbers collected, zeros dropped."""
    flat: list[Expr] = []
    literal: float | int = 0
    for term in terms:
        merged = term.op == "add" and len(term.args) <= MOST_MERGED
        for part in term.args if merged else (term,):
            number = _literal(part)
            if number is None:
                flat.append(part)
            else:
                literal = literal + number
    if isnan(literal):
        return make("add", terms)  # infinity minus infinity: whoever evaluates it can name the place
    if literal != 0 or not flat:
        flat.append(const(_bounded(literal)))
    return flat[0] if len(flat) == 1 else make("add", tuple(flat))


def neg(a: Expr) -> Expr:
    """`-a`."""
    if a.op == "neg":
        return a.args[0]
    number = _literal(a)
    return make("neg", (a,)) if number is None else const(-number)


def sub(a: Expr, b: Expr) -> Expr:
    """`a - b`, held as the sum of `a` and `-b`."""
    if a is b:
        return ZERO
    return add(a, neg_term(b))


def neg_term(a: Expr) -> Expr:
    """`-a`, pushed into a sum so that sums stay flat, unless it is one of those that stay nested."""
    if a.op == "add" and len(a.args) <= MOST_MERGED:
        return add(*[neg(part) for part in a.args])
    return neg(a)


def mul(*factors: Expr) -> Expr:
    """Product; nested products flattened, literals collected, `0` absorbs, signs moved to the front."""
    flat: list[Expr] = []
    literal: float | int = 1
    for factor in factors:
        merged = factor.op == "mul" and len(factor.args) <= MOST_MERGED
        for part in factor.args if merged else (factor,):
            bare = part
            if part.op == "neg":
                literal = -literal
                bare = part.args[0]
            number = _literal(bare)
            if number is not None:
                literal = _bounded(literal * number)
            elif bare.op == "mul" and len(bare.args) <= MOST_MERGED:
                flat.extend(bare.args)
            else:
                flat.append(bare)
    if literal == 0:
        return ZERO
    if isnan(literal):
        return make("mul", factors)
    if not flat:
        return const(_bounded(literal))
    negative = literal == -1
    if literal not in (1, -1):
        flat.insert(0, const(_bounded(literal)))
    product = flat[0] if len(flat) == 1 else make("mul", tuple(flat))
    return neg(product) if negative else product


def div(a: Expr, b: Expr) -> Expr:
    """`a / b` (always Real in Modelica). Division by a literal zero stays and fails when evaluated."""
    if _is_number(b) and b.value != 0:
        if b.value == 1 and not isinstance(a.value, int):
            return a
        if _is_number(a) and not isnan(a.number / b.number):
            return const(a.number / b.number)
        if b.value == -1:
            return neg(a)
    if a.op == "const" and a.value == 0 and b.op != "const":
        return ZERO
    if b.op == "neg":
        return neg(div(a, b.args[0]))
    if a.op == "neg":
        return neg(div(a.args[0], b))
    return make("div", (a, b))


def power(a: Expr, b: Expr) -> Expr:
    """`a ^ b`."""
    if _is_number(b):
        if b.value == 1:
            return a
        if b.value == 0:
            return ONE
        if _is_number(a):
            return _fold("pow", (a, b))
    return make("pow", (a, b))


def relation(op: str, a: Expr, b: Expr) -> Expr:
    """One of `lt le gt ge eq ne`; folded when both sides are constants."""
    return _fold(op, (a, b))


def logical_not(a: Expr) -> Expr:
    """`not a`; a double one cancels."""
    if a.op == "not":
        return a.args[0]
    return _fold("not", (a,))


def logical_and(*terms: Expr) -> Expr:
    """`a and b and ...`; constants and repetitions are dropped."""
    return _logical("and", terms, absorbing=FALSE, neutral=TRUE)


def logical_or(*terms: Expr) -> Expr:
    """`a or b or ...`; constants and repetitions are dropped."""
    return _logical("or", terms, absorbing=TRUE, neutral=FALSE)


def _logical(op: str, terms: Iterable[Expr], absorbing: Expr, neutral: Expr) -> Expr:
    flat: list[Expr] = []
    for term in terms:
        flat.extend(term.args if term.op == op else (term,))
    if absorbing in flat:
        return absorbing
    kept = [term for term in dict.fromkeys(flat) if term is not neutral]
    if not kept:
        return neutral
    return kept[0] if len(kept) == 1 else make(op, tuple(kept))


def if_then_else(condition: Expr, then: Expr, otherwise: Expr) -> Expr:
    """`if condition then … else …`; a constant condition or equal branches decide it."""
    if condition.op == "const":
        return then if condition.value else otherwise
    if then is otherwise:
        return then
    return make("if", (condition, then, otherwise))


def der(a: Expr) -> Expr:
    """`der(a)` as written; `diff.time_derivative` expands it to derivatives of symbols."""
    return make("der", (a,))


def pre(a: Expr) -> Expr:
    """The left limit of `a` at an event."""
    return make("pre", (a,))


def initial() -> Expr:
    """`initial()`: true during initialisation and at its event only."""
    return make("initial")


def terminal() -> Expr:
    """`terminal()`: true at the end of a successful simulation."""
    return make("terminal")


def sample(start: Expr, interval: Expr) -> Expr:
    """`sample(start, interval)`: true at the events start + i*interval, i = 0, 1, ..., and only then (s)."""
    return make("sample", (start, interval))


def ordinal(a: Expr) -> Expr:
    """`Integer(a)`: the number of an enumeration's literal, from 1."""
    return const(a.value.index) if isinstance(a.value, EnumValue) else make("ordinal", (a,))


def trigger(a: Expr) -> Expr:
    """The `when`-condition `a` fires: `a and not pre(a)`; `initial()` during initialisation (8.3.5)."""
    return a if a is FALSE or a.op == "initial" else make("trigger", (a,))


def delay(a: Expr, *times: Expr) -> Expr:
    """`delay(a, T)` or `delay(a, T, Tmax)`: a at time - T, times in s; the first value of a before that."""
    return a if a.op == "const" else make("delay", (a, *times))


def homotopy(actual: Expr, simplified: Expr) -> Expr:
    """`homotopy(actual, simplified)`: `actual`, which initialisation may reach from the other (3.7.4.3)."""
    return actual if actual is simplified else make("homotopy", (actual, simplified))


def no_event(a: Expr) -> Expr:
    """`noEvent(a)`: no events for the relations in `a`."""
    return a if a.op in ("const", "sym", "noEvent") else make("noEvent", (a,))


def smooth(order: int, a: Expr) -> Expr:
    """`smooth(order, a)`: `a` is `order` times continuously differentiable, whatever ifs it holds."""
    return a if a.op in ("const", "sym") else make("smooth", (a,), order)


def function(name: str, *args: Expr) -> Expr:
    """A built-in function of the operator table, folded when all arguments are constants."""
    return _fold(name, args)


def apply(kernel: Kernel, *args: Expr) -> Expr:
    """The call of a kernel, folded when all arguments are constants."""
    if args and all(arg.op == "const" for arg in args):
        values = [arg.value for arg in args if arg.value is not None]
        plain = [value.index if isinstance(value, EnumValue) else value for value in values]
        try:
            return const(kernel.evaluate(*plain))
        except (ArithmeticError, ValueError):
            return call(kernel, *args)  # left for the evaluation that can name the place
    return call(kernel, *args)


def derived(a: Expr, derivative: Expr) -> Expr:
    """`a`, whose time derivative is `derivative` because its author says so (Modelica 3.6, 12.7.1).

    In `derivative`, `rate(u)` stands for the time derivative of `u`, which is found when it is needed.
    """
    return make("derived", (a, derivative))


def rate(a: Expr) -> Expr:
    """The time derivative of `a` inside the second argument of `derived`."""
    return make("rate", (a,))


def _fold(op: str, args: tuple[Expr, ...]) -> Expr:
    evaluate = OPERATORS[op].evaluate
    if evaluate is not None and all(arg.op == "const" for arg in args):
        values = [arg.value.index if isinstance(arg.value, EnumValue) else arg.value for arg in args]
        try:
            return const(evaluate(*values))
        except (ArithmeticError, ValueError, TypeError):
            return make(op, args)  # left for the evaluation that can name the place
    return make(op, args)


def rebuild(node: Expr, args: tuple[Expr, ...]) -> Expr:
    """The node with other arguments, through the simplifying constructors."""
    op = node.op
    special = _REBUILD.get(op)
    if special is not None:
        return special(*args)
    if op == "call":
        return apply(node.kernel, *args)
    if op == "smooth":
        return smooth(node.value, args[0])  # type: ignore[arg-type]  # the order of a smooth node is an int
    if op in RELATIONS or OPERATORS[op].shape == "function":
        return _fold(op, args)
    return make(op, args, node.value)


_REBUILD: dict[str, Callable[..., Expr]] = {
    "add": add,
    "neg": neg,
    "mul": mul,
    "div": div,
    "pow": power,
    "not": logical_not,
    "and": logical_and,
    "or": logical_or,
    "if": if_then_else,
    "noEvent": no_event,
    "ordinal": ordinal,
    "trigger": trigger,
    "delay": delay,
    "homotopy": homotopy,
    "derived": derived,
}
