"""Broken models end in a typed error or a proven flat model: never in a Python exception, never in a hang.

`python -m tests.fuzz` does the same with as many texts as one likes; what it found is in `found`.
"""

from __future__ import annotations

from pathlib import Path
from time import process_time

import pytest

from tests.fuzz import texts
from tests.language.models import FEATURES, FOLDER, INVALID, diagnostics
from tests.language.mutations import mutations
from tests.language.sentences import sentence

MOST_SECONDS = 2.0
EACH = 4
FOUND = sorted((FOLDER / "found").glob("*.mo"))


@pytest.mark.parametrize("path", [*FEATURES, *INVALID[::8]], ids=lambda path: path.stem)
def test_only_typed_errors_come_out(path: Path) -> None:
    for text in mutations(path.read_text(), path.stem, EACH):
        behaves(text)


@pytest.mark.parametrize("part", range(10))
def test_sentences(part: int) -> None:
    for number in range(30):
        behaves(sentence(f"{part}:{number}"))


def test_texts_of_all_kinds() -> None:
    for text in texts(100, "small"):
        behaves(text)


@pytest.mark.parametrize("path", FOUND, ids=lambda path: path.stem)
def test_found_cases(path: Path) -> None:
    behaves(path.read_text())


def behaves(text: str) -> None:
    start = process_time()
    found = diagnostics(text)
    assert process_time() - start < MOST_SECONDS, text
    assert all(d.code and d.message for d in found)


def test_mutations_are_reproducible() -> None:
    text = next(path for path in FEATURES if path.stem == "annotations").read_text()
    assert list(mutations(text, "seed", 5)) == list(mutations(text, "seed", 5))
    assert all(mutant != text for mutant in mutations(text, "seed", 5))
    assert sentence("seed") == sentence("seed")
