"""One model simulated over its own interval and compared: `python -m tests.reference.judge MODEL ...`."""

from __future__ import annotations

import argparse
import json
from dataclasses import asdict, dataclass
from pathlib import Path
from time import process_time

import numpy as np

import acausal
from acausal.api import CompiledModel
from acausal.errors import AcausalError
from acausal.simulate.result import Result
from tests.reference.published import Reference
from tests.reference.tube import Curve, Deviation, deviation

AGREES, DEVIATES, SIMULATES, FAILS = "agrees", "deviates", "simulates", "fails"


@dataclass(frozen=True)
class Verdict:
    """What came of one model: how many signals were compared, and the reason if it does not agree."""

    model: str
    verdict: str
    signals: int = 0
    reason: str = ""
    seconds: float = 0.0


def judge(model: str, libraries: list[Path], reference: Reference | None, solver: str = "auto") -> Verdict:
    """Compiles and simulates; compares if there is a reference with a table."""
    began = process_time()
    curves = reference.curves() if reference is not None and reference.table.is_file() else {}
    try:
        compiled = acausal.load(model, path=libraries).compile()
        interval = spacing(next(iter(curves.values()))) if curves else None
        stop = own_end(compiled, curves)
        result = compiled.simulate(interval=interval, solver=solver, stop_time=stop)
    except AcausalError as error:
        first = error.diagnostics[0]
        reason = f"[{first.code}] {first.message}"
        for folder in libraries:
            reason = reason.replace(f"{folder}/", "")
        return Verdict(model, FAILS, 0, reason, process_time() - began)
    if reference is None or not curves:
        reason = "no reference" if reference is None else "the reference has no table"
        return Verdict(model, SIMULATES, 0, reason, process_time() - began)
    names = [name for name in reference.signals if name in curves]
    found = worst(result, {name: curves[name] for name in names})
    spent = process_time() - began
    note = "" if stop is None else f"over the interval of the reference, which ends at {stop:g} s"
    if found is None:
        return Verdict(model, AGREES, len(names), note, spent)
    name, off, count = found
    why = f"{count} signals, most `{name}`: {text(off)}"
    return Verdict(model, DEVIATES, len(names), f"{why}, {note}" if note else why, spent)


def own_end(compiled: CompiledModel, curves: dict[str, Curve]) -> float | None:
    """Where the reference ends, if it was not made over the interval of the model's `experiment`."""
    if not curves:
        return None
    times = next(iter(curves.values())).time
    experiment = compiled.flat.experiment
    start = experiment.start_time or 0.0
    planned = start + 1.0 if experiment.stop_time is None else experiment.stop_time
    return None if abs(planned - times[-1]) <= 1e-6 * abs(planned - start) else float(times[-1])


def spacing(curve: Curve) -> float:
    """The interval of the reference's grid, which it has as often as it fits into the run."""
    steps = np.diff(curve.time)
    span = float(curve.time[-1] - curve.time[0])
    return span / max(1, round(span / float(np.max(steps))))


def worst(result: Result, curves: dict[str, Curve]) -> tuple[str, Deviation, int] | None:
    """The signal that is farthest outside of its tube, and how many are."""
    bad: list[tuple[str, Deviation]] = []
    for name, curve in curves.items():
        try:
            values = result.values(name)
        except AcausalError:
            bad.append((name, Deviation(0.0, float(curve.values[0]), float("nan"), float("inf"))))
            continue
        off = deviation(curve, Curve(result.time, values))
        if off is not None:
            bad.append((name, off))
    return (*max(bad, key=lambda one: one[1].widths), len(bad)) if bad else None


def text(off: Deviation) -> str:
    """A deviation in words."""
    return f"{off.found:.6g} instead of {off.expected:.6g} at {off.time:.6g} s ({off.widths:.3g} half widths)"


def main() -> None:
    """One model, judged; a JSON object on standard output."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("model")
    parser.add_argument("--path", type=Path, action="append", default=[])
    parser.add_argument("--reference", type=Path)
    parser.add_argument("--solver", default="auto")
    given = parser.parse_args()
    reference = Reference(given.model, given.reference) if given.reference is not None else None
    print(json.dumps(asdict(judge(given.model, given.path, reference, given.solver))))


if __name__ == "__main__":
    main()
