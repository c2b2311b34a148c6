"""Every model and block that is used as a component is balanced by itself (Modelica 3.6, 4.7).

Its local unknowns are its own variables, those of its connectors, and the inputs and flows of its components'
public connectors; its local equations those written in it, one for each input and flow of its own public
connectors, and one for each other public input without a value. `check_local_balance` compares the two for
each component of a flat model, for the values that its parameters have. Linear in the size of the model.

A value given to an input of a connector stands for the connection. Components with `inner`, `outer` or
expandable parts are left to the global count: their connections belong to other levels.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from acausal.errors import BalanceProblem, Diagnostic
from acausal.lang.flat import Causality, FlatModel, Origin, Variability
from acausal.lang.instance import Array, Connection, Instance, Leaf, Member, Outer, leaves
from acausal.symbolic.expressions.expr import symbols

_MODELS = ("model", "block", "class")
_MOST = 10


@dataclass
class _Count:
    """Of one component."""

    instance: Instance
    unknowns: int = 0
    equations: int = 0
    exempt: bool = False


@dataclass
class _Levels:
    """All components of the model, and which of them each variable counts in."""

    connected: set[tuple[str, str]]
    counts: dict[str, _Count] = field(default_factory=dict[str, _Count])
    owner: dict[str, str] = field(default_factory=dict[str, str])
    outside: dict[str, str] = field(default_factory=dict[str, str])
    """For variables of connectors: the component whose connections can reach them."""


def check_local_balance(flat: FlatModel, root: Instance) -> None:
    """Raise `BalanceProblem` `balance.local` for components that are not balanced by themselves."""
    levels = _levels(root, _connected(flat))
    _count_equations(flat, levels)
    wrong = [count for path, count in levels.counts.items() if path and not count.exempt]
    found: dict[str, Diagnostic] = {}
    for count in wrong:
        scope = count.instance.scope
        if count.unknowns != count.equations and scope.path not in found:
            found[scope.path] = _diagnostic(count)
    if found:
        raise BalanceProblem(list(found.values())[:_MOST])


def _diagnostic(count: _Count) -> Diagnostic:
    scope = count.instance.scope
    more = "too few" if count.equations < count.unknowns else "too many"
    return Diagnostic(
        "balance.local",
        f"`{count.instance.path}` (`{scope.path}`) has {count.equations} equations for {count.unknowns} "
        f"unknowns of its own: {more}",
        scope.span,
        (count.instance.path, scope.path),
        "counted with its connectors' flows and inputs, which come from outside (Modelica 3.6, 4.7)",
    )


# --------------------------------------------------------------------------- unknowns


def _connected(flat: FlatModel) -> set[tuple[str, str]]:
    """The variables in connections, each with the component that connects it."""
    equations = [equation for equation in flat.equations if equation.origin is Origin.CONNECTION]
    return {
        (name, equation.component)
        for equation in equations
        for name in symbols([equation.left, equation.right])
    }


def _levels(root: Instance, connected: set[tuple[str, str]]) -> _Levels:
    levels = _Levels(connected)
    stack: list[tuple[Instance, str]] = [(root, "")]
    while stack:
        model, around = stack.pop()
        count = levels.counts[model.path] = _Count(model)
        for name, member in model.members.items():
            entry = model.scope.table.components.get(name)
            inner = entry is None or entry.clause.prefixes.inner
            count.exempt = count.exempt or inner or _is_expandable(member)
            if isinstance(member, Outer):
                count.exempt = count.exempt or not isinstance(member.target, Leaf)
                continue
            public = entry is None or not entry.protected
            for part in _scalars_of(member):
                if isinstance(part, Leaf) or part.scope.kind not in _MODELS:
                    _count_variables(levels, count, part, public, around)
                else:
                    count.unknowns += sum(
                        1
                        for leaf in _public_connector_leaves(part)
                        if _from_outside(leaf, model.path, levels.connected)
                    )
                    count.exempt = count.exempt or any(_is_expandable(m) for m in part.members.values())
                    stack.append((part, model.path))
    return levels


def _is_expandable(member: Member | Outer) -> bool:
    while isinstance(member, Array) and member.items:
        member = member.items[0]
    return isinstance(member, Instance) and member.scope.definition.class_prefixes.expandable


def _scalars_of(member: Member) -> Iterator[Leaf | Instance]:
    """A component; of an array, its elements."""
    stack: list[Member] = [member]
    while stack:
        current = stack.pop()
        if isinstance(current, Array):
            stack.extend(current.items)
        elif isinstance(current, (Leaf, Instance)):
            yield current


def _count_variables(
    levels: _Levels, count: _Count, part: Leaf | Instance, public: bool, around: str
) -> None:
    """Variables, records and connectors of a component."""
    connector = part.connector if isinstance(part, Leaf) else part.is_connector
    path = count.instance.path
    for leaf in leaves(part):
        levels.owner[leaf.path] = path
        levels.outside[leaf.path] = around if public else path
        if leaf.prefixes.variability <= Variability.PARAMETER:
            continue
        count.unknowns += 1
        if not public:
            continue
        if connector:
            count.equations += _from_outside(leaf, around, levels.connected)
        elif leaf.prefixes.causality is Causality.INPUT and leaf.binding is None:
            count.equations += 1


def _from_outside(leaf: Leaf, around: str, connected: set[tuple[str, str]]) -> bool:
    """Whether a connection determines a variable of a component's connector, not a value in place of one."""
    prefixes = leaf.prefixes
    if prefixes.variability <= Variability.PARAMETER:
        return False
    if prefixes.causality is Causality.INPUT:
        return leaf.binding is None or (leaf.path, around) in connected
    return prefixes.connection is Connection.FLOW


def _public_connector_leaves(model: Instance) -> Iterator[Leaf]:
    for name, member in model.members.items():
        entry = model.scope.table.components.get(name)
        if entry is None or entry.protected or isinstance(member, Outer):
            continue
        for part in _scalars_of(member):
            if part.connector if isinstance(part, Leaf) else part.is_connector:
                yield from leaves(part)


# --------------------------------------------------------------------------- equations


def _count_equations(flat: FlatModel, levels: _Levels) -> None:
    counts = levels.counts
    for equation in flat.equations:
        path = equation.component
        if equation.origin is Origin.BINDING and equation.left.op == "sym":
            path = levels.owner.get(equation.left.name, path)
        elif equation.origin is Origin.UNCONNECTED and equation.left.op == "sym":
            path = levels.outside.get(equation.left.name, path)
        if path in counts:
            counts[path].equations += 1
    for when in flat.whens:
        if when.component in counts:
            counts[when.component].equations += len(when.assigned)
