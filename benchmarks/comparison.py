"""How long other compilers take for the same texts, and whether they arrive at the same values.

Timed: acausal from text to ready functions, and the same with a run of one second; rumoca's
`Session.load`, and the same with a run of one second; pymoca's parsing and CasADi generation. Imports never.
They do not do the same work: rumoca leaves its structural work to the first run, so that the second pair is
the comparable one; pymoca keeps arrays whole and neither flattens to scalars, sorts nor reduces the index.
Both runs are at the tool's default tolerance and solver. `value` is one variable after one second. One
run each in a process of its own, with a time limit; a tool that fails is a row that says so.
"""

from __future__ import annotations

from collections.abc import Iterator
from importlib.util import find_spec

from benchmarks.measure import TOOLS, Row, measured
from benchmarks.models import NETWORKS

SIZES = (1_000, 10_000)
TIME_LIMIT = 60.0
QUICK_TIME_LIMIT = 20.0
CELLS = 800
RELATIVE_SIZE = 13 * CELLS + 4
OTHERS = ("equations on arrays", "mechanical chain written out", "electrical chain written out")


def rows(*, quick: bool) -> Iterator[Row]:
    """The relative chain, then every network and the others, by tool and size."""
    limit = QUICK_TIME_LIMIT if quick else TIME_LIMIT
    sizes = SIZES[:1] if quick else SIZES
    for tool in installed():
        yield row("relative chain", RELATIVE_SIZE, tool, limit)
    for model in (*NETWORKS, *OTHERS):
        for tool in installed():
            for size in sizes:
                found = row(model, size, tool, limit)
                yield found
                if found["note"]:
                    break  # what fails or takes too long is not tried at a larger size


def installed() -> list[str]:
    """The tools there are."""
    return [tool for tool in TOOLS if find_spec(tool.split(maxsplit=1)[0]) is not None]


def row(model: str, size: int, tool: str, limit: float) -> Row:
    """One measurement; `note` says why there is none."""
    cost = measured(model, size, tool, 1, limit)
    start: Row = {"model": model, "equations": size, "tool": tool}
    if isinstance(cost, str):
        return start | {"cpu_s": "", "wall_s": "", "MiB": "", "value": "", "note": cost}
    value = f"{cost.facts['value']:.7g}" if "value" in cost.facts else ""
    times: Row = {"cpu_s": round(cost.cpu, 2), "wall_s": round(cost.wall, 2), "MiB": round(cost.mib)}
    return start | times | {"value": value, "note": ""}
