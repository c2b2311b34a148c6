"""Hash-consed scalar expressions.

Two structurally equal expressions are the same object, so equality is identity, hashing is free and every
rewrite can be memoised per node. Expressions know no model: a variable is a symbol with a name; what the
name means is the caller's business. All walks are iterative over the directed acyclic graph, because
models hold sums of thousands of terms.

Constructors (`add`, `mul`, `call`, ...) apply only rewrites that are exact in real arithmetic and cheap:
constant folding, neutral elements, double negation, flattening of nested sums and products. Anything
cleverer lives in `simplify`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import TypeVar
from weakref import WeakValueDictionary

from acausal.symbolic.expressions.operators import OPERATORS, RELATIONS


@dataclass(frozen=True, slots=True)
class EnumValue:
    """A literal of an enumeration: `index` counts from 1, as `Integer(e)` does."""

    type_name: str
    literal: str
    index: int


Constant = float | int | bool | str | EnumValue
_T = TypeVar("_T")


class Expr:
    """A node: `op` from the operator table, `args`, and `value` (constant, symbol or function name, order).

    Never construct one directly; use the functions of this module.
    """

    __slots__ = ("__weakref__", "args", "op", "value")
    op: str
    args: tuple[Expr, ...]
    value: Constant | None

    def __repr__(self) -> str:
        from acausal.symbolic.expressions.text import to_text  # the printer sits above this module

        return f"Expr({to_text(self)})"

    def __reduce__(self) -> tuple[Callable[..., Expr], tuple[object, ...]]:
        return make, (self.op, self.args, self.value)

    @property
    def name(self) -> str:
        """The name of a symbol or of a called function."""
        if not isinstance(self.value, str):
            raise TypeError(f"{self.op} has no name")
        return self.value

    @property
    def is_const(self) -> bool:
        return self.op == "const"

    @property
    def number(self) -> float:
        """The numeric value of a constant (Boolean 0/1, enumeration: its index)."""
        value = self.value
        if self.op != "const" or value is None or isinstance(value, str):
            raise TypeError(f"{self.op} is not a numeric constant")
        return float(value.index) if isinstance(value, EnumValue) else float(value)


_table: WeakValueDictionary[object, Expr] = WeakValueDictionary()


def make(op: str, args: tuple[Expr, ...] = (), value: Constant | None = None) -> Expr:
    """The unique node with these parts, without any simplification."""
    key = (op, args, value, value.__class__) if op == "const" else (op, args, value)
    found = _table.get(key)
    if found is not None:
        return found
    node = Expr()
    node.op = op
    node.args = args
    node.value = value
    _table[key] = node
    return node


def const(value: Constant) -> Expr:
    """A literal. Reals, Integers, Booleans, Strings and enumeration values stay distinct."""
    if isinstance(value, float):
        if value != value:
            raise ValueError("not-a-number is not a literal")
        value = value + 0.0  # -0.0 becomes 0.0
    return make("const", (), value)


def sym(name: str) -> Expr:
    """A variable or parameter by its flat name."""
    return make("sym", (), name)


TIME = sym("time")
ZERO = const(0.0)
ONE = const(1.0)
TRUE = const(True)
FALSE = const(False)


def _is_number(node: Expr) -> bool:
    return node.op == "const" and type(node.value) in (float, int)


def add(*terms: Expr) -> Expr:
    """Sum; nested sums are flattened, literal numbers collected, zeros dropped."""
    flat: list[Expr] = []
    literal: float | int = 0
    for term in terms:
        for part in term.args if term.op == "add" else (term,):
            if _is_number(part):
                literal = literal + part.value  # type: ignore[operator]  # _is_number proved it
            else:
                flat.append(part)
    if literal != 0 or not flat:
        flat.append(const(literal))
    return flat[0] if len(flat) == 1 else make("add", tuple(flat))


def neg(a: Expr) -> Expr:
    """`-a`."""
    if a.op == "neg":
        return a.args[0]
    if _is_number(a):
        return const(-a.value)  # type: ignore[operator]
    return make("neg", (a,))


def sub(a: Expr, b: Expr) -> Expr:
    """`a - b`, held as the sum of `a` and `-b`."""
    if a is b:
        return ZERO
    return add(a, neg_term(b))


def neg_term(a: Expr) -> Expr:
    """`-a`, pushed into a sum so that sums stay flat."""
    if a.op == "add":
        return add(*[neg(part) for part in a.args])
    return neg(a)


def mul(*factors: Expr) -> Expr:
    """Product; nested products flattened, literals collected, `0` absorbs, signs moved to the front."""
    flat: list[Expr] = []
    literal: float | int = 1
    for factor in factors:
        for part in factor.args if factor.op == "mul" else (factor,):
            if part.op == "neg":
                literal = -literal
                part = part.args[0]
            if _is_number(part):
                literal = literal * part.value  # type: ignore[operator]
            elif part.op == "mul":
                flat.extend(part.args)
            else:
                flat.append(part)
    if literal == 0:
        return ZERO
    if not flat:
        return const(literal)
    negative = literal == -1
    if literal not in (1, -1):
        flat.insert(0, const(literal))
    product = flat[0] if len(flat) == 1 else make("mul", tuple(flat))
    return neg(product) if negative else product


def div(a: Expr, b: Expr) -> Expr:
    """`a / b` (always Real in Modelica). Division by a literal zero stays and fails when evaluated."""
    if _is_number(b) and b.value != 0:
        if b.value == 1 and not isinstance(a.value, int):
            return a
        if _is_number(a):
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
        if _is_number(a) and (a.number > 0 or b.number == int(b.number) > 0):
            return const(a.number**b.number)
    return make("pow", (a, b))


def relation(op: str, a: Expr, b: Expr) -> Expr:
    """One of `lt le gt ge eq ne`; folded when both sides are constants."""
    return _fold(op, (a, b))


def logical_not(a: Expr) -> Expr:
    if a.op == "not":
        return a.args[0]
    return _fold("not", (a,))


def logical_and(*terms: Expr) -> Expr:
    return _logical("and", terms, absorbing=FALSE, neutral=TRUE)


def logical_or(*terms: Expr) -> Expr:
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
    return make("pre", (a,))


def no_event(a: Expr) -> Expr:
    return a if a.op in ("const", "sym", "noEvent") else make("noEvent", (a,))


def smooth(order: int, a: Expr) -> Expr:
    """`smooth(order, a)`: `a` is `order` times continuously differentiable, whatever ifs it holds."""
    return a if a.op in ("const", "sym") else make("smooth", (a,), order)


def function(name: str, *args: Expr) -> Expr:
    """A built-in function of the operator table, folded when all arguments are constants."""
    return _fold(name, args)


def call(name: str, *args: Expr) -> Expr:
    """A call of a user function that is not inlined."""
    return make("call", args, name)


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
}


# --------------------------------------------------------------------------- walks


def postorder(roots: Iterable[Expr]) -> Iterator[Expr]:
    """Every distinct node below `roots`, arguments before users. Iterative."""
    seen: set[Expr] = set()
    for root in roots:
        if root in seen:
            continue
        stack = [(root, iter(root.args))]
        seen.add(root)
        while stack:
            node, pending = stack[-1]
            for arg in pending:
                if arg not in seen:
                    seen.add(arg)
                    stack.append((arg, iter(arg.args)))
                    break
            else:
                stack.pop()
                yield node


def fold(
    roots: Iterable[Expr], visit: Callable[[Expr, list[_T]], _T], memo: dict[Expr, _T] | None = None
) -> dict[Expr, _T]:
    """Value of every node below `roots`: `visit(node, values of its args)`, each node once.

    `memo` may be passed to share results between calls and to preset the values of nodes.
    """
    values: dict[Expr, _T] = {} if memo is None else memo
    for root in roots:
        if root in values:
            continue
        stack = [root]
        while stack:
            node = stack[-1]
            if node in values:
                stack.pop()
                continue
            missing = [arg for arg in node.args if arg not in values]
            if missing:
                stack.extend(reversed(missing))
            else:
                stack.pop()
                values[node] = visit(node, [values[arg] for arg in node.args])
    return values


def substitute(root: Expr, mapping: Mapping[Expr, Expr], memo: dict[Expr, Expr] | None = None) -> Expr:
    """Replace nodes (usually symbols) by expressions; unchanged parts are shared.

    Pass the same `memo` for many roots with the same mapping.
    """
    values: dict[Expr, Expr] = {} if memo is None else memo
    if not values:
        values.update(mapping)

    def visit(node: Expr, args: list[Expr]) -> Expr:
        if not args:
            return node
        new = tuple(args)
        return node if new == node.args else rebuild(node, new)

    return fold([root], visit, values)[root]


def unknown_leaves(root: Expr) -> tuple[Expr, ...]:
    """The distinct symbols and derivatives of symbols, in order of first appearance.

    `der(x)` counts as one leaf (and `x` inside it does not); so does `pre(x)`.
    """
    found: dict[Expr, None] = {}
    seen: set[Expr] = set()
    stack = [root]
    while stack:
        node = stack.pop()
        if node in seen:
            continue
        seen.add(node)
        if node.op == "sym" or node.op in ("der", "pre"):
            found[node] = None
        else:
            stack.extend(reversed(node.args))
    return tuple(found)


def symbols(roots: Iterable[Expr]) -> tuple[str, ...]:
    """Names of all symbols below `roots` (also inside `der`), in order of first appearance."""
    return tuple(dict.fromkeys(node.name for node in postorder(roots) if node.op == "sym"))
