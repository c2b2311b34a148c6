"""How compile time grows with the number of equations, and how it compares.

Timed: text to ready functions, by `compile` of acausal, by `Session.load` of rumoca, by parsing and CasADi
generation of pymoca; imports never. The three do not do the same work: pymoca keeps arrays whole and
neither flattens to scalars, sorts nor reduces the index; rumoca does its structural work when it first
simulates, so that its first run of one second is timed too, beside ours. Every measurement is the median of
three in a process of its own with a time limit; a tool that fails is a row that says so.
"""

from __future__ import annotations

import gc
import json
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from statistics import median
from time import perf_counter
from typing import Any

import acausal
from benchmarks.models import component_chain, equation_chain

REPEATS = 3
TIME_LIMIT = 120.0
MODELS = {"equations": (equation_chain, "Chain", 3), "components": (component_chain, "Parts.Chain", 14)}
Row = dict[str, str | int | float]


def seconds(work: Callable[[], object], repeats: int = REPEATS) -> float:
    """Median wall time of `work`."""
    taken: list[float] = []
    for _ in range(repeats):
        gc.collect()
        start = perf_counter()
        work()
        taken.append(perf_counter() - start)
    return median(taken)


def rows(sizes: tuple[int, ...] = (1_000, 10_000)) -> Iterator[Row]:
    """One row per model, tool and size; `growth` is the time per equation over that of the smallest size."""
    for model, (text, name, per_cell) in MODELS.items():
        for tool, (package, _) in TOOLS.items():
            if package and find_spec(package) is None:
                continue
            base = 0.0
            for size in sizes:
                cells = size // per_cell
                equations = len(acausal.loads(text(cells), name).compile().flat.equations)
                taken = measured(model, tool, cells)
                row: Row = {"model": model, "tool": tool, "equations": equations}
                if isinstance(taken, str):
                    yield row | {"us_per_equation": taken, "growth": ""}
                    continue
                each = taken / equations * 1e6
                base = base or each
                yield row | {"us_per_equation": round(each, 1), "growth": round(each / base, 2)}


def measured(model: str, tool: str, cells: int) -> float | str:
    """Seconds that `tool` takes, in a process of its own; the reason when it does not get there."""
    command = [sys.executable, "-m", "benchmarks.compile_growth", model, tool, str(cells)]
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=TIME_LIMIT, check=False)
    except subprocess.TimeoutExpired:
        return f"over {TIME_LIMIT:g} s"
    if run.returncode != 0:
        return "fails: " + (run.stderr.strip().splitlines() or ["?"])[-1][:60]
    return float(json.loads(run.stdout.splitlines()[-1]))


def acausal_compile(text: str, name: str) -> object:
    """Compile with acausal."""
    return acausal.loads(text, name).compile()


def acausal_run(text: str, name: str) -> object:
    """Compile and run one second with acausal."""
    return acausal.loads(text, name).compile().simulate(stop_time=1.0)


def rumoca_load(text: str, name: str) -> Any:
    """Load with rumoca."""
    rumoca: Any = import_module("rumoca")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{name.split('.', maxsplit=1)[0]}.mo"
        path.write_text(text)
        return rumoca.Session().load(str(path), model=name)


def rumoca_run(text: str, name: str) -> Any:
    """Load and run one second with rumoca."""
    return rumoca_load(text, name).simulate(t=(0, 1))


def pymoca_generate(text: str, name: str) -> Any:
    """Parse and generate CasADi with pymoca."""
    parser: Any = import_module("pymoca.parser")
    generator: Any = import_module("pymoca.backends.casadi.generator")
    return generator.generate(parser.parse(text), name)


TOOLS: dict[str, tuple[str, Callable[[str, str], object]]] = {
    "acausal compile": ("", acausal_compile),
    "acausal compile + 1 s": ("", acausal_run),
    "rumoca load": ("rumoca", rumoca_load),
    "rumoca load + 1 s": ("rumoca", rumoca_run),
    "pymoca generate": ("pymoca", pymoca_generate),
}


def main() -> None:
    """One measurement, printed as JSON: model, tool, cells."""
    model, tool, cells = sys.argv[1:]
    text, name, _ = MODELS[model]
    source = text(int(cells))
    work = TOOLS[tool][1]
    work(text(2), name)  # imports and caches
    print(json.dumps(seconds(lambda: work(source, name))))


if __name__ == "__main__":
    main()
