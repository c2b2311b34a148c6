"""Errors that stand in a library's text are shown where the user's own text uses the library."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import contextmanager
from dataclasses import replace

from acausal.errors import AcausalError, Diagnostic, Span
from acausal.lang.flat import FlatModel
from acausal.symbolic.causal import CausalEquation
from acausal.symbolic.describe import place
from acausal.symbolic.expressions.expr import symbols


@contextmanager
def at_users_lines(flat: FlatModel, equations: Sequence[CausalEquation] = ()) -> Generator[None, None, None]:
    """Errors raised inside it point at declarations in the model's own package, if they came from another.

    The place in the library stays in the message. What only adds an equation at the same declaration is left
    out. `equations` are those that the errors may show. O(model), and only where there is an error.
    """
    try:
        yield
    except AcausalError as error:
        moved: list[Diagnostic] = []
        for diagnostic in error.diagnostics:
            found = moved_to_user(flat, diagnostic, equations)
            again = found is not diagnostic and not found.hint and any(d.span == found.span for d in moved)
            moved += [] if again else [found]
        if moved == list(error.diagnostics):
            raise
        raise type(error)(moved) from error.__cause__


def moved_to_user(
    flat: FlatModel, diagnostic: Diagnostic, equations: Sequence[CausalEquation] = ()
) -> Diagnostic:
    """The diagnostic at the innermost component around its place that the model's own package declares."""
    span = diagnostic.span
    if span is None or _is_own(flat, span):
        return diagnostic
    path = _component(flat, span, frozenset(diagnostic.names), equations)
    while path and not ((where := flat.places.components.get(path)) and _is_own(flat, where)):
        path = path.rpartition(".")[0]
    if not path:
        return diagnostic
    known = place(span) in diagnostic.message
    message = diagnostic.message if known else f"{diagnostic.message} ({place(span)} in `{path}`)"
    return replace(diagnostic, message=message, span=flat.places.components[path])


def _is_own(flat: FlatModel, span: Span) -> bool:
    """Whether a text belongs to the package of the model: its file, or a folder with the package's name."""
    own, file = flat.span.file, span.file
    folder = f"/{flat.name.split('.')[0]}/"
    cut = own.find(folder)
    return file == own or (cut >= 0 and file.startswith(own[: cut + len(folder)]))


def _component(
    flat: FlatModel, span: Span, names: frozenset[str], equations: Sequence[CausalEquation]
) -> str:
    """The component that the line is about: one with an equation or a variable of these names there."""
    bases = names | {name.removeprefix("der(").rstrip(")") for name in names}
    for causal in equations:
        if causal.flat.span == span and not bases.isdisjoint(symbols([causal.left, causal.right])):
            return causal.flat.component
    for equation in (*flat.equations, *flat.initial_equations):
        if equation.span == span and not bases.isdisjoint(symbols([equation.left, equation.right])):
            return equation.component or flat.places.owner(
                equation.left.name if equation.left.op == "sym" else ""
            )
    for variable in flat.variables:
        if variable.span == span and variable.name in bases:
            return flat.places.owner(variable.name)
    owners = [flat.places.owner(name) for name in sorted(bases) if name in flat.by_name]
    return max(owners, key=len, default="")
