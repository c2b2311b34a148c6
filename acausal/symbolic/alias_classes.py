"""Signed equivalence classes of variables: x = y and x = -y, with at most one constant value per class.

Union-find with signs (Tarjan, "Efficiency of a good but not linear set union algorithm", J. ACM 22 (1975)):
near-linear in the number of links. Every link remembers the equation that made it, so that a class can say
which equation eliminates which member, and a redundant link can name its loop.
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


@dataclass
class _Class:
    members: list[str]
    links: list[Link] = field(default_factory=list[Link])
    pinned: Pinned | None = None
    level: int = 0


class Classes:
    """The classes while they grow: the working memory of alias elimination."""

    def __init__(self) -> None:
        self._parent: dict[str, tuple[str, int]] = {}
        self._classes: dict[str, _Class] = {}

    def find(self, name: str) -> tuple[str, int]:
        """Root of the class of `name`, and its sign relative to it. Alone if it is new."""
        parent = self._parent
        if name not in parent:
            return name, 1
        path: list[tuple[str, int]] = []
        while parent[name][0] != name:
            path.append((name, parent[name][1]))
            name = parent[name][0]
        sign = 1
        for below, step in reversed(path):
            sign *= step
            parent[below] = (name, sign)
        return name, sign

    def of(self, name: str) -> _Class:
        """The class of `name`, made if it is new."""
        root, _ = self.find(name)
        if root not in self._parent:
            self._parent[root] = (root, 1)
            self._classes[root] = _Class([root])
        return self._classes[root]

    def link(self, link: Link, level: int) -> None:
        """Join two different classes, the smaller into the larger; only one of them may be pinned."""
        big, small = self.of(link.a), self.of(link.b)
        (root, sign_a), (other, sign_b) = self.find(link.a), self.find(link.b)
        if len(big.members) < len(small.members):
            big, small, root, other = small, big, other, root
        self._parent[other] = (root, sign_a * link.sign * sign_b)
        big.members += small.members
        big.links += [*small.links, link]
        big.pinned = big.pinned or small.pinned
        big.level = max(big.level, small.level, level)
        del self._classes[other]

    def pin(self, pinned: Pinned, level: int) -> None:
        """Give a class its value."""
        group = self.of(pinned.name)
        group.pinned = pinned
        group.level = max(group.level, level)

    def value(self, name: str) -> Expr | None:
        """The value of `name` if its class is pinned."""
        root, sign = self.find(name)
        group = self._classes.get(root)
        if group is None or group.pinned is None:
            return None
        pinned = group.pinned
        return pinned.value if sign * self.find(pinned.name)[1] > 0 else neg(pinned.value)

    def eliminated_by(self, root: str) -> dict[str, int]:
        """Per member, except `root`, the number of the equation that links it towards `root`. O(members)."""
        neighbours: dict[str, list[Link]] = {}
        for link in self.of(root).links:
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
