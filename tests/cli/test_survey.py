"""`acausal check PACKAGE --recursive`: which classes, passed or why not, and that no class stops the rest."""

from __future__ import annotations

from pathlib import Path

import pytest

from acausal.cli.workers import Bounds, checked
from acausal.errors import Source
from acausal.lang.library import Library, library_directories
from acausal.lang.parser import parse
from acausal.survey import Surveyor, survey_classes
from tests.cli.calls import Call

KEYS = ["model", "passed", "equations", "variables", "seconds", "diagnostics"]

MIXED = """\
package Mixed
  model Good Real x; Real y; equation x = time; y = x; annotation(experiment(StopTime = 2)); end Good;
  model Bad Real x = nothing; annotation(experiment(StopTime = 1)); end Bad;
  partial model Part Real x; end Part;
  function f input Real u; output Real y; algorithm y := u; end f;
  package Inner
    block Alone Real x; equation der(x) = -x; end Alone;
    model Deep model Nested Real x = 1; end Nested; Nested n; end Deep;
  protected
    model Hidden Real x = nothing; end Hidden;
  end Inner;
  model Short = Good;
end Mixed;
"""
CLASSES = ["Mixed.Good", "Mixed.Bad", "Mixed.Inner.Alone", "Mixed.Inner.Deep", "Mixed.Short"]
SLOW = """\
package Slow
  model Large Real x[60000]; equation for i in 1:60000 loop der(x[i]) = sin(i * time); end for; end Large;
  model Quick Real x = time; end Quick;
end Slow;
"""


@pytest.fixture
def mixed(working_directory: Path) -> Path:
    file = working_directory / "Mixed.mo"
    file.write_text(MIXED)
    return file


def library_of(text: str) -> Library:
    library = Library()
    for _, definition in parse(Source("test.mo", text)).classes:
        library.add(definition)
    return library


@pytest.mark.usefixtures("mixed")
class TestCommand:
    def test_json(self, call: Call) -> None:
        done = call("check", "Mixed.mo", "--recursive", "--json")
        assert done.status == 1
        assert [list(row) for row in done.problems] == [KEYS] * len(CLASSES)
        assert [row["model"] for row in done.problems] == CLASSES
        assert [row["passed"] for row in done.problems] == [True, False, True, True, True]
        assert [row["equations"] for row in done.problems] == [2, None, 1, 1, 2]
        assert "lookup.unknown-name" in str(done.problems[1]["diagnostics"])

    def test_table(self, call: Call) -> None:
        lines = call("check", "Mixed.mo", "-r").out.splitlines()
        assert lines[0].split() == ["model", "result", "equations", "variables", "seconds", "reason"]
        assert lines[1].split()[:4] == ["Mixed.Good", "passed", "2", "2"]
        assert "[lookup.unknown-name]" in lines[2]
        assert lines[-1].startswith("4 of 5 passed")

    def test_examples(self, call: Call) -> None:
        done = call("check", "Mixed.mo", "--recursive", "--examples", "--json")
        assert [row["model"] for row in done.problems] == CLASSES[:2]

    def test_part_of_a_file(self, call: Call) -> None:
        done = call("check", "Mixed.mo", "--class", "Mixed.Inner", "--recursive", "--json")
        assert done.status == 0
        assert [row["model"] for row in done.problems] == CLASSES[2:4]

    def test_nothing_to_check(self, call: Call) -> None:
        done = call("check", "Mixed.mo", "--class", "f", "--recursive")
        assert (done.status, done.out.split(" in ")[0]) == (0, "0 of 0 passed")

    @pytest.mark.parametrize(
        "options", ["--examples", "--jobs 2", "-r -p x=1", "-r --timeout 0", "-r --jobs -1"]
    )
    def test_wrong_settings(self, call: Call, options: str) -> None:
        assert call("check", "Mixed.mo", *options.split()).status == 2


def test_files_that_cannot_be_read_are_findings(call: Call, working_directory: Path) -> None:
    folder = working_directory / "Stored"
    folder.mkdir()
    (folder / "package.mo").write_text("package Stored end Stored;")
    (folder / "package.order").write_text("Zed\nBroken\n")
    (folder / "Broken.mo").write_text("within Stored; model Broken Real; end Broken;")
    (folder / "Zed.mo").write_text("within Stored; model Zed Real x = 1; end Zed;")
    (folder / "Also.mo").write_text("within Stored; model Also Real x = 1; end Also;")
    done = call("check", "Stored", "--path", ".", "--recursive", "--json")
    assert [row["model"] for row in done.problems] == ["Stored.Zed", "Stored.Broken", "Stored.Also"]
    assert [row["passed"] for row in done.problems] == [True, False, True]
    assert call("check", "Stored/", "--recursive", "--json").problems[1]["model"] == "Stored.Broken"


def test_a_check_that_takes_too_long_is_stopped() -> None:
    library = library_of(SLOW)
    names = ["Slow.Large", "Slow.Quick"]
    found = list(checked(library, Library, names, Bounds(seconds=0.5, jobs=1)))
    assert [(f.model, f.passed) for f in found] == [("Slow.Large", False), ("Slow.Quick", True)]
    assert found[0].diagnostics[0]["code"] == "check.timeout"


def test_a_check_that_takes_too_much_memory_is_stopped() -> None:
    library = library_of(SLOW)
    names = ["Slow.Large", "Slow.Quick"]
    found = list(checked(library, Library, names, Bounds(seconds=60, megabytes=60, jobs=1)))
    assert [(f.model, f.passed) for f in found] == [("Slow.Large", False), ("Slow.Quick", True)]
    assert found[0].diagnostics[0]["code"] == "check.memory"


def test_what_models_share_does_not_change_what_is_found() -> None:
    library = Library(library_directories())
    names = [n for n in survey_classes(library.find("Hydraulics"), True) if isinstance(n, str)]
    together = Surveyor(library)
    shared = [together.check(name) for name in names]
    alone = [Surveyor(Library(library_directories())).check(name) for name in names[::4]]
    assert all(finding.passed for finding in shared)
    assert [(f.equations, f.variables) for f in alone] == [(f.equations, f.variables) for f in shared[::4]]
