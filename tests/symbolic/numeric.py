"""A causal system evaluated in plain Python: what tests compare with closed forms."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from acausal.symbolic.causal import Block, BlockKind, CausalSystem
from acausal.symbolic.expressions.evaluate import evaluate
from acausal.symbolic.expressions.expr import TIME, Constant, Expr, postorder, sym, unknown_leaves
from acausal.symbolic.expressions.text import to_text

Values = dict[str, float]


def _no(name: str) -> None:
    return None


def _value(expr: Expr, known: Mapping[Expr, Constant]) -> float:
    memo: dict[Expr, Constant] = {node: known[node] for node in postorder([expr]) if node in known}
    result = evaluate(expr, _no, memo)
    assert isinstance(result, int | float)
    return float(result)


def _parameters(system: CausalSystem, known: dict[Expr, Constant]) -> None:
    for name in system.parameters:
        variable = system.flat.by_name[name]
        expr = variable.binding if variable.binding is not None else variable.start
        if expr is not None and variable.is_fixed:
            known[sym(name)] = _value(expr, known)


def _run(blocks: Sequence[Block], known: dict[Expr, Constant], guesses: Mapping[Expr, float]) -> None:
    for block in blocks:

        def residuals(z: Sequence[float], block: Block = block) -> list[float]:
            for leaf, value in zip(block.tearing, z, strict=True):
                known[leaf] = float(value)
            for assignment in block.assignments:
                known[assignment.unknown] = _value(assignment.value, known)
            return [_value(residual.value, known) for residual in block.residuals]

        if not block.tearing:
            residuals([])
            continue
        if block.kind is BlockKind.LINEAR:
            solution = _newton(residuals, np.zeros(len(block.tearing)), steps=1, h=1.0)
        else:
            guess = np.array([guesses.get(leaf, 0.5) for leaf in block.tearing])
            solution = _newton(residuals, guess, steps=60, h=1e-6)
        assert max(abs(r) for r in residuals([float(z) for z in solution])) < 1e-7


def _newton(
    residuals: Callable[[Sequence[float]], list[float]], z: NDArray[np.float64], *, steps: int, h: float
) -> NDArray[np.float64]:
    """Newton's method with central differences; exact in one step for a linear system."""
    unit = np.eye(len(z))
    for _ in range(steps):
        columns = [
            (np.array(residuals(list(z + h * e))) - np.array(residuals(list(z - h * e)))) / (2 * h)
            for e in unit
        ]
        change = np.linalg.solve(np.array(columns).T, -np.array(residuals(list(z))))
        z = z + change
        if np.max(np.abs(change)) < 1e-14:
            break
    return z


def _named(system: CausalSystem, known: dict[Expr, Constant]) -> Values:
    for alias in system.aliases:
        known[sym(alias.name)] = _value(alias.value, known)
    return {to_text(leaf): float(v) for leaf, v in known.items() if not isinstance(v, str)}  # type: ignore[arg-type]


def run(
    system: CausalSystem,
    states: Mapping[str, float],
    time: float = 0.0,
    guesses: Mapping[str, float] | None = None,
) -> Values:
    """All unknowns, by name, for given states."""
    assert set(states) == set(system.states)
    known: dict[Expr, Constant] = {TIME: time, **{sym(name): value for name, value in states.items()}}
    _parameters(system, known)
    for assignment in system.discrete.assignments:
        if set(unknown_leaves(assignment.value)) <= set(known):  # the others depend on the blocks
            known[assignment.unknown] = _value(assignment.value, known)
    _run(system.blocks, known, {sym(name): value for name, value in (guesses or {}).items()})
    for assignment in system.discrete.assignments:
        known[assignment.unknown] = _value(assignment.value, known)
    return _named(system, known)


def initialise(system: CausalSystem, time: float = 0.0, guesses: Mapping[str, float] | None = None) -> Values:
    """All unknowns at the start, from the initial problem; checks must hold."""
    known: dict[Expr, Constant] = {TIME: time}
    _parameters(system, known)
    _run(system.initial.blocks, known, {sym(name): value for name, value in (guesses or {}).items()})
    for check in system.initial.checks:
        assert abs(_value(check.value, known)) < 1e-9
    return _named(system, known)
