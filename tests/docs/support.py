"""The list of what is supported of the specification, its proofs, and the page made from it."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
LIST = ROOT / "docs" / "support.toml"
PAGE = ROOT / "docs" / "support.md"
MODELS = ROOT / "tests" / "language"

STATUSES = ("supported", "partial", "refused")
_CODE = re.compile(r'"(unsupported\.[A-Za-z-]+)"')

_HEAD = """\
# Supported parts of the specification

Section numbers are those of the Modelica Language Specification 3.6. *Supported* means that the models named
here come to the flat text beside them; *refused* that the compiler says so at the place, with the code named
here. What is partly supported says what is missing. The page is made from `docs/support.toml`, and a test
holds it against the code.

| section | what | status | shown by |
|---|---|---|---|
"""


@dataclass(frozen=True)
class Entry:
    """One line of the page."""

    section: str
    title: str
    status: str
    note: str = ""
    tests: tuple[str, ...] = ()
    files: tuple[str, ...] = ()
    codes: tuple[str, ...] = ()
    others: frozenset[str] = field(default_factory=frozenset[str])
    """Keys that mean nothing."""

    def faults(self) -> Iterator[str]:
        """What is wrong with the entry on its own."""
        if self.status not in STATUSES:
            yield f"the status is {self.status!r}"
        if self.others:
            yield f"unknown keys {sorted(self.others)}"
        if self.status == "partial" and not self.note:
            yield "a note must say what is missing"
        if self.status != "refused" and not (self.tests or self.files):
            yield "nothing shows it"
        if self.status == "refused" and not self.codes:
            yield "no code refuses it"
        for name in self.tests:
            if not (MODELS / f"{name}.mo").is_file():
                yield f"there is no model {name}"
            elif "/" not in name and not (MODELS / f"{name}.flat").is_file():
                yield f"{name} has no flat text"
        for name in self.files:
            if not (ROOT / name).is_file():
                yield f"there is no file {name}"

    def line(self) -> str:
        """The row of the page."""
        shown = [f"`{name}`" for name in (*self.tests, *(Path(f).stem for f in self.files), *self.codes)]
        status = self.status if not self.note else f"{self.status}: {self.note}"
        return f"| {self.section} | {self.title} | {status} | {', '.join(shown)} |\n"


def read_entries(text: str) -> list[Entry]:
    """The entries of the list, in its order."""
    data: list[dict[str, Any]] = tomllib.loads(text)["entry"]
    return [_entry(item) for item in data]


def _entry(item: dict[str, Any]) -> Entry:
    known = ("section", "title", "status", "note", "tests", "files", "codes")
    return Entry(
        str(item["section"]),
        str(item["title"]),
        str(item["status"]),
        str(item.get("note", "")),
        tuple(item.get("tests", ())),
        tuple(item.get("files", ())),
        tuple(item.get("codes", ())),
        frozenset(item) - frozenset(known),
    )


def page_text(entries: list[Entry]) -> str:
    """The page as Markdown."""
    return _HEAD + "".join([entry.line() for entry in entries])


def refusing_codes() -> set[str]:
    """The codes `unsupported.*` that the compiler can give."""
    from acausal.lang.builtins import NOT_YET

    texts = [path.read_text(encoding="utf-8") for path in sorted((ROOT / "acausal").rglob("*.py"))]
    return {code for text in texts for code in _CODE.findall(text)} | {f"unsupported.{n}" for n in NOT_YET}
