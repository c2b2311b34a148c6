"""python-control: only what is used here."""

from collections.abc import Sequence

from numpy import float64
from numpy.typing import NDArray

class StateSpace:
    A: NDArray[float64]
    B: NDArray[float64]
    C: NDArray[float64]
    D: NDArray[float64]
    state_labels: list[str]
    input_labels: list[str]
    output_labels: list[str]

def ss(
    a: NDArray[float64],
    b: NDArray[float64],
    c: NDArray[float64],
    d: NDArray[float64],
    /,
    *,
    states: Sequence[str],
    outputs: Sequence[str],
    inputs: Sequence[str],
    name: str,
) -> StateSpace: ...
