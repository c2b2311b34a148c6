"""A snapshot: a compiled model linearised at one instant, with everything discrete frozen as it is there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from acausal.analysis.bode import Bode, bode, default_frequencies
from acausal.analysis.equilibrium import split, turning
from acausal.analysis.linear import Matrices, alias_of, matrices_at
from acausal.analysis.modes import Complex, Modes
from acausal.analysis.points import Point
from acausal.analysis.truth import Growing, Relation
from acausal.errors import UsageProblem, fail
from acausal.simulate.names import did_you_mean
from acausal.simulate.stability import GROWTH, step_limits

if TYPE_CHECKING:
    import control
    import xarray as xr
    from matplotlib.figure import Figure

Matrix = NDArray[np.float64]
_STEADY = 1e-6
"""Largest derivative of a state at rest, relative to its nominal value per second."""
_NOISE = 1e-14
"""Rounding of large values, such as angles after many turns, relative: it moves stiff states a little."""


@dataclass(frozen=True, eq=False)
class Snapshot:
    """The model near one instant.

    `rates` are the derivatives there; `nominals` are typical sizes of the states, and `units` their units.
    `relations` are frozen as they are; `growing` names those that may be the reason why a mode grows.
    """

    model: str
    at: str
    """`initial`, `steady`, or empty for an instant."""
    time: float
    states: tuple[str, ...]
    units: tuple[str, ...]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    """Every variable that changes, and declared outputs that equal one of them."""
    declared_outputs: tuple[str, ...]
    point: Point
    a: Matrix
    """A as it is, without labels."""
    modes: Modes
    """Eigenvalues in clusters, with shapes and participation; slowest first."""
    values: Matrix
    rates: Matrix
    nominals: Matrix
    relations: tuple[Relation, ...] = ()
    growing: tuple[Growing, ...] = ()
    notes: tuple[str, ...] = ()
    """Further warnings."""

    @cached_property
    def matrices(self) -> Matrices:
        """A, B, C, D without labels, C and D over `outputs`; all but A are made when first asked for."""
        found = matrices_at(self.point.evaluator())
        c, d = ([*matrix] for matrix in (found.c, found.d))
        position = {name: i for i, name in enumerate(self.outputs)}
        for name in self.outputs[len(c) :]:
            sign, source = alias_of(self.point.code, name) or (0.0, self.outputs[0])
            i = position.get(source, 0) if sign else 0
            c.append(sign * found.c[i])
            d.append(sign * found.d[i])
        return Matrices(found.a, found.b, np.array(c), np.array(d)) if len(c) > len(found.c) else found

    @property
    def eigenvalues(self) -> Complex:
        """In 1/s, as many as states, slowest first."""
        return self.modes.eigenvalues

    @property
    def condition(self) -> float:
        """Condition number of the eigenvector matrix; infinite where a cluster is defective."""
        return self.modes.condition

    @cached_property
    def residual(self) -> Matrix:
        """The derivatives without those of positions that turn, in the states' units per second."""
        scale = self.nominals
        null = turning(self.a * scale / scale[:, None], self.units)
        return split(self.rates / scale, null)[1] * scale

    @property
    def moving(self) -> tuple[str, ...]:
        """The states that are not at rest, the worst first."""
        sizes = np.abs(self.residual / self.nominals)
        noise = _NOISE * (np.abs(self.a) @ np.abs(self.values)) / self.nominals
        order: list[int] = np.argsort(-sizes, kind="stable").tolist()
        return tuple(self.states[i] for i in order if sizes[i] > _STEADY + noise[i])

    @property
    def is_equilibrium(self) -> bool:
        """Whether nothing changes but positions that turn."""
        return not self.moving

    @cached_property
    def max_step(self) -> dict[str, float]:
        """`step_limit` of every explicit method."""
        return step_limits(self.eigenvalues)

    @property
    def near_events(self) -> tuple[Relation, ...]:
        """What will switch within the longest step that an explicit method may take, the next first."""
        reach = max((limit for limit in self.max_step.values() if limit < inf), default=0.0)
        near = [relation for relation in self.relations if relation.seconds <= reach]
        return tuple(sorted(near, key=lambda relation: relation.seconds))

    @cached_property
    def warnings(self) -> tuple[str, ...]:
        """What the eigenvalues do not say: motion, modes that grow, events that are near."""
        from acausal.analysis.words import warnings_of

        return (*warnings_of(self), *self.notes)

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
        return self.max_step[method]

    @property
    def A(self) -> xr.DataArray:  # the names that control engineers know
        """D der(state) / d state, labelled."""
        return _labelled(self.a, ("derivative", self.states), ("state", self.states))

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

    def to_control(
        self, outputs: Sequence[str] | None = None, inputs: Sequence[str] | None = None
    ) -> control.StateSpace:
        """A `control.StateSpace` with names; without `outputs` the declared ones, else the states.

        Raises UsageProblem `eigen.control` where python-control is not installed, `eigen.unknown-signal`.
        """
        try:
            import control
        except ImportError:
            hint = "pip install 'acausal[control]'"
            problem = "python-control is not installed"
            raise fail(UsageProblem, "eigen.control", problem, hint=hint) from None
        rows, columns = self._outputs(outputs), self._inputs(inputs)
        m, r, c = self.matrices, [i for i, _ in rows], [i for i, _ in columns]
        return control.ss(
            m.a,
            m.b[:, c],
            m.c[r],
            m.d[np.ix_(r, c)],
            states=list(self.states),
            outputs=[name for _, name in rows],
            inputs=[name for _, name in columns],
            name=self.model,
        )

    def bode(
        self,
        outputs: str | Sequence[str] | None = None,
        inputs: str | Sequence[str] | None = None,
        frequency: Sequence[float] | Matrix | None = None,
    ) -> Bode:
        """Frequency responses; `frequency` in Hz. Without outputs: the declared ones, else the states.

        Raises UsageProblem `eigen.unknown-signal`, `eigen.frequency`, and `eigen.no-input` for a model
        without inputs.
        """
        rows, columns = self._outputs(outputs), self._inputs(inputs)
        if not columns:
            hint = "declare what acts on it as an input of the model"
            raise fail(UsageProblem, "eigen.no-input", f"{self.model} has no inputs", hint=hint)
        chosen = default_frequencies(self.eigenvalues) if frequency is None else np.asarray(frequency, float)
        if chosen.ndim != 1 or not chosen.size or not (np.isfinite(chosen) & (chosen >= 0)).all():
            raise fail(UsageProblem, "eigen.frequency", "frequencies must be numbers from 0 Hz on")
        return bode(f"{self.model} at {self.time:g} s", self.matrices, rows, columns, chosen)

    def response(self, output: str, source: str, frequencies: Sequence[float] | Matrix) -> Complex:
        """The transfer function G(2 pi i f) from an input to an output, f in Hz.

        Raises UsageProblem `eigen.unknown-signal`.
        """
        return self.bode(output, source, frequencies).gain[0, 0]

    def _outputs(self, names: str | Sequence[str] | None) -> list[tuple[int, str]]:
        chosen = self.declared_outputs or self.states if names is None else names
        wanted = [chosen] if isinstance(chosen, str) else list(chosen)
        return [(_position(self.outputs, name, "output"), name) for name in wanted]

    def _inputs(self, names: str | Sequence[str] | None) -> list[tuple[int, str]]:
        chosen = self.inputs if names is None else names
        wanted = [chosen] if isinstance(chosen, str) else list(chosen)
        return [(_position(self.inputs, name, "input"), name) for name in wanted]

    def plot(self, path: str | Path | None = None, *others: Snapshot) -> Figure:
        """The eigenvalues in the complex plane, those of `others` as well; PNG, SVG or PDF."""
        from acausal.analysis.drawing import draw_plane  # Matplotlib takes half a second to import

        return draw_plane([self, *others], path)

    def plot_shape(self, mode: int, path: str | Path | None = None) -> Figure:
        """One mode's shape and participation, by its number in `modes.modes`, from 0."""
        from acausal.analysis.drawing import draw_shape

        return draw_shape(self, mode, path)

    def to_json(self) -> dict[str, object]:
        """The keys of `acausal eigen --json`; what is infinite becomes null."""
        from acausal.analysis.words import snapshot_json

        return snapshot_json(self)

    def _repr_html_(self) -> str:
        from acausal.analysis.page import fragment

        return fragment(self)


def _labelled(
    matrix: Matrix, rows: tuple[str, tuple[str, ...]], columns: tuple[str, tuple[str, ...]]
) -> xr.DataArray:
    import xarray as xr  # takes a while to import

    return xr.DataArray(
        matrix, dims=(rows[0], columns[0]), coords={rows[0]: list(rows[1]), columns[0]: list(columns[1])}
    )


def _position(names: tuple[str, ...], name: str, kind: str) -> int:
    if name not in names:
        raise fail(
            UsageProblem,
            "eigen.unknown-signal",
            f"the snapshot has no {kind} `{name}`",
            names=[name],
            hint=did_you_mean(name, names) or f"there is {', '.join(names[:8]) or 'none'}",
        )
    return names.index(name)
