"""Source text, spans and typed diagnostics: the one way anything in acausal says that a model is wrong.

Every stage raises a subclass of `AcausalError`, which carries one or more `Diagnostic`s. A diagnostic
names the model's own variables, points at the source line and says what to try. Nothing else in the
package prints or formats errors.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal, TypeVar, dataclass_transform

Severity = Literal["error", "warning"]


_T = TypeVar("_T")
_Problem = TypeVar("_Problem", bound="AcausalError")


@dataclass_transform(frozen_default=True)
def _light_value(cls: type[_T]) -> type[_T]:
    """A value type that is immutable to the type checker and a plain slotted dataclass at run time.

    A frozen dataclass takes four times as long to build, and the parser builds a `Span` per node.
    """
    return dataclass(slots=True, eq=True, unsafe_hash=True)(cls)


@dataclass(frozen=True)
class Source:
    """One Modelica text and where it came from (`path` is a file name or a label such as `<string>`)."""

    path: str
    text: str = field(repr=False)

    @cached_property
    def _line_starts(self) -> list[int]:
        starts = [0]
        position = self.text.find("\n")
        while position >= 0:
            starts.append(position + 1)
            position = self.text.find("\n", position + 1)
        return starts

    def position(self, offset: int) -> tuple[int, int]:
        """Line and column, both counted from 1, of a character offset."""
        line = bisect_right(self._line_starts, offset)
        return line, offset - self._line_starts[line - 1] + 1

    def line_text(self, line: int) -> str:
        """The text of line `line` (counted from 1) without its line end."""
        start = self._line_starts[line - 1]
        end = self._line_starts[line] - 1 if line < len(self._line_starts) else len(self.text)
        return self.text[start:end].rstrip("\r")


@_light_value
class Span:
    """A piece of a source text: characters `start` (included) to `end` (excluded)."""

    source: Source
    start: int
    end: int

    @property
    def file(self) -> str:
        return self.source.path

    @property
    def line(self) -> int:
        return self.source.position(self.start)[0]

    @property
    def column(self) -> int:
        return self.source.position(self.start)[1]

    @property
    def text(self) -> str:
        return self.source.text[self.start : self.end]

    def __str__(self) -> str:
        line, column = self.source.position(self.start)
        return f"{self.file}:{line}:{column}"


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One thing that is wrong; `code` is stable (`lookup.unknown-name`), `names` are the model's own."""

    code: str
    message: str
    span: Span | None = None
    names: tuple[str, ...] = ()
    hint: str = ""
    severity: Severity = "error"

    def to_json(self) -> dict[str, object]:
        """The contract's JSON object: severity, code, message, file, line, column, names, hint."""
        return {
            "severity": self.severity,
            "code": self.code,
            "message": self.message,
            "file": self.span.file if self.span else None,
            "line": self.span.line if self.span else None,
            "column": self.span.column if self.span else None,
            "names": list(self.names),
            "hint": self.hint,
        }

    def render(self) -> str:
        """Text for a terminal: `file:line:column: severity: message`, the source line, carets, the hint."""
        where = f"{self.span}: " if self.span else ""
        lines = [f"{where}{self.severity}: {self.message} [{self.code}]"]
        if self.span is not None:
            lines += _quote(self.span)
        if self.hint:
            lines.append(f"  hint: {self.hint}")
        return "\n".join(lines)


def _quote(span: Span, width: int = 110) -> list[str]:
    """The span's first line with carets under it; long lines are cut around the span."""
    line, column = span.source.position(span.start)
    text = span.source.line_text(line).replace("\t", " ")
    length = max(1, min(span.end - span.start, len(text) - column + 1))
    cut = max(0, column - 1 - width // 2) if len(text) > width else 0
    shown = text[cut : cut + width]
    carets = "^" * max(1, min(length, width - (column - 1 - cut)))
    number = f"{line:>5} | "
    return [number + shown, " " * (len(number) - 2) + "| " + " " * (column - 1 - cut) + carets]


class AcausalError(Exception):
    """Base of every error a model or its use can cause; carries the diagnostics, never a bare text."""

    def __init__(self, diagnostics: Diagnostic | Sequence[Diagnostic]) -> None:
        self.diagnostics: tuple[Diagnostic, ...] = (
            (diagnostics,) if isinstance(diagnostics, Diagnostic) else tuple(diagnostics)
        )
        super().__init__("\n".join(d.render() for d in self.diagnostics))

    @property
    def codes(self) -> tuple[str, ...]:
        return tuple(d.code for d in self.diagnostics)

    def _render_traceback_(self) -> list[str]:
        """What IPython and notebooks show: the diagnostics, since a traceback says nothing about a model."""
        return [type(self).__name__, *str(self).splitlines()]


class SyntaxProblem(AcausalError):
    """The text is not Modelica (lexer and parser)."""


class LookupProblem(AcausalError):
    """A name, class or library cannot be found, or is found in a forbidden way."""


class TypeProblem(AcausalError):
    """Types, array sizes, variability, modifications or connectors do not fit."""


class UnitProblem(AcausalError):
    """Both sides of an equation declare units that provably differ."""


class BalanceProblem(AcausalError):
    """Too many or too few equations, or a structurally singular system."""


class ReductionProblem(AcausalError):
    """Index reduction or state selection fails: a jump in a prescribed quantity, redundant constraints."""


class InitializationProblem(AcausalError):
    """The initial problem is over- or under-determined, inconsistent, or does not converge."""


class UnsupportedProblem(AcausalError):
    """Valid Modelica that this version refuses by name."""


class SimulationProblem(AcausalError):
    """A run failed: not-a-number, divergent loop, failed assertion, solver failure."""


class UsageProblem(AcausalError):
    """The command line or the Python interface was used wrongly (exit code 2)."""


def fail(
    kind: type[_Problem],
    code: str,
    message: str,
    span: Span | None = None,
    *,
    names: Iterable[str] = (),
    hint: str = "",
) -> _Problem:
    """Build a typed error with one diagnostic: `raise fail(LookupProblem, "lookup.unknown-name", ...)`."""
    return kind(Diagnostic(code, message, span, tuple(names), hint))
