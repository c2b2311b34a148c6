"""A result that is written while the run goes on: memory stays bounded, and what is written is safe.

Beside the file stands `FILE.end`, which says where the run stood when it was written last: from there
another run goes on.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from time import monotonic, process_time

import numpy as np

from acausal.errors import AcausalError, UsageProblem, fail
from acausal.results.parquet_file import part_of
from acausal.results.signals import Layout, Vector
from acausal.results.stored import StoredResult, open_writer
from acausal.simulate.record import Recorder
from acausal.simulate.selection import default_names, layout_of
from acausal.simulate.standing import Standing, from_text
from acausal.symbolic.causal import CausalSystem

_NUMBERS = 1 << 18
_SECONDS = 0.5
"""So many numbers, or so much later, what there is is written."""


@dataclass(frozen=True)
class Store:
    """A file to write the variables `names` to (by default the contract's).

    A run that goes on leaves the first `rows` of the file, or writes those of `earlier`, another file, first.
    """

    path: Path
    names: tuple[str, ...] | None = None
    rows: int | None = None
    earlier: StoredResult | None = None


class Stream:
    """The rows of one run on their way to a file. `spent` are the CPU seconds that writing took."""

    def __init__(
        self, store: Store, system: CausalSystem, recorder: Recorder, parameters: dict[str, float]
    ) -> None:
        names = store.names if store.names is not None else default_names(system)
        layout, self._columns = layout_of(system, recorder.leaves, parameters, names)
        self._recorder = recorder
        self._path = store.path
        self._skip = 0 if store.rows is None else 1  # the row from which the run goes on
        self._before = (store.rows or 0) - self._skip
        self._writer = open_writer(store.path, layout, store.rows if store.earlier is None else None)
        self._last = monotonic()
        self.spent = 0.0
        self.is_broken = False
        """Whether the file could not be written."""
        if store.rows is None or store.earlier is not None:
            with suppress(OSError):
                end_of(store.path).unlink()
        if store.earlier is not None and store.rows:
            self._add(store.earlier.time[: store.rows], _rows(layout, store.earlier)[: store.rows])

    def observe(self, time: float, standing: Callable[[], Standing]) -> None:
        """Writes what there is, if it is much or the last time was long ago."""
        del time
        if self._recorder.pending >= _NUMBERS or monotonic() - self._last >= _SECONDS:
            self.write(standing())
            self._last = monotonic()

    def write(self, standing: Standing | None) -> None:
        """Writes all rows, and where the run stands. Raises `SimulationProblem` (`result.write`)."""
        began = process_time()
        times, rows = self._recorder.take()
        skip, self._skip = min(self._skip, len(times)), max(0, self._skip - len(times))
        if len(times) > skip:
            self._add(times[skip:], rows[skip:, self._columns])
        if standing is not None and (self._path.is_file() or part_of(self._path).is_file()):
            write_end(self._path, standing, self._before)
        self.spent += process_time() - began

    def _add(self, times: Vector, rows: Vector) -> None:
        try:
            self._writer.write(times, rows)
        except AcausalError:
            self.is_broken = True
            raise

    def close(self, standing: Standing | None) -> None:
        """Writes the rest. Raises `SimulationProblem` (`result.write`)."""
        self.write(standing)
        began = process_time()
        self._writer.close()
        self.spent += process_time() - began

    def abandon(self) -> None:
        """Lets go of the file, whatever happened."""
        self._writer.abandon()


def _rows(layout: Layout, stored: StoredResult) -> Vector:
    """The rows of a stored result as a layout wants them."""
    rows = np.empty((len(stored.time), layout.width))
    for signal in layout.signals:
        if signal.column is not None:
            rows[:, signal.column] = signal.factor * stored.values(signal.name)
    return rows


def end_of(path: Path) -> Path:
    """The file that says where the run stood that wrote `path`."""
    return path.with_name(path.name + ".end")


def write_end(path: Path, standing: Standing, before: int = 0) -> None:
    """Writes it whole or not at all; `before` rows of the file are of earlier runs."""
    target = end_of(path)
    new = target.with_name(target.name + ".new")
    whole = replace(standing, rows=standing.rows + before)
    try:
        new.write_text(whole.to_text(), encoding="utf-8")
        os.replace(new, target)
    except OSError:  # the rows matter more
        with suppress(OSError):
            new.unlink()


def read_end(path: Path) -> Standing:
    """Where the run stood that wrote `path`. Raises `UsageProblem` (`usage.continue`)."""
    try:
        return from_text(end_of(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as problem:
        why = problem.strerror if isinstance(problem, OSError) else str(problem)
        message = f"`{path}` cannot be continued: `{end_of(path)}`: {why}"
        hint = "a run that is stored with `acausal simulate -o` leaves this file beside its result"
        raise fail(UsageProblem, "usage.continue", message, hint=hint) from None
