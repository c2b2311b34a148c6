"""What a run can be told, and the contract's defaults."""

from __future__ import annotations

import math
from dataclasses import dataclass

from acausal.errors import UsageProblem, fail
from acausal.lang.flat import Experiment

DEFAULT_STOP = 1.0
DEFAULT_RTOL = 1e-6
DEFAULT_INTERVALS = 500
MAX_STEPS = 10_000_000
_MAX_POINTS = 50_000_000
_MOST_STEPS = 1e9
"""Of a length that was asked for."""
_SHARE = 4.0
"""So many times the steps that the longest ones would make are allowed."""
_LEAST_RTOL = 1e-15
_LEAST_SPAN, _TINY = 1e-13, 1e-290


@dataclass(frozen=True)
class Options:
    """A run's settings, complete: `atol` counts in nominal values; `max_step` 0 is no limit.

    `sample` is how often zero crossings are looked at (0 where there are none). `step` is the length of fixed
    steps; at their ends events are handled, or located inside them if `locate`. `compiled`: whether the
    model's functions are compiled C; None decides by what it costs.
    """

    start_time: float
    stop_time: float
    rtol: float
    atol: float
    max_step: float
    interval: float
    solver: str = "cvode"
    max_steps: int = MAX_STEPS
    sample: float = 0.0
    step: float = 0.0
    locate: bool = True
    compiled: bool | None = None
    times: tuple[float, ...] = ()
    """Output times after the start, ascending, instead of the grid; a run goes to the stop time anyway."""
    resumed: float | None = None
    """When the run goes on, that of a stored result; None: it begins at the start."""

    @property
    def first(self) -> float:
        """When the run begins or goes on."""
        return self.start_time if self.resumed is None else self.resumed

    @property
    def span(self) -> float:
        return self.stop_time - self.start_time


def resolve(
    experiment: Experiment,
    *,
    stop_time: float | None = None,
    start_time: float | None = None,
    rtol: float | None = None,
    atol: float | None = None,
    max_step: float | None = None,
    interval: float | None = None,
    solver: str = "cvode",
    max_steps: int = MAX_STEPS,
    has_events: bool = False,
    step: float | None = None,
    events: str = "locate",
    compiled: bool | None = None,
) -> Options:
    """Settings as given, else from the `experiment` annotation, else the contract's: 1 s, 1e-6, 1/500.

    `atol` is by default `rtol`, `step` the interval. Raises `UsageProblem`.
    """
    start = _first(start_time, experiment.start_time, 0.0)
    stop = _first(stop_time, experiment.stop_time, start + DEFAULT_STOP)
    _check_times(start, stop)
    relative = _positive("rtol", _first(rtol, experiment.tolerance, DEFAULT_RTOL))
    if not _LEAST_RTOL <= relative < 1.0:
        raise _wrong("rtol", f"a tolerance of {relative:g} is not between {_LEAST_RTOL:g} and 1")
    span = stop - start
    points = _positive("interval", _first(interval, experiment.interval, span / DEFAULT_INTERVALS or 1.0))
    if span / points > _MAX_POINTS:
        raise _wrong("interval", f"an interval of {points:g} s gives more than {_MAX_POINTS} output points")
    if max_step is not None:
        _check_count("max_step", _positive("max_step", max_step), span)
        max_steps = max(max_steps, int(_SHARE * span / max_step)) if max_steps == MAX_STEPS else max_steps
    absolute = _positive("atol", atol if atol is not None else relative)
    length = _positive("step", _first(step, points))
    if step is not None:
        _check_count("step", step, span)
    if events not in ("locate", "step"):
        raise _wrong("events", f"`{events}` is no way to handle events: `locate` or `step`")
    return Options(
        start,
        stop,
        relative,
        absolute,
        max_step or 0.0,
        points,
        solver,
        max_steps,
        sample=min(points, span) if has_events else 0.0,
        step=length,
        locate=events == "locate",
        compiled=compiled,
    )


def _check_times(start: float, stop: float) -> None:
    """Two different instants must be numbers with a few more between them."""
    for name, time in (("start-time", start), ("stop-time", stop)):
        if not math.isfinite(time):
            raise _wrong(name, f"the {name.replace('-', ' ')} must be a finite number, not {time:g}")
    if stop < start:
        raise _wrong("stop-time", f"the stop time {stop:g} s lies before the start time {start:g} s")
    if stop > start and stop - start < max(_LEAST_SPAN * max(abs(start), abs(stop)), _TINY):
        raise _wrong("stop-time", f"from {start!r} s to {stop!r} s is too short for numbers of 64 bits")


def _check_count(name: str, length: float, span: float) -> None:
    """Steps of this length must be few enough for a run that ends."""
    if span / length > _MOST_STEPS:
        what = name.replace("_", " ")
        message = f"a {what} of {length:g} s over {span:g} s takes more than {_MOST_STEPS:g} steps"
        raise _wrong(name, message)


def _first(*values: float | None) -> float:
    return next(value for value in values if value is not None)


def _positive(name: str, value: float) -> float:
    if not (math.isfinite(value) and value > 0):
        raise _wrong(name, f"{name} must be a positive number, not {value:g}")
    return value


def _wrong(name: str, message: str) -> Exception:
    return fail(UsageProblem, f"simulate.{name.replace('_', '-')}", message, names=[name])
