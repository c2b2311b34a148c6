"""Type and variability of scalar expressions (Modelica 3.6, chapters 3 and 6.7), one node at a time.

A `Kind` is what is known of a node: its type, its variability (a relation of continuous numbers is
discrete, since it changes at events only), and `raw`, the variability as it is inside `noEvent`.
Kinds are shared objects, so that the common case, arithmetic of continuous Reals, is an identity test.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

from acausal.lang.flat import BOOLEAN, INTEGER, REAL, STRING, ScalarType, Variability
from acausal.symbolic.expressions.expr import EnumValue, Expr
from acausal.symbolic.expressions.kernel import Named
from acausal.symbolic.expressions.operators import OPERATORS, RELATIONS
from acausal.symbolic.expressions.text import beginning


@dataclass(frozen=True, slots=True)
class Kind:
    """Type and variability of an expression; made by `kind` only."""

    type: ScalarType
    variability: Variability
    raw: Variability


@lru_cache(maxsize=4096)
def kind(type_: ScalarType, variability: Variability, raw: Variability | None = None) -> Kind:
    """The shared `Kind` with these parts; `raw` is `variability` unless given."""
    return Kind(type_, variability, variability if raw is None else raw)


REAL_CONTINUOUS = kind(REAL, Variability.CONTINUOUS)


class TypeMistake(Exception):
    """An expression that has no type; `node` is the offending one."""

    def __init__(self, code: str, message: str, node: Expr, hint: str = "") -> None:
        super().__init__(message)
        self.code = code
        self.message = message
        self.node = node
        self.hint = hint


def kind_of(node: Expr, args: list[Kind]) -> Kind:
    """The kind of a node that is not a symbol, from the kinds of its arguments; raises `TypeMistake`."""
    op = node.op
    if op in _ARITHMETIC and args[0] is REAL_CONTINUOUS and all(arg is REAL_CONTINUOUS for arg in args):
        return REAL_CONTINUOUS
    arity = OPERATORS[op].arity
    if arity is not None and arity != len(args):
        raise TypeMistake("type.arguments", f"{op} takes {arity} arguments, not {len(args)}", node)
    return _RULES[op](node, args)


def assignable(target: ScalarType, source: ScalarType) -> bool:
    """Whether a value of type `source` may be given to a variable of type `target`."""
    return target.name == source.name or (target == REAL and source == INTEGER)


def comparable(a: ScalarType, b: ScalarType) -> bool:
    """Whether the two sides of an equation may have these types."""
    return a.name == b.name or (a.is_numeric and b.is_numeric)


def short_text(node: Expr) -> str:
    """The expression, in quotes and cut for a message."""
    text = beginning(node, 60)
    return f"`{text if len(text) <= 60 else text[:57] + '...'}`"


# ------------------------------------------------------------------------------ rules

_Rule = Callable[[Expr, list[Kind]], Kind]


def _join(type_: ScalarType, args: list[Kind]) -> Kind:
    return kind(type_, max([arg.variability for arg in args]), max([arg.raw for arg in args]))


def _numeric(node: Expr, args: list[Kind]) -> None:
    for part, arg in zip(node.args, args, strict=True):
        if not arg.type.is_numeric:
            operator = OPERATORS[node.op].text
            message = f"`{operator}` needs numbers, but {short_text(part)} is {article(arg.type)}"
            hint = "a Boolean becomes a number by `if b then 1 else 0`" if arg.type == BOOLEAN else ""
            raise TypeMistake("type.operand", message, node, hint)


def article(type_: ScalarType) -> str:
    """`a Boolean`, `an Integer`, `a value of the enumeration Modes`."""
    if type_.name in ("Real", "Integer", "Boolean", "String"):
        return f"{'an' if type_ == INTEGER else 'a'} {type_.name}"
    return f"a value of the enumeration {type_.name}"


def _constant(node: Expr, _args: list[Kind]) -> Kind:
    value = node.value
    if isinstance(value, EnumValue):
        return kind(ScalarType(value.type_name, (value.literal,)), Variability.CONSTANT)
    types = {bool: BOOLEAN, int: INTEGER, float: REAL, str: STRING}
    return kind(types[type(value)], Variability.CONSTANT)  # type: ignore[index]  # a const has a value


def _promote(node: Expr, args: list[Kind]) -> Kind:
    """Integers stay Integers, with any Real the result is Real."""
    _numeric(node, args)
    return _join(REAL if any(arg.type == REAL for arg in args) else INTEGER, args)


def _sum(node: Expr, args: list[Kind]) -> Kind:
    if all(arg.type == STRING for arg in args):
        return _join(STRING, args)
    return _promote(node, args)


def _to_real(node: Expr, args: list[Kind]) -> Kind:
    _numeric(node, args)
    return _join(REAL, args)


def _discrete(type_: ScalarType, args: list[Kind]) -> Kind:
    """What changes at events only, unless it stands inside `noEvent`."""
    joined = _join(type_, args)
    return kind(type_, min(joined.variability, Variability.DISCRETE), joined.raw)


def _to_integer(node: Expr, args: list[Kind]) -> Kind:
    """`integer(x)` of a number, `Integer(e)` of an enumeration."""
    if not args[0].type.is_enumeration:
        _numeric(node, args)
    return _discrete(INTEGER, args)


def _ordinal(node: Expr, args: list[Kind]) -> Kind:
    """`Integer(e)` of an enumeration."""
    if not args[0].type.is_enumeration:
        message = f"Integer needs an enumeration, but {short_text(node.args[0])} is {article(args[0].type)}"
        raise TypeMistake("type.operand", message, node)
    return _join(INTEGER, args)


def _sign(node: Expr, args: list[Kind]) -> Kind:
    """Like `noEvent(if x > 0 ...)` (3.7.1): no event, hence not discrete."""
    _numeric(node, args)
    return _join(INTEGER, args)


def _rounding(node: Expr, args: list[Kind]) -> Kind:
    _numeric(node, args)
    return _discrete(REAL, args)


def _quotient(node: Expr, args: list[Kind]) -> Kind:
    return _discrete(_promote(node, args).type, args)


def _extreme(node: Expr, args: list[Kind]) -> Kind:
    return _join(_common(node, node.args, args), args)


def _common(node: Expr, parts: tuple[Expr, ...], args: list[Kind]) -> ScalarType:
    first, second = args
    if first.type.name == second.type.name:
        return first.type
    if first.type.is_numeric and second.type.is_numeric:
        return REAL
    left, right = (
        f"{short_text(part)} is {article(arg.type)}" for part, arg in zip(parts, args, strict=True)
    )
    what = "both branches of an `if`" if node.op == "if" else f"both sides of `{OPERATORS[node.op].text}`"
    raise TypeMistake("type.mismatch", f"{what} must have one type, but {left} and {right}", node)


def _relation(node: Expr, args: list[Kind]) -> Kind:
    """Equality of Reals is judged by `verify`, which knows where the relation stands."""
    _common(node, node.args, args)
    return _join(BOOLEAN, args) if node.op in EQUALITIES else _discrete(BOOLEAN, args)


def _logical(node: Expr, args: list[Kind]) -> Kind:
    for part, arg in zip(node.args, args, strict=True):
        if arg.type != BOOLEAN:
            message = (
                f"`{OPERATORS[node.op].text}` needs Booleans, but {short_text(part)} is {article(arg.type)}"
            )
            raise TypeMistake("type.operand", message, node)
    return _join(BOOLEAN, args)


def _event_flag(_node: Expr, args: list[Kind]) -> Kind:
    """`initial()`, `terminal()`, and `sample` of its two times."""
    for arg in args:
        if not arg.type.is_numeric:
            raise TypeMistake("type.operand", f"sample needs two times, not {article(arg.type)}", _node)
    return kind(BOOLEAN, Variability.DISCRETE)


def _trigger(node: Expr, args: list[Kind]) -> Kind:
    if args[0].type != BOOLEAN:
        condition = short_text(node.args[0])
        message = f"the condition of a `when` must be Boolean, but {condition} is {article(args[0].type)}"
        raise TypeMistake("type.condition", message, node, "compare it: `x > 0`")
    if args[0].variability is Variability.CONTINUOUS:
        message = f"the condition of a `when` must be discrete, but {short_text(node.args[0])} is continuous"
        raise TypeMistake("when.condition", message, node, "a relation is discrete outside noEvent")
    return kind(BOOLEAN, Variability.DISCRETE)


def _delay(node: Expr, args: list[Kind]) -> Kind:
    if len(args) not in (2, 3):
        raise TypeMistake("type.arguments", f"delay takes 2 or 3 arguments, not {len(args)}", node)
    for part, arg in zip(node.args[1:], args[1:], strict=True):
        if not arg.type.is_numeric:
            message = f"delay needs a time in seconds, but {short_text(part)} is {article(arg.type)}"
            raise TypeMistake("type.operand", message, node)
    return kind(args[0].type, Variability.CONTINUOUS)


def _homotopy(node: Expr, args: list[Kind]) -> Kind:
    return _join(_common(node, node.args, args), args)


def _at_events(condition: Expr) -> bool:
    """Whether a condition is true at events only, so that what it guards is computed at events only."""
    if condition.op == "or":
        return all(_at_events(part) for part in condition.args)
    if condition.op == "and":
        return any(_at_events(part) for part in condition.args)
    return condition.op in ("trigger", "sample", "initial")


def _if(node: Expr, args: list[Kind]) -> Kind:
    if args[0].type != BOOLEAN:
        condition = short_text(node.args[0])
        message = f"the condition of an `if` must be Boolean, but {condition} is {article(args[0].type)}"
        raise TypeMistake("type.condition", message, node, "compare it: `x > 0`")
    type_ = _common(node, node.args[1:], args[1:])
    if args[1].variability is Variability.CONTINUOUS and _at_events(node.args[0]):
        return _join(type_, [args[0], kind(args[1].type, Variability.DISCRETE), args[2]])
    return _join(type_, args)


def _der(node: Expr, args: list[Kind]) -> Kind:
    arg = args[0]
    if arg.type != REAL:
        message = f"der needs a continuous Real, but {short_text(node.args[0])} is {article(arg.type)}"
        raise TypeMistake("type.der", message, node)
    if Variability.DISCRETE in (arg.variability, arg.raw):
        message = f"{short_text(node.args[0])} is discrete and has no derivative"
        raise TypeMistake("type.der", message, node, "it is constant between events")
    return kind(REAL, Variability.CONTINUOUS)


def _pre(node: Expr, args: list[Kind]) -> Kind:
    """That the variable is discrete is judged by `verify`, since initial equations may use any."""
    if node.args[0].op != "sym":
        raise TypeMistake("type.pre", f"pre needs a variable, not {short_text(node.args[0])}", node)
    return kind(args[0].type, Variability.DISCRETE)


def _no_event(_node: Expr, args: list[Kind]) -> Kind:
    return kind(args[0].type, args[0].raw)


def _smooth(node: Expr, args: list[Kind]) -> Kind:
    _numeric(node, args)
    if not isinstance(node.value, int) or node.value < 0:
        raise TypeMistake("type.smooth", "the order of smooth must be an Integer that is not negative", node)
    return args[0]


def _call(node: Expr, args: list[Kind]) -> Kind:
    """A kernel raises no events, so its value varies as its arguments do."""
    kernel = node.kernel
    if isinstance(kernel, Named):
        message = (
            f"a call of the function {kernel.name} is left, but the functions of a flat model are inlined"
        )
        raise TypeMistake("flat.function-call", message, node)
    if len(args) != kernel.arity:
        message = f"{kernel.name} takes {kernel.arity} arguments, not {len(args)}"
        raise TypeMistake("type.arguments", message, node)
    type_ = _RESULTS[kernel.result]
    return _join(type_, args) if args else kind(type_, Variability.CONSTANT)


def _derived(_node: Expr, args: list[Kind]) -> Kind:
    return args[0]


_RESULTS = {type_.name: type_ for type_ in (REAL, INTEGER, BOOLEAN, STRING)}
EQUALITIES = frozenset({"eq", "ne"})
_ARITHMETIC = frozenset({"add", "neg", "mul", "div", "pow"})
_RULES: dict[str, _Rule] = {
    "const": _constant,
    "der": _der,
    "pre": _pre,
    "noEvent": _no_event,
    "smooth": _smooth,
    "call": _call,
    **dict.fromkeys(("initial", "terminal", "sample"), _event_flag),
    "trigger": _trigger,
    "delay": _delay,
    "homotopy": _homotopy,
    "derived": _derived,
    "rate": _der,
    "if": _if,
    "add": _sum,
    "sign": _sign,
    "integer": _to_integer,
    "ordinal": _ordinal,
    "idiv": _quotient,
    **dict.fromkeys(("neg", "mul", "abs", "mod", "rem"), _promote),
    **dict.fromkeys(("and", "or", "not"), _logical),
    **dict.fromkeys(RELATIONS, _relation),
    **dict.fromkeys(("min", "max"), _extreme),
    **dict.fromkeys(("floor", "ceil"), _rounding),
    **dict.fromkeys(
        "div pow sqrt sin cos tan asin acos atan atan2 sinh cosh tanh exp log log10".split(), _to_real
    ),
}
