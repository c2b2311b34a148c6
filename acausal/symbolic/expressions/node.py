"""Hash-consed nodes: two structurally equal expressions are the same object.

Expressions know no model: a variable is a symbol with a name; what the name means is the caller's business.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from math import isnan
from typing import TYPE_CHECKING
from weakref import WeakValueDictionary, ref

if TYPE_CHECKING:  # a kernel works on constants
    from acausal.symbolic.expressions.kernel import Kernel


@dataclass(frozen=True, slots=True)
class EnumValue:
    """A literal of an enumeration: `index` counts from 1, as `Integer(e)` does."""

    type_name: str
    literal: str
    index: int


Constant = float | int | bool | str | EnumValue


class Expr:
    """A node: `op` from the operator table, `args`, and `value` (constant, name of a symbol, order, key).

    `kernel` and `wide` exist on calls only; `value` is the kernel's key there. Never construct a node
    directly; use the functions of this module.
    """

    __slots__ = ("__weakref__", "args", "kernel", "op", "value", "wide")
    op: str
    args: tuple[Expr, ...]
    value: Constant | None
    kernel: Kernel
    wide: Wide | None
    """Of a call with many arguments: what it shares with all other calls that have the same ones."""

    def __repr__(self) -> str:
        from acausal.symbolic.expressions.text import to_text  # the printer sits above this module

        return f"Expr({to_text(self)})"

    def __reduce__(self) -> tuple[Callable[..., Expr], tuple[object, ...]]:
        if self.op == "call":
            return call, (self.kernel, *self.args)
        return make, (self.op, self.args, self.value)

    @property
    def name(self) -> str:
        """The name of a symbol."""
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


class _Entry(ref[Expr]):
    """A weak reference that knows its key in the table; `WeakValueDictionary` takes twice the time."""

    __slots__ = ("key",)
    key: object


_table: dict[object, _Entry] = {}


def _forget(entry: _Entry) -> None:
    if _table.get(entry.key) is entry:
        del _table[entry.key]


def make(
    op: str, args: tuple[Expr, ...] = (), value: Constant | None = None, shared: Wide | None = None
) -> Expr:
    """The unique node with these parts, without any simplification; `shared` stands for `args` in its key."""
    key = (op, args, value, value.__class__) if op == "const" else (op, shared or args, value)
    known = _table.get(key)
    if known is not None:
        found = known()
        if found is not None:
            return found
    node = Expr()
    node.op = op
    node.args = args
    node.value = value
    entry = _table[key] = _Entry(node, _forget)
    entry.key = key
    return node


def call(kernel: Kernel, *args: Expr) -> Expr:
    """The call of a kernel; equal kernels with equal arguments give one node."""
    return _call(kernel, args, _wide(args))


def _call(kernel: Kernel, args: tuple[Expr, ...], shared: Wide | None) -> Expr:
    node = make("call", args if shared is None else shared.args, kernel.key, shared)
    node.kernel = kernel
    node.wide = shared
    return node


class Wide:
    """Many arguments, made once: whole arrays are handed to kernels, one for each element of the result.

    `known` is what walks found below them, by the kind of walk: so that equations, each with the call for one
    element of the result, do not walk the same thousands of nodes again.
    """

    __slots__ = ("__weakref__", "args", "known")

    def __init__(self, args: tuple[Expr, ...]) -> None:
        self.args = args
        self.known: dict[str, tuple[Expr, ...]] = {}


_WIDE = 16
_wides: WeakValueDictionary[tuple[Expr, ...], Wide] = WeakValueDictionary()


def _wide(args: tuple[Expr, ...]) -> Wide | None:
    if len(args) < _WIDE:
        return None
    known = _wides.get(args)
    if known is None:
        known = _wides[args] = Wide(args)
    return known


def calls(kernels: Iterable[Kernel], args: tuple[Expr, ...]) -> tuple[Expr, ...]:
    """Calls of several kernels with the same arguments, which they share."""
    shared = _wide(args)
    return tuple([_call(kernel, args, shared) for kernel in kernels])


def const(value: Constant) -> Expr:
    """A literal. Reals, Integers, Booleans, Strings and enumeration values stay distinct."""
    if isinstance(value, float):
        if isnan(value):
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
