"""What to do about an event that does not end: by what goes round, and whether the roots jump."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from acausal.errors import AcausalError
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.initial_modes import Switched
from acausal.simulate.matrices import Vector
from acausal.simulate.messages import leaf_name
from acausal.symbolic.causal import Assignment
from acausal.symbolic.expressions.expr import Expr
from acausal.symbolic.leaves import all_leaves

_JUMP = 1e-6
"""Of the larger root: what a root may move without being said to jump."""
_SLIDES = "the solution slides along the switching point: use a hysteresis or a continuous characteristic"
_JUMPS = "the branches contradict their conditions: use a hysteresis, or a characteristic without a jump"
_CONTRADICTS = "an equation contradicts its own value before the event, as `b = not pre(b)` does"


def cycle_hint(
    evaluator: Evaluator, circle: Sequence[Switched], which: NDArray[np.bool_], unknowns: Sequence[Expr]
) -> str:
    """For conditions, those of `which`, and discrete `unknowns` that switch back and forth.

    Where the roots stay what they are in all of the circle, the derivatives alone turn them back: sliding.
    """
    if not _jumps(evaluator, circle, which):
        return _SLIDES
    if not unknowns:
        return _JUMPS
    name = leaf_name(unknowns[0])
    return f"the conditions depend on what they set at the same instant: use `pre({name})`, or a hysteresis"


def endless_hint(assignments: Sequence[Assignment]) -> str:
    """For values that change in every iteration: whether their equations need one another's results."""
    needs = {a.unknown: all_leaves([a.value]) for a in assignments}
    uses = {leaf: [other for other in leaves if other in needs] for leaf, leaves in needs.items()}
    for first, used in uses.items():
        reached, waiting = dict[Expr, None](), [*used]
        while waiting:
            leaf = waiting.pop()
            if leaf not in reached:
                reached[leaf] = None
                waiting += uses[leaf]
        others = [leaf for leaf in reached if leaf != first]
        if first in reached and others:
            name = leaf_name(others[0])
            return f"these equations set one another at the same instant: use `pre({name})` in one of them"
    return _CONTRADICTS


def _jumps(evaluator: Evaluator, circle: Sequence[Switched], which: NDArray[np.bool_]) -> bool:
    """Whether one of these roots has different values in the circle; the evaluator ends where it was."""
    before = evaluator.m.copy(), evaluator.d.copy()
    found: list[Vector] = []
    try:
        for switched in circle:
            evaluator.m[:], evaluator.d[:] = switched.m, switched.d
            evaluator.settle()
            evaluator.event()
            found.append(evaluator.roots[which])
    except AcausalError:
        return False
    finally:
        evaluator.m[:], evaluator.d[:] = before
    roots = np.array(found)
    spread = roots.max(axis=0) - roots.min(axis=0)
    return bool((spread > _JUMP * np.maximum(1.0, np.abs(roots).max(axis=0))).any())
