"""The page of supported features is made from its list, and the list agrees with the code and its tests.

`UPDATE_DOCS=1` writes the page.
"""

from __future__ import annotations

import os

from tests.docs.support import LIST, PAGE, Entry, page_text, read_entries, refusing_codes
from tests.language.models import FEATURES

ENTRIES = read_entries(LIST.read_text(encoding="utf-8"))


def test_every_entry_is_proven() -> None:
    faults = [f"{entry.section} {entry.title}: {fault}" for entry in ENTRIES for fault in entry.faults()]
    assert not faults


def test_every_feature_test_is_listed() -> None:
    listed = {name for entry in ENTRIES for name in entry.tests}
    missing = [path.stem for path in FEATURES if path.stem not in listed]
    assert not missing, f"list them in {LIST.name}"


def test_every_refusal_is_listed_and_none_other() -> None:
    listed = {code for entry in ENTRIES for code in entry.codes if code.startswith("unsupported.")}
    assert sorted(refusing_codes() - listed) == [], f"list them in {LIST.name}"
    assert sorted(listed - refusing_codes()) == [], f"nothing gives these codes of {LIST.name}"


def test_the_page_is_up_to_date() -> None:
    text = page_text(ENTRIES)
    if os.environ.get("UPDATE_DOCS") == "1":
        PAGE.write_text(text, encoding="utf-8")
    assert PAGE.read_text(encoding="utf-8") == text, "UPDATE_DOCS=1 writes it"


def test_wrong_entries_are_found() -> None:
    unproven = Entry("1", "x", "supported")
    assert list(unproven.faults()) == ["nothing shows it"]
    assert list(Entry("1", "x", "refused").faults()) == ["no code refuses it"]
    assert list(Entry("1", "x", "maybe", tests=("records",)).faults()) == ["the status is 'maybe'"]
    assert list(Entry("1", "x", "supported", tests=("nothing",)).faults()) == ["there is no model nothing"]
    partial = Entry("1", "x", "partial", tests=("records",))
    assert list(partial.faults()) == ["a note must say what is missing"]
