"""Steady states of a hydrodynamic torque converter, for whole arrays of operating points and parameters."""

from acausal.study.converter.geometry import NOMINAL, STUDY_RANGES, Geometry
from acausal.study.converter.map import ConverterMap, steady_map

__all__ = ["NOMINAL", "STUDY_RANGES", "ConverterMap", "Geometry", "steady_map"]
