"""The two systems: the kinematics in eleven gears, and the main regulator on three supplies."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from time import perf_counter

from acausal.api import CompiledModel, load
from acausal.simulate.result import Result
from acausal.symbolic.causal import CausalEquation

GEARS: dict[int, tuple[str, float]] = {
    1: ("B1 B2 F1", 5.246),
    2: ("B1 B2 C2", 3.271),
    3: ("B1 B2 C3", 2.185),
    4: ("B1 C2 C3", 1.597),
    5: ("B1 C1 C3", 1.304),
    6: ("C1 C2 C3", 1.000),
    7: ("B2 C1 C3", 0.782),
    8: ("B2 C1 C2", 0.653),
    9: ("B2 B3 C1", 0.581),
    10: ("B3 C1 C2", 0.517),
    -1: ("B2 C3 F1", -3.974),
}
"""Gear (-1 is reverse): what is engaged, and the published ratio of input to output speed."""

TOLERANCE = 0.003
"""How far a simulated ratio may be from the published one: the tooth counts are whole numbers."""

SUPPLIES: dict[str, tuple[str, int]] = {
    "MainRegulatorFlow": ("flow source", 5),
    "MainRegulatorPressure": ("constant pressure", 4),
    "MainRegulatorPressureRamp": ("pressure ramp", 4),
}
"""Model: what feeds the line, and how many states that leaves."""

INTERVAL = 1e-4
"""Seconds between output points of the regulator, whose spool settles within milliseconds."""


@dataclass(frozen=True)
class Trial:
    """One model, compiled and run."""

    compiled: CompiledModel
    result: Result
    run_seconds: float

    def final(self, name: str) -> float:
        return self.result.final([name])[name]

    @property
    def compile_seconds(self) -> float:
        return self.compiled.compilation.seconds["total"]


@dataclass(frozen=True)
class GearTrial(Trial):
    """The kinematics in one gear."""

    gear: int

    @property
    def title(self) -> str:
        return "R" if self.gear < 0 else f"{self.gear}"

    @property
    def engaged(self) -> str:
        return GEARS[self.gear][0]

    @property
    def published(self) -> float:
        return GEARS[self.gear][1]

    @property
    def ratio(self) -> float:
        """Input over output speed at the end of the run."""
        return self.final("ratio")

    @property
    def deviation(self) -> float:
        return self.ratio - self.published


@dataclass(frozen=True)
class RegulatorTrial(Trial):
    """The main regulator on one supply."""

    model: str

    @property
    def supply(self) -> str:
        return SUPPLIES[self.model][0]

    @property
    def differentiated(self) -> tuple[CausalEquation, ...]:
        """What index reduction differentiated, aliases not counted."""
        return tuple(e for e in self.compiled.causal.equations if e.differentiations > 0)


def gear_trials(gears: tuple[int, ...] = tuple(GEARS)) -> tuple[GearTrial, ...]:
    """The kinematics, once for each gear: the gear is structural, so each is compiled anew."""
    model = load("TenSpeed.Examples.FixedGear")
    return tuple(GearTrial(*_run(model.compile(gear=gear)), gear) for gear in gears)


def regulator_trials() -> tuple[RegulatorTrial, ...]:
    """The regulator on each of its supplies."""
    models = {name: load(f"TenSpeed.Examples.{name}").compile() for name in SUPPLIES}
    return tuple(RegulatorTrial(*_run(model, INTERVAL), name) for name, model in models.items())


def _run(compiled: CompiledModel, interval: float | None = None) -> tuple[CompiledModel, Result, float]:
    began = perf_counter()
    result = compiled.simulate(interval=interval)
    return compiled, result, perf_counter() - began


def problems(gears: tuple[GearTrial, ...], regulators: tuple[RegulatorTrial, ...]) -> Iterator[str]:
    """What is not as it has to be; nothing when all is well."""
    for trial in gears:
        if not abs(trial.deviation) <= TOLERANCE:
            wanted = f"{trial.published} within {TOLERANCE}"
            yield f"gear {trial.title}: ratio {trial.ratio:.4f} instead of {wanted}"
        if len(trial.compiled.states) != 2:
            yield f"gear {trial.title}: {len(trial.compiled.states)} states instead of 2"
    for trial in regulators:
        count = SUPPLIES[trial.model][1]
        if len(trial.compiled.states) != count:
            yield f"{trial.model}: {len(trial.compiled.states)} states instead of {count}"
