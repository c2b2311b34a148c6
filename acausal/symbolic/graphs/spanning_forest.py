"""Spanning trees of a virtual connection graph with chosen roots (Modelica 3.6, 9.4.2).

Every tree has one root. Required edges are always part of a tree, optional ones are left out where they would
close a circle or join two roots. Kruskal, "On the shortest spanning subtree of a graph", Proc. AMS 7 (1956),
with a root for each tree.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

Edge = tuple[int, int]


@dataclass(frozen=True)
class Forest:
    """What became of a graph.

    `kept` says of each optional edge whether it is part of a tree; `depth` is the distance of each node from
    its root. `circles` are the required edges that close a circle or join two definite roots, and `rootless`
    the lowest node of every part without any root, which serves as its root.
    """

    roots: tuple[int, ...]
    kept: tuple[bool, ...]
    depth: tuple[int, ...]
    circles: tuple[Edge, ...]
    rootless: tuple[int, ...]


def spanning_forest(
    count: int,
    required: Sequence[Edge],
    optional: Sequence[Edge],
    definite: Sequence[int],
    potential: Mapping[int, int],
) -> Forest:
    """The trees of a graph of `count` nodes, edges taken in the order given; O(E log V).

    A part without definite root takes the potential root of the lowest priority number, the lowest node of
    those that share it.
    """
    sets = _Sets(count, definite)
    circles = [edge for edge in required if not sets.join(*edge)]
    kept = [sets.join(*edge) for edge in optional]
    roots, rootless = _chosen_roots(count, sets, definite, potential)
    tree: list[list[int]] = [[] for _ in range(count)]
    chosen = [edge for edge, stays in zip(optional, kept, strict=True) if stays]
    for a, b in (*required, *chosen):
        tree[a].append(b)
        tree[b].append(a)
    return Forest(tuple(roots), tuple(kept), tuple(_depths(tree, roots)), tuple(circles), tuple(rootless))


class _Sets:
    """Disjoint sets of nodes, of which at most one has a definite root each."""

    def __init__(self, count: int, definite: Sequence[int]) -> None:
        self._parent = list(range(count))
        self._rooted = [False] * count
        for node in definite:
            self._rooted[node] = True

    def find(self, node: int) -> int:
        while self._parent[node] != node:
            self._parent[node] = self._parent[self._parent[node]]
            node = self._parent[node]
        return node

    def rooted(self, node: int) -> bool:
        return self._rooted[self.find(node)]

    def join(self, a: int, b: int) -> bool:
        """Make one set of two; False if they are one already, or both have a root."""
        a, b = self.find(a), self.find(b)
        if a == b or (self._rooted[a] and self._rooted[b]):
            return False
        self._parent[b] = a
        self._rooted[a] = self._rooted[a] or self._rooted[b]
        return True


def _chosen_roots(
    count: int, sets: _Sets, definite: Sequence[int], potential: Mapping[int, int]
) -> tuple[list[int], list[int]]:
    """All roots, ascending, and those of them that nobody offered."""
    best: dict[int, tuple[int, int]] = {}
    for node in sorted(potential):
        if not sets.rooted(node):
            candidate = (potential[node], node)
            best[sets.find(node)] = min(best.get(sets.find(node), candidate), candidate)
    lowest: dict[int, int] = {}
    for node in range(count):
        if not sets.rooted(node) and sets.find(node) not in best:
            lowest.setdefault(sets.find(node), node)
    rootless = sorted(lowest.values())
    selected = [node for _, node in best.values()]
    return sorted({*definite, *selected, *rootless}), rootless


def _depths(tree: Sequence[Sequence[int]], roots: Sequence[int]) -> list[int]:
    """Distances from the nearest root, breadth first."""
    depth = [-1] * len(tree)
    queue = deque(roots)
    for root in roots:
        depth[root] = 0
    while queue:
        node = queue.popleft()
        for other in tree[node]:
            if depth[other] < 0:
                depth[other] = depth[node] + 1
                queue.append(other)
    return depth
