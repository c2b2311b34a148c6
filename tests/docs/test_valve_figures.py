"""The figures of the page on valves: each that the page shows is one that the script draws."""

from __future__ import annotations

import re

from tests.docs.examples import ROOT


def test_every_figure_is_there_and_can_be_drawn_again() -> None:
    page = (ROOT / "docs" / "valves.md").read_text(encoding="utf-8")
    script = (ROOT / "docs" / "draw_valves.py").read_text(encoding="utf-8")
    shown = set(re.findall(r"\(figures/valve-([\w-]+)\.svg\)", page))
    drawn = {*re.findall(r'^    "([\w-]+)": Picture\(', script, re.MULTILINE), "circuit"}
    kept = {path.stem.removeprefix("valve-") for path in (ROOT / "docs" / "figures").glob("valve-*.svg")}
    assert shown == drawn == kept
