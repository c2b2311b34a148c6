# pyright: reportUnknownMemberType=false
"""Frequency responses: G(2 pi i f) = C (2 pi i f I - A)^-1 B + D from every input to every output."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from acausal.analysis.linear import Matrices

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure

Vector = NDArray[np.float64]
Complex = NDArray[np.complex128]

POINTS = 400
_DECADES = 8


@dataclass(frozen=True, eq=False)
class Bode:
    """`gain` (outputs, inputs, frequencies), complex, over `frequency` in Hz."""

    title: str
    outputs: tuple[str, ...]
    inputs: tuple[str, ...]
    frequency: Vector
    gain: Complex

    @property
    def magnitude(self) -> Vector:
        """|G| in the output's unit per the input's."""
        return np.abs(self.gain)

    @property
    def magnitude_db(self) -> Vector:
        """20 log10 |G|; minus infinity where nothing comes through."""
        with np.errstate(divide="ignore"):
            return np.asarray(20 * np.log10(np.abs(self.gain)), dtype=np.float64)

    @property
    def phase_deg(self) -> Vector:
        """The phase in degrees, without jumps along the frequencies."""
        return np.asarray(np.degrees(np.unwrap(np.angle(self.gain), axis=-1)), dtype=np.float64)

    def to_xarray(self) -> xr.DataArray:
        """The complex gain over `output`, `input` and `frequency` (Hz)."""
        import xarray as xr  # takes a while to import

        frequency = xr.DataArray(self.frequency, dims="frequency", attrs={"units": "Hz"})
        coordinates = {"output": list(self.outputs), "input": list(self.inputs), "frequency": frequency}
        return xr.DataArray(self.gain, dims=("output", "input", "frequency"), coords=coordinates, name="gain")

    def _repr_png_(self) -> bytes:
        from acausal.analysis.drawing import draw_bode

        return draw_bode(self).as_png()

    def plot(self, path: str | Path | None = None) -> Figure:
        """Magnitude and phase over frequency; written as PNG, SVG or PDF if `path` is given."""
        from acausal.analysis.drawing import draw_bode  # Matplotlib takes half a second to import

        return draw_bode(self, path)


def bode(
    title: str,
    matrices: Matrices,
    outputs: Sequence[tuple[int, str]],
    inputs: Sequence[tuple[int, str]],
    frequency: Vector,
) -> Bode:
    """The response from chosen inputs to chosen outputs, given by position and name. O(n^3) a frequency."""
    rows, columns = [i for i, _ in outputs], [i for i, _ in inputs]
    m, n = matrices, len(matrices.a)
    gain = np.empty((len(rows), len(columns), len(frequency)), dtype=np.complex128)
    for k, f in enumerate(frequency.tolist()):
        system = np.asarray(2j * np.pi * f * np.eye(n) - m.a, dtype=np.complex128)
        right = np.asarray(m.b[:, columns], dtype=np.complex128)
        gain[:, :, k] = m.c[rows] @ np.linalg.solve(system, right) + m.d[np.ix_(rows, columns)]
    names = tuple(name for _, name in outputs), tuple(name for _, name in inputs)
    return Bode(title, *names, frequency, gain)


def default_frequencies(eigenvalues: Complex) -> Vector:
    """From a tenth of the slowest to ten times the fastest natural frequency, over at most eight decades."""
    sizes = np.abs(eigenvalues) / (2 * np.pi)
    sizes = sizes[sizes > 1e-12 * sizes.max(initial=0.0)]
    if not sizes.size:
        return np.geomspace(0.01, 100.0, POINTS)
    high = 10 * float(sizes.max())
    return np.geomspace(max(float(sizes.min()) / 10, high / 10**_DECADES), high, POINTS)
