"""The mechanics library in another Modelica tool, unmodified: rumoca runs the examples, and agrees.

Left out are examples whose motion is prescribed, which take index reduction that rumoca 0.10 has not, and
those with parameters that an initial equation determines. rumoca does not follow `uses`: each text imports
something of the other library.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import pytest

import acausal
from acausal.lang.library import bundled_directories

ROTATIONAL = """BacklashImpact ClutchSticks CoastDown DamperAndInertia ElasticPlanetaryWindUp
FrictionBrakeHolds FrictionLaws GearPairWindUp GearedInertias HelicalPlanetaryEnergy HelicalPlanetaryWindUp
IdealClutch InertiaUnderTorque OverrunningClutch PlanetaryReduction RigidClutchHolds RigidClutchesInRow
RigidPlanetaryDrive SignalsAsMotion SmoothClutchCreeps SpringAndInertia SpringDamperAndInertia
TwoWayLock""".split()
TRANSLATIONAL = """BouncingMass ClutchPistonAtPack DamperAndMass ElasticStopImpact MassUnderForce PlayInARod
SpringAndMass SpringDamperAndMass""".split()
EXAMPLES = [f"Rotational.Examples.{name}" for name in ROTATIONAL] + [
    f"Translational.Examples.{name}" for name in TRANSLATIONAL
]


@cache
def session() -> Any:
    rumoca = pytest.importorskip("rumoca")
    roots = [str(path) for path in bundled_directories() if path.name in ("mechanics", "signals")]
    assert len(roots) == 2
    return rumoca.Session(roots=roots)


@pytest.mark.parametrize("example", EXAMPLES)
def test_example(example: str) -> None:
    """All states at the end are those of this project's run."""
    text = f"model Other import Signals.Interfaces.RealInput; extends Mechanics.{example}; end Other;"
    other = session().loads(text, model="Other")
    compiled = acausal.load(f"Mechanics.{example}").compile()
    run = compiled.simulate(compiled=False)
    found = other.simulate(t=(0, float(run.time[-1])))
    for name in compiled.states:
        assert float(found[name][-1]) == pytest.approx(float(run.values(name)[-1]), rel=1e-3, abs=1e-4), name
