"""Outlines of parsed files on disk, by content: `ACAUSAL_CACHE`, else `acausal` below `XDG_CACHE_HOME`.

The name of an entry is the hash of the file's bytes, the format and the version of the package. An entry
starts with a checksum of the rest; one that is damaged, cut off, too large, or somebody else's is not used
and written anew. Entries are put in place as a whole, so several processes may work at once. A cache that
cannot be written is no error. When it grows beyond its bound the entries that were written first go.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from hashlib import blake2b
from pathlib import Path
from tempfile import NamedTemporaryFile

from acausal.errors import Source
from acausal.lang import ast
from acausal.lang.lexer import decode as decode_text
from acausal.lang.outline import FORMAT, decode, encode, outline_of
from acausal.lang.outline_reading import read_outlined
from acausal.lang.parser import parse_with_marks
from acausal.version import __version__

VARIABLE = "ACAUSAL_CACHE"
MOST_BYTES = 64_000_000
"""Size that the cache is kept to, in bytes of its entries."""
MOST_ENTRY_BYTES = 16_000_000
_OFF = frozenset(("off", "no", "0", "false"))
_SUM_BYTES = 16
_SUFFIX = ".outline"


def cache_directory(environment: Mapping[str, str] | None = None) -> Path | None:
    """Where outlines are kept; None when the cache is off or there is no place for one."""
    env = os.environ if environment is None else environment
    wish = env.get(VARIABLE, "")
    if wish:
        return None if wish.lower() in _OFF else Path(wish)
    base = env.get("XDG_CACHE_HOME", "")
    if os.path.isabs(base):
        return Path(base) / "acausal" / "parsed"
    home = env.get("HOME", "")
    return Path(home) / ".cache" / "acausal" / "parsed" if os.path.isabs(home) else None


def read_stored(data: bytes, shown: str, directory: Path | None) -> ast.StoredDefinition:
    """The classes in the bytes of a file, which messages call `shown`. Raises `SyntaxProblem`.

    With an outline in the cache `directory` the text is parsed part by part, as it is looked at.
    """
    source = decode_text(data, shown)
    if directory is None:
        return parse_with_marks(source)[0]
    entry = directory / entry_name(data)
    found = _read_entry(entry, source)
    if found is not None:
        return found
    stored, marks = parse_with_marks(source)
    write_entry(entry, encode(outline_of(stored, marks)))
    return stored


def entry_name(data: bytes) -> str:
    """The path of a file's entry in the cache, from what the file holds."""
    name = blake2b(
        data, digest_size=20, person=FORMAT.encode()[:16], salt=__version__.encode()[:16]
    ).hexdigest()
    return f"{name[:2]}/{name[2:]}{_SUFFIX}"


def _read_entry(entry: Path, source: Source) -> ast.StoredDefinition | None:
    body = read_entry(entry)
    outline = None if body is None else decode(body, len(source.text))
    return None if outline is None else read_outlined(source, outline)


def read_entry(entry: Path) -> bytes | None:
    """What an entry holds behind its checksum; None when there is no good one."""
    try:
        with open(entry, "rb") as file:
            state = os.fstat(file.fileno())
            if not _is_ours(state) or state.st_size > MOST_ENTRY_BYTES:
                return None
            data = file.read(MOST_ENTRY_BYTES)
    except OSError:
        return None
    body = data[_SUM_BYTES:]
    return body if data[:_SUM_BYTES] == _checksum(body) else None


def _is_ours(state: os.stat_result) -> bool:
    """Written by this user or the administrator, and by nobody else."""
    return not hasattr(os, "geteuid") or state.st_uid in (os.geteuid(), 0)


def _checksum(body: bytes) -> bytes:
    return blake2b(body, digest_size=_SUM_BYTES).digest()


def write_entry(entry: Path, body: bytes, most_bytes: int = MOST_BYTES) -> None:
    """Put an entry in place as a whole, if that is possible; one in 64 looks after the size of the cache."""
    if len(body) + _SUM_BYTES > MOST_ENTRY_BYTES:
        return
    try:
        entry.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        with NamedTemporaryFile(dir=entry.parent, suffix=".tmp", delete=False) as file:
            temporary = Path(file.name)
            try:
                file.write(_checksum(body) + body)
                file.close()
                temporary.replace(entry)
            except OSError:
                temporary.unlink(missing_ok=True)
                return
        if entry.name[0] in "0123" and entry.name[1] in "0123":
            evict(entry.parent.parent, most_bytes)
    except OSError:
        return


def evict(directory: Path, most_bytes: int = MOST_BYTES) -> None:
    """Delete the oldest entries when there are more than `most_bytes`, down to three quarters of it."""
    entries: list[tuple[int, str, int]] = []
    for path in directory.glob(f"*/*{_SUFFIX}"):
        try:
            state = path.stat()
        except OSError:
            continue
        entries.append((state.st_mtime_ns, str(path), max(state.st_size, 4096)))
    total = sum(size for _, _, size in entries)
    if total <= most_bytes:
        return
    for _, path, size in sorted(entries):
        Path(path).unlink(missing_ok=True)
        total -= size
        if total <= 0.75 * most_bytes:
            return
