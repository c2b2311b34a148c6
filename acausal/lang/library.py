"""Finding and loading stored classes: the library path, packages as folders and files (Modelica 3.6, 13.4).

A `ClassNode` is one class definition at its place in the package tree. Its children are the classes
declared in its text and, for a package stored as a folder, the files and folders beside `package.mo`;
those are read only when they are first asked for.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path

from acausal.errors import Diagnostic, LookupProblem, Source, Span, SyntaxProblem, fail
from acausal.lang import ast
from acausal.lang.imports import Imports, imports_of
from acausal.lang.lexer import decode
from acausal.lang.library_versions import Wish, chosen, mismatch, uses_of
from acausal.lang.parse_cache import cache_directory, read_stored
from acausal.lang.reading_time import reading

MAX_FILE_BYTES = 20_000_000


def library_directories(
    extra: Sequence[str | Path] = (), environment: Mapping[str, str] | None = None
) -> tuple[Path, ...]:
    """The contract's library path: `extra`, MODELICAPATH, `~/.openmodelica/libraries`, bundled."""
    env = os.environ if environment is None else environment
    listed = [Path(p) for p in extra]
    listed += [Path(p) for p in env.get("MODELICAPATH", "").split(":") if p]
    if env.get("HOME"):
        listed.append(Path(env["HOME"]) / ".openmodelica" / "libraries")
    listed += bundled_directories()
    return tuple(dict.fromkeys(p for p in listed if p.is_dir()))


def bundled_directories() -> list[Path]:
    """Folders that contain the packages shipped with acausal (inside the wheel, or in a source checkout)."""
    package = Path(__file__).resolve().parent.parent
    for base in (package / "_bundled", package.parent):
        found = sorted(p.parent.parent for p in base.glob("library/*/*/package.mo"))
        found += sorted(p.parent.parent for p in base.glob("models/*/*/package.mo"))
        if found:
            return list(dict.fromkeys(found))
    return []


_PART = re.compile(r"'(?:[^'\\]|\\.)*'|[^.']+|'")


def name_parts(dotted: str) -> list[str]:
    """The identifiers of a dotted name; a quoted one may hold dots itself."""
    return _PART.findall(dotted) or [dotted]


class ClassNode:
    """A class definition in the package tree; `folder` is set for a package stored as a directory."""

    __slots__ = ("_imports", "_loaded", "_stored", "definition", "folder", "name", "parent", "path")

    def __init__(
        self, definition: ast.ClassDefinition, parent: ClassNode | None, folder: Path | None
    ) -> None:
        self.definition = definition
        self.name = definition.name
        self.parent = parent
        self.path: str = f"{parent.path}.{definition.name}" if parent is not None else definition.name
        self.folder = folder
        self._stored: dict[str, ClassNode] | None = None
        self._loaded: dict[str, ClassNode | None] = {}
        self._imports: Imports | None = None

    @property
    def imports(self) -> Imports:
        """The import clauses of the class."""
        if self._imports is None:
            self._imports = imports_of(self.definition)
        return self._imports

    def child(self, name: str) -> ClassNode | None:
        """The nested class `name`, reading its file if it has one of its own."""
        inside = self._inside()
        if name in inside:
            return inside[name]
        if self.folder is None:
            return None
        if name not in self._loaded:
            self._loaded[name] = self._load_stored(name)
        return self._loaded[name]

    def child_names(self) -> list[str]:
        """Names of all nested classes: those in the text, then those in files, sorted."""
        names = list(self._inside())
        if self.folder is not None:
            names += [name for name in stored_names(self.folder) if name not in names]
        return names

    def ordered_names(self) -> list[str]:
        """As `child_names`, in the order of `package.order` (13.4.1); what it leaves out comes last."""
        names = self.child_names()
        rank = {name: i for i, name in enumerate(stored_order(self.folder))} if self.folder else {}
        return sorted(names, key=lambda name: rank.get(name, len(rank)))

    def _inside(self) -> dict[str, ClassNode]:
        if self._stored is None:
            self._stored = {}
            if isinstance(self.definition, ast.LongClass):
                for element in self.definition.body.elements:
                    if isinstance(element, ast.ClassDefinition):
                        self._stored[element.name] = ClassNode(element, self, None)
        return self._stored

    def _load_stored(self, name: str) -> ClassNode | None:
        assert self.folder is not None
        found = find_stored(self.folder, name)
        if found is None:
            return None
        root = self
        while root.parent is not None:
            root = root.parent
        if root.folder is not None and not found.resolve().is_relative_to(root.folder.resolve()):
            raise _outside(found, root.path)
        return load_class(found, name, self)


