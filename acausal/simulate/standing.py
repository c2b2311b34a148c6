"""Where a run stands: all that another run needs to go on from there."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import cast

import numpy as np

from acausal.simulate.evaluator import Evaluator
from acausal.simulate.history import Sample
from acausal.simulate.matrices import Vector
from acausal.simulate.options import Options
from acausal.symbolic.expressions.expr import sym
from acausal.symbolic.expressions.text import to_text

_FORM = 1
_PARTS = ("values", "lags", "longest", "value_slopes", "lag_slopes")


@dataclass(frozen=True)
class Standing:
    """An instant after its events: states, modes, discrete values, the samples' next numbers, the past.

    `start` and `rows` are those of the whole run; `states` has all that may be chosen as states, `parameters`
    those that the initial problem determined. Names are those of the flat model.
    """

    model: str
    start: float
    time: float
    rows: int
    states: Mapping[str, float]
    modes: tuple[float, ...]
    frozen: Mapping[str, float]
    guesses: Mapping[str, float]
    parameters: Mapping[str, float]
    samples: tuple[float, ...]
    past: tuple[Sample, ...]
    interval: float | None = None
    """Between points of the output grid; None in what earlier versions wrote."""

    def to_text(self) -> str:
        """As JSON with all digits."""
        past = [[s.time, *(getattr(s, part).tolist() for part in _PARTS)] for s in self.past]
        parts = {key: value for key, value in vars(self).items() if key != "past"}
        return json.dumps({"form": _FORM, **parts, "past": past}) + "\n"


def from_text(text: str) -> Standing:
    """Reads what `to_text` wrote. Raises `ValueError`."""
    try:
        data = cast("dict[str, object]", json.loads(text))
        if data.pop("form") != _FORM:
            raise ValueError("it was written by another version")
        past = cast("list[list[object]]", data.pop("past"))
        samples = [
            Sample(cast("float", t), *(np.array(part, dtype=float) for part in parts)) for t, *parts in past
        ]
        fixed = {"modes": tuple(cast("list[float]", data.pop("modes")))}
        fixed["samples"] = tuple(cast("list[float]", data.pop("samples")))
        return Standing(**fixed, **data, past=tuple(samples))  # pyright: ignore[reportArgumentType]
    except (KeyError, TypeError, AttributeError) as problem:
        raise ValueError(f"it does not say where a run stands ({problem})") from None


def standing_of(
    evaluator: Evaluator,
    own: int,
    options: Options,
    time: float,
    rows: int,
    row: Mapping[str, float],
    counts: Vector,
) -> Standing:
    """Of a run at `time` with all values in `row`; the first `own` modes are the model's."""
    code = evaluator.code
    system = code.system
    values = dict(zip(system.parameters, evaluator.p.tolist(), strict=True))
    past = evaluator.history.samples if evaluator.history is not None else ()
    return Standing(
        model=system.flat.name,
        start=options.start_time,
        time=time,
        rows=rows,
        states={name: row[name] for name in (system.states if system.dynamic is None else row)},
        modes=tuple(evaluator.m[:own].tolist()),
        frozen=dict(zip(map(to_text, system.discrete.frozen), evaluator.d.tolist(), strict=True)),
        guesses=dict(zip(map(to_text, code.dynamic.guesses), evaluator.guess.tolist(), strict=True)),
        parameters={name: values[name] for name in system.parameters if sym(name) in code.initial.unknowns},
        samples=tuple(counts.tolist()),
        past=tuple(sample for sample in past if sample.time <= time),
        interval=options.interval,
    )
