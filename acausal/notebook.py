"""`%load_ext acausal` gives a notebook the cell magic `%%modelica`, which makes models of a cell's text."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Protocol

from acausal.api import Model
from acausal.errors import Source, UsageProblem, fail
from acausal.lang.ast import ClassDefinition
from acausal.lang.library import Library, library_directories
from acausal.lang.parser import parse
from acausal.sources import add_source


class Shell(Protocol):
    """What is used of IPython's `InteractiveShell`, which declares few types."""

    def push(self, variables: Mapping[str, object]) -> None: ...
    def register_magic_function(
        self, func: Callable[[str, str], object], magic_kind: str, magic_name: str
    ) -> None: ...


class Cells:
    """The classes that the cells of one notebook declare; running a cell again replaces what it declared."""

    def __init__(self) -> None:
        self._classes: dict[str, ClassDefinition] = {}

    def add(self, text: str, name: str | None = None) -> Model:
        """The last class of `text`, or `name`; classes of other cells can be used. Raises `AcausalError`."""
        source = Source("<cell>", text)
        new = {definition.name: definition for _, definition in parse(source).classes}
        library = Library(library_directories())
        for old, definition in self._classes.items():
            if old not in new:
                library.add(definition)
        model = Model(library, add_source(library, source, name, None))
        self._classes |= new
        return model


def load_ipython_extension(shell: Shell) -> None:
    """What IPython calls for `%load_ext acausal`."""
    cells = Cells()

    def modelica(line: str, cell: str) -> Model:
        """`%%modelica [NAME]`: the cell's last class, or NAME, becomes a `Model` under its own name."""
        model = cells.add(cell, line.strip() or None)
        variable = model.name.split(".")[-1]
        if not variable.isidentifier():
            raise fail(UsageProblem, "usage.class", f"{variable} cannot be the name of a Python variable")
        shell.push({variable: model})
        return model

    shell.register_magic_function(modelica, magic_kind="cell", magic_name="modelica")
