"""Which of several stored versions of a library is meant (Modelica 3.6, 18.9).

A top-level class may be stored as `Name/package.mo`, `Name.mo`, `Name VERSION/package.mo` or
`Name VERSION.mo`. The `uses` annotation of the class that was loaded first decides: the first version on the
path that is the wanted one, else the first that says it can stand in for it (`conversion(noneFromVersion)`),
else what would be taken without a wish, with a warning. Without a wish it is the first folder of the path
that has one, there the one without a version in its name, else the highest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from acausal.errors import Diagnostic, Span
from acausal.lang import ast

Arguments = tuple[ast.Argument, ...]


@dataclass(frozen=True)
class Wish:
    """Version `version` of a library, as the `uses` annotation of the class `user` wants it."""

    version: str
    user: str
    span: Span


@dataclass(frozen=True)
class Stored:
    """A file that holds a top-level class, and the version in its name, if there is one."""

    path: Path
    version: str | None


def stored_versions(directory: Path, name: str) -> list[Stored]:
    """All that a folder of the path has of a top-level class: without a version first, then the highest."""
    plain = [
        Stored(p, None) for p in (directory / name / "package.mo", directory / f"{name}.mo") if p.is_file()
    ]
    found: list[Stored] = []
    try:
        entries = sorted(directory.iterdir(), key=lambda p: p.name)
    except OSError:
        entries = []
    for entry in entries:
        if entry.name.startswith(f"{name} "):
            version = entry.name.removeprefix(f"{name} ")
            if (entry / "package.mo").is_file():
                found.append(Stored(entry / "package.mo", version))
            elif entry.suffix == ".mo" and entry.is_file():
                found.append(Stored(entry, version.removesuffix(".mo")))
    found.sort(key=lambda stored: version_key(stored.version or ""), reverse=True)
    return plain + found


def version_key(version: str) -> tuple[tuple[int, str], ...]:
    """For comparing versions: numbers as numbers, and a release after its pre-releases."""
    release, _, rest = without_build(version).partition("-")
    parts = tuple((int(part), "") if part.isdigit() else (-1, part) for part in release.split("."))
    return (*parts, (-1, rest)) if rest else (*parts, (0, ""))


def without_build(version: str) -> str:
    """A version without its build data (`4.0.0+maint.om` is `4.0.0`)."""
    return version.partition("+")[0].strip()


def chosen(
    directories: Sequence[Path], name: str, wish: Wish | None, read: Callable[[Path], ast.ClassDefinition]
) -> Path | None:
    """The file to load the top-level class `name` from; `read` gives the class in a file."""
    found = [stored_versions(directory, name) for directory in directories]
    usual = next((versions[0] for versions in found if versions), None)
    if usual is None or wish is None:
        return None if usual is None else usual.path
    everything = [stored for versions in found for stored in versions]
    wanted = without_build(wish.version)
    for stored in everything:
        version = stored.version or version_of(read(stored.path))
        if version is not None and without_build(version) == wanted:
            return stored.path
    for stored in everything:
        if wanted in none_from(read(stored.path)):
            return stored.path
    return usual.path


def mismatch(definition: ast.ClassDefinition, wish: Wish) -> Diagnostic | None:
    """The warning about a library that is not what a class wants to use."""
    version, wanted = version_of(definition), without_build(wish.version)
    if version is None or without_build(version) == wanted or wanted in none_from(definition):
        return None
    message = (
        f"`{wish.user}` uses version {wish.version} of `{definition.name}`, but version {version} is loaded"
    )
    if wanted in converted_from(definition):
        message += ", which needs it converted"
    hint = f"put version {wish.version} on the library path, or update the `uses` annotation"
    return Diagnostic("library.version", message, wish.span, (definition.name,), hint, "warning")


# --------------------------------------------------------------------------- annotations


def version_of(definition: ast.ClassDefinition) -> str | None:
    """The `version` annotation of a top-level class."""
    return _string(_named(_annotation(definition), "version"))


def uses_of(definition: ast.ClassDefinition) -> dict[str, Wish]:
    """The versions of other libraries that a top-level class says it uses."""
    wishes: dict[str, Wish] = {}
    for used in _arguments(_named(_annotation(definition), "uses")):
        if isinstance(used, ast.ElementModification) and len(used.name) == 1:
            version = _string(_named(_arguments([used]), "version"))
            if version is not None:
                wishes.setdefault(used.name[0], Wish(version, definition.name, used.span))
    return wishes


def none_from(definition: ast.ClassDefinition) -> set[str]:
    """Versions whose users need no conversion to use this one."""
    entries = _arguments(_named(_annotation(definition), "conversion"))
    return {without_build(text) for entry in _named(entries, "noneFromVersion") for text in _strings(entry)}


def converted_from(definition: ast.ClassDefinition) -> set[str]:
    """Versions whose users must be converted to use this one."""
    entries = _arguments(_named(_annotation(definition), "conversion"))
    versions = [v for entry in _named(entries, "from") for v in _named(_arguments([entry]), "version")]
    return {without_build(text) for version in versions for text in _strings(version)}


def _annotation(definition: ast.ClassDefinition) -> Arguments:
    if isinstance(definition, ast.LongClass):
        notes = definition.body.annotation
    else:
        notes = definition.comment.annotation
    return () if notes is None else notes.arguments


def _named(arguments: Iterable[ast.Argument], name: str) -> list[ast.ElementModification]:
    return [a for a in arguments if isinstance(a, ast.ElementModification) and a.name == (name,)]


def _arguments(modifications: Iterable[ast.ElementModification]) -> Arguments:
    return tuple([a for m in modifications if m.modification is not None for a in m.modification.arguments])


def _string(modifications: Sequence[ast.ElementModification]) -> str | None:
    return next((text for modification in modifications for text in _strings(modification)), None)


def _strings(modification: ast.ElementModification) -> list[str]:
    """The string, or the strings of the array, that a modification gives."""
    value = None if modification.modification is None else modification.modification.value
    items = value.items if isinstance(value, ast.ArrayConstructor) else (value,)
    return [item.value for item in items if isinstance(item, ast.StringLiteral)]
