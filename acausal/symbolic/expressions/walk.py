"""Walks over the directed acyclic graph of expressions: iterative, each distinct node once."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeVar

from acausal.symbolic.expressions.construct import rebuild
from acausal.symbolic.expressions.node import Expr, Wide

_T = TypeVar("_T")


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
    roots: Iterable[Expr],
    visit: Callable[[Expr, list[_T]], _T],
    memo: dict[Expr, _T] | None = None,
    shared: dict[int, list[_T]] | None = None,
    closed: Callable[[Expr], _T] | None = None,
) -> dict[Expr, _T]:
    """Value of every node below `roots`: `visit(node, values of its args)`, each node once.

    `memo` may be passed to share results between calls and to preset the values of nodes; with it `shared`,
    the values of arguments that several calls have in common, by the identity of these arguments.
    `closed` gives the value of a call with many arguments without theirs.
    """
    values: dict[Expr, _T] = {} if memo is None else memo
    for root in roots:
        if root in values:
            continue
        stack = [root]
        while stack:
            node = stack.pop()
            if node in values:
                continue
            args = node.args
            if not args:
                values[node] = visit(node, [])
                continue
            if closed is not None and node.op == "call" and node.wide is not None:
                values[node] = closed(node)
                continue
            if shared is not None and node.op == "call" and id(args) in shared:
                values[node] = visit(node, shared[id(args)])
                continue
            missing = [arg for arg in args if arg not in values]
            if missing:
                missing.reverse()
                stack.append(node)
                stack.extend(missing)
                continue
            given = [values[arg] for arg in args]
            values[node] = visit(node, given)
            if shared is not None and node.op == "call":
                shared[id(args)] = given
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


def parts(node: Expr) -> tuple[Expr, ...]:
    """The arguments that make up the value: of `derived` the first one only."""
    return node.args[:1] if node.op == "derived" else node.args


def without_derivatives(roots: Iterable[Expr]) -> dict[Expr, Expr]:
    """Every root without its `derived`, as it is once nothing is to be differentiated any more."""

    def visit(node: Expr, args: list[Expr]) -> Expr:
        if node.op == "derived":
            return args[0]
        new = tuple(args)
        return node if new == node.args else rebuild(node, new)

    roots = list(roots)
    if not any(node.op == "derived" for node in postorder(roots)):
        return {root: root for root in roots}
    values = fold(roots, visit)
    return {root: values[root] for root in roots}


def unknown_leaves(root: Expr) -> tuple[Expr, ...]:
    """The distinct symbols and derivatives of symbols, in order of first appearance.

    `der(x)` counts as one leaf (and `x` inside it does not); so does `pre(x)`.
    """
    return gather([root], UNKNOWNS)


def outermost(root: Expr, operators: Container[str]) -> tuple[Expr, ...]:
    """The distinct nodes of these operators that make up the value, none inside another, as they appear."""
    found: dict[Expr, None] = {}
    seen: set[Expr] = set()
    stack = [root]
    while stack:
        node = stack.pop()
        if node in seen:
            continue
        seen.add(node)
        if node.op in operators:
            found[node] = None
        else:
            stack.extend(reversed(parts(node)))
    return tuple(found)


@dataclass(frozen=True)
class Kind:
    """What a walk looks for: `taken` operators; below any other node it goes on with what `held` gives.

    Of a call `held` must give all arguments. Kinds with different meanings have different names.
    """

    name: str
    taken: Container[str]
    held: Callable[[Expr], tuple[Expr, ...]]


UNKNOWNS = Kind("unknowns", frozenset({"sym", "der", "pre"}), parts)


def _arguments(node: Expr) -> tuple[Expr, ...]:
    return node.args


_SYMBOLS = Kind("symbols", frozenset({"sym"}), _arguments)


def gather(roots: Iterable[Expr], kind: Kind) -> tuple[Expr, ...]:
    """The distinct taken nodes, none inside another, in order of first appearance.

    Many arguments that calls share are walked once for all, whoever asks.
    """
    roots = list(roots)
    found, missing = _walk(roots, kind)
    if not missing:
        return tuple(found)
    _note(missing, kind)
    return tuple(_walk(roots, kind)[0])


def _note(wides: list[Wide], kind: Kind) -> None:
    """Find what is below shared arguments; those inside first, without recursion."""
    stack = wides
    while stack:
        wide = stack[-1]
        if kind.name in wide.known:
            stack.pop()
            continue
        found, missing = _walk(wide.args, kind)
        if missing:
            stack.extend(missing)
        else:
            wide.known[kind.name] = tuple(found)


def _walk(roots: Sequence[Expr], kind: Kind) -> tuple[dict[Expr, None], list[Wide]]:
    """The nodes, and the shared arguments below which nobody has looked yet: they are left out."""
    taken, held = kind.taken, kind.held
    found: dict[Expr, None] = {}
    missing: list[Wide] = []
    seen: set[Expr] = set()
    done: set[Wide] = set()
    stack = [*reversed(roots)]
    while stack:
        node = stack.pop()
        if node in seen:
            continue
        seen.add(node)
        op = node.op
        if op in taken:
            found[node] = None
        elif op == "call" and node.wide is not None:
            if node.wide in done:
                continue
            done.add(node.wide)
            known = node.wide.known.get(kind.name)
            if known is None:
                missing.append(node.wide)
            else:
                found.update(dict.fromkeys(known))
        else:
            stack.extend(reversed(held(node)))
    return found, missing


def symbols(roots: Iterable[Expr]) -> tuple[str, ...]:
    """Names of all symbols below `roots` (also inside `der`), in order of first appearance."""
    return tuple([leaf.name for leaf in gather(roots, _SYMBOLS)])


def each_symbol(roots: Iterable[Expr]) -> Iterator[str]:
    """As `symbols`, one after the other: whoever needs the first ones only does not walk the rest."""
    return (node.name for node in postorder(roots) if node.op == "sym")
