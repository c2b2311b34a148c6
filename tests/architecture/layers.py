"""Who imports whom in acausal, and the order in which that is allowed."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "acausal"

# From the bottom up. A module belongs to the longest prefix that names it; it may import its own prefix and
# anything in a lower layer. Two prefixes in one layer do not know each other.
LAYERS: tuple[tuple[str, ...], ...] = (
    ("acausal.errors", "acausal.symbolic.graphs", "acausal.version"),
    ("acausal.symbolic.expressions",),
    ("acausal.externals",),
    ("acausal.lang",),
    ("acausal.symbolic",),
    ("acausal.codegen", "acausal.plotting", "acausal.results", "acausal.runtime"),
    ("acausal.simulate",),
    ("acausal.pipeline",),
    ("acausal.analysis",),
    ("acausal.study",),
    ("acausal.explain", "acausal.export", "acausal.sources", "acausal.summary"),
    ("acausal.api",),
    ("acausal.notebook", "acausal.survey"),
    ("acausal",),
    ("acausal.cli", "acausal.demo"),
    ("acausal.__main__",),
)
RANKS = {prefix: rank for rank, layer in enumerate(LAYERS) for prefix in layer}


@dataclass(frozen=True)
class Edge:
    """`importer` imports `imported` on line `line`."""

    importer: str
    imported: str
    line: int


def prefix_of(module: str) -> str | None:
    """The longest prefix in `LAYERS` that names `module`; the package's own name stands only for itself."""
    parts = module.split(".")
    prefixes = (".".join(parts[:n]) for n in range(len(parts), 0, -1))
    found = next((prefix for prefix in prefixes if prefix in RANKS), None)
    return None if found == "acausal" != module else found


def is_allowed(edge: Edge) -> bool:
    """Whether the edge stays within its prefix or points down."""
    importer, imported = prefix_of(edge.importer), prefix_of(edge.imported)
    if importer is None or imported is None:
        return False
    return importer == imported or RANKS[imported] < RANKS[importer]


def module_name(path: Path, root: Path) -> str:
    """The dotted name under which `path` is imported."""
    parts = path.relative_to(root).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def modules(root: Path = ROOT) -> dict[str, Path]:
    """Every module of the package, by name."""
    return {module_name(path, root): path for path in sorted((root / "acausal").rglob("*.py"))}


def edges(name: str, text: str, known: frozenset[str]) -> Iterator[Edge]:
    """Every import of acausal's own modules in one text, wherever it stands, also under TYPE_CHECKING."""
    for node in ast.walk(ast.parse(text)):
        match node:
            case ast.Import():
                targets = [alias.name for alias in node.names]
            case ast.ImportFrom(module=str(base), level=0):
                targets = [_submodule_or_base(base, alias.name, known) for alias in node.names]
            case _:
                continue
        for target in targets:
            if target.split(".")[0] == "acausal":
                yield Edge(name, target, node.lineno)


def _submodule_or_base(base: str, name: str, known: frozenset[str]) -> str:
    return f"{base}.{name}" if f"{base}.{name}" in known else base
