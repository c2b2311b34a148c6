"""What external functions need of a compilation: objects by their components, files, call sites."""

from __future__ import annotations

from functools import cached_property
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING

from acausal.externals.files import Files
from acausal.externals.objects import ExternalObject, named
from acausal.lang.arithmetic import as_scalar, type_error
from acausal.lang.instance import Leaf
from acausal.lang.library import Library
from acausal.lang.predefined import EXTERNAL_OBJECT
from acausal.lang.scope import Scope

if TYPE_CHECKING:  # the translation holds this
    from acausal.lang.translation import Translation


def is_external_class(scope: Scope) -> bool:
    """Whether a class is one of external objects: its objects are made by calling it (12.9.7)."""
    return any(base.scope.is_predefined and base.scope.path == EXTERNAL_OBJECT for base in scope.table.bases)


_COMPILATIONS = count()


class Externals:
    """One per compilation."""

    def __init__(self, translation: Translation, library: Library) -> None:
        self._translation = translation
        self._library = library
        self._objects: dict[Leaf, ExternalObject] = {}
        self.number = next(_COMPILATIONS)
        """Tells the functions of this compilation from those of others in one process; never printed."""
        self._sites = 0
        self.orders = 0
        """How many derivatives of functions are being inlined within each other."""

    @cached_property
    def files(self) -> Files:
        """What the model may read: below the library path, and below the folders of its own files."""
        own = self._library.own_folders()
        roots = (*self._library.directories, *own)
        return Files(roots, own[0] if own else Path.cwd(), self._folder_of)

    def next_site(self) -> int:
        """A number for every call that must not be merged with another one."""
        self._sites += 1
        return self._sites

    def object(self, leaf: Leaf) -> ExternalObject:
        """The object that a component holds. Raises `TypeProblem` `external.object`."""
        found = self._objects.get(leaf)
        if found is None:
            found = self._objects[leaf] = named(self._built(leaf), leaf.path)
        return found

    def _built(self, leaf: Leaf) -> ExternalObject:
        binding = leaf.binding
        if binding is None:
            message = f"the external object `{leaf.path}` is not constructed"
            raise type_error("external.object", message, leaf.span, "", (leaf.path,))
        item = as_scalar(self._translation.binding_value(binding), binding.span).item
        other = self._translation.leaf(item.name) if item.op == "sym" else None
        if other is not None and other is not leaf:
            return self.object(other)
        if item.op == "call" and isinstance(item.kernel, ExternalObject):
            return item.kernel
        message = f"the value of `{leaf.path}` is no external object known at compile time"
        raise type_error("external.object", message, binding.span, "", (leaf.path,))

    def _folder_of(self, package: str) -> Path | None:
        first, *rest = package.split(".")
        node = self._library.top_level(first)
        folder = None if node is None else node.folder
        for part in rest:
            node = None if node is None else node.child(part)
            if node is None:
                return None
            folder = node.folder or folder
        return folder
