"""C text to a shared library: compiled by the system's compiler once, kept by content, loaded by `ctypes`.

The cache is a directory of our own that nobody else may write to (mode 0700, owned by the user):
`ACAUSAL_CACHE`, else `acausal` in `XDG_CACHE_HOME` or `~/.cache`; where none can be had, a temporary one for
this process. A library's name is the SHA-256 of its sources, of the compiler and of the flags; beside it
stands the SHA-256 of its bytes, which is checked before it is loaded. Both are written under other names and
renamed, so that what is there is whole. What does not fit is compiled again.
"""

from __future__ import annotations

import ctypes
import json
import os
import platform
import shutil
import stat
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import cache, cached_property
from hashlib import sha256
from pathlib import Path
from time import time

from acausal.errors import UnsupportedProblem, fail
from acausal.runtime import compiling

_FLAGS = (
    "-std=c99",
    "-fPIC",
    "-fno-semantic-interposition",
    "-fno-math-errno",
    "-fno-trapping-math",
    "-ffp-contract=off",
)
"""Products and sums are rounded one by one, as the virtual machine does it; no flags or `errno` are kept."""
_SHARED = ("-fPIC", "-shared")
MOST = 500
"""Libraries that the cache keeps."""
_SUFFIX = ".dylib" if sys.platform == "darwin" else ".so"


@dataclass(frozen=True)
class Compiler:
    """An executable, and what tells it from others: its path, size and time of change."""

    path: str
    identity: str


@cache
def _found(wanted: str, search: str) -> Compiler | None:
    for name in (wanted,) if wanted else ("cc", "gcc", "clang"):
        path = shutil.which(name, path=search)
        if path is not None:
            status = os.stat(path)
            identity = f"{os.path.realpath(path)} {status.st_size} {status.st_mtime_ns} {platform.machine()}"
            return Compiler(path, identity)
    return None


def compiler() -> Compiler | None:
    """The system's C compiler: `ACAUSAL_CC`, else `cc`, `gcc`, `clang`; None where there is none.

    `ACAUSAL_CC=none` does without. Not on Windows, where the run-time is not built.
    """
    wanted = os.environ.get("ACAUSAL_CC", "")
    if wanted == "none" or sys.platform == "win32":
        return None
    return _found(wanted, os.environ.get("PATH", os.defpath))


@cache
def cache_directory(wanted: str = "") -> Path:
    """The directory that compiled libraries are kept in; see the module's text."""
    base = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    path = Path(wanted) if wanted else Path(base) / "acausal"
    try:
        path.mkdir(mode=0o700, parents=True, exist_ok=True)
        if _is_private(path) and os.access(path, os.W_OK):
            return path
    except OSError:
        pass
    return Path(tempfile.mkdtemp(prefix="acausal-"))


def _is_private(path: Path) -> bool:
    """Whether it is a directory of this user's that nobody else can write to."""
    status = os.lstat(path)
    own = not hasattr(os, "getuid") or status.st_uid == os.getuid()
    return stat.S_ISDIR(status.st_mode) and own and not status.st_mode & 0o077


@dataclass(frozen=True)
class Sources:
    """C files by name, of which `.c` are compiled; `level` is the optimisation and `link` more flags.

    Those in `light` are compiled with `-O1`.
    """

    files: Mapping[str, str]
    level: str = "-O2"
    link: tuple[str, ...] = ()
    light: tuple[str, ...] = ()

    @cached_property
    def keys(self) -> dict[str, str]:
        """The library's names found so far, by the compiler's identity: the files are long."""
        return {}


def _key(sources: Sources, tool: Compiler) -> str:
    known = sources.keys.get(tool.identity)
    if known is not None:
        return known
    text = [tool.identity, sources.level, *_FLAGS, *sources.link, *sources.light]
    for name, content in sources.files.items():
        text += [name, content]
    key = sources.keys[tool.identity] = sha256("\0".join(text).encode()).hexdigest()
    return key


def cached(sources: Sources) -> Path | None:
    """The whole library of these sources in the cache, if there is one."""
    tool = compiler()
    if tool is None:
        return None
    library = _directory() / f"{_key(sources, tool)}{_SUFFIX}"
    return library if _is_whole(library) else None


def _directory() -> Path:
    return cache_directory(os.environ.get("ACAUSAL_CACHE", ""))


def _is_whole(library: Path) -> bool:
    """Whether the library is this user's regular file with the bytes that were written."""
    try:
        status = os.lstat(library)
        own = not hasattr(os, "getuid") or status.st_uid == os.getuid()
        if not (stat.S_ISREG(status.st_mode) and own and _is_private(library.parent)):
            return False
        expected = library.with_suffix(".sha256").read_text(encoding="ascii").strip()
        return sha256(library.read_bytes()).hexdigest() == expected
    except (OSError, ValueError):
        return False


