"""What can be shown of a model that is structurally singular: where equations are too many, where too few."""

from __future__ import annotations

from collections.abc import Iterator

from acausal.explain.folding import listing
from acausal.explain.words import counted, short, where
from acausal.lang.flat import FlatModel
from acausal.symbolic.balance import flat_structure
from acausal.symbolic.describe import equation_text, place
from acausal.symbolic.graphs.dulmage_mendelsohn import Decomposition, Part, decompose
from acausal.symbolic.graphs.matching import maximum_matching
from acausal.symbolic.structure import Structure

_MOST_ROWS, _MOST_TEXT = 20, 160


def singular_text(flat: FlatModel, *, everything: bool = False) -> str:
    """The counts and the decomposition by Dulmage and Mendelsohn; "" where there is nothing wrong with it."""
    system, parts = decomposed(flat)
    if not parts.over.equations and not parts.under.variables:
        return ""
    title = f"{flat.name}: {flat.description}" if flat.description else flat.name
    counts = (
        f"{counted(len(system.equations), 'equation')} in {counted(len(system.unknowns), 'unknown')}, "
        f"{counted(len(parts.well.equations), 'equation')} of which determine as many unknowns by themselves"
    )
    lines = [title, "", "Flat model", f"  {counts}"]
    most = None if everything else _MOST_ROWS
    for name, part in (("Too many equations", parts.over), ("Too few equations", parts.under)):
        lines += _part(system, name, part, most)
    return "\n".join(lines)


def decomposed(flat: FlatModel) -> tuple[Structure, Decomposition]:
    """The structure of a flat model and its parts with too many, too few and just enough equations."""
    system = flat_structure(flat)
    return system, decompose(system.incidence, maximum_matching(system.incidence, len(system.unknowns)))


def _part(system: Structure, title: str, part: Part, most: int | None) -> Iterator[str]:
    """The equations and the unknowns of one part."""
    if not part.equations and not part.variables:
        return
    sizes = f"{counted(len(part.equations), 'equation')} for {counted(len(part.variables), 'unknown')}"
    yield from ("", f"{title}: {sizes}")
    equations = [system.equations[eq] for eq in part.equations]
    yield from listing([f"`{short(equation_text(e), _MOST_TEXT)}` ({where(e)})" for e in equations], most)
    unknowns = [system.unknowns[var] for var in part.variables]
    yield from listing([f"unknown {v.name} ({place(v.span)})" for v in unknowns], most)
