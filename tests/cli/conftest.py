"""A working directory with a model in it, and calls."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.calls import TANK, Call


@pytest.fixture
def call(capsys: pytest.CaptureFixture[str]) -> Call:
    return Call(capsys)


@pytest.fixture(autouse=True)
def working_directory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "Tank.mo").write_text(TANK)
    return tmp_path
