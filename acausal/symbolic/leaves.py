"""Unknown leaves of equations and the derivative chains that connect them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from acausal.lang.flat import Causality, FlatModel, Variability, Variable
from acausal.symbolic.describe import base_name
from acausal.symbolic.expressions.diff import INPUT, NotDifferentiable, TimeDerivative
from acausal.symbolic.expressions.evaluate import Lookup
from acausal.symbolic.expressions.expr import (
    ZERO,
    Expr,
    Kind,
    der,
    fold,
    gather,
    neg,
    parts,
    pre,
    rebuild,
    sym,
)
from acausal.symbolic.expressions.operators import KNOWN_AT_EVENTS, RELATIONS


def is_input(variable: Variable) -> bool:
    """An input of the whole model: known from outside, so no equation determines it."""
    return variable.causality is Causality.INPUT and variable.top_level and variable.is_unknown


def determined(flat: FlatModel) -> tuple[Variable, ...]:
    """The variables the equations must determine, in declaration order."""
    return tuple(v for v in flat.variables if v.is_unknown and not is_input(v))


def is_discrete(variable: Variable) -> bool:
    """Whether the variable changes at events only."""
    return variable.is_unknown and (
        variable.variability is Variability.DISCRETE or variable.type.name != "Real"
    )


def is_moving(variable: Variable | None) -> bool:
    """Whether the variable changes between events."""
    return variable is not None and variable.is_unknown and not is_discrete(variable)


def value_leaves(roots: Iterable[Expr]) -> tuple[Expr, ...]:
    """Leaves an equation could be solved for: those outside conditions, in order of appearance."""
    return gather(roots, _VALUE)


def _held(node: Expr) -> tuple[Expr, ...]:
    """The arguments that an equation could be solved through."""
    op = node.op
    if op == "if":
        return node.args[1:]
    if op == "homotopy":
        return node.args[:1]
    return () if op in _CLOSED else parts(node)


class PresentLeaves:
    """`value_leaves` without those under `pre`, for equations that share large parts.

    What holds few leaves is visited once for all equations, and so are arguments that calls share.
    """

    def __init__(self) -> None:
        self._few: dict[Expr, tuple[Expr, ...] | None] = {}
        self._joined: dict[int, tuple[Expr, ...] | None] = {}
        """By the identity of arguments, which the nodes in `_few` keep alive."""

    def __call__(self, roots: Sequence[Expr]) -> tuple[Expr, ...]:
        """The leaves below `roots`, in order of appearance."""
        found: dict[Expr, None] = {}
        seen: set[Expr] = set()
        stack = [*reversed(roots)]
        while stack:
            node = stack.pop()
            if node in seen:
                continue
            seen.add(node)
            few = self._leaves(node)
            if few is None and node.op == "call" and node.wide is not None:
                few = [leaf for leaf in value_leaves([node]) if leaf.op != "pre"]
            if few is None:
                stack.extend(reversed(_held(node)))
            else:
                found.update(dict.fromkeys(few))
        return tuple(found)

    def _leaves(self, root: Expr) -> tuple[Expr, ...] | None:
        """The leaves below a node; None if they are many."""
        known = self._few
        stack = [root]
        while stack:
            node = stack[-1]
            if node in known:
                stack.pop()
            elif node.op in ("sym", "der", "pre"):
                known[node] = () if node.op == "pre" else (node,)
            elif id(node.args) in self._joined and node.op == "call":
                known[node] = self._joined[id(node.args)]
            else:
                held = _held(node)
                missing = [part for part in held if part not in known]
                if missing:
                    stack.extend(reversed(missing))
                    continue
                known[node] = self._join(held)
                if node.op == "call":
                    self._joined[id(node.args)] = known[node]
        return known[root]

    def _join(self, held: Sequence[Expr]) -> tuple[Expr, ...] | None:
        found: dict[Expr, None] = {}
        for part in held:
            few = self._few[part]
            if few is None or len(found) > _FEW:
                return None
            found.update(dict.fromkeys(few))
        return tuple(found) if len(found) <= _FEW else None


def all_leaves(roots: Iterable[Expr]) -> tuple[Expr, ...]:
    """Every leaf, those in conditions too. In order of appearance."""
    return gather(roots, _ALL)


def present(node: Expr) -> tuple[Expr, ...]:
    """The arguments that an equation uses as they are now: a delay is known from the past."""
    return () if node.op == "delay" else parts(node)


_LEAVES = frozenset({"sym", "der", "pre"})
_VALUE = Kind("value leaves", _LEAVES, _held)
_ALL = Kind("all leaves", _LEAVES, present)
_FEW = 4
"""How many leaves are noted at every node above them."""

_CLOSED = RELATIONS | KNOWN_AT_EVENTS | {"integer"}


@dataclass(frozen=True)
class Chains:
    """Which leaf is whose time derivative: `der(x)`, unless an equation v = der(x) named it `v`."""

    variables: Mapping[str, Variable]
    named: Mapping[str, str]
    """x -> v."""

    def derivative(self, leaf: Expr) -> Expr | None:
        """The derivative of a leaf; ZERO for what is constant between events, None for an input."""
        if leaf.op == "sym":
            variable = self.variables.get(leaf.name)
            if variable is None or not is_moving(variable):
                return ZERO
            if is_input(variable):
                return None
            name = self.named.get(leaf.name)
            return der(leaf) if name is None else sym(name)
        return der(leaf)

    def is_unknown(self, leaf: Expr) -> bool:
        """Whether the continuous part of the running system must determine the leaf."""
        variable = None if leaf.op == "pre" else self.variables.get(base_name(leaf))
        return is_moving(variable) and variable is not None and not is_input(variable)


class Rewriter:
    """Puts expressions for symbols and expands `der(expression)`; shares work between all calls. O(nodes).

    `homotopy(actual, simplified)` becomes `actual`; `met_homotopy` says that there was one.
    """

    def __init__(self, values: Mapping[Expr, Expr], chains: Chains, lookup: Lookup) -> None:
        self._memo: dict[Expr, Expr] = dict(values)
        self._shared: dict[int, list[Expr]] = {}
        self._chains = chains
        self._derivative = TimeDerivative(chains.derivative, lookup)
        self.met_homotopy = False

    def __call__(self, root: Expr) -> Expr:
        """The rewritten expression. Raises `NotDifferentiable`."""
        return fold([root], self._visit, self._memo, self._shared)[root]

    def _visit(self, node: Expr, args: list[Expr]) -> Expr:
        if node.op == "der":
            return self._differentiated(args[0])
        if node.op == "homotopy":
            self.met_homotopy = True
            return args[0]
        if node.op == "pre":
            return self._before(args[0])
        new = tuple(args)
        return node if new == node.args else rebuild(node, new)

    def _before(self, arg: Expr) -> Expr:
        """`pre(arg)`: what does not vary is its own past."""
        if arg.op == "neg":
            return neg(self._before(arg.args[0]))
        variable = self._chains.variables.get(arg.name) if arg.op == "sym" else None
        steady = arg.op == "const" or (variable is not None and not variable.is_unknown)
        return arg if steady else pre(arg)

    def _differentiated(self, arg: Expr) -> Expr:
        if arg.op not in ("sym", "der"):
            return self._derivative(arg)
        if arg.op == "sym" and arg.name == "time":
            return self._derivative(arg)
        slope = self._chains.derivative(arg)
        if slope is None:
            raise NotDifferentiable(arg, INPUT)
        return slope
