"""Which class a person means: a dotted name on the library path, a file, or a text."""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import SupportsIndex, TypeAlias

from acausal.errors import LookupProblem, Source, SyntaxProblem, UsageProblem, fail
from acausal.lang.base_reading import as_modelica_text, is_base_modelica, model_of
from acausal.lang.library import Library, library_directories, name_parts
from acausal.lang.parser import parse

FILE_ENDINGS = (".mo", ".bmo")
"""What the name of a file ends in: Modelica, Base Modelica; the latter is told by its first line."""

_IDENTIFIER = r"(?:[^\W\d]\w*|'[^']+')"
_DOTTED_NAME = re.compile(rf"\.?{_IDENTIFIER}(?:\.{_IDENTIFIER})*")


def searched_directories(path: Sequence[str | Path]) -> tuple[Path, ...]:
    """The library path, with `path` first. Raises `UsageProblem` when one of `path` is no folder."""
    for folder in path:
        if not Path(folder).is_dir():
            raise fail(UsageProblem, "usage.path", f"`{folder}` on the library path is not a folder")
    return library_directories(path)


def existing_file(text: str) -> Path:
    """The file called `text`. Raises `UsageProblem` when there is none."""
    file = Path(text)
    if not file.exists():
        raise fail(
            UsageProblem,
            "usage.no-file",
            f"there is no file `{text}`",
            hint="check the path and the working directory",
        )
    if not file.is_file():
        raise fail(UsageProblem, "usage.no-file", f"`{text}` is not a file")
    return file


def class_name(text: str) -> str:
    """`text`, if it can be the dotted name of a class. Raises `UsageProblem`, with what it may have meant."""
    if _DOTTED_NAME.fullmatch(text) and not Path(text).is_file():
        return text.removeprefix(".")
    place = Path(text)
    if place.is_dir():
        problem = f"`{text}` is a folder; a model is a dotted class name or a file FILE.mo"
        hint = "put the folder that holds the package on the library path (--path), and name a class in it"
    elif place.is_file():
        problem, hint = f"`{text}` does not end in `.mo` or `.bmo`", "rename the file, if it holds Modelica"
    else:
        problem, hint = f"`{text}` is neither a dotted class name nor a file FILE.mo", ""
    raise fail(UsageProblem, "usage.model", problem, names=[text], hint=hint)


def stored_root(file: Path) -> tuple[Path, ...]:
    """The folder that a file's top-level package lies in, so that its siblings are found."""
    folder = file.resolve().parent
    while (folder / "package.mo").is_file():
        folder = folder.parent
    return (folder,) if folder != file.resolve().parent else ()


def add_source(library: Library, source: Source, name: str | None, file: Path | None) -> str:
    """Add the classes of a text to the library; returns the full name of the chosen one."""
    base = is_base_modelica(source)
    stored = parse(as_modelica_text(source) if base else source)
    if not stored.classes:
        hint = "a Modelica file starts with `model Name`"
        raise fail(SyntaxProblem, "syntax.no-class", f"{source.path} holds no class", hint=hint)
    if stored.within:
        full = ".".join((*stored.within, stored.classes[-1][1].name))
        return library.find(name or full).path
    for _, definition in stored.classes:
        folder = file.resolve().parent if file is not None and file.name == "package.mo" else None
        library.add(definition, folder)
    if base and name is None:
        return library.find(model_of(stored)).path
    if name is None:
        return stored.classes[-1][1].name
    return library.find(_qualified(library, class_name(name), [d.name for _, d in stored.classes])).path


def _qualified(library: Library, name: str, tops: Sequence[str]) -> str:
    """`name` as given, or below the last class of the file."""
    if name_parts(name)[0] in tops:
        return name
    inside = f"{tops[-1]}.{name}"
    try:
        library.find(inside)
    except LookupProblem:
        return name
    return inside


ParameterValue: TypeAlias = float | int | bool | str | SupportsIndex | Iterable["ParameterValue"]
"""A number, a Boolean, Modelica text (`"{1, 2}"`, `"Types.Mode.open"`), or a list of these."""


def as_modelica(value: ParameterValue, name: str = "") -> str:
    """A Python value as a Modelica expression; text is taken as it is.

    Raises `UsageProblem` for what is not a number.
    """
    match value:
        case str():
            return value
        case bool():
            return "true" if value else "false"
        case float():
            if not math.isfinite(value):
                raise fail(
                    UsageProblem, "usage.parameter-value", f"{value} is no value for `{name}`", names=[name]
                )
            return repr(float(value))
        case Iterable():
            return "{" + ", ".join([as_modelica(item, name) for item in value]) + "}"
        case _:
            return repr(operator.index(value))
