"""Signed equivalence classes of variables: x = y and x = -y, with at most one constant value per class.

Every member knows its class, and the smaller of two classes moves into the larger (Galler and Fisher, "An
improved equivalence algorithm", Comm. ACM 7 (1964)): a variable moves at most log2(n)
times, and looking it up costs one step. Every link remembers the equation that made it, so that a class can
say which equation eliminates which member, and a redundant link can name its loop.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field

from acausal.symbolic.expressions.expr import Expr, neg


@dataclass(frozen=True, slots=True)
class Link:
    """Equation number `equation` says `a = sign * b`."""

    a: str
    b: str
    sign: int
    equation: int


@dataclass(frozen=True, slots=True)
class Pinned:
    """Equation number `equation` says `name = value`, an expression in parameters."""

    name: str
    value: Expr
    equation: int


@dataclass(slots=True, eq=False)
class Group:
    """A class while it grows. `signs`: its members in order of arrival, relative to the first of them."""

    signs: dict[str, int]
    links: list[Link] = field(default_factory=list[Link])
    pinned: Pinned | None = None
    level: int = 0
    fixed: str = ""
    """Of discrete variables, a member whose value before the start is fixed."""

    @property
    def members(self) -> list[str]:
        return list(self.signs)

    def value(self, name: str) -> Expr | None:
        """The value of a member if the class is pinned."""
        pinned = self.pinned
        if pinned is None:
            return None
        return pinned.value if self.signs[name] == self.signs[pinned.name] else neg(pinned.value)


class Classes:
    """The classes while they grow: the working memory of alias elimination."""

    def __init__(self) -> None:
        self._group: dict[str, Group] = {}

    def find(self, name: str) -> Group | None:
        """The class of `name`; None if it is alone."""
        return self._group.get(name)

    def of(self, name: str) -> Group:
        """The class of `name`, made if it is new."""
        group = self._group.get(name)
        if group is None:
            group = self._group[name] = Group({name: 1})
        return group

    def link(self, link: Link, level: int) -> None:
        """Join two different classes, the smaller into the larger; only one of them may be pinned."""
        big, small = self.of(link.a), self.of(link.b)
        sign = big.signs[link.a] * link.sign * small.signs[link.b]
        if len(big.signs) < len(small.signs):
            big, small = small, big
        for name, own in small.signs.items():
            big.signs[name] = sign * own
            self._group[name] = big
        big.links += small.links
        big.links.append(link)
        big.pinned = big.pinned or small.pinned
        big.fixed = big.fixed or small.fixed
        big.level = max(big.level, small.level, level)

    def pin(self, pinned: Pinned, level: int) -> None:
        """Give a class its value."""
        group = self.of(pinned.name)
        group.pinned = pinned
        group.level = max(group.level, level)

    def value(self, name: str) -> Expr | None:
        """The value of `name` if its class is pinned."""
        group = self._group.get(name)
        return None if group is None else group.value(name)

    def eliminated_by(self, root: str) -> dict[str, int]:
        """Per member, except `root`, the number of the equation that links it towards `root`. O(members)."""
        links = self.of(root).links
        if len(links) == 1:
            return {links[0].b if links[0].a == root else links[0].a: links[0].equation}
        neighbours: dict[str, list[Link]] = {}
        for link in links:
            neighbours.setdefault(link.a, []).append(link)
            neighbours.setdefault(link.b, []).append(link)
        found: dict[str, int] = {}
        queue = deque([root])
        while queue:
            name = queue.popleft()
            for link in neighbours.get(name, ()):
                other = link.b if link.a == name else link.a
                if other != root and other not in found:
                    found[other] = link.equation
                    queue.append(other)
        return found

    def path(self, a: str, b: str) -> list[Link]:
        """The links that connect two members of one class."""
        by_equation = {link.equation: link for link in self.of(a).links}
        towards = self.eliminated_by(a)
        links: list[Link] = []
        while b != a:
            link = by_equation[towards[b]]
            links.append(link)
            b = link.a if link.b == b else link.b
        return links[::-1]
