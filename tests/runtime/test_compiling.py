"""Commands side by side: their order, their failures, and what ends them."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from acausal.runtime import build, compiling

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="no run-time in C")


def python(text: str) -> list[str]:
    return [sys.executable, "-I", "-S", "-c", text]


def test_the_last_command_waits_for_all_others(tmp_path: Path) -> None:
    touch = "import sys, time; time.sleep({}); open('{}', 'w').close()"
    link = python("import os, sys; sys.exit(not (os.path.exists('a') and os.path.exists('b')))")
    units = [python(touch.format(0.2, "a")), python(touch.format(0.0, "b"))]
    assert compiling.build(units, link, str(tmp_path)) == ""


def test_what_a_command_says_is_the_problem(tmp_path: Path) -> None:
    bad = python("import sys; sys.exit('no such thing')")
    assert compiling.run([bad, bad], str(tmp_path)) == "no such thing"


def test_nothing_runs_for_ever(tmp_path: Path) -> None:
    endless = python("import time; time.sleep(100)")
    assert "more than" in compiling.run([endless], str(tmp_path), seconds=0.2)


def test_a_folder_that_goes_away_ends_it(tmp_path: Path) -> None:
    folder = tmp_path / "work"
    folder.mkdir()
    text = f"import shutil, time; shutil.rmtree({str(folder)!r}); time.sleep(100)"
    assert compiling.run([python(text)], str(folder)) == "its folder is gone"


@pytest.mark.skipif(build.compiler() is None, reason="no C compiler")
def test_units_with_helpers_of_one_name_link(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ACAUSAL_CACHE", str(tmp_path / "cache"))
    unit = "static double helper(void) {{ return {0}; }}\ndouble f{0}(void) {{ return helper(); }}\n"
    files = {f"{i}.c": unit.format(i) for i in (1, 2)}
    assert build.load(build.build(build.Sources(files, light=("2.c",)))).f2 is not None
