"""A snapshot: a compiled model linearised at one instant, with everything discrete frozen as it is there."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import inf
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from acausal.analysis.linear import Matrices
from acausal.analysis.modes import CLUSTER, Complex, Mode, Modes, modes
from acausal.analysis.stability import GROWTH, step_limit
from acausal.errors import UsageProblem, fail

if TYPE_CHECKING:
    import xarray as xr

Matrix = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Snapshot:
    """The model near one instant.

    `rates` are the derivatives there; those of an equilibrium are zero but for angles that turn (`moving`
    lists the states for which that is not so, the worst first). `nominals` are typical sizes of the states.
    """

    model: str
    time: float
    states: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    matrices: Matrices
    values: Matrix
    rates: Matrix
    nominals: Matrix
    warnings: tuple[str, ...] = ()

    @cached_property
    def modes(self) -> Modes:
        """Eigenvalues in clusters, with shapes and participation; slowest first."""
        return modes(self.matrices.a, self.nominals)

    @property
    def eigenvalues(self) -> Complex:
        return self.modes.eigenvalues

    @property
    def condition(self) -> float:
        """Condition number of the eigenvector matrix; infinite where a cluster is defective."""
        return self.modes.condition

    def step_limit(self, method: str) -> float:
        """The largest step in seconds with which an explicit method is stable here; see `stability`.

        Raises UsageProblem `eigen.method`.
        """
        if method not in GROWTH:
            raise fail(
                UsageProblem,
                "eigen.method",
                f"`{method}` has no step limit here",
                names=[method],
                hint=f"explicit methods are {', '.join(GROWTH)}",
            )
        values = self.eigenvalues
        return step_limit(method, values, CLUSTER * float(np.abs(values).max(initial=0.0)))

    @property
    def A(self) -> xr.DataArray:  # the names that control engineers know
        """D der(state) / d state, labelled."""
        return _labelled(self.matrices.a, ("derivative", self.states), ("state", self.states))

    @property
    def B(self) -> xr.DataArray:
        """D der(state) / d input, labelled."""
        return _labelled(self.matrices.b, ("derivative", self.states), ("input", self.inputs))

    @property
    def C(self) -> xr.DataArray:
        """D output / d state, labelled."""
        return _labelled(self.matrices.c, ("output", self.outputs), ("state", self.states))

    @property
    def D(self) -> xr.DataArray:
        """D output / d input, labelled."""
        return _labelled(self.matrices.d, ("output", self.outputs), ("input", self.inputs))

    def response(self, output: str, source: str, frequencies: Matrix) -> Complex:
        """The transfer function G(2 pi i f) from an input to an output, f in Hz.

        Raises UsageProblem `eigen.unknown-signal`.
        """
        row, column = _position(self.outputs, output, "output"), _position(self.inputs, source, "input")
        m = self.matrices
        eye = np.eye(len(self.states))
        gains = np.empty(len(frequencies), dtype=np.complex128)
        for i, frequency in enumerate(np.asarray(frequencies, dtype=np.float64).tolist()):
            system: Complex = np.asarray(2j * np.pi * frequency * eye - m.a, dtype=np.complex128)
            right = np.asarray(m.b[:, column], dtype=np.complex128)
            states = np.asarray(np.linalg.solve(system, right), dtype=np.complex128)
            gains[i] = complex(np.dot(m.c[row], states)) + float(m.d[row, column])
        return gains

    def to_json(self) -> dict[str, object]:
        """The keys of `acausal eigen --json`; what is infinite becomes null."""
        limits = {method: self.step_limit(method) for method in GROWTH}
        return {
            "model": self.model,
            "time": self.time,
            "states": list(self.states),
            "eigenvalues": [self._mode(mode) for mode in self.modes.modes for _ in range(mode.multiplicity)],
            "max_step": {method: None if limit == inf else limit for method, limit in limits.items()},
            "condition": None if self.condition == inf else self.condition,
            "rates": dict(zip(self.states, self.rates.tolist(), strict=True)),
            "warnings": list(self.warnings),
        }

    def _mode(self, mode: Mode) -> dict[str, object]:
        constant = mode.time_constant
        return {
            "re": mode.eigenvalue.real,
            "im": mode.eigenvalue.imag,
            "frequency_hz": mode.frequency_hz,
            "damping_ratio": mode.damping_ratio,
            "time_constant": None if constant == inf else constant,
            "multiplicity": mode.multiplicity,
            "defective": mode.is_defective,
            "participation": dict(zip(self.states, mode.participation.tolist(), strict=True)),
        }


def _labelled(
    matrix: Matrix, rows: tuple[str, tuple[str, ...]], columns: tuple[str, tuple[str, ...]]
) -> xr.DataArray:
    import xarray as xr  # takes a while to import

    return xr.DataArray(
        matrix, dims=(rows[0], columns[0]), coords={rows[0]: list(rows[1]), columns[0]: list(columns[1])}
    )


def _position(names: tuple[str, ...], name: str, kind: str) -> int:
    if name not in names:
        listed = ", ".join(names[:8]) or "none"
        raise fail(
            UsageProblem,
            "eigen.unknown-signal",
            f"the snapshot has no {kind} `{name}`",
            names=[name],
            hint=f"there is {listed}",
        )
    return names.index(name)
