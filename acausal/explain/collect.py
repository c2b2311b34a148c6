"""Facts that a CausalSystem holds between the lines: dependencies, incidence, differentiated equations."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from acausal.lang.flat import Equation, Origin
from acausal.symbolic.causal import Block, CausalEquation, CausalSystem
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.leaves import all_leaves


@dataclass(frozen=True, slots=True)
class Differentiated:
    """An equation of the flat model that was differentiated `times` times."""

    equation: Equation
    times: int
    alias: str = ""
    """The alias that the equation eliminated: it was differentiated on the way. Else index reduction did."""


@dataclass(frozen=True)
class Dependencies:
    """Which block gives an unknown, which blocks each needs, and which need it. Numbers count from 1."""

    producer: Mapping[Expr, int]
    needs: Mapping[int, tuple[int, ...]]
    needed_by: Mapping[int, tuple[int, ...]]


@dataclass(frozen=True)
class Incidence:
    """Equations against unknowns. `pairs` are (row, column) in the order before sorting.

    Row `i` is `equations[i]` and moves to `row_to[i]`; column `j`, `unknowns[j]`, moves to `column_to[j]`.
    """

    equations: tuple[CausalEquation, ...]
    unknowns: tuple[Expr, ...]
    pairs: tuple[tuple[int, int], ...]
    row_to: tuple[int, ...]
    column_to: tuple[int, ...]
    sizes: tuple[int, ...]
    """Of the blocks, in order."""


def block_equations(block: Block) -> tuple[CausalEquation, ...]:
    """The equations of a block: those that are assignments first, then the residuals."""
    return (*[a.equation for a in block.assignments], *[r.equation for r in block.residuals])


def solved_order(block: Block) -> tuple[Expr, ...]:
    """The unknowns beside their equations: assigned ones first, then the tearing variables."""
    return (*[a.unknown for a in block.assignments], *block.tearing)


def dependencies(system: CausalSystem) -> Dependencies:
    """Who needs whom. Linear in the size of the equations."""
    numbered = list(enumerate(system.blocks, 1))
    producer = {leaf: number for number, block in numbered for leaf in block.unknowns}
    needs: dict[int, tuple[int, ...]] = {}
    users: dict[int, list[int]] = {number: [] for number, _ in numbered}
    for number, block in numbered:
        found = {producer[leaf] for leaf in _leaves(block) if leaf in producer} - {number}
        needs[number] = tuple(sorted(found))
        for other in needs[number]:
            users[other].append(number)
    return Dependencies(producer, needs, {number: tuple(who) for number, who in users.items()})


def given(system: CausalSystem, block: Block) -> tuple[Expr, ...]:
    """What a block takes that no block gives: states, inputs, parameters and time, in order of appearance."""
    made = {leaf for other in system.blocks for leaf in other.unknowns}
    return tuple(leaf for leaf in _leaves(block) if leaf not in made)


def _leaves(block: Block) -> tuple[Expr, ...]:
    return all_leaves(
        [side for equation in block_equations(block) for side in (equation.left, equation.right)]
    )


def incidence(system: CausalSystem) -> Incidence:
    """The matrix in the model's order, and where its rows and columns go. Linear in the equations' size."""
    sorted_equations = [equation for block in system.blocks for equation in block_equations(block)]
    sorted_unknowns = [leaf for block in system.blocks for leaf in solved_order(block)]
    row_to = {_sides(equation): i for i, equation in enumerate(sorted_equations)}
    equations = [equation for equation in system.equations if _sides(equation) in row_to]
    unknowns = sorted(sorted_unknowns, key=_Declared(system))
    column = {leaf: j for j, leaf in enumerate(unknowns)}
    column_to = {leaf: j for j, leaf in enumerate(sorted_unknowns)}
    pairs = [
        (i, column[leaf])
        for i, equation in enumerate(equations)
        for leaf in all_leaves(_sides(equation))
        if leaf in column
    ]
    return Incidence(
        tuple(equations),
        tuple(unknowns),
        tuple(pairs),
        tuple(row_to[_sides(equation)] for equation in equations),
        tuple(column_to[leaf] for leaf in unknowns),
        tuple(block.size for block in system.blocks),
    )


def _sides(equation: CausalEquation) -> tuple[Expr, Expr]:
    return equation.left, equation.right


def unconnected(system: CausalSystem) -> tuple[str, ...]:
    """Connectors of components that nothing is connected to, in order: no flow passes them."""
    zeros = [e.left.name for e in system.flat.equations if e.origin is Origin.UNCONNECTED and e.component]
    return tuple(dict.fromkeys(name.rpartition(".")[0] for name in zeros))


class _Declared:
    """Sorts unknowns by the declaration of their variables, derivatives after them."""

    def __init__(self, system: CausalSystem) -> None:
        self.position = {variable.name: i for i, variable in enumerate(system.flat.variables)}

    def __call__(self, leaf: Expr) -> tuple[int, int]:
        order, inner = 0, leaf
        while inner.op != "sym":
            order, inner = order + 1, inner.args[0]
        return self.position.get(inner.name, len(self.position)), order


def differentiated(system: CausalSystem) -> tuple[Differentiated, ...]:
    """By index reduction, and by alias elimination: the derivatives of an alias need its equation's."""
    times: dict[tuple[Expr, Expr, int], Differentiated] = {}
    for equation in system.equations:
        if equation.differentiations:
            flat = equation.flat
            key = (flat.left, flat.right, flat.span.start)
            known = times[key].times if key in times else 0
            times[key] = Differentiated(flat, max(known, equation.differentiations))
    return (*times.values(), *_by_aliases(system))


def _by_aliases(system: CausalSystem) -> Iterator[Differentiated]:
    """Aliases that could have been states: once, and once more where `der(a) = b` and b is one as well."""
    aliases = {alias.name: alias for alias in system.aliases}
    names = [c.name for c in system.choices if not c.is_state and c.name in aliases]
    higher = _higher(system, names)
    for name in names:
        times, current = 1, name
        while (current := higher.get(current, "")) and times <= len(names):
            times += 1
        yield Differentiated(aliases[name].equation, times, name)


def _higher(system: CausalSystem, names: Sequence[str]) -> dict[str, str]:
    """The map of a to b where an equation of the model says b = der(a), both in `names`."""
    wanted = frozenset(names)
    found: dict[str, str] = {}
    for equation in system.flat.equations if wanted else ():
        for slope, speed in ((equation.left, equation.right), (equation.right, equation.left)):
            if slope.op == "der" and slope.args[0].op == speed.op == "sym":
                integral = slope.args[0].name
                if integral in wanted and speed.name in wanted:
                    found[integral] = speed.name
    return found