def _outside(path: Path, package: str) -> LookupProblem:
    """A link that leads out of its library: only the entries of the library path itself may be links."""
    return fail(
        LookupProblem,
        "library.outside",
        f"{display_path(path)} lies outside the folder of `{package}`, to which it is linked",
        names=[package],
        hint="link the whole library into the library path, not parts of it",
    )


def stored_names(folder: Path) -> Iterator[str]:
    """Names of the classes stored beside a `package.mo`, sorted."""
    for entry in sorted(folder.iterdir(), key=lambda p: p.name):
        if entry.is_dir() and (entry / "package.mo").is_file():
            yield entry.name
        elif entry.suffix == ".mo" and entry.name != "package.mo":
            yield entry.stem


def stored_order(folder: Path) -> list[str]:
    """The names listed in `package.order`, as far as it can be read; it is a wish, not a promise (13.4.1)."""
    try:
        text = (folder / "package.order").read_text(encoding="utf-8", errors="replace")
    except OSError:
        return []
    return [line.strip() for line in text.splitlines() if line.strip()]


def find_stored(folder: Path, name: str) -> Path | None:
    """`folder/name/package.mo` or `folder/name.mo`. Raises `LookupProblem` when both are there."""
    if not _is_entry(name):
        return None
    found = [p for p in (folder / name / "package.mo", folder / f"{name}.mo") if p.is_file()]
    if len(found) > 1:
        message = f"`{name}` is stored twice: as {display_path(found[0])} and as {display_path(found[1])}"
        hint = "a class is stored either as a folder or as a file (Modelica 3.6, 13.4)"
        raise fail(LookupProblem, "library.stored-twice", message, names=[name], hint=hint)
    return found[0] if found else None


def _is_entry(name: str) -> bool:
    """Whether a class name can be that of an entry of a folder; a quoted one may hold anything."""
    return not any(character in name for character in "/\\\0") and name not in {".", ".."}


def read_source(path: Path, shown: str | None = None) -> Source:
    """Read and decode a Modelica file. Raises `SyntaxProblem` or `LookupProblem`."""
    label = shown or display_path(path)
    return decode(read_bytes(path, label), label)


def read_bytes(path: Path, label: str) -> bytes:
    """What a Modelica file holds; messages call it `label`. Raises `SyntaxProblem` or `LookupProblem`."""
    try:
        if path.stat().st_size > MAX_FILE_BYTES:
            message = f"{label} is larger than {MAX_FILE_BYTES // 1_000_000} MB"
            raise fail(SyntaxProblem, "syntax.too-large", message)
        return path.read_bytes()
    except OSError as problem:
        message = f"cannot read {label}: {problem.strerror or problem}"
        raise fail(LookupProblem, "library.unreadable", message) from None


def display_path(path: Path) -> str:
    """A path as messages show it: relative to the working directory when it lies below it."""
    try:
        return str(path.resolve().relative_to(Path.cwd()))
    except ValueError:
        return str(path)


def load_class(path: Path, name: str, parent: ClassNode | None) -> ClassNode:
    """The class stored in `path`, which must be called `name` and be `within` its parent."""
    label = display_path(path)
    with reading():
        stored = read_stored(read_bytes(path, label), label, cache_directory())
    folder = path.parent if path.name == "package.mo" else None
    within = ".".join(stored.within or ())
    expected = parent.path if parent is not None else ""
    if len(stored.classes) != 1 or stored.classes[0][1].name != name:
        found = ", ".join(c.name for _, c in stored.classes) or "no class"
        raise fail(
            LookupProblem,
            "library.file-name",
            f"{display_path(path)} must hold exactly the class `{name}`, but it holds {found}",
            stored.classes[0][1].span if stored.classes else None,
            hint="a class stored in a file of a package has the name of the file (Modelica 3.6, 13.4)",
        )
    definition = stored.classes[0][1]
    if stored.within is not None and within != expected:
        raise fail(
            LookupProblem,
            "library.within",
            f"{display_path(path)} says `within {within};` but is stored in `{expected or 'the top level'}`",
            definition.span,
            hint=f"write `within {expected};` or move the file",
        )
    return ClassNode(definition, parent, folder)


