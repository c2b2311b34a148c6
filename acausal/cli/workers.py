"""Checking many classes in processes of their own, each check bounded in time and memory.

A worker is forked where the system can (it then has what the parent has read), else started afresh. It
answers one class name after the other with a finding as JSON; one that hangs, dies or grows too large is
replaced, and its class has failed. Findings come in the order of the names.
"""

from __future__ import annotations

import json
import multiprocessing
import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from time import monotonic
from typing import TYPE_CHECKING

from acausal.errors import Diagnostic
from acausal.lang.library import Library
from acausal.survey import Finding, Surveyor, failed

if TYPE_CHECKING:  # not every system has both
    from multiprocessing.context import ForkContext, SpawnContext

_FORKS = "fork" in multiprocessing.get_all_start_methods()
_OUT_OF_MEMORY = 66
"""Exit status of a worker that could not even say so."""


@dataclass(frozen=True)
class Bounds:
    """Per class: wall seconds, megabytes of address space beyond the start; and how many run at once."""

    seconds: float = 60.0
    megabytes: int = 1024
    jobs: int = 1


def _context() -> ForkContext | SpawnContext:
    return multiprocessing.get_context("fork") if _FORKS else multiprocessing.get_context("spawn")


def available_cores() -> int:
    """The processors that this process may use, eight at most."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return min(cores, 8)


def checked(
    library: Library, reread: Callable[[], Library], names: Sequence[str], bounds: Bounds
) -> Iterator[Finding]:
    """The findings about `names`, as they come; `reread` makes the library anew where forking is impossible.

    `reread` must be picklable.
    """
    waiting = list(reversed(names))
    workers: list[_Worker] = []
    try:
        while waiting or workers:
            while waiting and len(workers) < bounds.jobs:
                workers.append(_Worker(library, reread, bounds))
                workers[-1].ask(waiting.pop())
            soonest = min(worker.deadline for worker in workers)
            wait([worker.pipe for worker in workers], max(0.0, soonest - monotonic()))
            for worker in list(workers):
                finding = worker.answer()
                if finding is None:
                    continue
                yield finding
                if worker.alive and waiting:
                    worker.ask(waiting.pop())
                else:
                    worker.stop()
                    workers.remove(worker)
    finally:
        for worker in workers:
            worker.stop()


class _Worker:
    """One process and the class it is at."""

    def __init__(self, library: Library, reread: Callable[[], Library], bounds: Bounds) -> None:
        context = _context()
        self.pipe, theirs = context.Pipe()
        self._bounds = bounds
        self._name = ""
        self.deadline = 0.0
        self.alive = True
        origin = library if _FORKS else reread
        self._process: BaseProcess = context.Process(
            target=_serve, args=(theirs, origin, bounds.megabytes), daemon=True
        )
        self._process.start()
        theirs.close()

    def ask(self, name: str) -> None:
        self._name = name
        self.deadline = monotonic() + self._bounds.seconds
        with suppress(OSError):  # it may have died since: `answer` sees the end of its pipe
            self.pipe.send_bytes(name.encode())

    def answer(self) -> Finding | None:
        """What it found, or how it failed; None while it is still at it."""
        if self.pipe.poll():
            try:
                data = json.loads(self.pipe.recv_bytes())
            except (EOFError, OSError):
                return self._died()
            self.alive = bool(data["again"])
            counts = data["equations"], data["variables"]
            return Finding(
                data["model"], data["passed"], *counts, data["seconds"], tuple(data["diagnostics"])
            )
        if monotonic() >= self.deadline:
            return self._lost("check.timeout", f"the check took more than {self._bounds.seconds:g} s")
        return None

    def _died(self) -> Finding:
        self._process.join(1.0)
        if self._process.exitcode == _OUT_OF_MEMORY:
            return self._lost("check.memory", f"the check took more than {self._bounds.megabytes} MB")
        return self._lost("check.crashed", "the check ended without an answer")

    def _lost(self, code: str, message: str) -> Finding:
        spent = self._bounds.seconds - max(0.0, self.deadline - monotonic())
        self.alive = False
        return failed(self._name, [Diagnostic(code, message, names=(self._name,))], spent)

    def stop(self) -> None:
        self._process.kill()
        self._process.join()
        self.pipe.close()


def _serve(pipe: Connection, origin: Library | Callable[[], Library], megabytes: int) -> None:
    """The worker: it ends with the pipe, when it has grown large, or when a check runs out of memory."""
    _limit_memory(megabytes)
    try:
        surveyor = Surveyor(origin if isinstance(origin, Library) else origin())
        again = True
        while again:
            finding = surveyor.check(pipe.recv_bytes().decode())
            again = _grown() < 0.5 * megabytes
            pipe.send_bytes(json.dumps({**finding.to_json(), "again": again}).encode())
    except MemoryError:
        os._exit(_OUT_OF_MEMORY)
    except (EOFError, OSError):
        return


def _limit_memory(megabytes: int) -> None:
    """At most so much address space more than now, where the system can bound it."""
    try:
        import resource
    except ImportError:
        return
    limit = (_address_space() + megabytes) * 2**20
    hard = resource.getrlimit(resource.RLIMIT_AS)[1]
    resource.setrlimit(resource.RLIMIT_AS, (limit if hard < 0 else min(limit, hard), hard))


def _address_space() -> int:
    """Megabytes of address space in use; a generous guess where the system does not tell."""
    try:
        with open("/proc/self/statm", encoding="ascii") as file:
            pages = int(file.read().split()[0])
    except (OSError, ValueError):
        return 4096
    return pages * os.sysconf("SC_PAGE_SIZE") // 2**20


def _grown() -> float:
    """Megabytes of memory that this process has taken at most."""
    try:
        import resource
    except ImportError:
        return 0.0
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
