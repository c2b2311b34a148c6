"""The page stands alone and injects nothing; drawings are small and quick for large systems."""

from __future__ import annotations

from html.parser import HTMLParser
from pathlib import Path

import pytest

from acausal.errors import UsageProblem
from acausal.explain.explanation import Explanation
from tests.explain.models import PENDULUM, chain, explained
from tests.growth import Work, growth

VOID = {"meta", "br"}


class Checker(HTMLParser):
    """Collects what a page refers to and notes tags that are not closed."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: set[str] = set()
        self.links: list[str] = []
        self.anchors: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)
        if tag not in VOID:
            self.open.append(tag)
        for name, value in attrs:
            if name in ("href", "src", "xlink:href"):
                self.links.append(value or "")
            if name == "id":
                self.anchors.append(value or "")
            assert not name.startswith("on"), "an event handler is a script"

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def checked(page: str) -> Checker:
    checker = Checker()
    checker.feed(page)
    checker.close()
    assert not checker.open
    return checker


@pytest.fixture(scope="module")
def pendulum() -> Explanation:
    return explained(PENDULUM)


@pytest.mark.parametrize("text", [PENDULUM, chain(60)])
def test_the_page_needs_nothing_else(text: str) -> None:
    found = checked(explained(text).html())
    assert {"svg", "details"} <= found.tags
    assert not {"script", "link", "iframe"} & found.tags
    assert all(link.startswith(("#", "data:")) for link in found.links)
    assert {link[1:] for link in found.links if link.startswith("#")} <= set(found.anchors)


def test_the_page_has_everything(pendulum: Explanation) -> None:
    page = pendulum.html()
    for part in (
        "A point mass on a rod",
        "twice, by index reduction",
        "x solved for instead of y",
        "linear block of 3, torn to 1",
        '<a href="#block-2">2</a>',
        "nobody gave it",
        "x &gt; 0",
        "Initial system, in order",
    ):
        assert part in page


def test_nothing_is_cut_from_the_page_but_from_a_cell() -> None:
    explanation = explained(chain(100))
    assert "v[100]" in explanation.html()
    assert "more lines" not in explanation.html()
    cell = explanation._repr_html_()  # pyright: ignore[reportPrivateUsage]
    assert "more lines" in cell
    checked(cell)
    assert not checked(cell).anchors


def test_names_inject_nothing(tmp_path: Path) -> None:
    evil = "</code><script>alert(1)</script>$x_$"
    text = f'model M "{evil}" Real \'{evil}\'(unit = "{evil}") "{evil}"; Real y = 2*\'{evil}\'; '
    explanation = explained(f"{text} equation der('{evil}') = if y > 0 then -1 else 1; end M;")
    assert "script" not in checked(explanation.html()).tags
    explanation.plot(tmp_path / "evil.png")
    assert explanation.block_text(1, latex=True)


@pytest.mark.parametrize(("ending", "magic"), [("png", b"\x89PNG"), ("svg", b"<?xml"), ("pdf", b"%PDF")])
def test_plots_are_files_of_their_kind_and_the_same_every_time(
    pendulum: Explanation, tmp_path: Path, ending: str, magic: bytes
) -> None:
    first, second = tmp_path / f"a.{ending}", tmp_path / f"b.{ending}"
    pendulum.plot(first)
    pendulum.plot(second)
    assert first.read_bytes() == second.read_bytes()
    assert first.read_bytes().startswith(magic)


def test_other_endings_are_refused(pendulum: Explanation, tmp_path: Path) -> None:
    with pytest.raises(UsageProblem):
        pendulum.plot(tmp_path / "a.bmp")


def test_drawing_ten_thousand_equations_takes_no_longer_for_each(tmp_path: Path) -> None:
    def prepare(equations: int) -> Work:
        explanation = explained(chain(equations // 5))
        assert len(explanation.system.flat.equations) == equations
        return lambda: explanation.plot(tmp_path / "large.svg")

    assert growth(prepare, 1_000, 10_000, repeats=1) < 2
    assert (tmp_path / "large.svg").stat().st_size < 3_000_000
