"""How compile time and memory grow with the model, by stage: nine networks from 1,000 to 100,000 equations,
and six that are one system of equations.

Timed: CPU time from text to ready functions, imports not. `us_*` is per scalar equation of the flat model,
`growth` the total over that of the smallest size, `MiB` the peak of the whole process, Python, CasADi and
the repetitions included. Median of three runs, each model and size in a process of its own; from 100,000
equations on a single run.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from benchmarks.measure import Row, measured
from benchmarks.models import LOOP_CASES, NETWORKS

SIZES = (1_000, 10_000, 100_000)
QUICK_SIZES = (1_000, 10_000)
LOOP_SIZES = (1_000, 10_000, 30_000)
"""Of the networks that are one system of equations."""
ONCE_FROM = 100_000
TIME_LIMIT = 300.0
STAGES = ("parse", "flatten", "causalise", "codegen", "total")


def rows(*, quick: bool) -> Iterator[Row]:
    """One row per network and size."""
    for model in NETWORKS:
        yield from of_model(model, QUICK_SIZES if quick else SIZES)
    for model in LOOP_CASES:
        yield from of_model(model, QUICK_SIZES if quick else LOOP_SIZES)


def of_model(model: str, sizes: Sequence[int]) -> Iterator[Row]:
    """The rows of one network."""
    base = 0.0
    for size in sizes:
        cost = measured(model, size, "acausal compile", 1 if size >= ONCE_FROM else 3, TIME_LIMIT)
        if isinstance(cost, str):
            raise RuntimeError(f"{model} of {size} equations: {cost}")
        equations = int(cost.facts["equations"])
        each = {f"us_{stage}": round(cost.facts[stage] / equations * 1e6, 1) for stage in STAGES}
        base = base or each["us_total"]
        yield {
            "model": model,
            "equations": equations,
            "states": int(cost.facts["states"]),
            **each,
            "growth": round(each["us_total"] / base, 2),
            "MiB": round(cost.mib),
        }
