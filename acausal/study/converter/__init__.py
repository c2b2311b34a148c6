"""Steady states of a hydrodynamic torque converter, for whole arrays of operating points and parameters."""

from acausal.study.converter.geometry import NOMINAL, STUDY_RANGES, Geometry
from acausal.study.converter.map import ConverterMap, steady_map
from acausal.study.converter.steady import Operating, SteadyState, steady_state

__all__ = [
    "NOMINAL",
    "STUDY_RANGES",
    "ConverterMap",
    "Geometry",
    "Operating",
    "SteadyState",
    "steady_map",
    "steady_state",
]
