"""Words of the engineer's domains: what a flow variable with a unit belongs to, and what to put where."""

from __future__ import annotations

from dataclasses import dataclass

from acausal.lang.flat import Variable


@dataclass(frozen=True)
class Domain:
    """`across` and `through` name the pair of a connector; the others what helps a wrong circuit."""

    across: str
    through: str
    compliant: str
    """What may stand between two places of different across values."""
    storage: str
    """What may take up a difference of flows."""
    reference: str
    """What fixes the level of the across value."""


_MECHANICAL = "a fixed flange"
GENERIC = Domain(
    "potential",
    "flow",
    "a resistance or spring",
    "a storage (capacitor, inertia, volume)",
    "a reference (ground, tank, fixed flange)",
)
_HYDRAULIC = Domain("pressure", "flow", "an orifice or pipe", "a volume", "a tank or pressure source")
_BY_UNIT = {
    "N.m": Domain("angle or speed", "torque", "a spring, damper or clutch", "an inertia", _MECHANICAL),
    "N": Domain("position or speed", "force", "a spring or damper", "a mass", _MECHANICAL),
    "A": Domain("potential", "current", "a resistor", "a capacitor", "a ground"),
    "m3/s": _HYDRAULIC,
    "kg/s": _HYDRAULIC,
    "W": Domain("temperature", "heat flow", "a thermal resistor", "a heat capacitor", "a fixed temperature"),
}


_UNIT_BY_NAME = {"tau": "N.m", "f": "N", "i": "A", "q": "m3/s", "m_flow": "kg/s", "Q_flow": "W"}
"""What flow variables without a unit are usually called."""


def domain_of(flow: Variable) -> Domain:
    """By the unit of the flow variable; without one, by its name."""
    unit = flow.unit or _UNIT_BY_NAME.get(flow.name.rpartition(".")[2], "")
    return _BY_UNIT.get(unit, GENERIC)
