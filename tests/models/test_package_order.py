"""Every `package.order` names the classes of its folder, each once (Modelica 13.4.1)."""

from __future__ import annotations

from pathlib import Path

import pytest

from acausal.lang.library import bundled_directories

ORDERS = sorted(path for folder in bundled_directories() for path in folder.rglob("package.order"))


def test_there_are_some() -> None:
    assert len(ORDERS) > 5


@pytest.mark.parametrize("order", ORDERS, ids=lambda order: f"{order.parent.parent.name}.{order.parent.name}")
def test_order_names_all_classes_of_the_folder(order: Path) -> None:
    files = [file.stem for file in order.parent.glob("*.mo") if file.name != "package.mo"]
    folders = [entry.name for entry in order.parent.iterdir() if (entry / "package.mo").exists()]
    assert sorted(order.read_text(encoding="utf-8").split()) == sorted(files + folders)
