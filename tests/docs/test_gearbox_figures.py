"""The figures of the page on the gearbox: each that the page shows is one that the script draws."""

from __future__ import annotations

import re

from tests.docs.examples import ROOT


def test_every_figure_is_there_and_can_be_drawn_again() -> None:
    page = (ROOT / "docs" / "gearbox.md").read_text(encoding="utf-8")
    script = (ROOT / "docs" / "draw_gearbox.py").read_text(encoding="utf-8")
    shown = set(re.findall(r"\(figures/(gearbox-[\w-]+)\.svg\)", page))
    drawn = set(re.findall(r'save\(figure, "(gearbox-[\w-]+)"\)', script))
    kept = {path.stem for path in (ROOT / "docs" / "figures").glob("gearbox-*.svg")}
    assert shown == drawn == kept
