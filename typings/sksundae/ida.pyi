"""IDA of scikit-sundae 1.2. All the callbacks fill their last array in place; what they return is ignored."""

from collections.abc import Sequence
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csc_array, csc_matrix

from sksundae.cvode import CVODEResult

type _Vector = NDArray[np.float64]

class _Residual(Protocol):
    def __call__(self, t: float, y: _Vector, yp: _Vector, res: _Vector, /) -> None: ...

class _Events(Protocol):
    """May carry the attributes `terminal: list[bool | int]` and `direction: list[int]`."""

    def __call__(self, t: float, y: _Vector, yp: _Vector, events: _Vector, /) -> None: ...

class _Jacobian(Protocol):
    """`JJ` is (n, n) for dense and banded solvers, the non-zeros by column (CSC) for the sparse one."""

    def __call__(
        self, t: float, y: _Vector, yp: _Vector, res: _Vector, cj: float, JJ: _Vector, /
    ) -> None: ...

class IDA:
    def __init__(
        self,
        resfn: _Residual,
        *,
        algebraic_idx: Sequence[int] | None = None,
        min_step: float = 0,
        max_step: float = 0,
        rtol: float = 1e-5,
        atol: float | Sequence[float] | _Vector = 1e-6,
        linsolver: Literal["dense", "sparse"] = "dense",
        sparsity: NDArray[np.generic] | csc_array | csc_matrix | None = None,
        max_num_steps: int = 500,
        eventsfn: _Events | None = None,
        num_events: int = 0,
        jacfn: _Jacobian | None = None,
    ) -> None: ...
    def init_step(self, t0: float, y0: _Vector, yp0: _Vector) -> CVODEResult: ...
    def step(
        self,
        t: float,
        method: Literal["normal", "onestep"] = "normal",
        tstop: float | None = None,
    ) -> CVODEResult: ...
