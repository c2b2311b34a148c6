"""Runs compiler commands side by side, within limits. Also a script of its own, for the background.

The script ends early where its folder goes away, and takes the compilers with it.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from contextlib import suppress
from time import monotonic

SECONDS = 600.0
"""Wall time that all commands together may take."""
CPU_SECONDS = 120
"""CPU time that one command may take."""
_LIMITED = ("/bin/sh", "-c", f'ulimit -t {CPU_SECONDS}; exec "$@"', "sh")
_POLL = 0.05


def run(commands: Sequence[Sequence[str]], folder: str, seconds: float = SECONDS) -> str:
    """Runs the commands, as many at a time as there are cores; what went wrong, or nothing."""
    deadline = monotonic() + seconds
    waiting = list(enumerate(commands))
    running: list[tuple[int, subprocess.Popen[bytes]]] = []
    try:
        while waiting or running:
            while waiting and len(running) < max(1, os.cpu_count() or 1):
                number, command = waiting.pop(0)
                running.append((number, _started(number, command, folder)))
            with suppress(subprocess.TimeoutExpired):
                running[0][1].wait(_POLL)
            for number, process in [entry for entry in running if entry[1].poll() is not None]:
                running.remove((number, process))
                if process.returncode != 0:
                    return _said(number, folder)
            if monotonic() > deadline:
                return f"it took more than {seconds:g} s"
            if not os.path.isdir(folder):
                return "its folder is gone"
    except OSError as problem:
        return str(problem)
    finally:
        for _, process in running:
            process.kill()
            process.wait()
    return ""


def _started(number: int, command: Sequence[str], folder: str) -> subprocess.Popen[bytes]:
    limited = _LIMITED if os.path.exists(_LIMITED[0]) else ()
    with open(os.path.join(folder, f"{number}.log"), "wb") as log:
        return subprocess.Popen(
            [*limited, *command], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=log
        )


def _said(number: int, folder: str) -> str:
    """The first line that the command wrote."""
    with suppress(OSError), open(os.path.join(folder, f"{number}.log"), "rb") as log:
        lines = log.read(10_000).decode(errors="replace").strip().splitlines()
        return lines[0] if lines else "it says nothing"
    return "it says nothing"


def build(commands: Sequence[Sequence[str]], link: Sequence[str], folder: str) -> str:
    """Compiles, and then links; what went wrong, or nothing."""
    return run(commands, folder) or run([link], folder)


def main(folder: str, made: str, library: str, digest: str, commands: Sequence[Sequence[str]]) -> None:
    """Builds a library quietly, at low priority, and puts it with its digest where it belongs.

    The last of the commands links what the others compile.
    """
    try:
        os.nice(10)
        if build(commands[:-1], commands[-1], folder):
            return
        with open(made, "rb") as file:
            found = hashlib.sha256(file.read()).hexdigest()
        with open(made + ".sha256", "w", encoding="ascii") as file:
            file.write(found + "\n")
        os.replace(made, library)
        os.replace(made + ".sha256", digest)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4], json.loads(sys.argv[5]))
