"""`acausal check PACKAGE --recursive`: a table of all models of a package, passed or the reason."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from time import perf_counter

from acausal.cli.commands import Target
from acausal.cli.output import print_json, print_table, print_text
from acausal.cli.workers import Bounds, available_cores, checked
from acausal.errors import UsageProblem, fail
from acausal.lang.library import Library
from acausal.survey import Finding, survey_classes

_REASON = 160


@dataclass(frozen=True)
class Selection:
    """The settings of `acausal check --recursive`, as they were typed."""

    recursive: bool
    examples: bool
    timeout: float | None
    memory: int | None
    jobs: int | None

    def verify(self) -> None:
        """Raises `UsageProblem` for settings that cannot be, or mean nothing without `--recursive`."""
        given = {"--examples": self.examples, "--timeout": self.timeout is not None}
        given |= {"--memory": self.memory is not None, "--jobs": self.jobs is not None}
        for option, is_given in given.items():
            if is_given and not self.recursive:
                hint = "add --recursive"
                raise fail(UsageProblem, "usage.recursive", f"{option} is about a whole package", hint=hint)
        for option, value in {
            "--timeout": self.timeout,
            "--memory": self.memory,
            "--jobs": self.jobs,
        }.items():
            if value is not None and not 0 < value < 1e9:
                raise fail(UsageProblem, "usage.recursive", f"{option} must be a positive number")

    @property
    def bounds(self) -> Bounds:
        return Bounds(self.timeout or 60.0, self.memory or 1024, self.jobs or available_cores())


def run_survey(target: Target, selection: Selection, *, as_json: bool) -> int:
    """Check everything, print the table or the JSON list; the exit status is 1 when anything failed."""
    if target.assignments:
        problem = "-p modifies one model and cannot be combined with --recursive"
        raise fail(UsageProblem, "usage.recursive", problem)
    began = perf_counter()
    library, roots = loaded(target)
    classes = [found for root in roots for found in survey_classes(library.find(root), selection.examples)]
    known = {found.model: found for found in classes if isinstance(found, Finding)}
    names = [found for found in classes if isinstance(found, str)]
    progress = _Progress(len(names))
    for finding in checked(library, partial(_library, target), names, selection.bounds):
        known[finding.model] = finding
        progress.step(finding)
    progress.end()
    findings = [known[found if isinstance(found, str) else found.model] for found in classes]
    if as_json:
        print_json([finding.to_json() for finding in findings])
    else:
        print_findings(findings, perf_counter() - began)
    return 0 if all(finding.passed for finding in findings) else 1


def loaded(target: Target) -> tuple[Library, list[str]]:
    """The library, and the classes to start from: the named one, or all of a file.

    A folder with a `package.mo` is that package. Raises `UsageProblem`, `LookupProblem`, `SyntaxProblem`.
    """
    text = target.model
    if (Path(text) / "package.mo").is_file():
        target = Target(str(Path(text) / "package.mo"), target.class_name, target.path, target.assignments)
    model = target.load()
    given = model.library.given
    whole_file = target.class_name is None and model.name in given
    return model.library, given if whole_file else [model.name]


def _library(target: Target) -> Library:
    return loaded(target)[0]


def print_findings(findings: list[Finding], seconds: float) -> None:
    """The table, for people, and how many passed."""
    if findings:
        titles = ("model", "result", "equations", "variables", "seconds", "reason")
        print_table([_row(finding) for finding in findings], titles, right=(2, 3, 4))
        print_text("")
    passed = sum(finding.passed for finding in findings)
    print_text(f"{passed} of {len(findings)} passed in {seconds:.1f} s")


def _row(finding: Finding) -> tuple[str, ...]:
    reason = finding.reason if len(finding.reason) <= _REASON else finding.reason[: _REASON - 3] + "..."
    counts = ("" if n is None else str(n) for n in (finding.equations, finding.variables))
    return finding.model, "passed" if finding.passed else "failed", *counts, f"{finding.seconds:.2f}", reason


class _Progress:
    """One line on standard error that says how far it is, when a person is looking."""

    def __init__(self, total: int) -> None:
        self._total = total
        self._done = 0
        self._failed = 0
        self._shown = sys.stderr.isatty()

    def step(self, finding: Finding) -> None:
        self._done += 1
        self._failed += not finding.passed
        if self._shown:
            line = f"{self._done}/{self._total}, {self._failed} failed  {finding.model}"
            print(f"\r\x1b[K{line[:100]}", end="", file=sys.stderr, flush=True)

    def end(self) -> None:
        if self._shown:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)
