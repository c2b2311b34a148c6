"""Every feature's flat text. `UPDATE_FLAT=1` writes it anew: read the difference before keeping it."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.language.models import FEATURES, flat_model, flat_text


@pytest.mark.parametrize("path", FEATURES, ids=lambda path: path.stem)
def test_flat_text(path: Path) -> None:
    text = flat_text(path.read_text(), path.name)
    expected = path.with_suffix(".flat")
    if os.environ.get("UPDATE_FLAT"):
        expected.write_text(text)
    assert text == expected.read_text()


@pytest.mark.parametrize("path", FEATURES, ids=lambda path: path.stem)
def test_is_balanced(path: Path) -> None:
    flat = flat_model(path.read_text(), path.name)
    assert flat.equation_count == len(flat.unknowns)


def test_no_expectation_is_left_over() -> None:
    stems = {path.stem for path in FEATURES}
    assert {path.stem for path in FEATURES[0].parent.glob("*.flat")} == stems
