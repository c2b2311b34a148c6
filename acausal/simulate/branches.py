"""Whether a block of one unknown left its branch between two rows (`turns`).

Rows at one instant are the sides of an event, where jumps are meant.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from acausal.codegen.functions import Code
from acausal.codegen.program import ImplicitCode, implicit_code
from acausal.codegen.segments import Segment
from acausal.simulate.evaluator import Evaluator
from acausal.simulate.jumps import jump_warning
from acausal.simulate.matrices import Vector
from acausal.simulate.turns import turns_between
from acausal.symbolic.causal import BlockKind

_LEAST = 0.05
"""Changes from row to row below this, relative to the values or the nominal value, are not looked at."""
_MOST = 100
"""So many changes of one block are looked at."""


@dataclass
class _Watched:
    """A block, where its unknown stands in a row and its nominal value, and how often it was looked at."""

    segment: Segment
    column: int
    nominal: float
    code: ImplicitCode | None = None
    looks: int = 0


class Branches:
    """Watches the rows of one run for the first jump of each block."""

    def __init__(self, evaluator: Evaluator) -> None:
        code, nominals = evaluator.code, evaluator.nominal_of()
        self._evaluator = evaluator
        columns = {leaf: i for i, leaf in enumerate(code.output_leaves)}
        self._columns = columns
        self._watched = [
            _Watched(segment, columns[z], nominals.get(z, 1.0))
            for segment in (code.dynamic.segments if evaluator.guess.size else ())
            if segment.implicit
            and segment.block.kind is BlockKind.NONLINEAR
            and len(segment.block.tearing) == 1
            if (z := segment.block.tearing[0]) in columns
        ]
        self._found = evaluator.jumps.found

    @property
    def are_watched(self) -> bool:
        """Whether there is a block left to look at."""
        return bool(self._watched)

    def stop(self) -> None:
        """Other states were chosen, and with them other blocks: no longer."""
        self._watched = []

    def look(self, times: Vector, rows: Vector) -> None:
        """The rows, of which the first was looked at before, are neighbours in time."""
        for watched in self._watched:
            z = rows[:, watched.column]
            sizes = np.maximum(np.maximum(np.abs(z[1:]), np.abs(z[:-1])), watched.nominal)
            with np.errstate(all="ignore"):
                large = (np.abs(np.diff(z)) > _LEAST * sizes) & (np.diff(times) > 0)
            for i in np.flatnonzero(large):
                if watched.looks >= _MOST:
                    break
                watched.looks += 1
                if self._has_jumped(watched, float(times[i + 1]), rows[i], rows[i + 1]):
                    block, when = watched.segment.block, f"between {times[i]:.9g} s and {times[i + 1]:.9g} s"
                    self._found[block.tearing[0]] = jump_warning(block, when, float(z[i]), float(z[i + 1]))
                    break
        self._watched = [w for w in self._watched if w.looks < _MOST and self._is_open(w)]

    def _is_open(self, watched: _Watched) -> bool:
        return watched.segment.block.tearing[0] not in self._found

    def _has_jumped(self, watched: _Watched, time: float, before: Vector, after: Vector) -> bool:
        code = self._evaluator.code
        if watched.code is None:
            watched.code = implicit_code(watched.segment, code.dynamic.slots, "watched")
        known = self._known(watched.code, code, time, after)
        if known is None:
            watched.looks = _MOST
            return False
        return turns_between(watched.code, known, *(float(r[watched.column]) for r in (before, after)))

    def _known(self, block: ImplicitCode, code: Code, time: float, row: Vector) -> Vector | None:
        """What the block reads, from a row; None where it reads what no row holds."""
        e = self._evaluator
        slots, columns = code.dynamic.slots, self._columns
        inputs = np.concatenate([[time], e.x, e.p, e.m, e.u, e.d])
        values: list[float] = []
        for leaf in block.reads:
            if leaf in columns:
                values.append(float(row[columns[leaf]]))
            elif slots[leaf] < len(inputs):
                values.append(float(inputs[slots[leaf]]))
            else:
                return None
        return np.array(values)
