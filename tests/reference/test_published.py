"""Examples of the Modelica Standard Library agree with the published reference results.

ACAUSAL_REFERENCES names the folder of the reference results, and MODELICAPATH the library of the same
version. `python -m tests.reference` does the same for any package and writes the table of the documentation.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from acausal.lang.library import Library
from acausal.survey import survey_classes
from tests.reference.judge import AGREES, SIMULATES, judge
from tests.reference.published import Reference, references
from tests.reference.table import PACKAGES, PAGE, TABLE, page_text, read_rows

# The fixture that isolates the tests takes MODELICAPATH away, so it is read when this file is collected.
PATH = [Path(part) for part in os.environ.get("MODELICAPATH", "").split(os.pathsep) if part]
ROOTS = [folder for folder in PATH if (folder / "Modelica" / "package.mo").is_file()][:1]
FOLDER = os.environ.get("ACAUSAL_REFERENCES", "")
READY = bool(ROOTS and FOLDER)
KNOWN = {one.model: one for one in references(Path(FOLDER))} if READY else {}
LONG = ("pulseFFT", "HarmonicDistortion")
"""Examples that take minutes."""


def models() -> list[str]:
    """All examples of the three packages."""
    library = Library(tuple(ROOTS))
    found = [one for p in PACKAGES for one in survey_classes(library.find(p), examples_only=True)]
    return [one for one in found if isinstance(one, str) and not one.endswith(LONG)]


@pytest.mark.msl
@pytest.mark.skipif(not READY, reason="ACAUSAL_REFERENCES and MODELICAPATH do not name results and library")
@pytest.mark.parametrize("model", models() if READY else ["none"])
def test_example_agrees(model: str) -> None:
    reference: Reference | None = KNOWN.get(model)
    verdict = judge(model, ROOTS, reference)
    has_table = reference is not None and reference.table.is_file()
    assert verdict.verdict == (AGREES if has_table else SIMULATES), verdict.reason


def test_the_page_is_up_to_date() -> None:
    text = page_text(read_rows(TABLE))
    if os.environ.get("UPDATE_DOCS") == "1":
        PAGE.write_text(text, encoding="utf-8")
    assert PAGE.read_text(encoding="utf-8") == text, "UPDATE_DOCS=1 writes it"
