"""CVODE of scikit-sundae 1.2. All the callbacks fill their last array in place; what they return is ignored."""

from collections.abc import Sequence
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csc_array, csc_matrix

type _Vector = NDArray[np.float64]

class _RightHandSide(Protocol):
    def __call__(self, t: float, y: _Vector, yp: _Vector, /) -> None: ...

class _Events(Protocol):
    """May carry the attributes `terminal: list[bool | int]` and `direction: list[int]`."""

    def __call__(self, t: float, y: _Vector, events: _Vector, /) -> None: ...

class _Jacobian(Protocol):
    """`JJ` is (n, n) for dense and banded solvers, the non-zeros by column (CSC) for the sparse one."""

    def __call__(self, t: float, y: _Vector, yp: _Vector, JJ: _Vector, /) -> None: ...

class CVODEResult:
    """From `step`, `t` is a number and `y` has shape (n,); from `solve`, (k,) and (k, n)."""

    message: str
    success: bool
    status: int
    t: float | _Vector
    y: _Vector
    i_events: NDArray[np.int_] | None
    t_events: _Vector | None
    y_events: _Vector | None
    nfev: int
    njev: int

class CVODE:
    def __init__(
        self,
        rhsfn: _RightHandSide,
        *,
        method: Literal["Adams", "BDF"] = "BDF",
        first_step: float = 0,
        min_step: float = 0,
        max_step: float = 0,
        rtol: float = 1e-5,
        atol: float | Sequence[float] | _Vector = 1e-6,
        linsolver: Literal["dense", "band", "sparse", "lapackdense", "lapackband", "gmres"] = "dense",
        lband: int | None = None,
        uband: int | None = None,
        sparsity: NDArray[np.generic] | csc_array | csc_matrix | None = None,
        nthreads: int | None = None,
        max_order: int = ...,
        max_num_steps: int = 500,
        max_nonlin_iters: int = 3,
        max_conv_fails: int = 10,
        eventsfn: _Events | None = None,
        num_events: int = 0,
        jacfn: _Jacobian | None = None,
    ) -> None: ...
    def init_step(self, t0: float, y0: _Vector) -> CVODEResult: ...
    def step(
        self,
        t: float,
        method: Literal["normal", "onestep"] = "normal",
        tstop: float | None = None,
    ) -> CVODEResult: ...
    def solve(self, tspan: _Vector, y0: _Vector) -> CVODEResult: ...
