"""Who is solved from which equation, and in which order: matching, strong components, tearing.

Matching prefers pairs that can be solved safely (linear with a constant coefficient), then linear ones, so
that nonlinear scalar equations appear only where they are unavoidable. A block is linear if every residual is
linear in the tearing variables once the block's assignments are put in, shown by a degree analysis that
visits every node once.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from acausal.symbolic.causal import Assignment, Block, BlockKind, CausalEquation, Residual
from acausal.symbolic.expressions.expr import Expr, fold, sub
from acausal.symbolic.expressions.operators import SWITCHING
from acausal.symbolic.graphs.anchoring import anchored
from acausal.symbolic.graphs.blt import Component, strong_components
from acausal.symbolic.graphs.matching import Matcher, Matching
from acausal.symbolic.graphs.tearing import tear
from acausal.symbolic.graphs.types import Eq, Var
from acausal.symbolic.solving import Profile, Profiler, Solvability, solve


@dataclass(frozen=True)
class Square:
    """Equations and the leaves they must determine, with a complete matching."""

    profiles: tuple[Profile, ...]
    unknowns: tuple[Expr, ...]
    incidence: tuple[tuple[Var, ...], ...]
    """All unknowns of every equation, those in conditions too."""
    matching: Matching


class NoCompleteMatching(Exception):
    """The equations cannot determine the unknowns; the caller knows which message this deserves."""

    def __init__(self, square: Square) -> None:
        super().__init__("no complete matching")
        self.square = square


def rows(profile: Profile, index: dict[Expr, Var], worst: Solvability = Solvability.NONLINEAR) -> list[Var]:
    """The unknowns an equation can be solved for, the safest first."""
    found = [
        (how, i)
        for leaf, how in profile.solvable.items()
        if how <= worst and (i := index.get(leaf)) is not None
    ]
    found.sort(key=lambda pair: pair[0])
    return [i for _, i in found]


def square_system(profiles: Sequence[Profile], unknowns: Sequence[Expr]) -> Square:
    """Match the equations with the unknowns, safest pairs first. Raises `NoCompleteMatching`.

    Three matchings, each extending the one before: O(V E) at worst, near-linear in practice.
    """
    index = {leaf: Var(i) for i, leaf in enumerate(unknowns)}
    pairs: list[tuple[Eq, Var]] = []
    full: Matcher | None = None
    for worst in (Solvability.SAFE, Solvability.VARYING, Solvability.NONLINEAR):
        full = Matcher([rows(profile, index, worst) for profile in profiles], len(unknowns))
        for eq, var in pairs:
            full.pair(eq, var)
        left = full.augment(Eq(i) for i, var in enumerate(full.var_of_eq) if var is None)
        pairs = [(Eq(i), var) for i, var in enumerate(full.var_of_eq) if var is not None]
        if not left:
            break
    assert full is not None
    matching = full.freeze()
    incidence = tuple(tuple(index[leaf] for leaf in profile.leaves if leaf in index) for profile in profiles)
    square = Square(tuple(profiles), tuple(unknowns), incidence, matching)
    if not matching.size == len(profiles) == len(unknowns):
        raise NoCompleteMatching(square)
    return square


def ordered_blocks(square: Square) -> tuple[Block, ...]:
    """The blocks in solving order. Near-linear."""
    return tuple(
        _scalar(square, component) if len(component.equations) == 1 else _loop(square, component)
        for component in strong_components(square.incidence, square.matching)
    )


def _scalar(square: Square, component: Component) -> Block:
    profile = square.profiles[component.equations[0]]
    leaf = square.unknowns[component.variables[0]]
    how = profile.solvable[leaf]
    if how is Solvability.SWITCHING:
        return Block(BlockKind.LINEAR, (), (leaf,), (_residual(profile.equation),))
    solved = solve(profile.equation, leaf)
    if solved is not None:
        return Block(BlockKind.EXPLICIT, (solved,))
    return Block(BlockKind.NONLINEAR, (), (leaf,), (_residual(profile.equation),))


def _residual(equation: CausalEquation) -> Residual:
    return Residual(sub(equation.left, equation.right), equation)


def _loop(square: Square, component: Component) -> Block:
    """A torn block of several equations."""
    unknowns = [square.unknowns[var] for var in component.variables]
    profiles = [square.profiles[eq] for eq in component.equations]
    local = {leaf: Var(i) for i, leaf in enumerate(unknowns)}

    def solvable(eq: Eq, var: Var) -> bool:
        return profiles[eq].solvable.get(unknowns[var]) is Solvability.SAFE

    incidence = [[local[leaf] for leaf in profile.leaves if leaf in local] for profile in profiles]
    coefficients = [
        {local[leaf]: profile.numbers.get(leaf) for leaf in profile.leaves if leaf in local}
        for profile in profiles
    ]
    torn = anchored(tear(incidence, solvable, len(unknowns)), coefficients)
    assignments = tuple(_solved(profiles[eq].equation, unknowns[var]) for eq, var in torn.assignments)
    residuals = tuple(_residual(profiles[eq].equation) for eq in torn.residuals)
    tearing = tuple(unknowns[var] for var in torn.tearing_vars)
    linear = is_linear(tearing, assignments, residuals)
    return Block(BlockKind.LINEAR if linear else BlockKind.NONLINEAR, assignments, tearing, residuals)


def _solved(equation: CausalEquation, leaf: Expr) -> Assignment:
    solved = solve(equation, leaf)
    if solved is None:
        raise AssertionError(f"{leaf!r} was called solvable in {equation.flat.span}")
    return solved


_SUMS = frozenset({"add", "neg", "noEvent", "smooth"})


def is_linear(
    tearing: Iterable[Expr], assignments: Sequence[Assignment], residuals: Sequence[Residual]
) -> bool:
    """Whether the residuals are linear in `tearing` once the assignments are put in.

    Every node gets its degree in the tearing variables, 0, 1 or 2 for "more"; an assigned unknown has the
    degree of its value. Relations outside `noEvent` and `smooth` are modes, constant while a block is solved.
    O(nodes).
    """
    outer = _Degrees(frozen=True)
    inner = _Degrees(frozen=False)
    outer.inner = inner
    for leaf in tearing:
        outer.values[leaf] = inner.values[leaf] = 1
    for assignment in assignments:
        degree = outer.of(assignment.value)
        outer.values[assignment.unknown] = inner.values[assignment.unknown] = degree
    return all(outer.of(residual.value) <= 1 for residual in residuals)


class _Degrees:
    """Degrees of nodes, memoised; `frozen`: relations count as known."""

    def __init__(self, *, frozen: bool) -> None:
        self.values: dict[Expr, int] = {}
        self.inner = self
        self._frozen = frozen

    def of(self, root: Expr) -> int:
        return fold([root], self._visit, self.values)[root]

    def _visit(self, node: Expr, args: list[int]) -> int:
        op = node.op
        if self._frozen and op in ("noEvent", "smooth"):
            return self.inner.of(node)
        if not any(args) or op == "delay" or (self._frozen and op in SWITCHING):
            return 0
        if op in _SUMS:
            return max(args)
        if op == "mul":
            return min(2, sum(args))
        if op == "div":
            return 2 if args[1] else args[0]
        if op == "if":
            return 2 if args[0] else max(args[1:])
        return 2


def profiles_of(profiler: Profiler, equations: Iterable[CausalEquation]) -> list[Profile]:
    """The profiles of equations, in order."""
    return [profiler.profile(equation) for equation in equations]
