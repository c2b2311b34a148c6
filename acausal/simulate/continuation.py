"""Newton homotopy for a block on which damped Newton iterations fail.

`F(z) - (1 - s) F(z0) = 0` has the solution `z0` at s = 0 and is the block itself at s = 1. `s` grows in steps
that double after a success and halve after a failure, each corrected by Newton iterations from a linear
prediction (Allgower and Georg, Numerical Continuation Methods, 1990, ch. 1 and 2.1). The number of steps is
bounded; a path that turns back is given up.
"""

from __future__ import annotations

import numpy as np

from acausal.simulate.matrices import Matrix, Vector
from acausal.simulate.newton import Solution, System, solve

MAX_STEPS = 200
_SHORTEST = 1e-6
_CORRECTOR = 12


def follow(system: System, start: Vector, nominal: Vector) -> Solution | None:
    """The solution at the end of the path from `start`; None where the path cannot be followed."""
    with np.errstate(all="ignore"):
        offset = system(start)[0]
    if not np.isfinite(offset).all():
        return None
    z, before = start, start
    reached, last, step = 0.0, 0.0, 0.1
    for _ in range(MAX_STEPS):
        target = min(1.0, reached + step)
        ahead = z + (z - before) * (target - reached) / last if last > 0 else z
        found = solve(_shifted(system, (1 - target) * offset), ahead, nominal, _CORRECTOR)
        if not found.converged and last > 0:
            found = solve(_shifted(system, (1 - target) * offset), z, nominal, _CORRECTOR)
        if found.converged:
            before, z, last, reached = z, found.z, target - reached, target
            if reached >= 1.0:
                return found
            step = min(2 * step, 0.5)
        else:
            step /= 2
            if step < _SHORTEST:
                return None
    return None


def _shifted(system: System, shift: Vector) -> System:
    def shifted(z: Vector) -> tuple[Vector, Matrix]:
        residual, jacobian = system(z)
        return residual - shift, jacobian

    return shifted
