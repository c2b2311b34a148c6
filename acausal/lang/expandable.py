"""Expandable connectors: what connections add to them, and what is left of their declarations (9.1.3).

Connections are looked at again and again until nothing changes: a name that is not declared becomes a copy of
what it is connected to, and connected expandable connectors get what only the other has. In the end variables
that no connection names are taken out, and what feeds each of the others is found from the inside out.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from acausal.errors import AcausalError
from acausal.lang import ast
from acausal.lang.arithmetic import type_error
from acausal.lang.expandable_causality import infer_causality
from acausal.lang.expandable_copies import copied, with_element
from acausal.lang.expandable_paths import Missing, Place, locate
from acausal.lang.flat import Variability
from acausal.lang.instance import Absent, Array, Connection, Instance, Leaf, Member, Outer, leaves
from acausal.lang.links import Link, components
from acausal.lang.translation import Translation
from acausal.lang.values import all_indices

MAX_ROUNDS = 1000


@dataclass(slots=True)
class Expansion:
    """What became of the expandable connectors: the paths inside them, and flow variables that were added."""

    inside: dict[str, None] = field(default_factory=dict[str, None])
    added_flows: list[Leaf] = field(default_factory=list[Leaf])


def expand(translation: Translation, root: Instance, links: Sequence[Link]) -> Expansion:
    """Elaborate all expandable connectors of a model. Raises `expandable.*`."""
    work = _Elaboration(translation)
    connections = [link for link in links if isinstance(link.node, ast.ConnectEquation)]
    for _ in range(MAX_ROUNDS):
        work.changed = False
        pending = [link for link in connections if not work.take(link)]
        if not work.changed:
            break
    else:
        raise type_error("expandable.endless", "these connections add variables without end", root.span)
    if pending:
        raise _undeclared(pending[0])
    result = Expansion()
    for instance in components(root):
        if instance.is_expandable:
            check_no_flow(instance)
            work.prune(instance)
            result.inside |= dict.fromkeys([member.path for member in _below(instance)])
    infer_causality(translation, root, connections, result.inside)
    result.added_flows = [leaf for leaf in work.added if leaf.prefixes.connection is Connection.FLOW]
    return result


def check_no_flow(bus: Instance) -> None:
    """Flow variables stand in connectors inside an expandable one, not in itself."""
    for entry in bus.scope.table.components.values():
        if entry.clause.flow:
            raise type_error(
                "expandable.flow",
                f"the expandable connector `{bus.path}` cannot have the {entry.clause.flow} variable "
                f"`{entry.name}`",
                entry.declaration.span,
                "put it into a connector inside the expandable connector",
                (f"{bus.path}.{entry.name}",),
            )


def _below(bus: Instance) -> list[Member]:
    found: list[Member] = []
    stack: list[Member | Outer] = list(bus.members.values())
    while stack:
        member = stack.pop()
        if isinstance(member, Outer):
            continue
        found.append(member)
        if isinstance(member, Array):
            stack.extend(member.items)
    return found


@dataclass(slots=True)
class _Elaboration:
    translation: Translation
    changed: bool = False
    present: dict[str, None] = field(default_factory=dict[str, None])
    """Paths of what is known to be present."""
    added: list[Leaf] = field(default_factory=list[Leaf])

    # ------------------------------------------------------------------ one connection

    def take(self, link: Link) -> bool:
        """Draw what can be drawn from one connection; False if both its sides are undeclared."""
        node = link.node
        assert isinstance(node, ast.ConnectEquation)
        left = locate(self.translation, node.left, link.env)
        right = locate(self.translation, node.right, link.env)
        for place in (left, right):
            if place is not None:
                for member in place.passed:
                    self.mark(member)
        if left is None or right is None or not (left.is_complete or right.is_complete):
            return False
        if not left.is_complete:
            self.add(left, right)
        elif not right.is_complete:
            self.add(right, left)
        elif left.shape == right.shape:
            for a, b in zip(left.items, right.items, strict=True):
                self.pair(a, b)
        return True

    def mark(self, member: Member) -> None:
        if member.path not in self.present:
            self.present[member.path] = None
            self.changed = True

    def add(self, place: Place, other: Place) -> None:
        """Put copies of what stands on the other side where something is missing."""
        members = [member for member in other.items if not isinstance(member, Missing)]
        if any(isinstance(member, Absent) for member in members):
            return
        first = place.items[0]
        if len(place.items) == 1 and not place.shape and other.shape and isinstance(first, Missing):
            self.put(first, members, other.shape)
            return
        if place.shape != other.shape:
            return  # the connection itself reports it
        for item, member in zip(place.items, members, strict=True):
            if isinstance(item, Missing):
                self.put(item, [member], ())

    def put(self, missing: Missing, members: Sequence[Member], shape: tuple[int, ...]) -> None:
        bus, name = missing.bus, missing.name
        path = f"{bus.path}.{name}"
        if missing.index:
            old = bus.members.get(name)
            new = with_element(old if isinstance(old, Array) else None, path, missing.index, members[0], bus)
            element = next(x for x in new.items if x.path == f"{path}[{','.join(map(str, missing.index))}]")
            bus.members[name] = new
            self.note(element)
            self.mark(new)
        elif shape:
            indices = [f"[{','.join(str(i + 1) for i in index)}]" for index in all_indices(shape)]
            items = tuple([copied(m, path + k, bus) for m, k in zip(members, indices, strict=True)])
            kind = items[0].type if items and isinstance(items[0], Leaf) else None
            bus.members[name] = Array(path, shape, items, kind, members[0].span if members else bus.span)
            for item in items:
                self.note(item)
            self.present[path] = None
        else:
            bus.members[name] = copied(members[0], path, bus)
            self.note(copied(members[0], path, bus))
        self.changed = True

    def note(self, member: Member) -> None:
        self.present[member.path] = None
        self.added += list(leaves(member))

    # ------------------------------------------------------------------ declared on both sides

    def pair(self, a: Member | Missing, b: Member | Missing) -> None:
        """Two connected members: expandable ones share what they have."""
        if isinstance(a, Instance) and isinstance(b, Instance):
            if a.is_expandable and b.is_expandable:
                self.share(a, b)
                self.share(b, a)
            elif a.is_expandable or b.is_expandable:
                raise type_error(
                    "expandable.kind",
                    f"`{a.path}` and `{b.path}` cannot be connected: only one of them is expandable",
                    (a if a.is_expandable else b).span,
                    "an expandable connector can be connected to expandable connectors only",
                    (a.path, b.path),
                )
            else:
                for name in a.members:
                    x, y = a.members[name], b.members.get(name)
                    if y is not None and not isinstance(x, Outer) and not isinstance(y, Outer):
                        self.pair(x, y)

    def share(self, a: Instance, b: Instance) -> None:
        """Give `b` what is present in `a`."""
        for name, member in list(a.members.items()):
            if isinstance(member, (Outer, Absent)) or not self.is_present(member):
                continue
            mine = b.members.get(name)
            if mine is None or isinstance(mine, Outer):
                new = copied(member, f"{b.path}.{name}", b)
                b.members[name] = new
                self.note(new)
                if isinstance(new, Array):
                    for item in new.items:
                        if not isinstance(item, Absent):
                            self.present[item.path] = None
                self.changed = True
            else:
                self.meet(member, mine, b, name)

    def meet(self, member: Member, mine: Member, bus: Instance, name: str) -> None:
        """The same name in two connected connectors."""
        if isinstance(member, Array) and isinstance(mine, Array):
            for item in member.items:
                index = item.path[len(member.path) :]
                if isinstance(item, Absent) or not self.is_present(item):
                    continue
                other = next((x for x in mine.items if x.path == mine.path + index), None)
                if other is None or isinstance(other, Absent):
                    numbers = tuple([int(i) for i in index[1:-1].split(",")])
                    self.put(Missing(bus, name, numbers), [item], ())
                    current = bus.members[name]
                    assert isinstance(current, Array)
                    mine = current
                else:
                    self.meet(item, other, bus, name)
            self.mark(mine)
        elif isinstance(member, Instance) and isinstance(mine, Instance):
            self.mark(mine)
            if member.is_expandable and mine.is_expandable:
                self.share(member, mine)
        else:
            self.mark(mine)

    def is_present(self, member: Member) -> bool:
        if member.path in self.present:
            return True
        if isinstance(member, Array):
            return any(self.is_present(item) for item in member.items)
        return False

    # ------------------------------------------------------------------ in the end

    def prune(self, bus: Instance) -> None:
        """Take out what is declared but not present."""
        for name, member in list(bus.members.items()):
            if not isinstance(member, Outer):
                bus.members[name] = self.kept(member)

    def kept(self, member: Member) -> Member:
        if isinstance(member, Leaf) and member.prefixes.variability <= Variability.PARAMETER:
            return member
        if isinstance(member, Array):
            items = tuple([self.kept(item) for item in member.items])
            return Array(member.path, member.shape, items, member.type, member.span)
        return member if self.is_present(member) else Absent(member.path, member.span, potential=True)


def _undeclared(link: Link) -> AcausalError:
    node = link.node
    assert isinstance(node, ast.ConnectEquation)
    return type_error(
        "expandable.undeclared",
        f"`{node.left.text}` and `{node.right.text}` cannot be connected: neither of them is declared",
        node.span,
        "one side of a connection with an expandable connector must be declared",
        (node.left.text, node.right.text),
    )
