"""Instants of a run, each with everything that a linearisation needs: states, modes, discrete values.

One run visits all of them. A mode or a discrete value is constant between events, so what holds when a row is
recorded holds at that row's instant; at an event the last row counts, the one after it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from acausal.codegen.functions import Code
from acausal.errors import SimulationProblem, fail
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.initialize import InitialPoint
from acausal.simulate.inputs import Inputs
from acausal.simulate.matrices import Vector
from acausal.simulate.options import Options
from acausal.simulate.record import Recorder
from acausal.simulate.run import run
from acausal.simulate.settle import Settling
from acausal.simulate.solvers import make_solver

_SAME = 1e-12


@dataclass(frozen=True, eq=False)
class Point:
    """States `x`, parameters `p`, modes `m`, discrete values `d`, inputs and delays `u`, a guess `z`."""

    code: Code
    time: float
    x: Vector
    p: Vector
    m: Vector
    d: Vector
    u: Vector
    z: Vector
    inputs: Inputs

    @classmethod
    def of(cls, evaluator: Evaluator) -> Point:
        """Where an evaluator is now."""
        e = evaluator
        x, p, m, d, u, z = (array.copy() for array in (e.x, e.p, e.m, e.d, e.u, e.guess))
        return cls(e.code, float(e.t[0]), x, p, m, d, u, z, e.inputs)

    def evaluator(self) -> Evaluator:
        """A new evaluator that is settled here; delayed values stay what they are."""
        made = Evaluator(self.code, self.p, self.inputs)
        made.history = None
        made.m[:], made.d[:], made.u[:], made.guess[:] = self.m, self.d, self.u, self.z
        made.at(self.time, self.x)
        made.settle()
        return made


class _Notes(Recorder):
    """A recorder that also keeps the points at the instants in `wanted`."""

    watches_modes = True

    def __init__(self, evaluator: Evaluator, wanted: Sequence[float]) -> None:
        super().__init__(evaluator)
        self._wanted = np.array(wanted)
        self.points: dict[float, Point] = {}

    def add(self, time: float, x: Vector) -> None:
        super().add(time, x)
        self._note(time, x)

    def extend(self, times: Vector, rows: Vector) -> None:
        super().extend(times, rows)
        for time, row in zip(times.tolist(), rows, strict=True):
            self._note(time, row[: len(self._evaluator.x)])

    def _note(self, time: float, x: Vector) -> None:
        wanted = self._wanted[np.abs(self._wanted - time) <= _SAME * np.maximum(np.abs(self._wanted), 1e-300)]
        for instant in wanted.tolist():
            point = Point.of(self._evaluator)
            self.points[instant] = replace(point, time=time, x=x.copy(), d=_outside_samples(self._evaluator))


def _outside_samples(evaluator: Evaluator) -> Vector:
    """The discrete values once the moment in which samples are true is over."""
    d = evaluator.d.copy()
    d[Settling(evaluator, 0.0).samples] = 0.0
    return d


def points_of_run(start: InitialPoint, options: Options, instants: Sequence[float]) -> tuple[Point, ...]:
    """The points at ascending instants; those at the start come after its event.

    Raises `SimulationProblem`, and `linearize.ended` where the model ends the run before an instant.
    """
    evaluator = start.evaluator
    notes = _Notes(evaluator, instants)
    moves = options.span > 0 or evaluator.code.system.dynamic is not None
    times = tuple(t for t in dict.fromkeys(instants) if t > options.start_time)
    given = replace(options, times=times)
    course = run(evaluator, (lambda e: make_solver(e, given)) if moves else None, start.x, given, notes)
    for instant in instants:
        if instant not in notes.points:
            ended = course.ended
            when, why = (ended.time, ended.message) if ended is not None else (float(notes.time[-1]), "")
            message = f"there is no snapshot at {instant:g} s: the model ended the run at {when:g} s"
            raise fail(SimulationProblem, "linearize.ended", message + (f" ({why})" if why else ""))
    return tuple(notes.points[instant] for instant in instants)
