"""The models of this folder: one `.mo` per language feature, and what each must come to."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from acausal.errors import AcausalError, Diagnostic, Source
from acausal.lang.base_modelica import print_flat
from acausal.lang.flat import FlatModel
from acausal.lang.library import Library
from acausal.lang.parser import parse
from acausal.pipeline import compile_model

FOLDER = Path(__file__).parent
FEATURES = sorted(FOLDER.glob("*.mo"))
INVALID = sorted((FOLDER / "invalid").glob("*.mo"))

_EXPECTED = re.compile(
    r"^// error: (?P<code>\S+) line (?P<line>\d+|none)(?: names (?P<names>.*?))?(?: says (?P<says>.*))?$"
)


@dataclass(frozen=True)
class ExpectedError:
    """What the first line of an invalid model says: `// error: CODE line N names a, b says TEXT`."""

    code: str
    line: int | None
    names: tuple[str, ...]
    says: str

    def matches(self, diagnostic: Diagnostic) -> bool:
        line = None if diagnostic.span is None else diagnostic.span.line
        return (
            diagnostic.code == self.code
            and line == self.line
            and all(name in diagnostic.names for name in self.names)
            and self.says in diagnostic.message
        )


def expected_error(text: str) -> ExpectedError:
    found = _EXPECTED.match(text.partition("\n")[0])
    assert found is not None, "the first line must be `// error: CODE line N names a, b says TEXT`"
    line = None if found["line"] == "none" else int(found["line"])
    names = tuple(name.strip() for name in (found["names"] or "").split(", ") if name.strip())
    return ExpectedError(found["code"], line, names, found["says"] or "")


def flat_model(text: str, path: str = "test.mo") -> FlatModel:
    """The flat model of `Test`, or of the class `Test` inside the last one of the text."""
    library = Library()
    stored = parse(Source(path, text))
    nodes = [library.add(definition) for _, definition in stored.classes]
    last = nodes[-1]
    name = last.path if last.child("Test") is None else f"{last.path}.Test"
    flat = compile_model(library, name, stop_after="flat").flat
    assert flat is not None
    return flat


def flat_text(text: str, path: str = "test.mo") -> str:
    return print_flat(flat_model(text, path))


def diagnostics(text: str) -> tuple[Diagnostic, ...]:
    """What the compiler says about a model; nothing if it accepts it."""
    try:
        flat_model(text)
    except AcausalError as error:
        return error.diagnostics
    return ()
