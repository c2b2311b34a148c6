"""One measurement in a process of its own: what a tool needs for a model of a size.

`python -m benchmarks.measure MODEL EQUATIONS TOOL REPEATS` prints JSON. A small model goes first, so that
imports and caches are not timed; memory is that of the whole process, imports included.
"""

from __future__ import annotations

import gc
import json
import resource
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field
from importlib import import_module
from pathlib import Path
from statistics import median
from time import perf_counter, process_time
from typing import Any

import acausal
from acausal import pipeline
from benchmarks.models import CASES

Row = dict[str, str | int | float]
WARM_UP = 120
"""Scalar equations, about, of the model that goes first."""


@dataclass(frozen=True)
class Cost:
    """Medians over the repetitions; `facts` are what the tool said about the last one."""

    cpu: float
    wall: float
    mib: float
    facts: Mapping[str, float] = field(default_factory=dict[str, float])


def measured(model: str, size: int, tool: str, repeats: int, limit: float) -> Cost | str:
    """What `tool` needs; the reason when it does not get there within `limit` seconds."""
    command = [sys.executable, "-m", "benchmarks.measure", model, str(size), tool, str(repeats)]
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return f"over {limit:g} s"
    if run.returncode != 0:
        return "fails: " + (run.stderr.strip().splitlines() or ["?"])[-1][:60]
    return Cost(**json.loads(run.stdout.splitlines()[-1]))


def seconds(work: Callable[[], object], repeats: int = 3) -> float:
    """Median wall time of `work`."""
    taken: list[float] = []
    for _ in range(repeats):
        gc.collect()
        start = perf_counter()
        work()
        taken.append(perf_counter() - start)
    return median(taken)


def acausal_compile(text: str, name: str, watched: str) -> Mapping[str, float]:
    """Compile with acausal; CPU seconds by stage."""
    del watched
    compiled = acausal.loads(text, name).compile()
    return {
        **compiled.compilation.seconds,
        "equations": len(compiled.flat.equations),
        "states": len(compiled.states),
    }


def acausal_run(text: str, name: str, watched: str) -> Mapping[str, float]:
    """Compile and run one second with acausal."""
    result = acausal.loads(text, name).compile().simulate(stop_time=1.0)
    return {"value": float(result[watched][-1])}


def rumoca_model(text: str, name: str) -> Any:
    """Load with rumoca."""
    rumoca: Any = import_module("rumoca")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"{name.split('.', maxsplit=1)[0]}.mo"
        path.write_text(text)
        return rumoca.Session().load(str(path), model=name)


def rumoca_load(text: str, name: str, watched: str) -> Mapping[str, float]:
    """Load with rumoca, and nothing else."""
    del watched
    rumoca_model(text, name)
    return {}


def rumoca_run(text: str, name: str, watched: str) -> Mapping[str, float]:
    """Load and run one second with rumoca."""
    result = rumoca_model(text, name).simulate(t=(0, 1))
    return {"value": float(result[watched][-1])}


def pymoca_generate(text: str, name: str, watched: str) -> Mapping[str, float]:
    """Parse and generate CasADi with pymoca."""
    del watched
    parser: Any = import_module("pymoca.parser")
    generator: Any = import_module("pymoca.backends.casadi.generator")
    generator.generate(parser.parse(text), name)
    return {}


TOOLS: dict[str, Callable[[str, str, str], Mapping[str, float]]] = {
    "acausal compile": acausal_compile,
    "acausal compile + 1 s": acausal_run,
    "rumoca load": rumoca_load,
    "rumoca load + 1 s": rumoca_run,
    "pymoca generate": pymoca_generate,
}


def main() -> None:
    """One measurement, printed as JSON: model, equations, tool, repetitions."""
    model, size, tool, repeats = sys.argv[1:]
    case, work = CASES[model], TOOLS[tool]
    pipeline.perf_counter = process_time  # the stages' clock: on a shared machine CPU time says more
    work(case.text(WARM_UP), case.name, case.watched)
    text = case.text(int(size))
    cpu: list[float] = []
    wall: list[float] = []
    facts: list[Mapping[str, float]] = []
    for _ in range(int(repeats)):
        gc.collect()
        start, cpu_start = perf_counter(), process_time()
        facts.append(work(text, case.name, case.watched))
        cpu.append(process_time() - cpu_start)
        wall.append(perf_counter() - start)
    middle = {key: median(each[key] for each in facts) for key in facts[0]}
    print(json.dumps(asdict(Cost(median(cpu), median(wall), peak_memory(), middle))))


def peak_memory() -> float:
    """MiB of this process at most. On Linux `ru_maxrss` will not do: it starts at the parent's peak."""
    status = Path("/proc/self/status")
    if status.exists():
        lines = dict(line.split(":", 1) for line in status.read_text().splitlines())
        return float(lines["VmHWM"].split()[0]) / 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


if __name__ == "__main__":
    main()
