"""Which classes of a package can be checked, and what each check comes to: `acausal check --recursive`.

Models share the parsed library and the scopes of its classes, so that what many of them use is read and
looked up once. One failing model never hides another: every way a check can end becomes a `Finding`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from time import perf_counter

from acausal.api import check_flat
from acausal.errors import AcausalError, Diagnostic
from acausal.lang import ast
from acausal.lang.library import ClassNode, Library
from acausal.lang.scope import Root
from acausal.pipeline import compile_model
from acausal.summary import summary_of

_CHECKED = ("model", "block", "class")


@dataclass(frozen=True)
class Finding:
    """What the check of one class came to; counts are None where it did not get so far."""

    model: str
    passed: bool
    equations: int | None = None
    variables: int | None = None
    seconds: float = 0.0
    diagnostics: tuple[dict[str, object], ...] = ()

    def to_json(self) -> dict[str, object]:
        return {**asdict(self), "diagnostics": list(self.diagnostics)}

    @property
    def reason(self) -> str:
        """Why it failed, on one line; "" when it passed."""
        errors = [d for d in self.diagnostics if d["severity"] == "error"]
        return "" if self.passed or not errors else f"[{errors[0]['code']}] {errors[0]['message']}"


def failed(model: str, problems: Sequence[Diagnostic], seconds: float = 0.0) -> Finding:
    """The finding of a class that did not pass."""
    return Finding(model, False, None, None, seconds, tuple(p.to_json() for p in problems))


# --------------------------------------------------------------------------- which classes


def survey_classes(node: ClassNode, examples_only: bool = False) -> Iterator[str | Finding]:
    """Full names of all models and blocks that can be checked, in the order of the package.

    Partial classes and the protected parts of packages are left out, classes inside models too. With
    `examples_only` just those with an `experiment` annotation. A file that cannot be read is a finding.
    """
    definition = node.definition
    if definition.kind in _CHECKED and not definition.class_prefixes.partial:
        if not examples_only or has_experiment(definition):
            yield node.path
    elif definition.kind == "package" and isinstance(definition, ast.LongClass):
        for name in node.ordered_names():
            try:
                child = node.child(name)
            except AcausalError as error:
                yield failed(f"{node.path}.{name}", error.diagnostics)
                continue
            if child is not None and not child.definition.prefixes.protected:
                yield from survey_classes(child, examples_only)


def has_experiment(definition: ast.ClassDefinition) -> bool:
    """Whether the class says in its annotation how it is to be simulated (Modelica 3.6, 18.4)."""
    if isinstance(definition, ast.LongClass):
        notes = definition.body.annotation
    else:
        notes = definition.comment.annotation
    return notes is not None and any(
        isinstance(argument, ast.ElementModification) and argument.name == ("experiment",)
        for argument in notes.arguments
    )


# --------------------------------------------------------------------------- one check


class Surveyor:
    """Checks classes of one library, one after the other, keeping what they have in common."""

    def __init__(self, library: Library) -> None:
        self._root = Root(library)

    def check(self, name: str) -> Finding:
        """The finding about one class. Raises `MemoryError` only."""
        began = perf_counter()
        try:
            compilation = compile_model(self._root.library, name, stop_after="flat", root=self._root)
            assert compilation.flat is not None
            counts = summary_of(compilation)
            check_flat(compilation.flat)
        except AcausalError as error:
            return failed(name, error.diagnostics, perf_counter() - began)
        except MemoryError:
            raise
        except Exception as error:
            what = f"internal error, {type(error).__name__}: {error}".splitlines()[0]
            return failed(name, [Diagnostic("internal", what)], perf_counter() - began)
        warnings = tuple(warning.to_json() for warning in compilation.warnings)
        equations, variables = counts["equations"], counts["variables"]
        assert isinstance(equations, int)
        assert isinstance(variables, int)
        return Finding(name, True, equations, variables, perf_counter() - began, warnings)
