"""The longest stable step of explicit Heun at each level of the gearbox; linearly implicit methods beyond it.

The bench starts in reverse with its input torque at once. The limit is predicted as the smallest over
snapshots of the first `SPAN` seconds; the state named has the largest share in the mode that sets it. Then it
is tried: in the last quarter that state lies on the reference with a stable step, and swings with one that is
too long. How far depends on what bounds the swing: near zero pressure difference an orifice is laminar and
quick, a little off it is not. So a swing is compared with that of the stable steps. Between snapshots
contacts open and close, and what they do may need a somewhat shorter step than any snapshot says. Last,
linearly implicit Euler and `rosenbrock` run at `BEYOND` times the predicted limit; there the speed of the
output counts, relative to its largest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

import acausal
from acausal.analysis.linearize import snapshots
from acausal.simulate.stability import step_limit
from benchmarks.measure import Row

SPAN = 0.4
POINTS = 400
INSTANTS = (0.01, 0.05, 0.1, 0.2, 0.3, 0.4)
FACTORS = (0.6, 0.7, 0.8, 0.85, 0.9, 0.95, 1.05, 1.15, 1.3)
"""Steps that are tried, over the predicted limit."""
BEYOND = 10.0
CALM = 1e-3
LOUDER = 30.0
"""How many times further than below the limit the state must swing for the limit to be confirmed."""
OUTPUT = "vehicle.inertia.w"
Values = NDArray[np.float64]


def rows(*, quick: bool) -> Iterator[Row]:
    """One row per level, the simplest first."""
    for level in (4, 3) if quick else (4, 3, 2, 1):
        yield row(level)


def row(level: int) -> Row:
    """Limits and trials of one level."""
    compiled = acausal.load(f"TenSpeed.Benches.GearboxL{level}").compile()
    limit, state = heun_limit(compiled)
    reference = trial(compiled, "rodas", None, (state, OUTPUT))

    def error(solver: str, factor: float) -> tuple[float, float]:
        found = trial(compiled, solver, factor * limit, (state, OUTPUT))
        if found is None or reference is None:
            return float("inf"), float("inf")
        late = len(reference[0]) * 3 // 4
        swing = float(np.abs(found[0] - reference[0])[late:].max() / np.abs(reference[0]).max())
        return swing, float(np.abs(found[1] - reference[1]).max() / np.abs(reference[1]).max())

    stable, broken = bracket(lambda factor: error("heun", factor)[0])
    return {
        "level": level,
        "states": len(compiled.states),
        "predicted, us": round(1e6 * float(limit), 2),
        "set by": state,
        "stable at, us": round(1e6 * float(limit) * stable, 2),
        "not at, us": round(1e6 * float(limit) * broken, 2),
        f"lieuler at {BEYOND:g} times": f"{error('lieuler', BEYOND)[1]:.1e}",
        f"rosenbrock at {BEYOND:g} times": f"{error('rosenbrock', BEYOND)[1]:.1e}",
    }


def bracket(swing: Callable[[float], float]) -> tuple[float, float]:
    """The longest of `FACTORS` that is stable and the next one, which is not; NaN where there is none."""
    last, quiet = float("nan"), 0.0
    for factor in FACTORS:
        found = swing(factor)
        if found > CALM or (quiet and found > LOUDER * quiet):
            return last, factor
        last, quiet = factor, max(quiet, found, 1e-12)
    return last, float("nan")


def heun_limit(compiled: acausal.CompiledModel) -> tuple[float, str]:
    """The smallest limit over the snapshots, in seconds, and the state of the mode that sets it."""
    worst, name = float("inf"), ""
    for snapshot in snapshots(compiled.code, list(INSTANTS)):
        for mode in snapshot.modes.modes:
            limit = step_limit("heun", [mode.eigenvalue], floor=1e-3)
            if limit < worst:
                worst, name = limit, snapshot.states[int(np.argmax(mode.participation))]
    return worst, name


def trial(
    compiled: acausal.CompiledModel, solver: str, step: float | None, names: tuple[str, ...]
) -> tuple[Values, ...] | None:
    """The named variables on one grid; None where the run fails. Without a step the tolerance is 1e-9."""
    grid = np.linspace(0, SPAN, POINTS + 1)
    try:
        if step is None:
            run = compiled.simulate(stop_time=SPAN, solver=solver, rtol=1e-9, interval=SPAN / POINTS)
        else:
            run = compiled.simulate(stop_time=SPAN, solver=solver, step=step, interval=SPAN / POINTS)
    except acausal.AcausalError:
        return None
    return tuple(np.interp(grid, run.time, run.values(name)) for name in names)
