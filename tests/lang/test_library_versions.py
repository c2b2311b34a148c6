"""Several versions of a library on the path: which one is taken, and what is said when it does not fit."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from acausal.errors import LookupProblem, Source
from acausal.lang.library import Library
from acausal.lang.library_versions import version_key
from acausal.lang.parser import parse


def store(place: Path, version: str | None, conversion: str = "", uses: str = "") -> None:
    """The library `Lib`, with a constant that says where it comes from."""
    place.parent.mkdir(parents=True, exist_ok=True)
    notes = [f'version = "{version}"'] if version else []
    notes += [f"conversion({conversion})"] if conversion else []
    notes += [f"uses({uses})"] if uses else []
    name = place.parent.name.split(" ")[0] if place.name == "package.mo" else place.stem.split(" ")[0]
    where = f"{place.parent.name}/{place.name}" if place.name == "package.mo" else place.name
    place.write_text(
        f'package {name} constant String where = "{where}"; annotation({", ".join(notes)}); end {name};'
    )


def library(*directories: Path, uses: str | None = None) -> Library:
    """A library path, and a model that uses a version of `Lib`."""
    made = Library(directories)
    notes = "" if uses is None else f'annotation(uses(Lib(version = "{uses}")));'
    ((_, definition),) = parse(Source("user.mo", f"model User {notes} end User;")).classes
    made.add(definition)
    return made


def loaded(made: Library, name: str = "Lib") -> str:
    """Where the library was loaded from."""
    file = Path(made.find(name).definition.span.file)
    return file.parent.name if file.name == "package.mo" else file.name


@pytest.fixture
def path(tmp_path: Path) -> Path:
    store(tmp_path / "Lib 3.2.3" / "package.mo", "3.2.3")
    store(tmp_path / "Lib 4.0.0+build.7" / "package.mo", "4.0.0")
    conversion = 'noneFromVersion = "9.0.0", from(version = {"1.0", "2.0"}, script = "x")'
    store(tmp_path / "Lib 10.0.0" / "package.mo", "10.0.0", conversion)
    store(tmp_path / "Lib 10.0.0-beta.mo", "10.0.0-beta")
    return tmp_path


@pytest.mark.parametrize(
    ("uses", "expected", "warned"),
    [
        (None, "Lib 10.0.0", False),
        ("3.2.3", "Lib 3.2.3", False),
        ("4.0.0", "Lib 4.0.0+build.7", False),
        ("10.0.0", "Lib 10.0.0", False),
        ("10.0.0-beta", "Lib 10.0.0-beta.mo", False),
        ("9.0.0", "Lib 10.0.0", False),
        ("2.0", "Lib 10.0.0", True),
        ("5.0", "Lib 10.0.0", True),
    ],
)
def test_uses_selects(path: Path, uses: str | None, expected: str, warned: bool) -> None:
    made = library(path, uses=uses)
    assert loaded(made) == expected
    assert [w.code for w in made.warnings] == ["library.version"] * warned
    if uses == "2.0":
        assert "converted" in made.warnings[0].message


def test_without_a_version_in_the_name_comes_first_but_a_wish_counts_more(path: Path) -> None:
    store(path / "Lib" / "package.mo", "7.0.0")
    assert loaded(library(path)) == "Lib"
    assert loaded(library(path, uses="7.0.0")) == "Lib"
    assert loaded(library(path, uses="4.0.0")) == "Lib 4.0.0+build.7"


def test_the_first_folder_of_the_path_comes_first(path: Path) -> None:
    store(path / "first" / "Lib 1.0.0" / "package.mo", "1.0.0")
    assert loaded(library(path / "first", path)) == "Lib 1.0.0"
    assert loaded(library(path / "first", path, uses="4.0.0")) == "Lib 4.0.0+build.7"


def test_the_first_who_uses_a_library_decides(path: Path) -> None:
    store(path / "Other" / "package.mo", None, uses='Lib(version = "3.2.3")')
    made = library(path, uses="4.0.0")
    made.find("Other")
    assert loaded(made) == "Lib 4.0.0+build.7"
    assert [w.message for w in made.warnings] == [
        "`Other` uses version 3.2.3 of `Lib`, but version 4.0.0 is loaded"
    ]


def test_a_library_that_is_loaded_already_is_compared(path: Path) -> None:
    made = library(path)
    made.find("Lib")
    text = 'model Late annotation(uses(Lib(version = "4.0.0"))); end Late;'
    ((_, late),) = parse(Source("late.mo", text)).classes
    made.add(late)
    assert [w.names for w in made.warnings] == [("Lib",)]


def test_a_library_without_a_version_fits_everybody(tmp_path: Path) -> None:
    store(tmp_path / "Lib.mo", None)
    made = library(tmp_path, uses="3.0")
    assert loaded(made) == "Lib.mo"
    assert not made.warnings


def test_versions_are_ordered_as_numbers() -> None:
    ordered = ["1.0-alpha", "1.0", "1.9", "1.10", "2.0.0-beta.2", "2.0.0"]
    shuffled = [ordered[i] for i in (3, 1, 5, 0, 4, 2)]
    assert sorted(shuffled, key=version_key) == ordered


# --------------------------------------------------------------------------- files


def nested(folder: Path) -> Path:
    """A stored package `P` with a folder and a file."""
    package = folder / "P"
    (package / "Q").mkdir(parents=True)
    (package / "package.mo").write_text("package P end P;")
    (package / "Q" / "package.mo").write_text("within P; package Q end Q;")
    (package / "M.mo").write_bytes(b"\xef\xbb\xbfwithin P; model M end M;")
    return package


def test_folders_files_and_a_byte_order_mark(tmp_path: Path) -> None:
    nested(tmp_path)
    made = Library((tmp_path,))
    assert made.find("P.M").path == "P.M"
    assert made.find("P.Q").folder == tmp_path / "P" / "Q"
    assert made.find("P").child_names() == ["M", "Q"]
    (tmp_path / "P" / "package.order").write_text("Q\nM\n")
    assert made.find("P").ordered_names() == ["Q", "M"]


def test_a_class_stored_twice_is_refused(tmp_path: Path) -> None:
    package = nested(tmp_path)
    (package / "Q.mo").write_text("within P; package Q end Q;")
    with pytest.raises(LookupProblem) as raised:
        Library((tmp_path,)).find("P.Q")
    assert raised.value.codes == ("library.stored-twice",)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("within P; model N end N;", "library.file-name"),
        ("within X; model M end M;", "library.within"),
        ("within P; model M end M; model N end N;", "library.file-name"),
        ("model M Real end M;", "syntax"),
    ],
)
def test_files_that_do_not_fit_their_place(tmp_path: Path, text: str, code: str) -> None:
    (nested(tmp_path) / "M.mo").write_text(text)
    with pytest.raises(Exception, match=rf"\[{code}") as raised:
        Library((tmp_path,)).find("P.M")
    assert "M.mo" in str(raised.value)


def test_links_out_of_a_library_are_refused(tmp_path: Path) -> None:
    package = nested(tmp_path / "path")
    secret = tmp_path / "S.mo"
    secret.write_text("within P; model S end S;")
    os.symlink(secret, package / "S.mo")
    with pytest.raises(LookupProblem) as raised:
        Library((tmp_path / "path",)).find("P.S")
    assert raised.value.codes == ("library.outside",)
    os.symlink(package / "M.mo", package / "N.mo")
    with pytest.raises(LookupProblem) as raised:
        Library((tmp_path / "path",)).find("P.N")
    assert raised.value.codes == ("library.file-name",)  # inside: read, and wrong for another reason


def test_a_whole_library_may_be_a_link(tmp_path: Path) -> None:
    nested(tmp_path / "elsewhere")
    (tmp_path / "path").mkdir()
    os.symlink(tmp_path / "elsewhere" / "P", tmp_path / "path" / "P")
    assert Library((tmp_path / "path",)).find("P.Q").path == "P.Q"


@pytest.mark.parametrize("name", ["'..'", "'../S'", "'a/../../S'", "'a\\\\b'"])
def test_quoted_names_do_not_lead_out_of_a_folder(tmp_path: Path, name: str) -> None:
    nested(tmp_path / "path")
    (tmp_path / "S.mo").write_text("model S end S;")
    with pytest.raises(LookupProblem) as raised:
        Library((tmp_path / "path",)).find(f"P.{name}")
    assert raised.value.codes == ("lookup.unknown-class",)
