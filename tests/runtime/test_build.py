"""Compiling and caching: what is in the cache is whole and ours, or it is made anew."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path
from time import sleep

import pytest

from acausal.errors import UnsupportedProblem
from acausal.runtime import binding, build

pytestmark = pytest.mark.skipif(build.compiler() is None, reason="no C compiler")

TWO = build.Sources({"two.c": "double two(void) { return 2.0; }\n"})


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "cache"
    monkeypatch.setenv("ACAUSAL_CACHE", str(folder))
    return folder


def test_library_is_made_once(cache: Path) -> None:
    assert build.cached(TWO) is None
    library = build.build(TWO)
    made = library.stat().st_mtime_ns
    assert build.cached(TWO) == build.build(TWO) == library
    assert library.stat().st_mtime_ns == made
    assert sorted(p.suffix for p in cache.iterdir()) == sorted([library.suffix, ".sha256"])
    assert (cache.stat().st_mode & 0o777) == 0o700


def test_other_text_and_other_flags_are_other_libraries(cache: Path) -> None:
    del cache
    other = build.Sources({"two.c": "double two(void) { return 2.5; }\n"})
    slow = build.Sources(TWO.files, "-O0")
    assert len({build.build(sources) for sources in (TWO, other, slow)}) == 3


@pytest.mark.parametrize("damage", ["cut", "foreign", "no digest", "wrong digest", "link"])
def test_damaged_library_is_not_loaded(cache: Path, damage: str) -> None:
    library = build.build(TWO)
    whole = library.read_bytes()
    digest = library.with_suffix(".sha256")
    if damage == "cut":
        library.write_bytes(whole[: len(whole) // 2])
    elif damage == "foreign":
        library.write_bytes(whole + b"\0")
    elif damage == "no digest":
        digest.unlink()
    elif damage == "wrong digest":
        digest.write_text("0" * 64)
    else:
        shutil.move(library, cache / "elsewhere")
        library.symlink_to(cache / "elsewhere")
    assert build.cached(TWO) is None
    assert build.build(TWO) == library
    assert build.cached(TWO) == library
    assert not library.is_symlink()


def test_directory_that_others_can_write_to_is_not_used(cache: Path) -> None:
    cache.mkdir()
    cache.chmod(0o777)
    library = build.build(TWO)
    assert cache not in library.parents
    assert (library.parent.stat().st_mode & 0o077) == 0


def test_cache_forgets_what_was_made_first(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(build, "MOST", 2)
    texts = [build.Sources({"n.c": f"double n(void) {{ return {i}.0; }}\n"}) for i in range(4)]
    made = [build.build(text) for text in texts]
    build.prune(cache)
    assert [build.cached(text) is not None for text in texts] == [False, False, True, True]
    assert len(list(cache.iterdir())) == 4
    assert made[3].exists()


def test_no_compiler_and_a_failing_one_are_errors(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    del cache
    with pytest.raises(UnsupportedProblem) as caught:
        build.build(build.Sources({"bad.c": "not C at all\n"}))
    assert caught.value.codes == ("runtime.compile",)
    monkeypatch.setenv("ACAUSAL_CC", "none")
    assert build.compiler() is None
    assert build.cached(TWO) is None
    with pytest.raises(UnsupportedProblem) as caught:
        build.build(TWO)
    assert caught.value.codes == ("runtime.compiler",)


def test_structures_have_the_sizes_of_the_header() -> None:
    import ctypes

    sizes = (ctypes.c_int * 4)()
    binding.RunTime().sizes(ctypes.addressof(sizes))
    mirrored = [
        binding.FunctionStructure,
        binding.ModelStructure,
        binding.LuStructure,
        binding.SolverStructure,
    ]
    assert list(sizes) == [ctypes.sizeof(structure) for structure in mirrored]


def test_run_time_is_c99_without_warnings(tmp_path: Path) -> None:
    tool = build.compiler()
    assert tool is not None
    for name, text in build.run_time_sources().files.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    units = sorted(path.name for path in tmp_path.glob("*.c"))
    strict = ["-std=c99", "-pedantic", "-O2", "-Wall", "-Wextra", "-Wconversion", "-Werror", "-c"]
    run = subprocess.run(
        [tool.path, *strict, *units], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr


def test_run_time_takes_no_memory_from_the_heap() -> None:
    for name, text in build.run_time_sources().files.items():
        assert not any(word in text for word in ("malloc(", "calloc(", "realloc(", "free(")), name


def test_home_without_a_cache_still_works(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("")
    monkeypatch.setenv("ACAUSAL_CACHE", os.fspath(blocked / "inside"))
    assert build.build(TWO).exists()


def test_another_process_compiles_in_the_background(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    build.start(TWO)
    assert not cache.exists() or not list(cache.iterdir())
    monkeypatch.delenv("ACAUSAL_COMPILE")
    build.start(TWO)
    build.start(TWO)
    for _ in range(600):
        if build.cached(TWO) is not None:
            break
        sleep(0.1)
    library = build.cached(TWO)
    assert library is not None
    assert build.load(library)
    for _ in range(100):
        if not list(cache.glob("building-*")):
            break
        sleep(0.1)
    assert sorted(p.suffix for p in cache.iterdir()) == sorted([library.suffix, ".sha256"])
