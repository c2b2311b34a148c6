"""A file that grows by whole rows: what was written stays readable, whatever happens next."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO

from acausal.errors import SimulationProblem, UsageProblem, fail


class RowFile:
    """An open file; after a failure it ends with the last row that was written whole."""

    def __init__(self, path: Path, head: bytes | None, end: int = 0) -> None:
        """Begins with `head`; without one, goes on with an existing file after `end` bytes.

        Raises `UsageProblem` (`usage.output`) where the file cannot be opened or begun.
        """
        self.path = path
        self._good = len(head) if head is not None else end
        self._problem: OSError | None = None
        try:
            self._file: BinaryIO = path.open("wb" if head is not None else "r+b", buffering=0)
        except OSError as problem:
            raise _unwritable(path, problem) from None
        try:
            if head is not None:
                self._write(head)
            else:
                self._file.truncate(end)
        except OSError as problem:
            self._file.close()
            raise _unwritable(path, problem) from None

    @property
    def size(self) -> int:
        """Bytes that were written whole."""
        return self._good

    def append(self, data: bytes, row: int = 0) -> int:
        """Adds bytes at the end, as far as they fit; says how many of them are whole rows.

        A row has so many bytes, or is a line. `check` tells whether all of them were written.
        """
        written = 0
        try:
            self._file.seek(self._good)  # an interrupted call may have left it anywhere
            while written < len(data):
                written += self._file.write(memoryview(data)[written:])
        except OSError as problem:
            self._problem = problem
            written = written // row * row if row else data.rfind(b"\n", 0, written) + 1
            with suppress(OSError):
                self._file.truncate(self._good + written)
        self._good += written
        return written

    def check(self, rows: int) -> None:
        """Raises `SimulationProblem` (`result.write`) where not all was written, as on a full disk."""
        if self._problem is not None:
            problem, self._problem = self._problem, None
            raise _full(self.path, problem, rows)

    def patch(self, position: int, data: bytes, rows: int) -> None:
        """Writes over bytes that are there. Raises `SimulationProblem` (`result.write`)."""
        try:
            self._file.seek(position)
            self._write(data)
        except OSError as problem:
            raise _full(self.path, problem, rows) from None

    def _write(self, data: bytes) -> None:
        left = memoryview(data)
        while left:
            left = left[self._file.write(left) :]

    def close(self) -> None:
        self._file.close()


def _unwritable(path: Path, problem: OSError) -> UsageProblem:
    return fail(UsageProblem, "usage.output", f"cannot write `{path}`: {problem.strerror or problem}")


def _full(path: Path, problem: OSError, rows: int) -> SimulationProblem:
    why = problem.strerror or os.strerror(problem.errno or 0)
    message = f"cannot write on to `{path}`: {why}; it holds the first {rows} rows"
    hint = "make room, or keep fewer variables (-v) or a longer interval, and go on with --continue"
    return fail(SimulationProblem, "result.write", message, hint=hint)
