"""Figures that engineers read off a trace: of clutch pressures and of gear shifts."""
