"""Whether a fold lies between two values of the unknown of a block.

On one branch of solutions the slope dr/dz of the residual keeps its sign. Where it has both signs between two
values, a fold lies between them, and what went from one to the other jumped over it (Kuznetsov, Elements of
Applied Bifurcation Theory, 2004, 3.2).
"""

from __future__ import annotations

import numpy as np

from acausal.codegen.program import ImplicitCode
from acausal.simulate.call import residual_and_jacobian
from acausal.simulate.matrices import Vector

_LOOKS = 33


def turns_between(code: ImplicitCode, known: Vector, before: float, after: float) -> bool:
    """Looks at the slope in a few points between; `known` are the values that the block reads."""
    points = np.linspace(before, after, _LOOKS)
    slopes = [residual_and_jacobian(code.residual, np.array([z]), known)[1] for z in points]
    values = np.array([float(np.asarray(slope)[0, 0]) for slope in slopes])
    least = 1e-9 * np.abs(values[np.isfinite(values)]).max(initial=0.0)
    return bool((values > least).any() and (values < -least).any())
