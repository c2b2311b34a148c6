"""CasADi Functions on NumPy arrays, where speed does not matter."""

from __future__ import annotations

import numpy as np
from casadi import Function

from acausal.simulate.matrices import DENSE_UP_TO, Matrix, Vector


def call(function: Function, *args: Vector) -> list[Vector]:
    """The outputs as dense arrays (slow; not for the integrator)."""
    return [np.asarray(out.full(), dtype=float) for out in function.call([np.asarray(a) for a in args])]


def residual_and_jacobian(function: Function, *args: Vector) -> tuple[Vector, Matrix]:
    """The two outputs of an implicit block's Function; the Jacobian is sparse if it is large."""
    residual, jacobian = function.call([np.asarray(a) for a in args])
    dense = residual.shape[0] <= DENSE_UP_TO
    values = np.asarray(residual.full(), dtype=float).ravel()
    if dense:
        return values, np.asarray(jacobian.full(), dtype=float)
    from scipy.sparse import csc_array  # takes a while to import

    return values, csc_array(jacobian.sparse())
