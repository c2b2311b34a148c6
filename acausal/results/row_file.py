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
        self._good = end
        try:
            self._file: BinaryIO = path.open("wb" if head is not None else "r+b", buffering=0)
            if head is not None:
                self._write(head)
                self._good = len(head)
            else:
                self._file.truncate(end)
                self._file.seek(end)
        except OSError as problem:
            message = f"cannot write `{path}`: {problem.strerror or problem}"
            raise fail(UsageProblem, "usage.output", message) from None

    @property
    def size(self) -> int:
        """Bytes that were written whole."""
        return self._good

    def append(self, data: bytes, rows: int) -> None:
        """Adds bytes at the end. Raises `SimulationProblem` (`result.write`), as on a full disk."""
        try:
            self._file.seek(self._good)  # an interrupted call may have left it anywhere
            self._write(data)
        except OSError as problem:
            with suppress(OSError):
                self._file.truncate(self._good)
            raise _full(self.path, problem, rows) from None
        self._good += len(data)

    def patch(self, position: int, data: bytes, rows: int) -> None:
        """Writes over bytes that are there."""
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


def _full(path: Path, problem: OSError, rows: int) -> SimulationProblem:
    why = problem.strerror or os.strerror(problem.errno or 0)
    message = f"cannot write on to `{path}`: {why}; it holds the first {rows} rows"
    hint = "make room, or keep fewer variables (-v) or a longer interval, and go on with --continue"
    return fail(SimulationProblem, "result.write", message, hint=hint)
