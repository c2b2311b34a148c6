"""Which variables of expandable connectors are inputs, which outputs: what feeds them decides (9.1.3)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from acausal.lang import ast
from acausal.lang.arithmetic import type_error
from acausal.lang.connecting import add_connection
from acausal.lang.connections import ConnectionSets, Node
from acausal.lang.expandable_copies import is_signal, with_causality_of
from acausal.lang.flat import Causality
from acausal.lang.instance import Array, Instance, Leaf, Member
from acausal.lang.links import Link, components
from acausal.lang.translation import Translation


def infer_causality(
    translation: Translation, root: Instance, links: Sequence[Link], inside: dict[str, None]
) -> None:
    """Give the signals in expandable connectors their causality, from the inside of components outwards."""
    sets = ConnectionSets(in_buses=inside)
    for link in links:
        if isinstance(link.node, ast.ConnectEquation):
            add_connection(translation, sets, link.node, link.env)
    buses = [instance for instance in components(root) if instance.is_expandable]
    unknown = {leaf.path: leaf for bus in buses for leaf in _signals(bus) if is_signal(leaf)}
    work = _Inference(sets, dict.fromkeys(unknown))
    work.run()
    own = dict.fromkeys([leaf.path for bus in buses if _is_own(bus, root) for leaf in _signals(bus)])
    work.check_fed(own)
    for bus in buses:
        for name, member in list(bus.members.items()):
            if isinstance(member, (Leaf, Array)):
                bus.members[name] = _changed(member, work.found)


def _is_own(bus: Instance, root: Instance) -> bool:
    """Whether a connector is the model's own, or stands inside one."""
    around = bus.parent
    while around is not None and around is not root and around.is_connector:
        around = around.parent
    return around is root


def _signals(bus: Instance) -> list[Leaf]:
    found: list[Leaf] = []
    for member in bus.members.values():
        items = member.items if isinstance(member, Array) else (member,)
        found += [item for item in items if isinstance(item, Leaf)]
    return found


def _changed(member: Member, found: dict[str, Causality]) -> Member:
    if isinstance(member, Array):
        items = tuple([_changed(item, found) for item in member.items])
        return Array(member.path, member.shape, items, member.type, member.span)
    if isinstance(member, Leaf) and is_signal(member):
        return with_causality_of(member, found.get(member.path, Causality.LOCAL))
    return member


@dataclass(slots=True)
class _Inference:
    sets: ConnectionSets
    unknown: dict[str, None]
    found: dict[str, Causality] = field(default_factory=dict[str, Causality])

    def run(self) -> None:
        groups: dict[Node, list[Node]] = {}
        for node in self.sets.place:
            groups.setdefault(self.sets.find(node), []).append(node)
        changed = True
        while changed:
            changed = self.decide_all(list(groups.values()))

    def decide_all(self, groups: Sequence[Sequence[Node]]) -> bool:
        """One round over all connection sets."""
        return sum(self.decide(group) for group in groups) > 0

    def causality(self, path: str) -> Causality:
        return self.found.get(path, self.sets.leaf[path].prefixes.causality)

    def decide(self, group: Sequence[Node]) -> bool:
        """Whether something new was found in one connection set."""
        open_ = [p for p, inside in group if not inside and p in self.unknown and p not in self.found]
        if not open_:
            return False
        inner = [path for path, inside in group if inside]
        outer = [p for p, inside in group if not inside and p not in self.unknown]
        fed = any(self.causality(p) is Causality.OUTPUT for p in inner)
        fed = fed or any(self.causality(p) is Causality.INPUT and p not in self.sets.hidden for p in outer)
        if fed:
            self.found |= dict.fromkeys(open_, Causality.OUTPUT)
            return True
        used = any(self.causality(p) is Causality.INPUT for p in inner)
        used = used or any(self.causality(p) is Causality.OUTPUT for p in outer)
        if len(open_) == 1 and used and all(self.causality(p) is not Causality.LOCAL for p in inner):
            self.found[open_[0]] = Causality.INPUT
            return True
        return False

    def check_fed(self, own: dict[str, None]) -> None:
        """What some expandable connectors need, another one that is connected with them must give.

        `own` are the variables of the model's own connectors, which its surroundings may feed.
        """
        parent: dict[str, str] = {path: path for path in self.unknown}

        def find(path: str) -> str:
            while parent[path] != path:
                parent[path] = parent[parent[path]]
                path = parent[path]
            return path

        groups: dict[Node, list[str]] = {}
        for node in self.sets.place:
            if node[0] in parent:
                groups.setdefault(self.sets.find(node), []).append(node[0])
        for first, *rest in groups.values():
            for path in rest:
                parent[find(path)] = find(first)
        members: dict[str, list[str]] = {}
        for path in self.unknown:
            members.setdefault(find(path), []).append(path)
        for paths in members.values():
            needs = [path for path in paths if self.found.get(path) is Causality.INPUT]
            if len(needs) == len(paths) and not any(path in own for path in paths):
                leaf = self.sets.leaf[needs[0]]
                raise type_error(
                    "expandable.not-fed",
                    f"`{needs[0]}` is used, but no expandable connector connected with it gives it a value",
                    leaf.span,
                    "connect a source to a variable of this name on the bus",
                    (needs[0],),
                )
