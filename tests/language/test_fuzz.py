"""Broken models end in a typed error or a proven flat model: never in a Python exception, never in a hang."""

from __future__ import annotations

from pathlib import Path
from time import process_time

import pytest

from tests.language.models import FEATURES, INVALID, diagnostics
from tests.language.mutations import mutations

MOST_SECONDS = 2.0
EACH = 4


@pytest.mark.parametrize("path", [*FEATURES, *INVALID[::8]], ids=lambda path: path.stem)
def test_only_typed_errors_come_out(path: Path) -> None:
    for text in mutations(path.read_text(), path.stem, EACH):
        start = process_time()
        found = diagnostics(text)
        assert process_time() - start < MOST_SECONDS, text
        assert all(d.code and d.message for d in found)


def test_mutations_are_reproducible() -> None:
    text = next(path for path in FEATURES if path.stem == "annotations").read_text()
    assert list(mutations(text, "seed", 5)) == list(mutations(text, "seed", 5))
    assert all(mutant != text for mutant in mutations(text, "seed", 5))
