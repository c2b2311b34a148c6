"""In which equations a variable occurs, while equations are rewritten.

The arguments that calls share have a row of their own, as if they were an equation: what holds a call holds
the row. A call for every element of the result would else note every argument once for each of them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import islice

from acausal.symbolic.describe import base_name
from acausal.symbolic.expressions.expr import Expr, Kind, gather, symbols
from acausal.symbolic.expressions.node import Wide
from acausal.symbolic.leaves import all_leaves, present

_COMPOSED = frozenset({"call", "delay", "derived"})
_PLAIN = Kind("plain leaves", frozenset({"sym", "der", "pre"}) | _COMPOSED, lambda node: node.args)
_HERE = Kind("leaves and calls", frozenset({"sym", "der", "pre", "call"}), present)
_PAST = Kind("past and calls", frozenset({"pre", "delay", "derived", "call"}), lambda node: node.args)


class Occurrences:
    """`leaves` of each equation (of one with shared arguments some of theirs), and where names occur.

    `differentiated` gets the names of which there are derivatives.
    """

    def __init__(self, count: int, unknown: Collection[str], differentiated: dict[str, None]) -> None:
        self.leaves: list[tuple[Expr, ...]] = [()] * count
        self._unknown = unknown
        self._differentiated = differentiated
        self._rows: dict[str, list[int]] = {}
        self._shared: dict[Wide, int] = {}
        self._holders: dict[int, list[int]] = {}

    def of(self, name: str) -> list[int]:
        """The equations that hold the variable, or its derivatives or past."""
        found: dict[int, None] = {}
        waiting = [*reversed(self._rows.get(name, ()))]
        while waiting:
            row = waiting.pop()
            if row in self._holders:
                waiting.extend(reversed(self._holders[row]))
            else:
                found[row] = None
        return list(found)

    def add(self, name: str, equation: int) -> None:
        """The variable occurs there."""
        self._rows.setdefault(name, []).append(equation)

    def all_leaves(self, equation: int, sides: Sequence[Expr]) -> tuple[Expr, ...]:
        """All leaves of an equation."""
        some = self.leaves[equation]
        return some if len(some) <= _SOME else all_leaves(sides)

    def update(self, equation: int, sides: Sequence[Expr]) -> None:
        """Note what the equation holds now."""
        before = {base_name(leaf) for leaf in self.leaves[equation]}
        found, shared = self._note(equation, sides, before)
        for wide in shared:
            found += self._some_of(wide, equation)
        self.leaves[equation] = tuple(found)

    def _note(self, row: int, roots: Sequence[Expr], before: set[str]) -> tuple[list[Expr], list[Wide]]:
        """Put the variables below `roots` into a row; the leaves, and the shared arguments, which are not."""
        found: list[Expr] = []
        shared: dict[Wide, None] = {}
        leaves = gather(roots, _PLAIN)
        if any(node.op in _COMPOSED for node in leaves):
            leaves, past = list(_outside(roots, _HERE, shared)), list(_outside(roots, _PAST, shared))
        else:
            past = [leaf for leaf in leaves if leaf.op == "pre"]
        for leaf in leaves:
            name = base_name(leaf)
            if leaf.op == "pre" or name not in self._unknown:
                continue
            found.append(leaf)
            if leaf.op == "der":
                self._differentiated[name] = None
            if name not in before:
                before.add(name)
                self.add(name, row)
        for name in symbols(past) if past else ():
            if name in self._unknown and name not in before:
                self.add(name, row)
        return found, list(shared)

    def _some_of(self, wide: Wide, holder: int) -> list[Expr]:
        """Let a row hold shared arguments; some of their leaves, so that it is no simple equation."""
        row = self._shared.get(wide)
        if row is not None:
            self._holders[row].append(holder)
        else:
            row = self._shared[wide] = len(self.leaves) + len(self._shared)
            self._holders[row] = [holder]
            _, inside = self._note(row, wide.args, set())
            for inner in inside:
                self._some_of(inner, row)
        unknown = (x for x in all_leaves(wide.args) if x.op != "pre" and base_name(x) in self._unknown)
        return list(islice(unknown, _SOME + 1))


_SOME = 2
"""Equations with more leaves than that are no aliases."""


def _outside(roots: Iterable[Expr], kind: Kind, shared: dict[Wide, None]) -> Iterator[Expr]:
    """The taken nodes that are not below shared arguments, which are put into `shared`."""
    waiting: list[Expr] = list(roots)
    seen: dict[Expr, None] = {}
    while waiting:
        taken = [node for node in gather(waiting, kind) if node not in seen]
        seen.update(dict.fromkeys(taken))
        waiting = []
        for node in taken:
            if node.op != "call":
                yield node
            elif node.wide is None:
                waiting.extend(node.args)
            else:
                shared[node.wide] = None
