"""What is shipped: libraries in the wheel, packages in folders of their own name, no machine's paths."""

from __future__ import annotations

import re
import zipfile
from pathlib import Path

import pytest
from hatchling.builders.wheel import WheelBuilder

from tests.architecture.layers import ROOT

SHIPPED = ("library", "models")
TEXT = {".py", ".pyi", ".mo", ".md", ".toml", ".txt", ".c", ".h", ".csv", ".json", ".yml", ""}
FOLDERS = ("acausal", "library", "models", "tests", "docs", "benchmarks", "typings", ".ci")
HOMES = re.compile(r"(?<![\w.])/(?:home|Users)/\w+/")


def top_packages() -> list[Path]:
    """The folder of every top-level package: the outermost ones that hold a package.mo."""
    found = sorted(path.parent for folder in SHIPPED for path in (ROOT / folder).rglob("package.mo"))
    return [folder for folder in found if not (folder.parent / "package.mo").exists()]


def relative(path: Path) -> str:
    return str(path.relative_to(ROOT))


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> zipfile.Path:
    directory = tmp_path_factory.mktemp("wheel")
    (built,) = WheelBuilder(str(ROOT)).build(directory=str(directory), versions=["standard"])
    return zipfile.Path(built)


def test_there_are_libraries_and_models() -> None:
    names = {folder.name for folder in top_packages()}
    assert {"Hydraulics", "Mechanics", "TenSpeed"} <= names


@pytest.mark.parametrize("folder", top_packages(), ids=relative)
def test_wheel_ships_every_file_of_the_package(folder: Path, wheel: zipfile.Path) -> None:
    for path in sorted(folder.rglob("*.mo")):
        shipped = wheel / "acausal" / "_bundled" / path.relative_to(ROOT).as_posix()
        assert shipped.is_file(), f"{relative(path)} is not in the wheel"
        assert shipped.read_text(encoding="utf-8") == path.read_text(encoding="utf-8")


def test_wheel_has_the_compiler_its_types_and_its_command(wheel: zipfile.Path) -> None:
    assert (wheel / "acausal" / "__init__.py").is_file()
    assert (wheel / "acausal" / "py.typed").is_file()
    (info,) = [path for path in wheel.iterdir() if path.name.endswith(".dist-info")]
    assert "acausal = acausal.cli:main" in (info / "entry_points.txt").read_text()
    assert {path.name for path in wheel.iterdir()} == {"acausal", info.name}, "nothing else is installed"


@pytest.mark.parametrize(
    "path", sorted(p for folder in SHIPPED for p in (ROOT / folder).rglob("package.mo")), ids=relative
)
def test_folder_carries_its_package_name(path: Path) -> None:
    """Modelica 3.6, section 13.4: the class in `A/package.mo` is called A."""
    declared = re.search(r"^\s*(?:encapsulated\s+)?package\s+(\w+)", path.read_text(), re.MULTILINE)
    assert declared, f"{relative(path)} declares no package"
    assert declared[1] == path.parent.name


@pytest.mark.parametrize("folder", top_packages(), ids=relative)
def test_one_model_per_file(folder: Path) -> None:
    """Every file but package.mo holds the class it is named after, and says which package that is within."""
    for path in sorted(folder.rglob("*.mo")):
        if path.name != "package.mo":
            text = path.read_text()
            within = ".".join(path.parent.relative_to(folder.parent).parts)
            assert re.search(rf"^within {re.escape(within)};", text, re.MULTILINE), relative(path)
            assert re.search(rf"^end {path.stem};", text, re.MULTILINE), relative(path)


def test_no_file_names_a_machine() -> None:
    own = [str(place) for place in (ROOT, Path.home()) if len(place.parts) > 1]
    mine = re.compile("|".join(rf"(?<![\w.]){re.escape(place)}(?=/)" for place in own))
    for path in text_files():
        text = path.read_text(encoding="utf-8")
        found = mine.search(text) or HOMES.search(text)
        assert not found, f"{relative(path)} names {found[0] if found else ''}"


def text_files() -> list[Path]:
    nested = [path for folder in FOLDERS for path in (ROOT / folder).rglob("*") if "_build" not in path.parts]
    every = [*ROOT.iterdir(), *nested]
    return sorted(
        path for path in every if path.is_file() and path.suffix in TEXT and path.name[:9] != ".coverage"
    )
