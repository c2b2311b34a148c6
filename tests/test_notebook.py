"""`%%modelica` in a notebook."""

from __future__ import annotations

import atexit
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, cast

import pytest
from IPython.core.interactiveshell import InteractiveShell
from IPython.utils.capture import capture_output

import acausal


@dataclass(frozen=True)
class Notebook:
    """A shell without a screen. IPython declares few types, hence `Any`."""

    shell: Any

    def run(self, cell: str) -> tuple[BaseException | None, str]:
        """The error that a cell raised, and what it printed."""
        with capture_output() as printed:
            outcome = self.shell.run_cell(cell)
        return cast("BaseException | None", outcome.error_in_exec), printed.stdout + printed.stderr

    def model(self, name: str) -> acausal.Model:
        found = self.shell.user_ns[name]
        assert isinstance(found, acausal.Model)
        return found


@pytest.fixture
def notebook() -> Iterator[Notebook]:
    shell = cast("Any", InteractiveShell())
    shell.run_line_magic("load_ext", "acausal")
    yield Notebook(shell)
    shell.atexit_operations()
    atexit.unregister(shell.atexit_operations)


DECAY = "%%modelica\nmodel Decay\n  Real x(start = 1, fixed = true);\nequation\n  der(x) = -x;\nend Decay;\n"


def test_a_cell_becomes_a_model(notebook: Notebook) -> None:
    error, printed = notebook.run(DECAY)
    assert error is None
    assert "<Model Decay>" in printed
    assert notebook.model("Decay").compile().states == ("x",)


def test_cells_know_each_other_and_can_be_run_again(notebook: Notebook) -> None:
    for cell in (DECAY, "%%modelica\nmodel Two Decay a; Decay b; end Two;", DECAY):
        assert notebook.run(cell)[0] is None
    assert notebook.model("Two").compile().states == ("a.x", "b.x")


def test_a_name_picks_a_class(notebook: Notebook) -> None:
    assert notebook.run("%%modelica P.A\npackage P model A Real x = 1; end A; end P;")[0] is None
    assert notebook.model("A").name == "P.A"


def test_an_error_shows_its_place_and_no_traceback(notebook: Notebook) -> None:
    error, printed = notebook.run("%%modelica\nmodel Wrong\n  Real x = ;\nend Wrong;")
    assert isinstance(error, acausal.AcausalError)
    assert "<cell>:2:12: error:" in printed
    assert "Traceback" not in printed


def test_models_and_plots_show_themselves(notebook: Notebook) -> None:
    notebook.run(DECAY)
    formatted, _ = notebook.shell.display_formatter.format(notebook.model("Decay").compile())
    assert "<h3>Decay</h3>" in formatted["text/html"]
    figure = notebook.model("Decay").compile().simulate().plot("x")
    formatted, _ = notebook.shell.display_formatter.format(figure)
    assert formatted["image/png"].startswith(b"\x89PNG")