@dataclass
class Library:
    """Top-level classes by name: given ones first, then those on the library path, loaded when met."""

    directories: tuple[Path, ...] = ()

    def __post_init__(self) -> None:
        self._classes: dict[str, ClassNode | None] = {}
        self._wishes: dict[str, list[Wish]] = {}
        self.warnings: list[Diagnostic] = []
        """Libraries that are not in the version that somebody uses."""
        self.given: list[str] = []
        """Names of the classes that were added from texts, in order."""

    def add(self, definition: ast.ClassDefinition, folder: Path | None = None) -> ClassNode:
        """Add a top-level class from a text that is not on the path."""
        if self._classes.get(definition.name) is not None:
            raise fail(
                LookupProblem,
                "library.duplicate-class",
                f"the class `{definition.name}` is defined twice",
                definition.span,
                names=[definition.name],
                hint="rename one of them",
            )
        node = ClassNode(definition, None, folder)
        self._classes[definition.name] = node
        self._note_uses(definition)
        self.given.append(definition.name)
        return node

    def own_folders(self) -> tuple[Path, ...]:
        """The folders of the files that classes were added from."""
        added = [node for node in self._classes.values() if node is not None]
        files = [Path(node.definition.span.file) for node in added]
        return tuple(dict.fromkeys(file.resolve().parent for file in files if file.is_file()))

    def top_level(self, name: str) -> ClassNode | None:
        """The top-level class `name`, loaded from the path when needed."""
        if name not in self._classes:
            wishes = self._wishes.get(name, [])
            node = self._load(name, wishes[0] if wishes else None)
            self._classes[name] = node
            if node is not None:
                self._note_uses(node.definition)
                for wish in wishes:
                    self._compare(node.definition, wish)
        return self._classes[name]

    def _load(self, name: str, wish: Wish | None) -> ClassNode | None:
        if not _is_entry(name):
            return None
        nodes: dict[Path, ClassNode] = {}

        def read(path: Path) -> ast.ClassDefinition:
            if path not in nodes:
                nodes[path] = load_class(path, name, None)
            return nodes[path].definition

        found = chosen(self.directories, name, wish, read)
        if found is None:
            return None
        read(found)
        return nodes[found]

    def _note_uses(self, definition: ast.ClassDefinition) -> None:
        """Remember which versions a top-level class uses; of what is loaded already they are compared now."""
        for name, wish in uses_of(definition).items():
            self._wishes.setdefault(name, []).append(wish)
            node = self._classes.get(name)
            if node is not None:
                self._compare(node.definition, wish)

    def _compare(self, definition: ast.ClassDefinition, wish: Wish) -> None:
        warning = mismatch(definition, wish)
        if warning is not None:
            self.warnings.append(warning)

    def top_level_names(self) -> list[str]:
        """Names that can be loaded, for suggestions; sorted."""
        names = {name for name, node in self._classes.items() if node is not None}
        for directory in self.directories:
            names.update(name.split(" ")[0] for name in stored_names(directory))
        return sorted(names)

    def find(self, dotted: str, span: Span | None = None) -> ClassNode:
        """The class with this full name. Raises `LookupProblem` with the nearest names."""
        parts = name_parts(dotted)
        node = self.top_level(parts[0])
        siblings: Callable[[], list[str]] = self.top_level_names
        for i, part in enumerate(parts):
            if i > 0:
                assert node is not None
                siblings = node.child_names
                node = node.child(part)
            if node is None:
                raise unknown_class(".".join(parts[: i + 1]), part, siblings(), span)
        assert node is not None
        return node


def unknown_class(shown: str, part: str, known: Sequence[str], span: Span | None) -> LookupProblem:
    """The error for a class name that is not there."""
    near = get_close_matches(part, known, 3)
    nearest = " or ".join(f"`{name}`" for name in near)
    hint = f"did you mean {nearest}?" if near else "check the library path (--path, MODELICAPATH)"
    message = f"class `{shown}` is not found"
    return fail(LookupProblem, "lookup.unknown-class", message, span, names=[shown], hint=hint)