def build(sources: Sources) -> Path:
    """The library of these sources, from the cache or compiled now.

    Raises `UnsupportedProblem`: `runtime.compiler` without a compiler, `runtime.compile` where it fails.
    """
    tool = compiler()
    if tool is None:
        raise fail(
            UnsupportedProblem,
            "runtime.compiler",
            "there is no C compiler",
            hint="install gcc or clang, or choose a solver that needs none (cvode)",
        )
    directory = _directory()
    library = directory / f"{_key(sources, tool)}{_SUFFIX}"
    if _is_whole(library):
        return library
    prune(directory)
    with tempfile.TemporaryDirectory(prefix="build-", dir=directory) as folder:
        made = _compile(sources, tool, Path(folder))
        digest = Path(folder) / "digest"
        digest.write_text(sha256(made.read_bytes()).hexdigest() + "\n", encoding="ascii")
        os.replace(made, library)
        os.replace(digest, library.with_suffix(".sha256"))
    return library


_running: list[subprocess.Popen[bytes]] = []
"""Processes that may still compile; kept, since Python complains of those it forgets."""


def may_compile() -> bool:
    """Whether to compile unasked: there is a compiler, and `ACAUSAL_COMPILE` is not `never`."""
    return compiler() is not None and os.environ.get("ACAUSAL_COMPILE") != "never"


def start(sources: Sources) -> None:
    """Begins to compile, in a process of its own that nobody waits for: `cached` finds what comes of it.

    Not twice at a time, not where `ACAUSAL_COMPILE` is `never`; without a compiler nothing happens.
    """
    tool = compiler()
    if tool is None or not may_compile():
        return
    directory, key = _directory(), _key(sources, tool)
    folder = directory / f"building-{key}"
    library = directory / f"{key}{_SUFFIX}"
    try:
        if folder.exists() and time() - folder.stat().st_mtime > compiling.SECONDS:
            shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(mode=0o700)
        for name, content in sources.files.items():
            (folder / name).write_text(content, encoding="utf-8")
        units, link = _commands(sources, tool)
        made = folder / f"library{_SUFFIX}"
        paths = [str(path) for path in (folder, made, library, library.with_suffix(".sha256"))]
        quiet = subprocess.DEVNULL
        prune(directory)
        _running[:] = [process for process in _running if process.poll() is None]
        process = subprocess.Popen(
            [sys.executable, "-I", "-S", compiling.__file__, *paths, json.dumps([*units, link])],
            stdin=quiet,
            stdout=quiet,
            stderr=quiet,
            start_new_session=True,
        )
        _running.append(process)
    except OSError:
        return  # it is being built already, or cannot be: the run goes on without


def _commands(sources: Sources, tool: Compiler) -> tuple[list[list[str]], list[str]]:
    """One command for each unit, and the one that links them."""
    units = [name for name in sources.files if name.endswith(".c")]
    commands = [
        [tool.path, "-O1" if name in sources.light else sources.level, *_FLAGS, "-c", name, "-o", f"{name}.o"]
        for name in units
    ]
    objects = [f"{name}.o" for name in units]
    return commands, [tool.path, *_SHARED, *objects, "-o", f"library{_SUFFIX}", *sources.link, "-lm"]


def prune(directory: Path) -> None:
    """Deletes the libraries that were made first, down to `MOST`."""
    made: list[tuple[int, Path]] = []
    for library in sorted(directory.glob(f"*{_SUFFIX}")):
        with suppress(OSError):
            made.append((library.lstat().st_mtime_ns, library))
    for _, library in sorted(made)[: max(0, len(made) - MOST)]:
        for path in (library.with_suffix(".sha256"), library):
            with suppress(OSError):
                path.unlink()


def _compile(sources: Sources, tool: Compiler, folder: Path) -> Path:
    for name, content in sources.files.items():
        (folder / name).write_text(content, encoding="utf-8")
    problem = compiling.build(*_commands(sources, tool), str(folder))
    if problem:
        message = f"the C compiler `{tool.path}` failed: {problem[:200]}"
        raise fail(UnsupportedProblem, "runtime.compile", message, hint="ACAUSAL_CC=none does without it")
    return folder / f"library{_SUFFIX}"


@cache
def load(library: Path) -> ctypes.CDLL:
    """The library, loaded once."""
    return ctypes.CDLL(str(library))


@cache
def run_time_sources() -> Sources:
    """The fixed C files of the run-time, as they stand in the package."""
    folder = Path(__file__).parent
    names = sorted(path.name for path in folder.iterdir() if path.suffix in (".c", ".h"))
    return Sources({name: (folder / name).read_text(encoding="utf-8") for name in names}, "-O3")


def run_time() -> ctypes.CDLL:
    """The run-time, compiled when it is first needed on a machine. Raises as `build` does."""
    return load(build(run_time_sources()))
