"""How much smaller tearing makes the loops of all models that come with acausal, and of some networks.

A row for each model with a loop of several unknowns, in the running system: how many loops there are, of how
many unknowns together, how many of those are guessed or solved for after tearing; the same for the largest
loop. The heuristic is that of `acausal.symbolic.graphs.tearing`, with the anchors of `anchoring`.
"""

from __future__ import annotations

from collections.abc import Iterator

import acausal
from acausal.errors import AcausalError
from acausal.lang.library import ClassNode, Library, bundled_directories
from acausal.symbolic.causal import Block, BlockKind, CausalSystem
from benchmarks.loops import SYSTEMS, system_text
from benchmarks.measure import Row

PACKAGES = ("Signals", "Electrical", "Mechanics", "Hydraulics", "TenSpeed")
CELLS, SIDE = 200, 20
"""Of the networks: in a row, and on each side of a grid."""


def rows() -> Iterator[Row]:
    """One row per model that has a loop; the last one counts the models without."""
    without = 0
    for name, system in _systems():
        loops = [block for block in system.blocks if block.size > 1]
        if loops:
            yield _row(name, loops)
        else:
            without += 1
    yield {**_row("models without loops", []), "loops": without}


def _row(name: str, loops: list[Block]) -> Row:
    largest = max(loops, key=lambda block: block.size, default=None)
    return {
        "model": name,
        "loops": len(loops),
        "nonlinear": sum(block.kind is BlockKind.NONLINEAR for block in loops),
        "unknowns": sum(block.size for block in loops),
        "torn": sum(len(block.tearing) for block in loops),
        "largest": largest.size if largest is not None else 0,
        "largest torn": len(largest.tearing) if largest is not None else 0,
    }


def _systems() -> Iterator[tuple[str, CausalSystem]]:
    for name in _names():
        try:
            causal = acausal.load(name).run({}, stop_after="causal").causal
        except AcausalError:
            continue  # a part of a bench: it has parameters without values
        if causal is not None and causal.blocks:
            yield name, causal
    for name in SYSTEMS:
        size = SIDE if name.startswith("grid") else CELLS
        causal = acausal.loads(system_text(name, size), "Net.System").run({}, stop_after="causal").causal
        assert causal is not None
        yield f"{name}, {size}", causal


def _names() -> Iterator[str]:
    """Full names of all examples and benches."""
    library = Library(tuple(bundled_directories()))
    for name in PACKAGES:
        yield from _below(library.find(name))


def _below(node: ClassNode) -> Iterator[str]:
    definition = node.definition
    runs = ".Examples." in node.path or ".Benches." in node.path
    if definition.kind == "model" and not definition.class_prefixes.partial and runs:
        yield node.path
    for name in node.child_names():
        child = node.child(name)
        if child is not None:
            yield from _below(child)
