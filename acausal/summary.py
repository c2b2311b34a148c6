"""What a compilation came to, as the JSON of `acausal compile`."""

from __future__ import annotations

from acausal.pipeline import Compilation


def summary_of(compilation: Compilation) -> dict[str, object]:
    """The JSON of `acausal compile`, as far as the compilation went."""
    summary: dict[str, object] = {"model": compilation.node.path}
    flat, causal = compilation.flat, compilation.causal
    if flat is not None:
        summary |= {"model": flat.name, "equations": flat.equation_count, "variables": len(flat.unknowns)}
    if causal is not None:
        largest = max(causal.blocks, key=lambda b: b.size, default=None)
        summary |= {
            "aliases": len(causal.aliases),
            "index": causal.index,
            "states": list(causal.states),
            "blocks": {
                "count": len(causal.blocks),
                "largest": largest.size if largest is not None else 0,
                "largest_torn": max((len(b.tearing) for b in causal.blocks), default=0),
            },
            "zero_crossings": len(causal.zero_crossings),
        }
        if causal.removed is not None:
            summary["removed"] = {
                "for": list(causal.removed.outputs),
                "equations": causal.removed.equation_count,
                "variables": len(causal.removed.variables),
            }
    summary["seconds"] = dict(compilation.seconds)
    return summary
