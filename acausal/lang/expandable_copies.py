"""Copies of connectors as parts of an expandable connector (Modelica 3.6, 9.1.3)."""

from __future__ import annotations

from acausal.lang.flat import Causality, Variability
from acausal.lang.instance import Absent, Array, Connection, Instance, Leaf, Member, Outer, Prefixes
from acausal.lang.values import all_indices, index_offset

_OWN = ("fixed", "stateSelect", "start")


def copied(member: Member, path: str, bus: Instance) -> Member:
    """The same connector under another path, seen from outside: whether it is an input is found later."""
    return _copied(member, member.path, path, bus, whole=True)


def _copied(member: Member, old: str, new: str, parent: Instance, *, whole: bool) -> Member:
    path = new + member.path[len(old) :]
    if isinstance(member, Leaf):
        return _leaf(member, path, whole=whole)
    if isinstance(member, Array):
        items = tuple([_copied(item, old, new, parent, whole=whole) for item in member.items])
        return Array(path, member.shape, items, member.type, member.span)
    if isinstance(member, Absent):
        return Absent(path, member.span, member.potential)
    prefixes = _prefixes(member.prefixes, Causality.LOCAL if whole else member.prefixes.causality)
    made = Instance(path, member.scope, parent, prefixes, member.span, member.description, member.modifier)
    for name, part in member.members.items():
        if not isinstance(part, Outer):
            made.members[name] = _copied(part, old, new, made, whole=False)
    return made


def _prefixes(prefixes: Prefixes, causality: Causality) -> Prefixes:
    return Prefixes(prefixes.variability, causality, prefixes.connection, False, False)


def _leaf(leaf: Leaf, path: str, *, whole: bool) -> Leaf:
    constant = leaf.prefixes.variability <= Variability.PARAMETER
    attributes = {name: value for name, value in leaf.attributes.items() if name not in _OWN}
    causality = leaf.prefixes.causality if constant or not whole else Causality.LOCAL
    return Leaf(
        path,
        leaf.type,
        _prefixes(leaf.prefixes, causality),
        attributes,
        leaf.binding if constant else None,
        leaf.span,
        leaf.description,
        connector=True,
    )


def with_causality_of(leaf: Leaf, causality: Causality) -> Leaf:
    """The leaf with the causality that its connections give it."""
    prefixes = leaf.prefixes
    changed = Prefixes(
        prefixes.variability, causality, prefixes.connection, prefixes.protected, prefixes.final
    )
    return Leaf(
        leaf.path,
        leaf.type,
        changed,
        leaf.attributes,
        leaf.binding,
        leaf.span,
        leaf.description,
        connector=True,
    )


def is_signal(leaf: Leaf) -> bool:
    """Whether the leaf may be an input or an output, and does not say which."""
    prefixes = leaf.prefixes
    varies = prefixes.variability > Variability.PARAMETER
    return varies and prefixes.causality is Causality.LOCAL and prefixes.connection is Connection.POTENTIAL


def with_element(
    array: Array | None, path: str, index: tuple[int, ...], member: Member, bus: Instance
) -> Array:
    """An array that has a copy of `member` at `index` (from 1), and grows as far as this needs."""
    old = array.shape if array is not None and len(array.shape) == len(index) else (0,) * len(index)
    shape = tuple([max(n, i) for n, i in zip(old, index, strict=True)])
    span = member.span if array is None else array.span
    items: list[Member] = []
    for place in all_indices(shape):
        shown = f"{path}[{','.join(str(i + 1) for i in place)}]"
        inside = all(i < n for i, n in zip(place, old, strict=True))
        if place == tuple([i - 1 for i in index]):
            items.append(copied(member, shown, bus))
        elif array is not None and inside:
            items.append(array.items[index_offset(old, place)])
        else:
            items.append(Absent(shown, span, potential=True))
    kind = member.type if isinstance(member, Leaf) else None
    return Array(path, shape, tuple(items), kind, span)
