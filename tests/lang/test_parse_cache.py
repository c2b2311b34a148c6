"""The cache of parsed files: found again by content, and never believed when it is not ours or not whole."""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from acausal.errors import Source, SyntaxProblem
from acausal.lang import ast, parse_cache
from acausal.lang.parse_cache import cache_directory, entry_name, evict, read_entry, read_stored, write_entry
from acausal.lang.parser import Marks, parse_with_marks

TEXT = b"package P model A Real x = 1; end A; model B = A; end P;"


@pytest.fixture
def parses(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The paths of the files that were parsed as a whole."""
    found: list[str] = []

    def counting(source: Source) -> tuple[ast.StoredDefinition, Marks]:
        found.append(source.path)
        return parse_with_marks(source)

    monkeypatch.setattr(parse_cache, "parse_with_marks", counting)
    return found


def entries(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*") if path.is_file())


def test_the_second_reading_is_from_the_cache(tmp_path: Path, parses: list[str]) -> None:
    first = read_stored(TEXT, "a.mo", tmp_path)
    second = read_stored(TEXT, "elsewhere.mo", tmp_path)
    assert parses == ["a.mo"]
    assert second == first
    assert second.source == "elsewhere.mo"
    assert second.classes[0][1].span.file == "elsewhere.mo"
    read_stored(TEXT + b"\n", "a.mo", tmp_path)
    assert parses == ["a.mo", "a.mo"]
    assert len(entries(tmp_path)) == 2


def test_no_directory_no_cache(parses: list[str]) -> None:
    read_stored(TEXT, "a.mo", None)
    read_stored(TEXT, "a.mo", None)
    assert len(parses) == 2


def test_a_wrong_file_is_not_kept(tmp_path: Path) -> None:
    for _ in range(2):
        with pytest.raises(SyntaxProblem):
            read_stored(b"model A Real x end A;", "a.mo", tmp_path)
    assert not entries(tmp_path)


DAMAGES: dict[str, Callable[[bytes], bytes]] = {
    "empty": lambda data: b"",
    "cut": lambda data: data[:-1],
    "cut short": lambda data: data[:10],
    "longer": lambda data: data + b" ",
    "changed": lambda data: data.replace(b"A", b"Z"),
    "no checksum": lambda data: bytes(16) + data[16:],
    "foreign": lambda data: pickle.dumps(print),
    "huge": lambda data: bytes(20_000_000),
}


@pytest.mark.parametrize("damage", DAMAGES.values(), ids=DAMAGES)
def test_a_damaged_entry_is_ignored_and_written_anew(
    damage: Callable[[bytes], bytes], tmp_path: Path, parses: list[str]
) -> None:
    expected = read_stored(TEXT, "a.mo", tmp_path)
    (entry,) = entries(tmp_path)
    good = entry.read_bytes()
    entry.write_bytes(damage(good))
    assert read_stored(TEXT, "a.mo", tmp_path) == expected
    assert len(parses) == 2
    assert entry.read_bytes() == good


def test_nothing_is_executed(tmp_path: Path) -> None:
    """Not even what carries a right checksum."""

    class Bomb:
        def __reduce__(self) -> tuple[object, ...]:
            return (os.mkdir, (str(tmp_path / "bomb"),))

    entry = tmp_path / entry_name(TEXT)
    for payload in (pickle.dumps(Bomb()), b"__import__('os').mkdir('bomb')", b'{"py/reduce": 1}'):
        write_entry(entry, payload)
        assert read_entry(entry) == payload
        assert read_stored(TEXT, "a.mo", tmp_path) == read_stored(TEXT, "a.mo", None)
    assert not (tmp_path / "bomb").exists()


def test_somebody_elses_entry_is_ignored(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    entry = tmp_path / "entry"
    write_entry(entry, b"x")
    assert read_entry(entry) == b"x"
    owner = entry.stat().st_uid
    if owner == 0:
        os.chown(entry, 12345, -1)
    monkeypatch.setattr(os, "geteuid", lambda: owner + 1)
    assert read_entry(entry) is None


def test_a_cache_that_cannot_be_written_is_no_error(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("no folder")
    assert read_stored(TEXT, "a.mo", blocked).classes
    assert blocked.read_text() == "no folder"

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    assert read_stored(TEXT, "a.mo", tmp_path / "full").classes
    assert not entries(tmp_path / "full")


def test_the_oldest_entries_go(tmp_path: Path) -> None:
    paths = [tmp_path / f"{i:02}" / f"{i}.outline" for i in range(10)]
    for i, path in enumerate(paths):
        write_entry(path, b"x" * 9984)
        os.utime(path, (1000 + i, 1000 + i))
    evict(tmp_path, 100_000)
    assert len(entries(tmp_path)) == 10
    evict(tmp_path, 60_000)
    assert entries(tmp_path) == paths[6:]


@pytest.mark.parametrize(
    ("environment", "expected"),
    [
        ({}, None),
        ({"HOME": "/h/a"}, "/h/a/.cache/acausal/parsed"),
        ({"HOME": "/h/a", "XDG_CACHE_HOME": "/x"}, "/x/acausal/parsed"),
        ({"HOME": "/h/a", "XDG_CACHE_HOME": "relative"}, "/h/a/.cache/acausal/parsed"),
        ({"HOME": "/h/a", "ACAUSAL_CACHE": "off"}, None),
        ({"HOME": "/h/a", "ACAUSAL_CACHE": "here"}, "here"),
    ],
)
def test_directory(environment: dict[str, str], expected: str | None) -> None:
    assert cache_directory(environment) == (None if expected is None else Path(expected))


WORK = """
import sys
from pathlib import Path
from acausal.lang.parse_cache import read_stored
texts = [f"package P{i} model A Real x = {i}; end A; end P{i};".encode() for i in range(40)]
for _ in range(5):
    for text in texts:
        (_, package), = read_stored(text, "a.mo", Path(sys.argv[1])).classes
        assert package.body.elements[0].body.elements, text
"""


def test_processes_share_a_cache(tmp_path: Path) -> None:
    words = [sys.executable, "-c", WORK, str(tmp_path)]
    together = [subprocess.Popen(words) for _ in range(3)]
    assert [process.wait() for process in together] == [0, 0, 0]
    assert len(entries(tmp_path)) == 40
