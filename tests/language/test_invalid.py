"""Invalid models: each is refused with its own code, the model's names and the right line, at once."""

from __future__ import annotations

import sys
from pathlib import Path
from time import process_time

import pytest

from acausal.errors import AcausalError
from acausal.lang.library import Library
from acausal.pipeline import compile_model
from tests.language.models import INVALID, diagnostics, expected_error

MOST_SECONDS = 2.0 if sys.gettrace() is None else 8.0  # measuring coverage takes four times as long


@pytest.mark.parametrize("path", INVALID, ids=lambda path: path.stem)
def test_is_refused(path: Path) -> None:
    text = path.read_text()
    start = process_time()
    found = diagnostics(text)
    seconds = process_time() - start
    assert any(expected_error(text).matches(d) for d in found), "\n".join(d.render() for d in found)
    assert seconds < MOST_SECONDS


def test_every_code_is_a_dotted_word() -> None:
    for path in INVALID:
        area, _, word = expected_error(path.read_text()).code.partition(".")
        assert area.isalpha()
        assert word.replace("-", "").isalpha()


@pytest.mark.parametrize(
    ("other", "hint"),
    [("", "one of its elements: `a[1]` to `a[2]`"), ("[1]", "in a `for` loop"), ("[3]", "in a `for` loop")],
)
def test_connected_sizes_are_explained(other: str, hint: str) -> None:
    pin = "connector Pin Real v; flow Real i; end Pin;"
    found = diagnostics(f"{pin} model Test Pin a[2]; Pin b{other}; equation connect(a, b); end Test;")
    assert hint in found[0].hint


def deep_components(levels: int) -> str:
    """`M1` holds an `M0`, `M2` an `M1`, ..."""
    classes = ["model M0\n  Real x = 1;\nend M0;"]
    classes += [f"model M{i}\n  M{i - 1} m;\nend M{i};" for i in range(1, levels + 1)]
    return "\n".join([*classes, f"model Test\n  M{levels} m;\nend Test;"])


def test_components_may_be_nested_deeply_but_not_without_bounds() -> None:
    assert not diagnostics(deep_components(50))
    assert [d.code for d in diagnostics(deep_components(300))] == ["instance.recursive"]


def stored(folder: Path, name: str) -> list[str]:
    """Codes of what is wrong with a class stored in a folder on the library path."""
    try:
        compile_model(Library((folder,)), name, stop_after="flat")
    except AcausalError as error:
        return list(error.codes)
    return []


def write(folder: Path, **files: str) -> None:
    package = folder / "P"
    package.mkdir()
    for name, text in files.items():
        (package / f"{name}.mo").write_text(text)


class TestStoredClasses:
    PACKAGE = "package P\nend P;"

    def test_found(self, tmp_path: Path) -> None:
        write(tmp_path, package=self.PACKAGE, A="within P;\nmodel A\n  Real x = 1;\nend A;")
        assert stored(tmp_path, "P.A") == []

    def test_file_name_differs_from_class_name(self, tmp_path: Path) -> None:
        write(tmp_path, package=self.PACKAGE, A="within P;\nmodel B\nend B;")
        assert stored(tmp_path, "P.A") == ["library.file-name"]

    def test_within_says_something_else(self, tmp_path: Path) -> None:
        write(tmp_path, package=self.PACKAGE, A="within Q;\nmodel A\nend A;")
        assert stored(tmp_path, "P.A") == ["library.within"]

    def test_two_classes_in_one_file(self, tmp_path: Path) -> None:
        write(tmp_path, package=self.PACKAGE, A="within P;\nmodel A\nend A;\nmodel B\nend B;")
        assert stored(tmp_path, "P.A") == ["library.file-name"]

    def test_not_modelica(self, tmp_path: Path) -> None:
        write(tmp_path, package=self.PACKAGE, A="this is a letter")
        assert stored(tmp_path, "P.A")[0].startswith("syntax.")

    def test_unknown(self, tmp_path: Path) -> None:
        write(tmp_path, package=self.PACKAGE)
        assert stored(tmp_path, "P.A") == ["lookup.unknown-class"]

    def test_highest_version_is_taken(self, tmp_path: Path) -> None:
        for version, value in (("1.9.0", 1), ("1.10.0", 2)):
            folder = tmp_path / f"P {version}"
            folder.mkdir()
            (folder / "package.mo").write_text(f"package P\nmodel A\nReal x = {value};\nend A;\nend P;")
        flat = compile_model(Library((tmp_path,)), "P.A", stop_after="flat").flat
        assert flat is not None
        assert flat.equations[0].right.value == 2
